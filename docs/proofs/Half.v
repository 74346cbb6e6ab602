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

(** At n = 1/2 the number of equilibria, for every indentation: above the threshold one at every d > 0 and none at d <= 0; below
    it one at every d < 0 and none at d >= 0; at the threshold all radii at d = 0 and no other. *)
Theorem eq_1_18_equilibria d : let P a := 0 < a /\ dn a = d in
  (1 < rho -> (one P <-> 0 < d) /\ (none P <-> d <= 0)) /\
  (rho < 1 -> (one P <-> d < 0) /\ (none P <-> 0 <= d)) /\
  (rho = 1 -> forall a, P a <-> 0 < a /\ d = 0).
Proof.
  intros P. set (r := rho) in *.
  assert (Hd : forall a, 0 < a -> 0 < dl a) by (intros a Ha; rewrite dl_half by auto; pose proof unit_pos; pos).
  assert (HP : forall a, P a <-> 0 < a /\ (r - 1) * dl a = d).
  { intros a. unfold P. split; intros [Ha H]; split; auto; rewrite eq_1_18 in * by auto; auto. }
  assert (Hone : 0 < d / (r - 1) -> r <> 1 -> one P).
  { intros H Hr. destruct (dl_half_onto _ H) as [a [Ha Ea]]. exists a. split.
    - apply HP. split; auto. rewrite Ea. field. lra.
    - intros b Hb. apply HP in Hb. destruct Hb as [Hb Eb]. apply dl_half_injective; auto. rewrite Ea, <- Eb. field. lra. }
  assert (Hsign : forall a, P a -> 0 < d * (r - 1) \/ r = 1).
  { intros a Ha. apply HP in Ha. destruct Ha as [Ha E1]. specialize (Hd a Ha). destruct (Req_dec r 1) as [L|L]; auto. left.
    rewrite <- E1. replace ((r-1) * dl a * (r-1)) with (dl a * (r-1)^2) by ring. apply Rmult_lt_0_compat; auto. apply pow2_gt_0; lra. }
  split; [|split]; intros Hr.
  - assert (Hn : d <= 0 -> none P). { intros H a Ha. destruct (Hsign a Ha) as [K|K]; nra. }
    assert (Ho : 0 < d -> one P). { intros H. apply Hone; [apply Rdiv_lt_0_compat|]; lra. }
    split; split; auto; intros H; apply Rnot_le_lt || apply Rnot_lt_le; intro K.
    destruct H as [a [Ha _]]. apply (Hn K a Ha). destruct (Ho K) as [a [Ha _]]. apply (H a Ha).
  - assert (Hn : 0 <= d -> none P). { intros H a Ha. destruct (Hsign a Ha) as [K|K]; nra. }
    assert (Ho : d < 0 -> one P).
    { intros H. apply Hone; [|lra]. replace (d/(r-1)) with ((- d)/(1 - r)) by (field; lra). apply Rdiv_lt_0_compat; lra. }
    split; split; auto; intros H; apply Rnot_le_lt || apply Rnot_lt_le; intro K.
    destruct H as [a [Ha _]]. apply (Hn K a Ha). destruct (Ho K) as [a [Ha _]]. apply (H a Ha).
  - intros a. rewrite HP, Hr. split; intros [Ha H]; split; auto; lra.
Qed.
End Half.
