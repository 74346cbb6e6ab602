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
End Half.
