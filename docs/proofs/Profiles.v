(** Section 1 of the paper, (1.1) to (1.3), and profiles: the improper integral (1.1) and its regular form for any smooth profile;
    sphere, cone and paraboloid with a flat, the paraboloid with waves of figure 4; springs and effective modulus. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform.
Open Scope R_scope.

(** (1.1) is improper at r = x. For a continuous f' the integral exists, and is that of the regular form over a quarter turn. *)
Theorem eq_1_1 (f1 : R -> R) x : 0 < x -> (forall r, continuous f1 r) ->
  is_RInt_gen (fun r => f1 r / sqrt (x^2 - r^2)) (at_point 0) (at_left x) (RInt (fun t => f1 (x * sin t)) 0 (PI/2)) /\
  x * RInt_gen (fun r => f1 r / sqrt (x^2 - r^2)) (at_point 0) (at_left x) = transform f1 x.
Proof.
  intros Hx Hf. pose proof PI_RGT_0.
  assert (Hc : forall t, continuous (fun t => f1 (x * sin t)) t).
  { intros t. apply (continuous_comp (fun t => x * sin t) f1); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  set (T := fun u => RInt (fun t => f1 (x * sin t)) 0 u).
  assert (HT : forall u, is_derive T u (f1 (x * sin u))).
  { intros u. apply (is_derive_RInt (V := R_NormedModule) (fun t => f1 (x * sin t)) _ 0); auto.
    exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct (V := R_CompleteNormedModule)).
    apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto. }
  set (Q := fun r => T (angle x r)).
  assert (HQ : forall r, 0 < r < x -> is_derive Q r (f1 r / sqrt (x^2 - r^2))).
  { intros r Hr. destruct (angle_sin_cos x Hx r ltac:(lra)) as [Hs _]. pose proof (q_pos x r ltac:(lra)) as Hq.
    replace (f1 r / sqrt (x^2 - r^2)) with (scal (1 / sqrt (x^2 - r^2)) (f1 (x * sin (angle x r)))).
    - apply (is_derive_comp T (angle x)); auto. apply angle_derive; auto.
    - rewrite Hs. replace (x * (r/x)) with r by (field; lra). set (p := sqrt _) in *. unfold scal; simpl; unfold mult; simpl. field. lra. }
  assert (HQc : forall r, 0 <= r <= x -> continuous Q r).
  { intros r Hr. apply (continuous_comp (angle x) T). apply angle_continuous; auto.
    apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply HT. }
  assert (Hq : forall r, - x < r < x -> 0 < sqrt (x^2 - r^2)) by (intros; apply sqrt_lt_R0; nra).
  assert (Hic : forall r, - x < r < x -> continuous (fun r => f1 r / sqrt (x^2 - r^2)) r).
  { intros r Hr. apply (continuous_mult (K := R_AbsRing) f1 (fun r => / sqrt (x^2 - r^2))); auto.
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive.
    replace (x*(x*1) + - (r*(r*1))) with (x^2 - r^2) by ring. specialize (Hq r Hr). repeat split; auto; try lra. nra. }
  assert (Hproper : forall b, 0 < b < x -> is_RInt (fun r => f1 r / sqrt (x^2 - r^2)) 0 b (Q b)).
  { intros b Hb. replace (Q b) with (minus (Q b) (Q 0)).
    2:{ unfold Q. rewrite angle_0. unfold T at 2. rewrite RInt_point. unfold minus, plus, opp, zero; simpl. ring. }
    (* the primitive from 0 has the same derivative inside, and both are continuous *)
    set (S := fun b => RInt (fun r => f1 r / sqrt (x^2 - r^2)) 0 b).
    assert (Hex : forall c, 0 <= c <= b -> ex_RInt (fun r => f1 r / sqrt (x^2 - r^2)) 0 c).
    { intros c Hc'. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply Hic. lra. }
    assert (HS : forall c, - x < c < x -> is_derive S c (f1 c / sqrt (x^2 - c^2))).
    { intros c Hc'. apply (is_derive_RInt (V := R_NormedModule) (fun r => f1 r / sqrt (x^2 - r^2)) _ 0); auto.
      assert (Hm : 0 < Rmin (c + x) (x - c)) by (apply Rmin_glb_lt; lra).
      exists (mkposreal _ Hm). intros y Hy. change (Rabs (y - c) < Rmin (c + x) (x - c)) in Hy.
      pose proof (Rmin_l (c + x) (x - c)). pose proof (Rmin_r (c + x) (x - c)). apply Rabs_def2 in Hy.
      apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
      intros z Hz. apply Hic. revert Hz. unfold Rmin, Rmax. destruct (Rle_dec 0 y); lra. }
    assert (Hconst : S b - Q b = S 0 - Q 0).
    { destruct (MVT_gen (fun c => S c - Q c) 0 b (fun _ => 0)) as [c [Hc1 Hc2]].
      - intros c Hc'. rewrite Rmin_left, Rmax_right in Hc' by lra.
        replace 0 with (minus (f1 c / sqrt (x^2 - c^2)) (f1 c / sqrt (x^2 - c^2))) by (unfold minus, plus, opp; simpl; ring).
        apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)). apply HS; lra. apply HQ; lra.
      - intros c Hc'. rewrite Rmin_left, Rmax_right in Hc' by lra. apply continuity_pt_filterlim.
        apply (continuous_minus (V := R_NormedModule) S Q). 2: apply HQc; lra.
        apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply HS. lra.
      - lra. }
    replace (minus (Q b) (Q 0)) with (S b).
    2:{ unfold minus, plus, opp; simpl. replace (S 0) with 0 in Hconst. lra. unfold S. rewrite RInt_point. auto. }
    apply (RInt_correct (V := R_CompleteNormedModule)). apply Hex. lra. }
  assert (Hgen : is_RInt_gen (fun r => f1 r / sqrt (x^2 - r^2)) (at_point 0) (at_left x) (RInt (fun t => f1 (x * sin t)) 0 (PI/2))).
  { intros P HP. replace (RInt (fun t => f1 (x * sin t)) 0 (PI/2)) with (Q x) in HP by (unfold Q, T; rewrite angle_x; auto).
    pose proof (HQc x ltac:(lra) P HP) as K. unfold filtermap in K.
    apply (Filter_prod _ _ _ (fun a => a = 0) (fun b => 0 < b < x /\ P (Q b))).
    - unfold at_point. auto.
    - destruct K as [e1 K]. assert (Hm : 0 < Rmin e1 x) by (apply Rmin_glb_lt; auto; apply cond_pos).
      exists (mkposreal _ Hm). intros y Hy Hyx. change (Rabs (y - x) < Rmin e1 x) in Hy.
      pose proof (Rmin_l e1 x). pose proof (Rmin_r e1 x). assert (Rabs (y - x) < e1) by lra. apply Rabs_def2 in Hy. split. lra. apply K; auto.
    - intros a b Ha [Hb HPb]. subst a. exists (Q b). split; auto. }
  split; auto. unfold transform. f_equal. apply is_RInt_gen_unique; auto.
Qed.

(** (1.1) is linear: the transform of a sum is the sum of the transforms, and a factor goes along. *)
Theorem eq_1_1_linear (f1 h1 : R -> R) c x : (forall r, continuous f1 r) -> (forall r, continuous h1 r) ->
  transform (fun r => c * f1 r + h1 r) x = c * transform f1 x + transform h1 x.
Proof.
  intros Hf Hh. unfold transform.
  assert (Hx : forall g1 : R -> R, (forall r : R, continuous g1 r) -> is_RInt (fun t => g1 (x * sin t)) 0 (PI/2) (RInt (fun t => g1 (x * sin t)) 0 (PI/2))).
  { intros g1 Hg. apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros t _. apply (continuous_comp (fun t => x * sin t) g1); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  replace (RInt (fun t => c * f1 (x * sin t) + h1 (x * sin t)) 0 (PI/2))
    with (c * RInt (fun t => f1 (x * sin t)) 0 (PI/2) + RInt (fun t => h1 (x * sin t)) 0 (PI/2)). ring.
  symmetry. apply is_RInt_unique. apply (is_RInt_plus (V := R_NormedModule)); auto.
  apply (is_RInt_scal (V := R_NormedModule) (fun t => f1 (x * sin t))); auto.
Qed.

(** The paraboloid with waves of figure 4, f = r²/2R + A(1 - cos qr): Struve's H_0 is (2/π) ∫ sin (z sin t) dt over a quarter
    turn. *)
Definition struve z := 2 / PI * RInt (fun t => sin (z * sin t)) 0 (PI/2).

Lemma RInt_sin : RInt sin 0 (PI/2) = 1.
Proof.
  pose proof PI_RGT_0. apply is_RInt_unique. replace 1 with (minus (- cos (PI/2)) (- cos 0)).
  2:{ rewrite cos_PI2, cos_0. unfold minus, plus, opp; simpl. ring. }
  apply (is_RInt_derive (fun t => - cos t)). intros; auto_derive; auto; ring.
  intros. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Theorem wavy R0 A q x : 0 < R0 ->
  (forall r, is_derive (fun r => r^2/(2*R0) + A*(1 - cos (q*r))) r (r/R0 + A*q*sin (q*r))) /\
  transform (fun r => r/R0 + A*q*sin (q*r)) x = x^2/R0 + PI/2 * A*q*x * struve (q*x).
Proof.
  intros HR. pose proof PI_RGT_0. split.
  - intros r. auto_derive. auto. field. lra.
  - unfold transform, struve.
    assert (Hc : forall t, continuous (fun t => sin (q*x * sin t)) t).
    { intros t. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
    replace (RInt (fun t => x * sin t/R0 + A*q*sin (q*(x * sin t))) 0 (PI/2))
      with (x/R0 * RInt sin 0 (PI/2) + A*q * RInt (fun t => sin (q*x * sin t)) 0 (PI/2)).
    { rewrite RInt_sin. set (I := RInt _ _ _). field. lra. }
    symmetry. apply is_RInt_unique. apply (is_RInt_ext (fun t => x/R0 * sin t + A*q * sin (q*x * sin t))).
    { intros t _. replace (q*(x * sin t)) with (q*x*sin t) by ring. unfold Rdiv.
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
    apply (is_RInt_plus (V := R_NormedModule) (fun t => x/R0 * sin t)).
    + apply (is_RInt_scal (V := R_NormedModule) sin). apply (RInt_correct (V := R_CompleteNormedModule)).
      apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
    + apply (is_RInt_scal (V := R_NormedModule) (fun t => sin (q*x * sin t))). apply (RInt_correct (V := R_CompleteNormedModule)).
      apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto.
Qed.

(** The sphere, f = R - sqrt (R² - r²): g(x) = x artanh (x/R). *)
Theorem sphere R0 x : 0 < x < R0 ->
  (forall r, 0 < r < R0 -> is_derive (fun r => R0 - sqrt (R0^2 - r^2)) r (r / sqrt (R0^2 - r^2))) /\
  transform (fun r => r / sqrt (R0^2 - r^2)) x = x * (/2 * ln ((1 + x/R0)/(1 - x/R0))).
Proof.
  intros Hx. pose proof PI_RGT_0. split.
  - intros r Hr. assert (0 < R0^2 - r^2) by nra. auto_derive.
    replace (R0*(R0*1) + - (r*(r*1))) with (R0^2 - r^2) by ring. auto.
    replace (R0*(R0*1) + - (r*(r*1))) with (R0^2 - r^2) by ring. field. apply Rgt_not_eq, sqrt_lt_R0; auto.
  - unfold transform. f_equal.
    assert (Ha : forall t, 0 < R0^2 - (x * sin t)^2).
    { intros t. pose proof (SIN_bound t). assert ((x * sin t)^2 <= x^2). { replace ((x * sin t)^2) with (x^2 * (sin t * sin t)) by ring.
        assert (sin t * sin t <= 1) by nra. assert (0 <= x^2) by nra. nra. } nra. }
    assert (Hp : forall t, 0 <= t <= PI/2 -> 0 < x * cos t + sqrt (R0^2 - (x * sin t)^2)).
    { intros t Ht. pose proof (sqrt_lt_R0 _ (Ha t)). assert (0 <= cos t) by (apply cos_ge_0; lra). nra. }
    apply is_RInt_unique.
    replace (/2 * ln ((1 + x/R0)/(1 - x/R0))) with (minus (- ln (x * cos (PI/2) + sqrt (R0^2 - (x * sin (PI/2))^2))) (- ln (x * cos 0 + sqrt (R0^2 - (x * sin 0)^2)))).
    2:{ rewrite cos_PI2, sin_PI2, cos_0, sin_0.
        replace (R0^2 - (x*0)^2) with (R0*R0) by ring. rewrite sqrt_square by lra.
        replace (x*0 + sqrt (R0^2 - (x*1)^2)) with (sqrt ((R0 - x)*(R0 + x))) by (rewrite Rmult_0_r, Rplus_0_l; f_equal; ring).
        replace ((1 + x/R0)/(1 - x/R0)) with ((R0 + x)/(R0 - x)) by (field; lra).
        rewrite ln_sqrt, ln_mult, ln_div by (try apply Rmult_lt_0_compat; lra). replace (x*1 + R0) with (R0 + x) by ring.
        unfold minus, plus, opp; simpl. field. }
    apply (is_RInt_derive (fun t => - ln (x * cos t + sqrt (R0^2 - (x * sin t)^2)))).
    + intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. specialize (Ha t). specialize (Hp t Ht). pose proof (sqrt_lt_R0 _ Ha) as Hs.
      auto_derive.
      * replace (R0*(R0*1) + - (x * sin t*(x * sin t*1))) with (R0^2 - (x * sin t)^2) by ring. auto.
      * replace (R0*(R0*1) + - (x * sin t*(x * sin t*1))) with (R0^2 - (x * sin t)^2) by ring.
        set (s := sqrt (R0^2 - (x * sin t)^2)) in *. field. lra.
    + intros t _. apply (ex_derive_continuous (V := R_NormedModule)). specialize (Ha t). auto_derive.
      replace (R0*(R0*1) + - (x * sin t*(x * sin t*1))) with (R0^2 - (x * sin t)^2) by ring. repeat split; auto.
      apply Rgt_not_eq, sqrt_lt_R0; auto.
Qed.

(** A profile that is flat up to b and from there on has the slope f1: in (1.1) only radii above b count. *)
Definition flat_to b (f1 : R -> R) r := if Rle_dec r b then 0 else f1 r.

Lemma flat_inner b f1 x (Fp : R -> R) : 0 < b < x ->
  (forall t, is_derive Fp t (f1 (x * sin t))) -> (forall t, continuous (fun t => f1 (x * sin t)) t) ->
  is_RInt (fun t => flat_to b f1 (x * sin t)) 0 (PI/2) (Fp (PI/2) - Fp (asin (b/x))).
Proof.
  intros Hb HF Hc. pose proof PI_RGT_0. set (tb := asin (b/x)).
  assert (Hbx : 0 < b/x < 1). { split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with x. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (Hsb : sin tb = b/x) by (apply sin_asin; lra).
  assert (Htb : 0 < tb < PI/2).
  { pose proof (asin_bound_lt (b/x) ltac:(lra)) as Hbd. fold tb in Hbd. split; [|lra]. apply Rnot_le_lt. intro L.
    pose proof (sin_incr_1 tb 0 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) L) as K. rewrite Hsb, sin_0 in K. lra. }
  replace (Fp (PI/2) - Fp tb) with (plus 0 (minus (Fp (PI/2)) (Fp tb))) by (unfold minus, plus, opp; simpl; ring).
  apply (is_RInt_Chasles (V := R_NormedModule) _ 0 tb (PI/2)).
  - apply (is_RInt_ext (fun _ => 0)).
    { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. unfold flat_to. destruct Rle_dec; auto.
      exfalso. apply n. assert (sin t < sin tb) by (apply sin_increasing_1; lra). rewrite Hsb in H0.
      apply Rmult_lt_compat_l with (r := x) in H0; [|lra]. replace (x*(b/x)) with b in H0 by (field; lra). lra. }
    replace 0 with (scal (tb - 0) 0) at 2 by (unfold scal; simpl; unfold mult; simpl; ring). apply (is_RInt_const (V := R_NormedModule)).
  - apply (is_RInt_ext (fun t => f1 (x * sin t))).
    { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. unfold flat_to. destruct Rle_dec; auto.
      exfalso. assert (sin tb < sin t) by (apply sin_increasing_1; lra). rewrite Hsb in H0.
      apply Rmult_lt_compat_l with (r := x) in H0; [|lra]. replace (x*(b/x)) with b in H0 by (field; lra). lra. }
    apply (is_RInt_derive Fp); auto.
Qed.

Lemma flat_transform b f1 x (Fp : R -> R) : 0 < b < x ->
  (forall t, is_derive Fp t (f1 (x * sin t))) -> (forall t, continuous (fun t => f1 (x * sin t)) t) ->
  transform (flat_to b f1) x = x * (Fp (PI/2) - Fp (asin (b/x))).
Proof. intros Hb HF Hc. unfold transform. f_equal. apply is_RInt_unique. apply flat_inner; auto. Qed.

(** The cone with a flat, slope s beyond b: g(x) = s x arccos (b/x). *)
Theorem cone_with_flat s b x : 0 < b < x -> transform (flat_to b (fun _ => s)) x = s * x * acos (b/x).
Proof.
  intros Hb. assert (Hbx : 0 < b/x < 1). { split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with x. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  rewrite (flat_transform b (fun _ => s) x (fun t => s * t)); auto.
  - rewrite acos_asin by lra. field.
  - intros t. auto_derive; auto. ring.
  - intros t. apply continuous_const.
Qed.

(** The paraboloid with a flat, (r² - b²)/2R beyond b: g(x) = (x/R) sqrt (x² - b²). *)
Theorem paraboloid_with_flat R0 b x : 0 < R0 -> 0 < b < x -> transform (flat_to b (fun r => r/R0)) x = x/R0 * sqrt (x^2 - b^2).
Proof.
  intros HR Hb. assert (Hbx : 0 < b/x < 1). { split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with x. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  rewrite (flat_transform b (fun r => r/R0) x (fun t => - (x/R0) * cos t)); auto.
  - rewrite cos_PI2, cos_asin by lra. replace (1 - (b/x)²) with ((x^2 - b^2)/(x*x)) by (unfold Rsqr; field; lra).
    rewrite sqrt_div, sqrt_square by nra. field. lra.
  - intros t. auto_derive; auto. field. lra.
  - intros t. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
Qed.

(** (1.2): springs of the stiffness E dx from -a to a have together the stiffness 2Ea of the flat punch. *)
Theorem eq_1_2 E a : RInt (fun _ => E) (- a) a = 2 * E * a.
Proof. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. Qed.

(** (1.3): the compliances of the two bodies add up. *)
Theorem eq_1_3 E1 E2 nu1 nu2 E : 0 < E1 -> 0 < E2 -> -1 < nu1 < 1 -> -1 < nu2 < 1 -> E <> 0 ->
  (1 / E = (1 - nu1^2) / E1 + (1 - nu2^2) / E2 <-> E = E1 * E2 / (E2 * (1 - nu1^2) + E1 * (1 - nu2^2))).
Proof.
  intros H1 H2 Hn1 Hn2 HE. assert (0 < E2 * (1 - nu1^2) + E1 * (1 - nu2^2)) by (assert (0 < 1 - nu1^2) by nra; assert (0 < 1 - nu2^2) by nra; nra).
  replace ((1 - nu1^2) / E1 + (1 - nu2^2) / E2) with ((E2 * (1 - nu1^2) + E1 * (1 - nu2^2)) / (E1 * E2)) by (field; lra).
  set (s := E2 * (1 - nu1^2) + E1 * (1 - nu2^2)) in *. split; intros K.
  - replace E with (/ (1 / E)) by (field; auto). rewrite K. field. repeat split; lra.
  - rewrite K. field. repeat split; lra.
Qed.
