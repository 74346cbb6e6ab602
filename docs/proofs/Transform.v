(** Section 1 of the paper, the transform (1.1): the improper integral as it is printed, its regular form, power laws (1.12),
    and the profiles that the paper and its discussion use. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa.
Open Scope R_scope.

(* theta with sin(theta) = r/x: twice the angle whose tangent is r/(x + sqrt(x^2 - r^2)), continuous up to r = x *)
Definition angle x r := 2 * atan (r / (x + sqrt (x^2 - r^2))).

Lemma half_angle u : sin (2 * atan u) = 2*u/(1+u^2) /\ cos (2 * atan u) = (1-u^2)/(1+u^2).
Proof.
  rewrite sin_2a, cos_2a, sin_atan, cos_atan. unfold Rsqr.
  assert (H : 0 < 1 + u*u) by nra. pose proof (sqrt_lt_R0 _ H) as Hs. pose proof (sqrt_sqrt (1+u*u) ltac:(lra)) as Hq.
  set (q := sqrt (1+u*u)) in *. replace (1+u^2) with (q*q) by (rewrite Hq; ring).
  split. field; lra. 
  replace (1/q*(1/q) - u/q*(u/q)) with ((1-u^2)/(q*q)) by (field; lra). auto.
Qed.

Section T.
Variables x : R.
Hypothesis Hx : 0 < x.
Notation q r := (sqrt (x^2 - r^2)).

Lemma q_sq r : 0 <= r <= x -> q r * q r = x^2 - r^2.
Proof. intros. apply sqrt_sqrt. nra. Qed.
Lemma q_pos r : 0 <= r < x -> 0 < q r.
Proof. intros. apply sqrt_lt_R0. nra. Qed.

Lemma angle_sin_cos r : 0 <= r < x -> sin (angle x r) = r/x /\ cos (angle x r) = q r/x.
Proof.
  intros Hr. pose proof (q_sq r ltac:(lra)) as H1. pose proof (q_pos r ltac:(lra)) as H2.
  unfold angle. destruct (half_angle (r / (x + q r))) as [-> ->]. set (p := q r) in *.
  assert (H3 : 1 + (r/(x+p))^2 = 2*x/(x+p)).
  { apply Rmult_eq_reg_r with ((x+p)^2). 2:{ apply pow_nonzero; lra. }
    replace ((1+(r/(x+p))^2)*(x+p)^2) with ((x+p)^2 + r^2) by (field; lra).
    replace (2*x/(x+p)*(x+p)^2) with (2*x*(x+p)) by (field; lra).
    replace (r^2) with (x^2 - p*p) by lra. ring. }
  rewrite H3. split. field; lra.
  replace (1 - (r/(x+p))^2) with (2*p/(x+p)). field; lra.
  apply Rmult_eq_reg_r with ((x+p)^2). 2:{ apply pow_nonzero; lra. }
  replace ((1-(r/(x+p))^2)*(x+p)^2) with ((x+p)^2 - r^2) by (field; lra).
  replace (2*p/(x+p)*(x+p)^2) with (2*p*(x+p)) by (field; lra).
  replace (r^2) with (x^2 - p*p) by lra. ring.
Qed.

Lemma angle_derive r : 0 < r < x -> is_derive (angle x) r (1 / q r).
Proof.
  intros Hr. pose proof (q_sq r ltac:(lra)) as H1. pose proof (q_pos r ltac:(lra)) as H2.
  unfold angle. auto_derive.
  - replace (x*(x*1) + - (r*(r*1))) with (x^2 - r^2) by ring. repeat split; auto. nra. lra.
  - replace (x*(x*1) + - (r*(r*1))) with (x^2 - r^2) by ring. set (p := q r) in *.
    assert (H3 : 1 + (r * / (x+p)) ^2 = 2*x/(x+p)).
    { apply Rmult_eq_reg_r with ((x+p)^2). 2:{ apply pow_nonzero; lra. }
      replace ((1+(r */(x+p))^2)*(x+p)^2) with ((x+p)^2 + r^2) by (field; lra).
      replace (2*x/(x+p)*(x+p)^2) with (2*x*(x+p)) by (field; lra).
      replace (r^2) with (x^2 - p*p) by lra. ring. }
    replace (1 + r * / (x+p) * (r * / (x+p) * 1)) with (2*x/(x+p)) by (rewrite <- H3; ring).
    replace (r * (- (- (1 * ((1+1) * (r*1))) * / (2*p)) * / ((x+p)*(x+p)))) with (r^2/p/((x+p)*(x+p))) by (field; lra).
    replace (r^2) with (x^2 - p*p) by lra. field. lra.
Qed.

Lemma angle_continuous r : 0 <= r <= x -> continuous (angle x) r.
Proof.
  intros Hr. unfold angle. pose proof (sqrt_pos (x^2 - r^2)) as H.
  apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) 2 (fun r => atan (r / (x + q r)))).
  apply (continuous_comp (fun r => r / (x + q r)) atan).
  - apply (continuous_mult (K := R_AbsRing) (fun r => r) (fun r => / (x + q r))). apply continuous_id.
    apply continuous_Rinv_comp; [|lra].
    apply (continuous_plus (V := R_NormedModule) (fun _ => x) (fun r => q r)). apply continuous_const.
    apply (continuous_comp (fun r => x^2 - r^2) sqrt). 
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. apply continuous_sqrt.
  - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Variables C n : R.
Hypotheses (Hn : 0 < n).

(* an antiderivative of n sin^(n-1) up to both ends, by the parts of 1.1 *)
Definition H t := cos t * pw n (sin t) + (n+1) * RInt (fun t => pw (n+1) (sin t)) 0 t.

Lemma H_derive t : 0 < t < PI/2 -> is_derive H t (n * Rpower (sin t) (n-1)).
Proof.
  intros Ht. assert (Hs : 0 < sin t) by (apply sin_gt_0; lra).
  replace (n * Rpower (sin t) (n-1)) with
    ((- sin t * pw n (sin t) + cos t * (cos t * (n * Rpower (sin t) (n-1)))) + (n+1) * pw (n+1) (sin t)).
  - apply (is_derive_plus (K := R_AbsRing) (V := R_NormedModule)).
    + apply (is_derive_mult cos (fun t => pw n (sin t))).
      * auto_derive; auto; ring.
      * apply (is_derive_comp (pw n) sin). 2: auto_derive; auto; ring.
        apply (is_derive_ext_loc (fun y => Rpower y n)). 2: apply is_derive_Rpower; auto.
        exists (mkposreal _ Hs). intros y Hy. change (Rabs (y - sin t) < sin t) in Hy. apply Rabs_def2 in Hy.
        symmetry. apply pw_pos. lra.
      * intros; apply Rmult_comm.
    + apply (is_derive_scal (fun t => RInt (fun t => pw (n+1) (sin t)) 0 t)).
      apply (is_derive_RInt (V := R_NormedModule) (fun t => pw (n+1) (sin t)) _ 0).
      * exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_W. lra.
      * apply cont_pw_sin. lra.
  - rewrite !pw_pos by auto. replace (Rpower (sin t) (n+1)) with (Rpower (sin t) (n-1) * (sin t * sin t)).
    2:{ rewrite <- (Rpower_1 (sin t)) at 2 3 by auto. rewrite <- !Rpower_plus. f_equal. ring. }
    replace (Rpower (sin t) n) with (Rpower (sin t) (n-1) * sin t).
    2:{ rewrite <- (Rpower_1 (sin t)) at 2 by auto. rewrite <- !Rpower_plus. f_equal. ring. }
    pose proof (sin2_cos2 t) as H1. unfold Rsqr in H1. set (P := Rpower (sin t) (n-1)).
    replace (cos t * (cos t * (n * P))) with ((1 - sin t * sin t) * (n * P)) by (replace (1 - sin t * sin t) with (cos t * cos t) by lra; ring).
    ring.
Qed.

Lemma H_continuous t : continuous H t.
Proof.
  apply (continuous_plus (V := R_NormedModule)).
  - apply (continuous_mult (K := R_AbsRing) cos (fun t => pw n (sin t))). 
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. apply cont_pw_sin; auto.
  - apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule)).
    apply (ex_derive_continuous (V := R_NormedModule)). eexists.
    apply (is_derive_RInt (V := R_NormedModule) (fun t => pw (n+1) (sin t)) _ 0).
    + exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_W. lra.
    + apply cont_pw_sin. lra.
Qed.

Lemma H_0 : H 0 = 0.
Proof. unfold H. rewrite sin_0, pw_neg, RInt_point by lra. unfold zero; simpl. ring. Qed.
Lemma H_end : H (PI/2) = kappa n.
Proof. unfold H. rewrite cos_PI2. unfold kappa, W. ring. Qed.

Definition integrand r := n * C * Rpower r (n-1) / q r.
Definition Phi r := C * Rpower x (n-1) * H (angle x r).

Lemma angle_0 : angle x 0 = 0.
Proof. unfold angle, Rdiv. rewrite Rmult_0_l, atan_0. ring. Qed.
Lemma angle_x : angle x x = PI/2.
Proof.
  unfold angle. replace (x^2 - x^2) with 0 by ring. rewrite sqrt_0.
  replace (x/(x+0)) with 1 by (field; lra). rewrite atan_1. field.
Qed.

Lemma angle_range r : 0 < r < x -> 0 < angle x r < PI/2.
Proof.
  intros Hr. pose proof (q_pos r ltac:(lra)) as H1. unfold angle.
  assert (0 < r/(x+q r)) by (apply Rdiv_lt_0_compat; lra).
  assert (r/(x+q r) < 1). { apply Rmult_lt_reg_r with (x+q r). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  pose proof (atan_increasing _ _ H0). pose proof (atan_increasing _ _ H2). rewrite atan_0 in *. rewrite atan_1 in *. lra.
Qed.

Lemma Phi_derive r : 0 < r < x -> is_derive Phi r (integrand r).
Proof.
  intros Hr. pose proof (q_pos r ltac:(lra)) as Hq. destruct (angle_sin_cos r ltac:(lra)) as [Hs _].
  replace (integrand r) with (C * Rpower x (n-1) * (1 / q r * (n * Rpower (sin (angle x r)) (n-1)))).
  - apply (is_derive_scal (fun r => H (angle x r))).
    apply (is_derive_comp H (angle x)). apply H_derive. apply angle_range; auto. apply angle_derive; auto.
  - unfold integrand. rewrite Hs. replace (Rpower r (n-1)) with (Rpower x (n-1) * Rpower (r/x) (n-1)). field; lra.
    rewrite Rpower_mult_distr by (try apply Rdiv_lt_0_compat; lra). f_equal. field; lra.
Qed.

Lemma Phi_continuous r : 0 <= r <= x -> continuous Phi r.
Proof.
  intros Hr. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) _ (fun r => H (angle x r))).
  apply (continuous_comp (angle x) H). apply angle_continuous; auto. apply H_continuous.
Qed.

Lemma integrand_continuous r : 0 < r < x -> continuous integrand r.
Proof.
  intros Hr. pose proof (q_pos r ltac:(lra)) as Hq.
  apply (ex_derive_continuous (V := R_NormedModule)). unfold integrand, Rpower. auto_derive.
  replace (x*(x*1) + - (r*(r*1))) with (x^2 - r^2) by ring. repeat split; try nra; lra.
Qed.

(** (1.1) for f = C r^n, improper at both ends: at r = x for every n, at r = 0 for n < 1. *)
Theorem eq_1_1_power :
  is_RInt_gen integrand (at_right 0) (at_left x) (kappa n * C * Rpower x (n-1)).
Proof.
  assert (Hin : filter_prod (at_right 0) (at_left x) (fun ab => forall r,
     Rmin (fst ab) (snd ab) <= r <= Rmax (fst ab) (snd ab) -> 0 < r < x)).
  { apply Filter_prod with (Q := fun a => 0 < a < x) (R := fun b => 0 < b < x).
    - exists (mkposreal x Hx). intros y Hy H0. change (Rabs (y - 0) < x) in Hy. apply Rabs_def2 in Hy. lra.
    - exists (mkposreal x Hx). intros y Hy H0. change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. lra.
    - intros a b Ha Hb r. simpl. unfold Rmin, Rmax. destruct (Rle_dec a b); lra. }
  apply (is_RInt_gen_ext (Derive Phi)).
  { revert Hin. apply filter_imp. intros ab K r Hr. apply is_derive_unique, Phi_derive. apply K; lra. }
  replace (kappa n * C * Rpower x (n-1)) with (Phi x - Phi 0).
  2:{ unfold Phi. rewrite angle_x, angle_0, H_end, H_0. ring. }
  apply is_RInt_gen_Derive.
  - revert Hin. apply filter_imp. intros ab K r Hr. eexists. apply Phi_derive. auto.
  - revert Hin. apply filter_imp. intros ab K r Hr.
    assert (Hr' : 0 < r < x) by auto.
    apply (continuous_ext_loc _ integrand).
    + assert (Hm : 0 < Rmin r (x - r)) by (apply Rmin_glb_lt; lra).
      exists (mkposreal _ Hm). intros y Hy. change (Rabs (y - r) < Rmin r (x-r)) in Hy.
      pose proof (Rmin_l r (x-r)). pose proof (Rmin_r r (x-r)). apply Rabs_def2 in Hy.
      symmetry. apply is_derive_unique, Phi_derive. lra.
    + apply integrand_continuous. auto.
  - intros P HP. pose proof (Phi_continuous 0 ltac:(lra) P HP) as K. unfold filtermap in *. unfold at_right, within.
    revert K. apply filter_imp. auto.
  - intros P HP. pose proof (Phi_continuous x ltac:(lra) P HP) as K. unfold filtermap in *. unfold at_left, within.
    revert K. apply filter_imp. auto.
Qed.
End T.

(** (1.12): |x| times the integral of (1.1) is κ_n C x^n. *)
Theorem eq_1_12 x C n : 0 < x -> 0 < n ->
  x * RInt_gen (fun r => n * C * Rpower r (n-1) / sqrt (x^2 - r^2)) (at_right 0) (at_left x) = kappa n * C * Rpower x n.
Proof.
  intros Hx Hn. change (fun r => n * C * Rpower r (n-1) / sqrt (x^2 - r^2)) with (integrand x C n).
  rewrite (is_RInt_gen_unique _ _ (eq_1_1_power x Hx C n Hn)).
  replace (Rpower x n) with (x * Rpower x (n-1)). ring.
  rewrite <- (Rpower_1 x) at 1 by auto. rewrite <- Rpower_plus. f_equal. ring.
Qed.
