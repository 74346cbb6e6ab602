(** A machine of finite stiffness k, and a dead load (k = 0): stability from the energy, the condition of a fold, and how many folds
    a power law has. Not in the paper, which controls the indentation (k infinite). *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw.
Open Scope R_scope.

Section Machine.
(** A spring of the stiffness k whose far end is at D, and a weight F0; g is any profile. *)
Variables E w k D F0 : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (Hk : 0 <= k).
Variable g : R -> R.
Hypothesis Hg : forall x, continuous g x.
Notation dl := (dl E w).
Notation U := (U E w g).
Notation F := (F E g).

(** The energy of contact and machine, and the indentation at which the forces balance. *)
Definition total a d := U a d - F0 * d + k/2 * (D - d)^2.
Definition dstar a := (k*D + F0 + 2*E*RInt g 0 a)/(k + 2*E*a).
Let G a := RInt g 0 a.
Let dP a := E*((dstar a - g a)^2 - (dl a)^2).

Lemma dstar_derive a : 0 < a -> is_derive dstar a (2*E*(g a - dstar a)/(k+2*E*a)).
Proof.
  intros Ha. assert (HG : is_derive G a (g a)) by (apply RInt_derive; auto).
  assert (Hp : 0 < k + 2*E*a) by nra.
  apply (is_derive_ext (fun a => (k*D + F0 + 2*E*G a)/(k + 2*E*a))). auto.
  auto_derive. repeat split. eexists; exact HG. lra.
  replace (Derive (fun x => G x) a) with (g a) by (symmetry; apply is_derive_unique; exact HG).
  unfold dstar. fold (G a). field. lra.
Qed.

Lemma total_min a d : 0 < a -> total a d - total a (dstar a) = (E*a + k/2) * (d - dstar a)^2.
Proof.
  intros Ha. assert (Hp : 0 < k + 2*E*a) by nra. unfold total. rewrite !U_expanded by auto. fold (G a).
  assert (H : k*D + F0 = (k + 2*E*a) * dstar a - 2*E*G a) by (unfold dstar; fold (G a); field; lra).
  set (Q := RInt _ _ _). set (ds := dstar a) in *. set (Ga := G a) in *.
  transitivity (E*(a*d^2 - a*ds^2 - 2*d*Ga + 2*ds*Ga) - (k*D+F0)*(d - ds) + k/2*(d^2 - ds^2)). field. rewrite H. field.
Qed.

Lemma total_derive a : 0 < a -> is_derive (fun a => total a (dstar a)) a (dP a).
Proof.
  intros Ha. assert (Hp : 0 < k + 2*E*a) by nra. pose proof (dstar_derive a Ha) as Hd.
  assert (HG : is_derive G a (g a)) by (apply RInt_derive; auto).
  set (Q := fun a => RInt (fun x => (g x)^2) 0 a).
  assert (HQ : is_derive Q a ((g a)^2)).
  { apply (RInt_derive (fun x => (g x)^2)). intros x. apply (continuous_ext (fun x => g x * g x)).
    intros; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring.
    apply (continuous_mult (K := R_AbsRing)); auto. }
  assert (H : k*D + F0 = (k + 2*E*a) * dstar a - 2*E*G a) by (unfold dstar; fold (G a); field; lra).
  apply (is_derive_ext (fun a => E*(a*(dstar a)^2 - 2*dstar a*G a + Q a) - PI*a^2*w - F0*dstar a + k/2*(D - dstar a)^2)).
  { intros t. unfold total. rewrite U_expanded by auto. auto. }
  set (ds := dstar) in *. clearbody ds G Q. auto_derive.
  { repeat split; eexists; eassumption. }
  replace (Derive (fun x => ds x) a) with (2*E*(g a - ds a)/(k+2*E*a)) by (symmetry; apply is_derive_unique; exact Hd).
  replace (Derive (fun x => G x) a) with (g a) by (symmetry; apply is_derive_unique; exact HG).
  replace (Derive (fun x => Q x) a) with ((g a)^2) by (symmetry; apply is_derive_unique; exact HQ).
  unfold dP. pose proof (dl_sq E w HE Hw a Ha) as Hs. replace (dl a ^ 2) with (dl a * dl a) by ring. rewrite Hs.
  unfold Definitions.B. set (e := 2*E*(g a - ds a)/(k+2*E*a)) in *.
  replace F0 with ((k + 2*E*a) * ds a - 2*E*G a - k*D) by lra. field. lra.
Qed.

Lemma reduced_curvature a g1 : 0 < a -> is_derive g a g1 -> dstar a = g a - dl a ->
  is_derive dP a (2*E*dl a/(k+2*E*a) * ((k+2*E*a)*(g1 - sqrt (PI*w/(2*E*a))) - 2*E*dl a)).
Proof.
  intros Ha Hg1 Heq. pose proof (dl_derive E w HE Hw a Ha) as Hl. set (s := sqrt _) in *.
  assert (Hp : 0 < k + 2*E*a) by nra.
  assert (Hd : is_derive dstar a (2*E*dl a/(k+2*E*a))).
  { replace (dl a) with (g a - dstar a) by lra. apply dstar_derive; auto. }
  assert (H2 : is_derive (fun a => dstar a - g a) a (2*E*dl a/(k+2*E*a) - g1)).
  { apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)); auto. }
  replace (2*E*dl a/(k+2*E*a)*((k+2*E*a)*(g1 - s) - 2*E*dl a))
    with (E * (minus (INR 2 * (2*E*dl a/(k+2*E*a) - g1) * (dstar a - g a)^pred 2) (INR 2 * s * dl a ^ pred 2))).
  - apply (is_derive_scal (fun a => (dstar a - g a)^2 - (dl a)^2)).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
    apply (is_derive_pow (fun a => dstar a - g a)); auto. apply (is_derive_pow dl); auto.
  - rewrite Heq. unfold minus, plus, opp; simpl. field. lra.
Qed.

(** For a given radius the contact takes the indentation at which the forces balance: there the energy is smallest. The energy
    that is left has the slope of (1.4), so it is stationary by the rule of Heß; and its second derivative in an equilibrium
    is a positive factor times (k + 2Ea)(g' - Δl') - 2EΔl. *)
Theorem machine_energy a : 0 < a ->
  (forall d, d <> dstar a -> total a (dstar a) < total a d) /\
  is_derive (fun a => total a (dstar a)) a (E*((dstar a - g a)^2 - (dl a)^2)) /\
  (forall g1, is_derive g a g1 -> dstar a = g a - dl a ->
    is_derive (fun a => Derive (fun a => total a (dstar a)) a) a
      (2*E*dl a/(k+2*E*a) * ((k+2*E*a)*(g1 - sqrt (PI*w/(2*E*a))) - 2*E*dl a))).
Proof.
  intros Ha. split; [|split].
  - intros d Hd. pose proof (total_min a d Ha). assert (0 < (E*a + k/2) * (d - dstar a)^2); [|lra].
    apply Rmult_lt_0_compat. nra. apply pow2_gt_0; lra.
  - apply total_derive; auto.
  - intros g1 Hg1 He. apply (is_derive_ext_loc dP). 2: apply reduced_curvature; auto.
    exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy.
    symmetry. apply is_derive_unique, total_derive. lra.
Qed.

(** That last expression is k times the slope of the controlled position d + F/k along the equilibria (for k = 0: the slope of
    the force): the equilibrium is stable where the control grows with the radius, and stability ends at a fold. *)
Theorem critical_machine a g1 : 0 < a -> is_derive g a g1 ->
  is_derive (fun a => k * (g a - dl a) + F a (g a - dl a)) a ((k+2*E*a)*(g1 - sqrt (PI*w/(2*E*a))) - 2*E*dl a) /\
  (k+2*E*a)*(g1 - sqrt (PI*w/(2*E*a))) - 2*E*dl a = (k+2*E*a)*(g1 - (k+6*E*a)/(k+2*E*a)*sqrt (PI*w/(2*E*a))).
Proof.
  intros Ha H. pose proof (dl_derive E w HE Hw a Ha) as Hl. pose proof (eq_1_6_slope E w HE Hw g Hg a g1 Ha H) as HF.
  assert (Hs : dl a = 2 * a * sqrt (PI*w/(2*E*a))).
  { unfold Definitions.dl. mono. }
  set (s := sqrt _) in *. split.
  - replace ((k+2*E*a)*(g1 - s) - 2*E*dl a) with (plus (k * (g1 - s)) (2 * E * (a * (g1 - s) - dl a)))
      by (unfold plus; simpl; ring).
    apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)); auto.
    apply (is_derive_scal (fun a => g a - dl a)).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)); auto.
  - rewrite Hs. field. nra.
Qed.
End Machine.

(** How many folds a power law has. With s = e^u = 2Ea/k and μ = n - 1/2 the condition is φ(u) = 0. *)
Definition lam s := (1 + 3*s) / (1 + s).
Definition phi mu c u := mu * u + c - ln (lam (exp u)).
Definition dphi mu u := mu - 2 * exp u / ((1 + exp u) * (1 + 3 * exp u)).

Lemma phi_derive mu c u : is_derive (phi mu c) u (dphi mu u).
Proof.
  pose proof (exp_pos u) as H. unfold phi, lam. auto_derive.
  - split. lra. split; auto. apply Rdiv_lt_0_compat; lra.
  - unfold dphi. field. lra.
Qed.

Lemma rolle mu c u v : u < v -> phi mu c u = 0 -> phi mu c v = 0 -> exists z, u < z < v /\ dphi mu z = 0.
Proof.
  intros Huv Hu Hv. destruct (MVT_cor2 (phi mu c) (dphi mu) u v Huv) as [z [H1 H2]].
  { intros z _. apply is_derive_Reals, phi_derive. }
  exists z. split; auto. rewrite Hu, Hv in H1.
  assert (H3 : dphi mu z * (v - u) = 0) by lra. apply Rmult_integral in H3. destruct H3; lra.
Qed.

(* the zeros of phi' are those of a quadratic polynomial in e^u *)
Lemma dphi_poly mu z : dphi mu z = 0 -> let s := exp z in 3*mu*s^2 - 2*(1-2*mu)*s + mu = 0.
Proof.
  intros H s. pose proof (exp_pos z) as Hs. fold s in Hs.
  assert (H1 : (1+s)*(1+3*s) * dphi mu z = 3*mu*s^2 - 2*(1-2*mu)*s + mu).
  { unfold dphi. fold s. field. lra. }
  rewrite <- H1, H. ring.
Qed.

Lemma quadratic_three A b c0 x y z : x < y -> y < z -> A <> 0 \/ b <> 0 \/ c0 <> 0 ->
  A*x^2 + b*x + c0 = 0 -> A*y^2 + b*y + c0 = 0 -> A*z^2 + b*z + c0 = 0 -> False.
Proof.
  intros Hxy Hyz Hne H1 H2 H3.
  assert (E1 : A*(x+y) + b = 0). { apply Rmult_eq_reg_l with (y-x); [|lra]. replace ((y-x)*(A*(x+y)+b)) with ((A*y^2+b*y+c0)-(A*x^2+b*x+c0)) by ring. lra. }
  assert (E2 : A*(y+z) + b = 0). { apply Rmult_eq_reg_l with (z-y); [|lra]. replace ((z-y)*(A*(y+z)+b)) with ((A*z^2+b*z+c0)-(A*y^2+b*y+c0)) by ring. lra. }
  assert (A = 0). { apply Rmult_eq_reg_l with (z-x); [|lra]. lra. }
  subst A. assert (b = 0) by lra. subst b. lra.
Qed.

Lemma phi_at_most_three mu c u1 u2 u3 u4 : u1 < u2 -> u2 < u3 -> u3 < u4 ->
  phi mu c u1 = 0 -> phi mu c u2 = 0 -> phi mu c u3 = 0 -> phi mu c u4 = 0 -> False.
Proof.
  intros H12 H23 H34 F1 F2 F3 F4.
  destruct (rolle mu c _ _ H12 F1 F2) as [z1 [Hz1 D1]]. destruct (rolle mu c _ _ H23 F2 F3) as [z2 [Hz2 D2]].
  destruct (rolle mu c _ _ H34 F3 F4) as [z3 [Hz3 D3]].
  apply dphi_poly in D1. apply dphi_poly in D2. apply dphi_poly in D3.
  apply (quadratic_three (3*mu) (-2*(1-2*mu)) mu (exp z1) (exp z2) (exp z3)); try (apply exp_increasing; lra); try lra.
Qed.

Lemma h_max s : 0 < s -> 2*s/((1+s)*(1+3*s)) <= 2 - sqrt 3 /\ (s <> / sqrt 3 -> 2*s/((1+s)*(1+3*s)) < 2 - sqrt 3).
Proof.
  intros Hs. assert (Hr : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra). pose proof (sqrt_lt_R0 3 ltac:(lra)) as Hr0.
  set (r := sqrt 3) in *. clearbody r. assert (r < 2) by nra.
  assert (Hp : 0 < (1+s)*(1+3*s)) by nra.
  assert (Hd : 2 - r - 2*s/((1+s)*(1+3*s)) = (2-r)*(1-r*s)^2/((1+s)*(1+3*s))).
  { apply Rmult_eq_reg_r with ((1+s)*(1+3*s)); [|lra]. 
    replace ((2 - r)*(1 - r*s)^2/((1+s)*(1+3*s))*((1+s)*(1+3*s))) with ((2-r)*(1 - 2*r*s + (r*r)*s^2)) by (field; lra).
    replace ((2 - r - 2*s/((1+s)*(1+3*s)))*((1+s)*(1+3*s))) with ((2-r)*((1+s)*(1+3*s)) - 2*s) by (field; lra).
    rewrite Hr. replace ((2-r)*(1-2*r*s+3*s^2)) with (2 - 4*r*s + 6*s^2 - r + 2*(r*r)*s - 3*r*s^2) by ring. rewrite Hr. ring. }
  split.
  - assert (0 <= (2-r)*(1-r*s)^2/((1+s)*(1+3*s))).
    { apply Rmult_le_pos. apply Rmult_le_pos. lra. apply pow2_ge_0. left; apply Rinv_0_lt_compat; auto. } lra.
  - intros Hne. assert (1 - r*s <> 0). { intro K. apply Hne. apply Rmult_eq_reg_l with r; [|lra]. rewrite Rinv_r; lra. }
    assert (0 < (2-r)*(1-r*s)^2/((1+s)*(1+3*s))).
    { apply Rdiv_lt_0_compat; auto. apply Rmult_lt_0_compat. lra. apply pow2_gt_0; auto. } lra.
Qed.

Lemma phi_at_most_one mu c u v : mu <= 0 \/ 2 - sqrt 3 <= mu -> u < v -> phi mu c u = 0 -> phi mu c v = 0 -> False.
Proof.
  intros Hmu Huv Fu Fv. 
  destruct (rolle mu c u v Huv Fu Fv) as [z [Hz D]]. pose proof (exp_pos z) as Hs.
  destruct (h_max (exp z) Hs) as [H1 H2]. unfold dphi in D.
  assert (0 < 2*exp z/((1+exp z)*(1+3*exp z))) by (apply Rdiv_lt_0_compat; nra).
  destruct Hmu as [Hmu|Hmu]. lra.
  (* mu = 2 - sqrt 3 and the only double zero: split the interval there *)
  assert (Hz' : exp z = / sqrt 3). { destruct (Req_dec (exp z) (/ sqrt 3)); auto. specialize (H2 H0). lra. }
  assert (Hpos : forall t, t <> z -> 0 < dphi mu t).
  { intros t Ht. unfold dphi. destruct (h_max (exp t) (exp_pos t)) as [_ K].
    assert (exp t <> / sqrt 3). { rewrite <- Hz'. intro E. apply exp_inv in E. auto. } specialize (K H0). lra. }
  assert (Hinc : forall a b, a < b -> b <= z \/ z <= a -> phi mu c a < phi mu c b).
  { intros a b Hab Hside. destruct (MVT_cor2 (phi mu c) (dphi mu) a b Hab) as [t [E1 E2]].
    { intros t _. apply is_derive_Reals, phi_derive. } assert (0 < dphi mu t) by (apply Hpos; lra). nra. }
  pose proof (Hinc u z ltac:(lra) ltac:(lra)). pose proof (Hinc z v ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma phi_continuity mu c : continuity (phi mu c).
Proof. intros u. apply derivable_continuous_pt. eexists. apply is_derive_Reals, phi_derive. Qed.

Lemma lam_range u : 0 < ln (lam (exp u)) < ln 3.
Proof.
  pose proof (exp_pos u). unfold lam. assert (1 < (1+3*exp u)/(1+exp u) < 3).
  { split; apply Rmult_lt_reg_r with (1+exp u); try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
  split. rewrite <- ln_1. apply ln_increasing; lra. apply ln_increasing; lra.
Qed.

Lemma phi_ends mu c : mu <> 0 -> exists L, 0 < L /\ forall v, L <= v -> phi mu c v * mu > 0 /\ phi mu c (- v) * mu < 0.
Proof.
  intros Hmu. set (L := (Rabs c + ln 3 + 1)/Rabs mu). pose proof (Rabs_pos_lt mu Hmu) as Hm. pose proof (Rabs_pos c) as Hc.
  assert (H3 : 0 < ln 3) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (HL : L * Rabs mu = Rabs c + ln 3 + 1) by (unfold L; field; lra).
  exists L. split. apply Rdiv_lt_0_compat; lra.
  intros v Hv. pose proof (lam_range v) as R1. pose proof (lam_range (-v)) as R2. unfold phi.
  set (l1 := ln (lam (exp v))) in *. set (l2 := ln (lam (exp (-v)))) in *.
  assert (HV : Rabs c + ln 3 + 1 <= v * Rabs mu) by (rewrite <- HL; apply Rmult_le_compat_r; lra).
  pose proof (Rle_abs c). pose proof (Rle_abs (- c)). rewrite Rabs_Ropp in *.
  destruct (Rle_dec 0 mu) as [Hp|Hp].
  - rewrite (Rabs_pos_eq mu) in HV by auto. split; nra.
  - rewrite (Rabs_left mu) in HV by lra. split; nra.
Qed.

Lemma phi_zero mu c u v : u < v -> phi mu c u * phi mu c v < 0 -> exists z, u < z < v /\ phi mu c z = 0.
Proof.
  intros Huv H. destruct (IVT_cor (phi mu c) u v (phi_continuity mu c) ltac:(lra) ltac:(lra)) as [z [Hz1 Hz2]].
  exists z. split; auto. destruct Hz1 as [[H1|H1] [H2|H2]]; try lra; subst; rewrite Hz2 in H; lra.
Qed.

Lemma phi_one mu c : mu <> 0 -> exists u, phi mu c u = 0.
Proof.
  intros Hmu. destruct (phi_ends mu c Hmu) as [L [HL H]]. destruct (H L ltac:(lra)) as [H1 H2].
  destruct (phi_zero mu c (-L) L ltac:(lra)) as [z [_ Hz]]. { nra. } exists z; auto.
Qed.

Lemma phi_three mu : 0 < mu < 2 - sqrt 3 -> exists c u1 u2 u3, u1 < u2 < u3 /\ phi mu c u1 = 0 /\ phi mu c u2 = 0 /\ phi mu c u3 = 0.
Proof.
  intros Hmu. assert (Hr : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra). pose proof (sqrt_lt_R0 3 ltac:(lra)) as Hr0.
  set (r := sqrt 3) in *.
  (* at s = 1/sqrt 3 phi falls, so it is larger a little before than there *)
  set (u0 := - ln r). assert (Hu0 : exp u0 = / r) by (unfold u0; rewrite exp_Ropp, exp_ln; auto).
  assert (Hd : dphi mu u0 < 0).
  { unfold dphi. rewrite Hu0. replace (2 * / r / ((1 + / r) * (1 + 3 * / r))) with (2 - r). lra.
    apply Rmult_eq_reg_r with ((1 + / r) * (1 + 3 * / r)). 2:{ pose proof (Rinv_0_lt_compat r Hr0). nra. }
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by (pose proof (Rinv_0_lt_compat r Hr0); nra).
    replace (1 + 3 * / r) with (1 + r * r * / r) by (rewrite Hr; auto). clearbody r.
    replace (1 + r * r * / r) with (1 + r) by (field; lra).
    apply Rmult_eq_reg_r with r; [|lra]. replace ((2-r)*((1 + / r)*(1+r))*r) with ((2-r)*((1+r)*(1+r))) by (field; lra).
    replace (2 * / r * 1 * r) with 2 by (field; lra).
    replace ((2-r)*((1+r)*(1+r))) with (2 + 3*r - r*(r*r)) by ring. rewrite Hr. ring. }
  assert (Hp : exists p, p < u0 /\ phi mu 0 u0 < phi mu 0 p).
  { pose proof (phi_derive mu 0 u0) as D. apply is_derive_Reals in D.
    destruct (D (- dphi mu u0) ltac:(lra)) as [del Hdel]. pose proof (cond_pos del) as Hdp.
    exists (u0 - del/2). split. lra. specialize (Hdel (- (del/2)) ltac:(lra)).
    rewrite Rabs_Ropp, Rabs_pos_eq in Hdel by lra. specialize (Hdel ltac:(lra)).
    replace (u0 + - (del/2)) with (u0 - del/2) in Hdel by ring. apply Rabs_def2 in Hdel.
    set (x := phi mu 0 (u0 - del/2)) in *. set (y := phi mu 0 u0) in *. destruct Hdel as [Hdel _].
    assert (Hq : (x - y) / - (del/2) < 0) by lra. apply Rnot_le_lt. intro Hxy.
    assert (0 <= (x - y) / - (del/2)).
    { replace ((x - y) / - (del/2)) with ((y - x) * / (del/2)) by (field; lra). apply Rmult_le_pos. lra.
      left. apply Rinv_0_lt_compat. lra. } lra. }
  destruct Hp as [p [Hp1 Hp2]]. set (c := - (phi mu 0 p + phi mu 0 u0)/2). exists c.
  assert (Hc : forall u, phi mu c u = phi mu 0 u + c) by (intros; unfold phi; ring).
  assert (P1 : 0 < phi mu c p) by (rewrite Hc; unfold c; lra). assert (P2 : phi mu c u0 < 0) by (rewrite Hc; unfold c; lra).
  destruct (phi_ends mu c ltac:(lra)) as [L [HL H]].
  set (M := Rmax L (Rmax (1 - p) (u0 + 1))). pose proof (Rmax_l L (Rmax (1 - p) (u0 + 1))). pose proof (Rmax_r L (Rmax (1 - p) (u0 + 1))).
  pose proof (Rmax_l (1 - p) (u0 + 1)). pose proof (Rmax_r (1 - p) (u0 + 1)). fold M in H0, H1.
  destruct (H M ltac:(lra)) as [E1 E2].
  destruct (phi_zero mu c (- M) p ltac:(lra)) as [z1 [Z1 F1]]. { assert (phi mu c (- M) < 0) by nra. nra. }
  destruct (phi_zero mu c p u0 ltac:(lra)) as [z2 [Z2 F2]]. { nra. }
  destruct (phi_zero mu c u0 M ltac:(lra)) as [z3 [Z3 F3]]. { assert (0 < phi mu c M) by nra. nra. }
  exists z1, z2, z3. repeat split; auto; lra.
Qed.

Section Power.
Variables E w C n k : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hn : 0 < n) (Hk : 0 < k).
Notation B := (B E w).
Notation N := (N C n).

(** The position of the machine along the equilibria of a power law. *)
Definition position a := dn E w C n a + Fn E w C n a / k.

(** For a power law the folds are the roots of N a^(n-1) = λ(a) sqrt (B/a), λ = (k + 6Ea)/(k + 2Ea). *)
Theorem critical_machine_power a : 0 < a ->
  is_derive position a ((k+2*E*a)/k * (N * Rpower a (n-1) - (k+6*E*a)/(k+2*E*a)*sqrt (B/a))).
Proof.
  intros Ha. pose proof (B_pos E w HE Hw) as HB.
  replace ((k+2*E*a)/k * (N * Rpower a (n-1) - (k+6*E*a)/(k+2*E*a)*sqrt (B/a)))
    with (plus (slope E w C n a) (/ k * (2 * E * (a * slope E w C n a - dl E w a)))).
  - apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)). apply eq_1_14; auto.
    apply (is_derive_ext (fun a => / k * Fn E w C n a)). intros; apply Rmult_comm.
    apply (is_derive_scal (Fn E w C n)). apply Fn_derive; auto.
  - assert (Hs : dl E w a = 2 * a * sqrt (B/a)).
    { unfold Definitions.dl, Definitions.B. mono. }
    rewrite Hs. unfold slope. replace (PI*w/(2*E*a)) with (B/a) by (unfold Definitions.B; field; lra).
    unfold Definitions.N, plus; simpl. field. split; nra.
Qed.

Definition offset := ln N - /2 * ln B + (n - /2) * ln (k/(2*E)).

Lemma fold_phi a : fold position a <-> 0 < a /\ phi (n - /2) offset (ln (2*E*a/k)) = 0.
Proof.
  pose proof (N_pos C n HC Hn) as HN. pose proof (B_pos E w HE Hw) as HB.
  assert (Hequiv : 0 < a -> ((k+2*E*a)/k * (N * Rpower a (n-1) - (k+6*E*a)/(k+2*E*a)*sqrt (B/a)) = 0
    <-> phi (n - /2) offset (ln (2*E*a/k)) = 0)).
  { intros Ha. assert (Hs : 0 < 2*E*a/k) by pos. unfold phi. rewrite exp_ln by auto.
    assert (Hl : 0 < (k+6*E*a)/(k+2*E*a)) by pos.
    replace (lam (2*E*a/k)) with ((k+6*E*a)/(k+2*E*a)) by (unfold lam; field; nra).
    assert (Hp : phi (n - /2) offset (ln (2*E*a/k)) = ln (N * Rpower a (n-1)) - ln ((k+6*E*a)/(k+2*E*a)*sqrt (B/a))).
    { unfold phi, offset. rewrite exp_ln by auto. replace (lam (2*E*a/k)) with ((k+6*E*a)/(k+2*E*a)) by (unfold lam; field; nra).
      rewrite (ln_mult N), (ln_mult ((k+6*E*a)/(k+2*E*a))), ln_Rpower, ln_sqrt, (ln_div B a), (ln_div (2*E*a)), (ln_mult (2*E)), (ln_div k) by pos.
      field. }
    unfold phi in Hp. rewrite exp_ln in Hp by auto.
    replace (lam (2*E*a/k)) with ((k+6*E*a)/(k+2*E*a)) in Hp by (unfold lam; field; nra). rewrite Hp.
    assert (0 < (k+2*E*a)/k) by pos. split; intros H0.
    - apply Rmult_integral in H0. destruct H0 as [H0|H0]. lra.
      replace (N * Rpower a (n-1)) with ((k+6*E*a)/(k+2*E*a)*sqrt (B/a)) by lra. ring.
    - assert (H1 : ln (N * Rpower a (n-1)) = ln ((k+6*E*a)/(k+2*E*a)*sqrt (B/a))) by lra.
      apply ln_inv in H1; try pos. rewrite H1. ring. }
  unfold fold. split; intros [Ha H]; split; auto.
  - apply Hequiv; auto. pose proof (critical_machine_power a Ha) as H1.
    rewrite <- (is_derive_unique _ _ _ H). symmetry. apply is_derive_unique; auto.
  - apply Hequiv in H; auto. rewrite <- H. apply critical_machine_power; auto.
Qed.

Lemma fold_of u : phi (n - /2) offset u = 0 -> fold position (k * exp u / (2*E)).
Proof.
  intros H. apply fold_phi. pose proof (exp_pos u). split. pos.
  replace (2*E*(k * exp u/(2*E))/k) with (exp u) by (field; lra). rewrite ln_exp. auto.
Qed.

Lemma log_increases a b : 0 < a -> a < b -> ln (2*E*a/k) < ln (2*E*b/k).
Proof. intros Ha Hab. apply ln_increasing. pos. apply Rmult_lt_compat_r. apply Rinv_0_lt_compat; auto. nra. Qed.

(** On a machine of any stiffness a power law has never more than three folds. *)
Theorem machine_folds_at_most_three a1 a2 a3 a4 : a1 < a2 -> a2 < a3 -> a3 < a4 ->
  fold position a1 -> fold position a2 -> fold position a3 -> fold position a4 -> False.
Proof.
  intros H12 H23 H34 F1 F2 F3 F4. apply fold_phi in F1, F2, F3, F4.
  apply (phi_at_most_three (n - /2) offset (ln (2*E*a1/k)) (ln (2*E*a2/k)) (ln (2*E*a3/k)) (ln (2*E*a4/k)));
  try apply log_increases; tauto.
Qed.

(** It has exactly one fold for n < 1/2 and for n >= 5/2 - sqrt 3. *)
Theorem machine_folds_one : n < 1/2 \/ 5/2 - sqrt 3 <= n -> one (fold position).
Proof.
  intros Hr. assert (sqrt 3 < 2). { rewrite <- (sqrt_square 2) by lra. apply sqrt_lt_1; lra. }
  destruct (phi_one (n - /2) offset) as [u Hu]. lra.
  exists (k * exp u / (2*E)). split. apply fold_of; auto.
  assert (Huniq : forall x y, fold position x -> fold position y -> x < y -> False).
  { intros x y Hx Hy Hxy. apply fold_phi in Hx, Hy.
    apply (phi_at_most_one (n - /2) offset (ln (2*E*x/k)) (ln (2*E*y/k))); try tauto. lra. apply log_increases; tauto. }
  intros y Hy. destruct (Rtotal_order y (k * exp u / (2*E))) as [H1|[H1|H1]]; auto; exfalso.
  apply (Huniq _ _ Hy (fold_of u Hu) H1). apply (Huniq _ _ (fold_of u Hu) Hy H1).
Qed.
End Power.

(** Three folds occur: for every exponent 1/2 < n < 5/2 - sqrt 3 and every machine there is a C whose contact has three. *)
Theorem machine_folds_three E w n k : 0 < E -> 0 < w -> 0 < k -> 1/2 < n < 5/2 - sqrt 3 ->
  exists C a1 a2 a3, 0 < C /\ a1 < a2 < a3 /\
    fold (position E w C n k) a1 /\ fold (position E w C n k) a2 /\ fold (position E w C n k) a3.
Proof.
  intros HE Hw Hk Hn. pose proof (kappa_pos n ltac:(lra)) as Hkap.
  destruct (phi_three (n - /2) ltac:(lra)) as [c [u1 [u2 [u3 [Hu [F1 [F2 F3]]]]]]].
  set (C := exp (c + /2 * ln (B E w) - (n - /2) * ln (k/(2*E))) / (n * kappa n)).
  assert (HC : 0 < C). { apply Rdiv_lt_0_compat. apply exp_pos. apply Rmult_lt_0_compat; lra. }
  assert (Hc : offset E w C n k = c).
  { unfold offset, N. replace (n * kappa n * C) with (exp (c + /2 * ln (B E w) - (n - /2) * ln (k/(2*E)))) by (unfold C; field; lra).
    rewrite ln_exp. ring. }
  exists C, (k * exp u1/(2*E)), (k * exp u2/(2*E)), (k * exp u3/(2*E)).
  assert (Hinc : forall x y, x < y -> k * exp x/(2*E) < k * exp y/(2*E)).
  { intros x y Hxy. apply exp_increasing in Hxy. apply Rmult_lt_compat_r. apply Rinv_0_lt_compat; lra. nra. }
  split; auto. split. split; apply Hinc; lra.
  split; [|split]; apply fold_of; auto; try lra; rewrite Hc; auto.
Qed.

(** At n = 1/2 the fold is at k(ρ - 1)/(2E(3 - ρ)) for 1 < ρ < 3, and there is no other and none for other ρ. *)
Theorem machine_half E w C k a : 0 < E -> 0 < w -> 0 < C -> 0 < k ->
  let r := rho E w C (/2) in
  (fold (position E w C (/2) k) a <-> 1 < r < 3 /\ a = k * (r - 1) / (2 * E * (3 - r))).
Proof.
  intros HE Hw HC Hk r. pose proof (B_pos E w HE Hw) as HB. pose proof (kappa_pos (/2) ltac:(lra)) as Hkap.
  assert (HN : forall a, 0 < a -> N C (/2) * Rpower a (/2-1) = r * sqrt (B E w/a)).
  { intros x Hx. unfold r, rho, N. replace (sqrt (2*PI*w/E)) with (2 * sqrt (B E w)).
    2:{ replace (2*PI*w/E) with (2*2*B E w) by (unfold B; field; lra). rewrite sqrt_mult, sqrt_square by lra. auto. }
    replace (Rpower x (/2-1)) with (/ sqrt x).
    2:{ rewrite <- Rpower_sqrt by auto. rewrite <- Rpower_Ropp. f_equal. field. }
    rewrite sqrt_div by lra. pose proof (sqrt_lt_R0 x Hx). pose proof (sqrt_lt_R0 _ HB). field. split; lra. }
  assert (Hd : forall a, 0 < a -> is_derive (position E w C (/2) k) a
    (((r - 1)*k - 2*E*a*(3 - r)) * (sqrt (B E w/a) / k))).
  { intros x Hx. replace (((r - 1)*k - 2*E*x*(3 - r)) * (sqrt (B E w/x) / k))
      with ((k+2*E*x)/k * (N C (/2) * Rpower x (/2-1) - (k+6*E*x)/(k+2*E*x)*sqrt (B E w/x))).
    apply critical_machine_power; auto; lra. rewrite HN by auto. field. split; nra. }
  assert (Hpos : forall a, 0 < a -> 0 < sqrt (B E w/a) / k) by (intros; pos).
  unfold fold. split.
  - intros [Ha H]. pose proof (slope_unique _ _ _ _ (Hd a Ha) H) as H1. specialize (Hpos a Ha).
    apply Rmult_integral in H1. destruct H1 as [H1|H1]; [|lra].
    assert (0 < 2*E*a) by pos. assert (1 < r < 3). { split; apply Rnot_le_lt; intro; nra. }
    split; auto. apply Rmult_eq_reg_r with (2*E*(3-r)). 2: nra. unfold Rdiv. rewrite (Rmult_assoc (k*(r-1))), Rinv_l by nra. lra.
  - intros [Hr Ha]. assert (0 < a) by (rewrite Ha; pos). split; auto.
    replace 0 with (((r - 1)*k - 2*E*a*(3 - r)) * (sqrt (B E w/a) / k)). apply Hd; auto.
    replace ((r-1)*k - 2*E*a*(3-r)) with 0. ring. rewrite Ha. field. lra.
Qed.
