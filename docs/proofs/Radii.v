(** The energy over all radii: any profile under a dead load and on a machine, power laws under a dead load, and where the energy of a
    power law has no lower bound. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw MDR.Half MDR.Equilibria MDR.Machine.
Open Scope R_scope.

Section AnyProfile.
Variables E w k D F0 : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (Hk : 0 <= k).
Variable g : R -> R.
Hypothesis Hg : forall x, continuous g x.
Notation dl := (dl E w).
Notation F := (F E g).
Notation dstar := (dstar E k D F0 g).
(** The energy of contact and machine at the indentation at which the forces balance, as a function of the contact radius. *)
Let T a := total E w k D F0 g a (dstar a).
(** The control along the equilibria: k times the position d + F/k of the machine; for k = 0, a dead load, the force. *)
Let control a := k * (g a - dl a) + F a (g a - dl a).

Lemma control_balance a : 0 < a -> (k + 2*E*a) * (dstar a - (g a - dl a)) = k*D + F0 - control a.
Proof.
  intros Ha. assert (HF : F a (g a - dl a) = 2*E*(a * (g a - dl a) - RInt g 0 a)).
  { unfold Definitions.F. f_equal. apply is_RInt_unique.
    replace (a * (g a - dl a)) with (scal (a - 0) (g a - dl a)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_minus (V := R_NormedModule) (fun _ => g a - dl a)).
    apply (is_RInt_const (V := R_NormedModule)).
    apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto. }
  unfold control. rewrite HF. unfold Machine.dstar. field. nra.
Qed.

Lemma total_mvt a b : 0 < a -> a < b -> exists x, a < x < b /\ T b - T a = E*((dstar x - g x)^2 - (dl x)^2) * (b - a).
Proof.
  intros Ha Hab. destruct (MVT_cor2 T (fun x => E*((dstar x - g x)^2 - (dl x)^2)) a b Hab) as [x [H1 H2]].
  - intros x Hx. apply is_derive_Reals. apply (total_derive E w k D F0 HE Hw Hk g Hg). lra.
  - exists x. auto.
Qed.

(** Where the control of every equilibrium between two radii is above the given one, k D + F0, the energy grows from the one to the
    other: the contact shrinks. Under a dead load below, or at a position beyond, those of all equilibria it breaks. *)
Theorem machine_breaks a b : 0 < a -> a < b -> (forall x, a < x < b -> k*D + F0 < control x) -> T a < T b.
Proof.
  intros Ha Hab H. destruct (total_mvt a b Ha Hab) as [x [Hx He]]. specialize (H x Hx).
  pose proof (control_balance x ltac:(lra)) as Hc. pose proof (dl_pos E w HE Hw x ltac:(lra)) as Hl.
  assert (Hp : 0 < k + 2*E*x) by nra. assert (Hd : dstar x - (g x - dl x) < 0) by nra.
  assert (0 < E*((dstar x - g x)^2 - (dl x)^2)).
  { apply Rmult_lt_0_compat; auto. replace ((dstar x - g x)^2 - (dl x)^2) with ((g x - dl x - dstar x) * (g x + dl x - dstar x)) by ring.
    apply Rmult_lt_0_compat; lra. }
  assert (0 < E*((dstar x - g x)^2 - (dl x)^2) * (b - a)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(** Where it is below the given one, and the edge is not pressed in by more than Δl, the energy falls: the contact grows. *)
Theorem machine_spreads a b : 0 < a -> a < b -> (forall x, a < x < b -> control x < k*D + F0 /\ dstar x < g x + dl x) -> T b < T a.
Proof.
  intros Ha Hab H. destruct (total_mvt a b Ha Hab) as [x [Hx He]]. destruct (H x Hx) as [H1 H2].
  pose proof (control_balance x ltac:(lra)) as Hc. pose proof (dl_pos E w HE Hw x ltac:(lra)) as Hl.
  assert (Hp : 0 < k + 2*E*x) by nra. assert (Hd : 0 < dstar x - (g x - dl x)) by nra.
  assert (0 < E*((dl x)^2 - (dstar x - g x)^2)).
  { apply Rmult_lt_0_compat; auto. replace ((dl x)^2 - (dstar x - g x)^2) with ((dstar x - (g x - dl x)) * (g x + dl x - dstar x)) by ring.
    apply Rmult_lt_0_compat; lra. }
  assert (0 < E*((dl x)^2 - (dstar x - g x)^2) * (b - a)) by (apply Rmult_lt_0_compat; lra).
  replace (E*((dstar x - g x)^2 - (dl x)^2)) with (- (E*((dl x)^2 - (dstar x - g x)^2))) in He by ring. nra.
Qed.
End AnyProfile.

Section PowerLaw.
Variables E w C n : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hn : 0 < n).
Notation kap := (kappa n).
Notation dl := (dl E w).
Notation dn := (dn E w C n).
Notation Fn := (Fn E w C n).
Notation Un := (Un E w C n).
Notation ac := (ac E w C n).
Notation aF := (aF E w C n).
(** g of a power law, with the value 0 below 0. *)
Let g x := kap * C * pw n x.

Lemma law_continuous x : continuous g x.
Proof. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (kap * C) (pw n)). apply continuous_pw; auto. Qed.

Lemma law_force a : 0 < a -> 0 * (g a - dl a) + F E g a (g a - dl a) = Fn a.
Proof.
  intros Ha. rewrite <- (force_Fn E w C n Hn a Ha). unfold F. rewrite Rmult_0_l, Rplus_0_l. f_equal.
  apply RInt_ext. intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra.
  unfold g, Definitions.dn. rewrite !pw_pos by lra. reflexivity.
Qed.

(** n > 1/2, a dead load below the force at the instability, F0 < F(a_F) < 0: the energy with that of the load grows with the radius
    from 0 on. Every contact, of whatever radius, breaks. *)
Theorem load_breaks F0 : 1/2 < n -> F0 < Fn aF -> forall a b, 0 < a -> a < b ->
  total E w 0 0 F0 g a (dstar E 0 0 F0 g a) < total E w 0 0 F0 g b (dstar E 0 0 F0 g b).
Proof.
  intros Hh HF a b Ha Hab. apply (machine_breaks E w 0 0 F0 HE Hw (Rle_refl 0) g law_continuous); auto.
  intros x Hx. rewrite law_force by lra. rewrite Rmult_0_l, Rplus_0_l.
  apply (level Fn aF F0 x (Fn_valley E w C n HE Hw HC Hn Hh) ltac:(lra)). auto.
Qed.

(* a slope of at most -E from some radius on *)
Lemma unbounded d b : 0 < b -> (forall x, b < x -> dn x <= d - 1) -> (forall x, b < x -> d + 1 <= dl x) ->
  forall M, exists c, 0 < c /\ forall a, c < a -> Un a d < M.
Proof.
  intros Hb H1 H2 M. exists (b + Rmax 0 ((Un b d - M) / E)). pose proof (Rmax_l 0 ((Un b d - M) / E)). pose proof (Rmax_r 0 ((Un b d - M) / E)).
  split. lra. intros a Ha. assert (Hab : b < a) by lra. destruct (Un_mvt E w C n HE Hw Hn b a d Hb Hab) as [x [Hx He]].
  specialize (H1 x ltac:(lra)). specialize (H2 x ltac:(lra)). pose proof (g_positive C n HC Hn x).
  assert (1 <= (d - dn x) * (kap * C * Rpower x n + dl x - d)) by nra.
  assert (E * (a - b) <= E * ((d - dn x) * (kap * C * Rpower x n + dl x - d)) * (a - b)).
  { apply Rmult_le_compat_r. lra. nra. }
  assert (Hm : (Un b d - M) / E < a - b) by lra. apply (Rmult_lt_compat_l E) in Hm; auto.
  replace (E * ((Un b d - M) / E)) with (Un b d - M) in Hm by (field; lra).
  replace (E * (dn x - d) * (kap * C * Rpower x n + dl x - d) * (a - b))
    with (- (E * ((d - dn x) * (kap * C * Rpower x n + dl x - d)) * (a - b))) in He by ring. lra.
Qed.

Lemma dl_above y : 0 <= y -> exists b, 0 < b /\ forall x, b < x -> y <= dl x.
Proof.
  intros Hy. pose proof PI_RGT_0. exists ((y^2 + 1) * E / (2 * PI * w)).
  assert (0 < 2 * PI * w) by nra. assert (0 < (y^2 + 1) * E / (2 * PI * w)) by (apply Rdiv_lt_0_compat; nra).
  split; auto. intros x Hx. unfold Definitions.dl. rewrite <- (sqrt_pow2 y Hy). apply sqrt_le_1_alt.
  apply (Rmult_lt_compat_l (2 * PI * w)) in Hx; auto.
  replace (2 * PI * w * ((y^2 + 1) * E / (2 * PI * w))) with ((y^2 + 1) * E) in Hx by (field; lra).
  apply (Rmult_le_reg_r E); auto. replace (2 * PI * x * w / E * E) with (2 * PI * w * x) by (field; lra). nra.
Qed.

(** n < 1/2: at every indentation the energy has no lower bound; the larger the contact, the further below. *)
Theorem energy_unbounded d : n < 1/2 -> forall M, exists c, 0 < c /\ forall a, c < a -> Un a d < M.
Proof.
  intros Hh. pose proof (dn_hill E w C n HE Hw HC Hn Hh) as V.
  set (e := Rmax (1 - d) 0). assert (He : 0 <= e /\ 1 - d <= e) by (unfold e; split; [apply Rmax_r | apply Rmax_l]).
  assert (O : one (fun a => 0 < a /\ - dn a = e)) by (apply (count_iff _ _ e V); lra).
  destruct O as [a1 [[A1 D1] _]].
  assert (M1 : ac < a1).
  { apply Rnot_le_lt. intros L. destruct V as [Hm [K [q [p [v [HK [Hq [Hp [Hmu Hf]]]]]]]]]. rewrite Hf in D1 by auto.
    pose proof (valley_negative K q p v (ln ac) HK Hq Hp Hmu (ln a1) (ln_le a1 ac A1 L)). lra. }
  set (y := Rmax (d + 1) 0). assert (Hy : 0 <= y /\ d + 1 <= y) by (unfold y; split; [apply Rmax_r | apply Rmax_l]).
  destruct (dl_above y (proj1 Hy)) as [b [Hb L]].
  apply (unbounded d (Rmax a1 b)).
  - pose proof (Rmax_l a1 b). lra.
  - intros x Hx. pose proof (Rmax_l a1 b). destruct (level _ _ e x V ltac:(lra)) as [_ [_ L2]]. pose proof (proj2 (L2 a1 D1 M1) ltac:(lra)). lra.
  - intros x Hx. pose proof (Rmax_r a1 b). specialize (L x ltac:(lra)). lra.
Qed.
End PowerLaw.

(** n = 1/2 below the threshold: neither has it there. *)
Theorem energy_half_unbounded E w C d : 0 < E -> 0 < w -> 0 < C -> rho E w C (/2) < 1 ->
  forall M, exists c, 0 < c /\ forall a, c < a -> Un E w C (/2) a d < M.
Proof.
  intros HE Hw HC Hr. set (r := rho E w C (/2)) in *.
  set (y := Rmax (Rmax (d + 1) ((1 - d) / (1 - r))) 0).
  assert (Hy : 0 <= y /\ d + 1 <= y /\ (1 - d) / (1 - r) <= y).
  { unfold y. pose proof (Rmax_l (Rmax (d + 1) ((1 - d) / (1 - r))) 0). pose proof (Rmax_r (Rmax (d + 1) ((1 - d) / (1 - r))) 0).
    pose proof (Rmax_l (d + 1) ((1 - d) / (1 - r))). pose proof (Rmax_r (d + 1) ((1 - d) / (1 - r))). lra. }
  destruct (dl_above E w HE Hw y (proj1 Hy)) as [b [Hb L]].
  apply (unbounded E w C (/2) HE Hw HC ltac:(lra) d b Hb).
  - intros x Hx. rewrite (eq_1_18 E w C HE Hw) by lra. specialize (L x Hx). fold r.
    assert (H : (1 - d) / (1 - r) * (1 - r) <= dl E w x * (1 - r)) by (apply Rmult_le_compat_r; lra).
    replace ((1 - d) / (1 - r) * (1 - r)) with (1 - d) in H by (field; lra). lra.
  - intros x Hx. specialize (L x Hx). lra.
Qed.
