(** Section 4 of the paper, n = 1/2: the energy over all radii, at every indentation. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw MDR.Half MDR.Equilibria.
Open Scope R_scope.

Section HalfEnergy.
Variables E w C : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C).
Notation kap := (kappa (/2)).
Notation dl := (dl E w).
Notation dn := (dn E w C (/2)).
Notation Un := (Un E w C (/2)).
Notation rho := (rho E w C (/2)).
Let half_pos : 0 < /2.
Proof. lra. Qed.

Lemma dl_half_grows a b : 0 < a -> a < b -> 0 < dl a < dl b.
Proof.
  intros Ha Hab. pose proof (unit_pos E w HE Hw) as Hu. rewrite !(dl_half E w HE Hw) by lra.
  pose proof (sqrt_lt_R0 a Ha). pose proof (sqrt_lt_1 a b ltac:(lra) ltac:(lra) Hab). split; nra.
Qed.

(* the sign of the slope of the energy beside the one equilibrium *)
Lemma half_equilibrium d : 0 < d / (rho - 1) -> rho <> 1 ->
  exists a1, 0 < a1 /\ dn a1 = d /\ forall x, 0 < x -> dn x - d = (rho - 1) * (dl x - dl a1).
Proof.
  intros Hd Hr. destruct (dl_half_onto E w HE Hw _ Hd) as [a1 [A1 D1]]. exists a1. split; auto.
  assert (E1 : dn a1 = d). { rewrite (eq_1_18 E w C HE Hw a1 A1), D1. field. lra. }
  split; auto. intros x Hx. rewrite <- E1, !(eq_1_18 E w C HE Hw) by auto. ring.
Qed.

(* from the contact without adhesion on, g(a) = d, the energy falls where the equilibrium indentation is below d *)
Lemma half_falls a b d : 0 < a -> d <= kap * C * Rpower a (/2) -> a < b -> (forall x, a < x < b -> dn x < d) -> Un b d < Un a d.
Proof.
  intros Ha Hg Hab H. apply (Un_falls E w C (/2) HE Hw half_pos); auto. intros x Hx. split. auto.
  pose proof (g_grows C (/2) HC half_pos a x Ha ltac:(lra)). pose proof (dl_half_grows a x Ha ltac:(lra)). lra.
Qed.

(** n = 1/2 above the threshold, C > (1/κ_½) sqrt (2πw/E): at every d > 0 the one equilibrium is a minimum of the energy over all
    radii; at every d <= 0 the energy grows with the radius from 0 on, every contact breaks. *)
Theorem energy_half_above d : 1 < rho ->
  (0 < d -> exists a1, 0 < a1 /\ dn a1 = d /\
    (forall a b, 0 < a -> d <= kap * C * Rpower a (/2) -> a < b -> b <= a1 -> Un b d < Un a d) /\
    (forall a b, a1 <= a -> a < b -> Un a d < Un b d)) /\
  (d <= 0 -> forall a b, 0 < a -> a < b -> Un a d < Un b d).
Proof.
  intros Hr. split; intros Hd.
  - destruct (half_equilibrium d) as [a1 [A1 [D1 S]]]. apply Rdiv_lt_0_compat; lra. lra. exists a1. repeat split; auto.
    + intros a b Ha Hg Hab Hb. apply half_falls; auto. intros x Hx. specialize (S x ltac:(lra)).
      pose proof (dl_half_grows x a1 ltac:(lra) ltac:(lra)). nra.
    + intros a b Ha Hab. apply (Un_grows E w C (/2) HE Hw half_pos); auto; try lra. intros x Hx. specialize (S x ltac:(lra)).
      pose proof (dl_half_grows a1 x A1 ltac:(lra)). nra.
  - intros a b Ha Hab. apply (Un_grows E w C (/2) HE Hw half_pos); auto. intros x Hx.
    rewrite (eq_1_18 E w C HE Hw) by lra. pose proof (dl_half_grows a x Ha ltac:(lra)). nra.
Qed.

(** n = 1/2 below the threshold: at every d < 0 the one equilibrium is a barrier, a smaller contact shrinks to nothing and a larger
    one becomes complete; at every d >= 0 the energy falls without end, every contact becomes complete. *)
Theorem energy_half_below d : rho < 1 ->
  (d < 0 -> exists a1, 0 < a1 /\ dn a1 = d /\
    (forall a b, 0 < a -> a < b -> b <= a1 -> Un a d < Un b d) /\
    (forall a b, a1 <= a -> a < b -> Un b d < Un a d)) /\
  (0 <= d -> forall a b, 0 < a -> d <= kap * C * Rpower a (/2) -> a < b -> Un b d < Un a d).
Proof.
  intros Hr. split; intros Hd.
  - destruct (half_equilibrium d) as [a1 [A1 [D1 S]]].
    { replace (d / (rho - 1)) with ((- d) / (1 - rho)) by (field; lra). apply Rdiv_lt_0_compat; lra. } lra. exists a1. repeat split; auto.
    + intros a b Ha Hab Hb. apply (Un_grows E w C (/2) HE Hw half_pos); auto. intros x Hx. specialize (S x ltac:(lra)).
      pose proof (dl_half_grows x a1 ltac:(lra) ltac:(lra)). nra.
    + intros a b Ha Hab. apply half_falls; auto; try lra. pose proof (g_positive C (/2) HC half_pos a). lra.
      intros x Hx. specialize (S x ltac:(lra)). pose proof (dl_half_grows a1 x A1 ltac:(lra)). nra.
  - intros a b Ha Hg Hab. apply half_falls; auto. intros x Hx.
    rewrite (eq_1_18 E w C HE Hw) by lra. pose proof (dl_half_grows a x Ha ltac:(lra)). nra.
Qed.

(** n = 1/2 at the threshold: at d < 0 every contact breaks, at d > 0 every contact becomes complete, and at d = 0 all radii have
    the same energy. *)
Theorem energy_half_threshold d : rho = 1 ->
  (d < 0 -> forall a b, 0 < a -> a < b -> Un a d < Un b d) /\
  (0 < d -> forall a b, 0 < a -> d <= kap * C * Rpower a (/2) -> a < b -> Un b d < Un a d) /\
  (d = 0 -> forall a b, 0 < a -> 0 < b -> Un a d = Un b d).
Proof.
  intros Hr. assert (S : forall x, 0 < x -> dn x = 0) by (intros; rewrite (eq_1_18 E w C HE Hw), Hr by auto; ring).
  split; [|split]; intros Hd.
  - intros a b Ha Hab. apply (Un_grows E w C (/2) HE Hw half_pos); auto. intros x Hx. rewrite S; lra.
  - intros a b Ha Hg Hab. apply half_falls; auto. intros x Hx. rewrite S; lra.
  - assert (K : forall a b, 0 < a -> a < b -> Un b d = Un a d).
    { intros a b Ha Hab. destruct (Un_mvt E w C (/2) HE Hw half_pos a b d Ha Hab) as [x [Hx Hu]]. rewrite (S x ltac:(lra)), Hd in Hu.
      subst d. lra. }
    intros a b Ha Hb. destruct (Rtotal_order a b) as [L|[L|L]]. symmetry; auto. subst; auto. auto.
Qed.
End HalfEnergy.
