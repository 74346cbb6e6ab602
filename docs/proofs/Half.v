(** Section 4 of the paper, the special case n = 1/2: (1.18), (1.19), and the threshold under controlled force. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw.
Open Scope R_scope.

Section Half.
Variables E w C : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C).
Notation kap := (kappa (/2)).
Let Hk : 0 < kap := kappa_pos (/2) ltac:(lra).
Notation B := (B E w).
Notation dl := (dl E w).
Notation dn := (dn E w C (/2)).
Notation Fn := (Fn E w C (/2)).
Notation rho := (rho E w C (/2)).

Lemma unit_pos : 0 < sqrt (2 * PI * w / E).
Proof. pos. Qed.

Lemma dl_half a : 0 < a -> dl a = sqrt (2*PI*w/E) * sqrt a.
Proof.
  intros Ha. unfold Definitions.dl. replace (2*PI*a*w/E) with (2*PI*w/E*a) by (field; lra).
  assert (0 < 2*PI*w/E) by pos. rewrite sqrt_mult by lra. auto.
Qed.

Lemma g_half a : 0 < a -> kap * C * Rpower a (/2) = rho * dl a.
Proof.
  intros Ha. rewrite Rpower_sqrt, dl_half by auto. unfold Definitions.rho. pose proof unit_pos. field. lra.
Qed.

(** (1.18): at n = 1/2 the curves g and Δl are proportional, with the ratio ρ, so that (1.13) is d = (ρ - 1) Δl(a). *)
Theorem eq_1_18 a : 0 < a -> dn a = (rho - 1) * dl a.
Proof. intros Ha. unfold Definitions.dn. rewrite g_half by auto. ring. Qed.

Lemma Fn_half a : 0 < a -> Fn a = 2 * E * a * dl a * (rho / 3 - 1).
Proof.
  intros Ha. unfold Definitions.Fn. replace (/2/(/2+1) * kap * C * Rpower a (/2)) with (kap * C * Rpower a (/2) / 3) by field.
  rewrite g_half by auto. field.
Qed.

(** (1.19): at d = 0 g is above Δl at every radius or below it at every radius, as C is above or below (1/κ_½) sqrt (2πw/E). *)
Theorem eq_1_19 a : 0 < a ->
  (dl a < kap * C * Rpower a (/2) <-> C > 1 / kap * sqrt (2*PI*w/E)) /\
  (kap * C * Rpower a (/2) < dl a <-> C < 1 / kap * sqrt (2*PI*w/E)).
Proof.
  intros Ha. pose proof unit_pos as Hu. assert (Hd : 0 < dl a) by (rewrite dl_half by auto; pos).
  rewrite g_half by auto.
  assert (H1 : rho = C / (1 / kap * sqrt (2*PI*w/E))) by (unfold Definitions.rho; field; split; lra).
  assert (H2 : 0 < 1 / kap * sqrt (2*PI*w/E)) by pos.
  set (T := 1 / kap * sqrt (2*PI*w/E)) in *.
  assert (H3 : C = rho * T) by (rewrite H1; field; lra). set (r := rho) in *. clearbody r T. rewrite H3. split; split; intros; nra.
Qed.

(** The force along the equilibria is tensile, zero or compressive at every radius as ρ < 3, ρ = 3 or ρ > 3. *)
Theorem threshold_force a : 0 < a -> (Fn a < 0 <-> rho < 3) /\ (Fn a = 0 <-> rho = 3) /\ (0 < Fn a <-> 3 < rho).
Proof.
  intros Ha. pose proof unit_pos as Hu. assert (Hd : 0 < dl a) by (rewrite dl_half by auto; pos).
  rewrite Fn_half by auto. assert (0 < 2 * E * a * dl a) by pos. set (k := 2 * E * a * dl a) in *.
  repeat split; intros; nra.
Qed.

(** Under controlled force an equilibrium at n = 1/2 is stable, indifferent or unstable as ρ > 3, = 3 or < 3, by the slope of the
    force. *)
Theorem threshold_force_slope a : 0 < a -> is_derive Fn a (E * dl a * (rho - 3)).
Proof.
  intros Ha. pose proof (dl_derive E w HE Hw a Ha) as H1.
  apply (is_derive_ext_loc (fun a => 2 * E * (rho / 3 - 1) * (a * dl a))).
  { exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy.
    rewrite Fn_half by lra. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  replace (E * dl a * (rho - 3)) with (2 * E * (rho / 3 - 1) * (1 * dl a + a * sqrt (PI * w / (2 * E * a)))).
  { apply (is_derive_scal (fun a => a * dl a)). apply (is_derive_mult (fun a => a) dl); auto.
    apply (is_derive_id (K := R_AbsRing)). intros; apply Rmult_comm. }
  assert (H2 : a * sqrt (PI * w / (2 * E * a)) = dl a / 2).
  { replace (PI * w / (2*E*a)) with (B / a) by (unfold Definitions.B; field; lra).
    pose proof (B_pos E w HE Hw). rewrite dl_B, sqrt_div, sqrt_mult by (auto; lra).
    assert (0 < sqrt a) by pos. rewrite <- (sqrt_sqrt a) at 1 by lra. field. lra. }
  rewrite H2. field.
Qed.

Lemma dl_half_onto y : 0 < y -> exists a, 0 < a /\ dl a = y.
Proof.
  intros Hy. pose proof unit_pos as Hu. set (u := sqrt (2*PI*w/E)) in *. exists ((y/u)*(y/u)).
  assert (0 < y/u) by pos. assert (0 < (y/u)*(y/u)) by pos. split; auto.
  rewrite dl_half by auto. fold u. rewrite sqrt_square by lra. field. lra.
Qed.

Lemma dl_half_injective a b : 0 < a -> 0 < b -> dl a = dl b -> a = b.
Proof.
  intros Ha Hb H. rewrite !dl_half in H by auto. pose proof unit_pos as Hu.
  apply Rmult_eq_reg_l in H; [|lra]. apply sqrt_inj in H; lra.
Qed.

(* How often a multiple c m of a function that is one to one between the positive numbers has a value. *)
Lemma multiple (m : R -> R) c d :
  (forall a, 0 < a -> 0 < m a) -> (forall y, 0 < y -> exists a, 0 < a /\ m a = y) ->
  (forall a b, 0 < a -> 0 < b -> m a = m b -> a = b) ->
  forall P : R -> Prop, (forall a, P a <-> 0 < a /\ c * m a = d) ->
  (0 < c -> (one P <-> 0 < d) /\ (none P <-> d <= 0)) /\
  (c < 0 -> (one P <-> d < 0) /\ (none P <-> 0 <= d)) /\
  (c = 0 -> forall a, P a <-> 0 < a /\ d = 0).
Proof.
  intros Hpos Honto Hinj P HP.
  assert (Hone : 0 < d / c -> c <> 0 -> one P).
  { intros H Hc. destruct (Honto _ H) as [a [Ha Ea]]. exists a. split.
    - apply HP. split; auto. rewrite Ea. field. lra.
    - intros b Hb. apply HP in Hb. destruct Hb as [Hb Eb]. apply Hinj; auto. rewrite Ea, <- Eb. field. lra. }
  assert (Hsign : forall a, P a -> 0 < d * c \/ c = 0).
  { intros a Ha. apply HP in Ha. destruct Ha as [Ha E1]. specialize (Hpos a Ha). destruct (Req_dec c 0) as [L|L]; auto. left.
    rewrite <- E1. replace (c * m a * c) with (m a * c^2) by ring. apply Rmult_lt_0_compat; auto. apply pow2_gt_0; lra. }
  split; [|split]; intros Hc.
  - assert (Hn : d <= 0 -> none P). { intros H a Ha. destruct (Hsign a Ha) as [K|K]; nra. }
    assert (Ho : 0 < d -> one P). { intros H. apply Hone; [apply Rdiv_lt_0_compat|]; lra. }
    split; split; auto; intros H; apply Rnot_le_lt || apply Rnot_lt_le; intro K.
    destruct H as [a [Ha _]]. apply (Hn K a Ha). destruct (Ho K) as [a [Ha _]]. apply (H a Ha).
  - assert (Hn : 0 <= d -> none P). { intros H a Ha. destruct (Hsign a Ha) as [K|K]; nra. }
    assert (Ho : d < 0 -> one P).
    { intros H. apply Hone; [|lra]. replace (d/c) with ((- d)/(- c)) by (field; lra). apply Rdiv_lt_0_compat; lra. }
    split; split; auto; intros H; apply Rnot_le_lt || apply Rnot_lt_le; intro K.
    destruct H as [a [Ha _]]. apply (Hn K a Ha). destruct (Ho K) as [a [Ha _]]. apply (H a Ha).
  - intros a. rewrite HP, Hc. split; intros [Ha H]; split; auto; lra.
Qed.

(** At n = 1/2 the number of equilibria, for every indentation: above the threshold one at every d > 0 and none at d <= 0; below
    it one at every d < 0 and none at d >= 0; at the threshold all radii at d = 0 and no other. *)
Theorem eq_1_18_equilibria d : let P a := 0 < a /\ dn a = d in
  (1 < rho -> (one P <-> 0 < d) /\ (none P <-> d <= 0)) /\
  (rho < 1 -> (one P <-> d < 0) /\ (none P <-> 0 <= d)) /\
  (rho = 1 -> forall a, P a <-> 0 < a /\ d = 0).
Proof.
  intros P. destruct (multiple dl (rho - 1) d) with (P := P) as [H1 [H2 H3]]; auto.
  - intros a Ha. rewrite dl_half by auto. pose proof unit_pos. pos.
  - apply dl_half_onto.
  - apply dl_half_injective.
  - intros a. unfold P. split; intros [Ha H]; split; auto; rewrite eq_1_18 in * by auto; auto.
  - split; [|split]; intros Hr; [apply H1 | apply H2 | apply H3]; lra.
Qed.

(** The same for every force: for ρ > 3 one equilibrium at every F > 0 and none at F <= 0; for ρ < 3 one at every F < 0 and none
    at F >= 0; at ρ = 3 all radii at F = 0 and no other. *)
Theorem threshold_force_equilibria F : let P a := 0 < a /\ Fn a = F in
  (3 < rho -> (one P <-> 0 < F) /\ (none P <-> F <= 0)) /\
  (rho < 3 -> (one P <-> F < 0) /\ (none P <-> 0 <= F)) /\
  (rho = 3 -> forall a, P a <-> 0 < a /\ F = 0).
Proof.
  intros P. pose proof unit_pos as Hu. set (u := sqrt (2*PI*w/E)) in *.
  set (m a := 2 * E / 3 * (a * dl a)). assert (Hv : 0 < 2 * E / 3 * u) by pos.
  assert (Hm : forall a, 0 < a -> m a = 2 * E / 3 * u * Rpower a (3/2)).
  { intros a Ha. unfold m. rewrite dl_half by auto. fold u. replace (3/2) with (1 + /2) by field.
    rewrite Rpower_plus, Rpower_1, Rpower_sqrt by auto. ring. }
  destruct (multiple m (rho - 3) F) with (P := P) as [H1 [H2 H3]].
  - intros a Ha. rewrite Hm by auto. pose proof (Rp_pos a (3/2)). pos.
  - intros y Hy. set (v := 2 * E / 3 * u) in *. exists (Rpower (y / v) (2/3)). split. apply Rp_pos.
    rewrite Hm by apply Rp_pos. rewrite Rpower_mult. replace (2/3 * (3/2)) with 1 by field.
    rewrite Rpower_1 by (apply Rdiv_lt_0_compat; auto). field. lra.
  - intros a b Ha Hb H. rewrite !Hm in H by auto. apply Rmult_eq_reg_l in H; [|lra].
    apply (f_equal ln) in H. rewrite !ln_Rpower in H. apply ln_inv; auto. lra.
  - intros a. unfold P. split; intros [Ha H]; split; auto; rewrite Fn_half in * by auto.
    rewrite <- H. unfold m. field. rewrite <- H. unfold m. field.
  - split; [|split]; intros Hr; [apply H1 | apply H2 | apply H3]; lra.
Qed.
End Half.
