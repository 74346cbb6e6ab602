(** κ at 1/3 and 1/4 by arithmetic-geometric means: κ_(1/p) is the integral of 1/sqrt (1 - x^(2p)) from 0 to 1, and a substitution
    makes it a complete elliptic integral. Then κ at 2/3 and 3/4 from these. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform MDR.Stability MDR.Agm.
Open Scope R_scope.

(* the antiderivative of Transform.v for κ_n, n = m/p, at x = X^p: with m = 1 that of 1/sqrt (1 - X^(2p)) *)
Lemma Phi_pow (i j : nat) (X : R -> R) X1 t : let p := S j in let n := INR (S i) / INR p in 0 < X t < 1 -> is_derive X t X1 ->
  is_derive (fun t => Phi 1 1 n (X t ^ p)) t (INR (S i) * X t ^ i * X1 / sqrt (1 - X t ^ (2*p))).
Proof.
  intros p n HX Hd. assert (Hp : 0 < INR p) by (apply lt_0_INR; unfold p; lia). assert (Hm : 0 < INR (S i)) by (apply lt_0_INR; lia).
  assert (Hn : 0 < n) by (apply Rdiv_lt_0_compat; auto).
  assert (Hr : 0 < X t ^ p < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | unfold p; lia]]).
  evar_last. apply (is_derive_comp (Phi 1 1 n) (fun t => X t ^ p)). apply (Phi_derive 1 Rlt_0_1 1 n Hn _ Hr). apply is_derive_pow, Hd.
  change (INR p * X1 * X t ^ j * (n * 1 * Rpower (X t ^ p) (n-1) / sqrt (1^2 - (X t ^ p)^2)) = INR (S i) * X t ^ i * X1 / sqrt (1 - X t ^ (2*p))).
  replace (2 * p)%nat with (p * 2)%nat by lia. rewrite pow_mult. assert (Hj : 0 < X t ^ j) by (apply pow_lt; lra).
  replace (Rpower (X t ^ p) (n-1)) with (X t ^ i / X t ^ j).
  2:{ rewrite <- (Rpower_pow p), Rpower_mult by lra. replace (INR p * (n-1)) with (INR i + - INR j).
      rewrite Rpower_plus, Rpower_Ropp, !Rpower_pow by lra. auto.
      replace (INR p * (n-1)) with (INR (S i) - INR p) by (unfold n; field; lra). unfold p. rewrite !S_INR. ring. }
  replace (1^2 - (X t ^ p)^2) with (1 - (X t ^ p)^2) by ring.
  assert (0 < sqrt (1 - (X t ^ p)^2)) by (apply sqrt_lt_R0; nra). unfold n. field. repeat split; lra.
Qed.

Lemma Phi_pow_continuous (i j : nat) (X : R -> R) t : let p := S j in let n := INR (S i) / INR p in 0 <= X t <= 1 -> continuous X t ->
  continuous (fun t => Phi 1 1 n (X t ^ p)) t.
Proof.
  intros p n HR HX. assert (Hn : 0 < n) by (apply Rdiv_lt_0_compat; apply lt_0_INR; unfold p; lia).
  apply (continuous_comp (fun t => X t ^ p) (Phi 1 1 n)). apply (continuous_comp X (fun x => x ^ p)); auto.
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
  apply Phi_continuous; auto; try lra. split. apply pow_le; lra. rewrite <- (pow1 p). apply pow_incr. lra.
Qed.

Lemma Phi_ends (n : R) (j : nat) : Phi 1 1 n (1 ^ S j) = kappa n /\ Phi 1 1 n (0 ^ S j) = 0.
Proof.
  rewrite pow1, pow_i by lia. unfold Phi. rewrite angle_x, angle_0, H_end, H_0 by lra. unfold Rpower. rewrite ln_1, Rmult_0_r, exp_0. lra.
Qed.

(* x = X(t)^m carries the integral of 1/sqrt (1 - x^(2p/m)) into that of m X^(m-1) k over 0 < t < T *)
Lemma kappa_substitution (i j : nat) (X X1 k : R -> R) T : let p := S j in 0 < T ->
  (forall t, 0 <= t <= T -> 0 <= X t <= 1 /\ continuous X t) -> X 0 = 0 -> X T = 1 ->
  (forall t, continuous (fun t => INR (S i) * X t ^ i * k t) t) ->
  (forall t, 0 < t < T -> 0 < X t < 1 /\ is_derive X t (X1 t) /\ X1 t = k t * sqrt (1 - X t ^ (2*p))) ->
  kappa (INR (S i) / INR p) = RInt (fun t => INR (S i) * X t ^ i * k t) 0 T.
Proof.
  intros p HT HX X0 XT Hk HD. set (n := INR (S i) / INR p). set (K := fun t => INR (S i) * X t ^ i * k t) in *.
  destruct (MVT_gen (fun t => Phi 1 1 n (X t ^ p) - RInt K 0 t) 0 T (fun _ => 0)) as [c [_ Hc]].
  - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (HD t Ht) as [HX1 [Hd E]]. evar_last.
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule) (fun t => Phi 1 1 n (X t ^ p)) (fun t => RInt K 0 t)).
    apply (Phi_pow i j X (X1 t) t HX1 Hd). apply RInt_derive; auto. rewrite E.
    assert (Hr : 0 <= X t ^ (2*p) < 1) by (apply pow_lt_1_compat; [lra | unfold p; lia]).
    assert (0 < sqrt (1 - X t ^ (2*p))) by (apply sqrt_lt_R0; lra).
    change (INR (S i) * X t ^ i * (k t * sqrt (1 - X t ^ (2*p))) / sqrt (1 - X t ^ (2*p)) - INR (S i) * X t ^ i * k t = 0). field. lra.
  - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply continuity_pt_filterlim.
    apply (continuous_minus (V := R_NormedModule) (fun t => Phi 1 1 n (X t ^ p)) (fun t => RInt K 0 t)).
    apply Phi_pow_continuous; apply HX; auto. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply RInt_derive; auto.
  - destruct (Phi_ends n j) as [E1 E0]. rewrite XT, X0, RInt_point in Hc. fold p in E1, E0. rewrite E1, E0 in Hc. unfold zero in Hc; simpl in Hc. lra.
Qed.

Lemma sqrt_is x y : 0 <= y -> y * y = x -> sqrt x = y.
Proof. intros Hy <-. apply sqrt_square; auto. Qed.

Lemma agm_step a b : agm ((a+b)/2) (sqrt (a*b)) = agm a b.
Proof. unfold agm. f_equal. rewrite <- (Lim_seq_incr_1 (fun k => fst (means k a b))). apply Lim_seq_ext. auto. Qed.

Lemma elliptic_agm a b : 0 < a -> 0 < b -> RInt (fun t => 1 / D a b t) 0 PI = PI / agm a b.
Proof.
  intros Ha Hb. rewrite half_turn by auto. pose proof (agm_pos a b Ha Hb). pose proof (gauss_agm a b Ha Hb : elliptic a b = _) as K.
  change (2 * elliptic a b = PI / agm a b). rewrite K. field. lra.
Qed.

(** κ_⅓ = π/(3^(1/4) agm(2, sqrt (2 + sqrt 3))). *)
Theorem kappa_third : kappa (/3) = PI / (Rpower 3 (/4) * agm 2 (sqrt (2 + sqrt 3))).
Proof.
  pose proof PI_RGT_0 as Hpi. set (q := sqrt 3). assert (Hq : 0 < q) by (apply sqrt_lt_R0; lra).
  assert (Hqq : q * q = 3) by (apply sqrt_sqrt; lra). set (b := sqrt (2 + q)). assert (Hb : 0 < b) by (apply sqrt_lt_R0; lra).
  assert (Hbb : b * b = 2 + q) by (apply sqrt_sqrt; lra). set (h := sqrt q). assert (Hh : 0 < h) by (apply sqrt_lt_R0; lra).
  assert (Hhh : h * h = q) by (apply sqrt_sqrt; lra).
  assert (Eh : Rpower 3 (/4) = h). { unfold h, q. rewrite <- (Rpower_sqrt 3), <- Rpower_sqrt, Rpower_mult by (apply Rp_pos || lra). f_equal. field. }
  rewrite Eh. pose proof (agm_pos 2 b ltac:(lra) Hb) as Hm.
  set (w := fun t => sin (t/2) ^ 2 + q * cos (t/2) ^ 2).
  assert (Hw : forall t, 0 < w t).
  { intros t. unfold w. pose proof (sin2_cos2 (t/2)) as H. unfold Rsqr in H. pose proof (pow2_ge_0 (sin (t/2))).
    pose proof (pow2_ge_0 (cos (t/2))). assert (1 < q) by nra. set (s := sin (t/2)) in *. set (c := cos (t/2)) in *. nra. }
  set (X := fun t => sin (t/2) / sqrt (w t)). set (k := fun t => / h * (1 / D 2 b t)).
  assert (Xd : forall t, is_derive X t (q * cos (t/2) / (2 * (w t * sqrt (w t))))).
  { intros t. pose proof (Hw t) as W0. pose proof (sqrt_lt_R0 _ W0) as Hs. pose proof (sqrt_sqrt _ (Rlt_le _ _ W0)) as Hss.
    pose proof (sin2_cos2 (t/2)) as Hsc. unfold Rsqr in Hsc. unfold X, w. auto_derive.
    - change (t * / 2) with (t/2). change (sin (t/2) * (sin (t/2) * 1) + q * (cos (t/2) * (cos (t/2) * 1))) with (w t). repeat split; auto. lra.
    - change (t * / 2) with (t/2). change (sin (t/2) * (sin (t/2) * 1) + q * (cos (t/2) * (cos (t/2) * 1))) with (w t).
      change (sin (t/2) ^ 2 + q * cos (t/2) ^ 2) with (w t).
      set (y := sqrt (w t)) in *. rewrite <- Hss. set (s := sin (t/2)) in *. set (c := cos (t/2)) in *.
      transitivity ((c*(y*y) - s*(s*c - q*(c*s)))/(2*(y*y*y))). field. lra.
      replace (y*y) with (s*s + q*(c*c)) at 1 by (rewrite Hss; unfold w; fold s c; ring).
      replace (c*(s*s + q*(c*c)) - s*(s*c - q*(c*s))) with (q*c*(s*s + c*c)) by ring. rewrite Hsc. field. lra. }
  assert (Hrange : forall t, 0 < t < PI -> 0 < X t < 1 /\ X t ^ 6 = sin (t/2)^6 / (w t * w t * w t)).
  { intros t Ht. pose proof (Hw t) as W0. pose proof (sqrt_lt_R0 _ W0) as Hs. pose proof (sqrt_sqrt _ (Rlt_le _ _ W0)) as Hss.
    assert (S0 : 0 < sin (t/2)) by (apply sin_gt_0; lra). assert (C0 : 0 < cos (t/2)) by (apply cos_gt_0; lra). split; [split|].
    - unfold X. apply Rdiv_lt_0_compat; auto.
    - unfold X. apply Rmult_lt_reg_r with (sqrt (w t)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. rewrite Rmult_1_r, Rmult_1_l.
      apply Rsqr_incrst_0; try lra. unfold Rsqr. rewrite Hss. unfold w. assert (0 < q * cos (t/2)^2) by (apply Rmult_lt_0_compat; auto; apply pow_lt; auto). nra.
    - unfold X. set (y := sqrt (w t)) in *. rewrite <- Hss. field. lra. }
  replace (/3) with (INR 1 / INR 3) by (simpl; field).
  rewrite (kappa_substitution 0 2 X (fun t => q * cos (t/2) / (2 * (w t * sqrt (w t)))) k PI); auto.
  - rewrite (RInt_ext _ k) by (intros; simpl; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring).
    unfold k. rewrite (RInt_scal (V := R_CompleteNormedModule) (fun t => 1 / D 2 b t)) by (apply ex_elliptic; lra).
    rewrite elliptic_agm by lra. unfold scal; simpl; unfold mult; simpl. field. lra.
  - intros t Ht. split. 2: apply (ex_derive_continuous (V := R_NormedModule)); eexists; apply Xd.
    destruct (Req_dec t 0) as [->|N0]; [|destruct (Req_dec t PI) as [->|N1]].
    + unfold X. replace (0/2) with 0 by field. rewrite sin_0. unfold Rdiv. lra.
    + unfold X, w. rewrite cos_PI2, sin_PI2. replace (1^2 + q*0^2) with 1 by ring. rewrite sqrt_1. lra.
    + destruct (Hrange t ltac:(lra)). lra.
  - unfold X. replace (0/2) with 0 by field. rewrite sin_0. unfold Rdiv. ring.
  - unfold X, w. rewrite cos_PI2, sin_PI2. replace (1^2 + q*0^2) with 1 by ring. rewrite sqrt_1. field.
  - intros t. apply (continuous_ext k). intros u. simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
    apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (/h) (fun t => 1 / D 2 b t)). apply D_continuous; lra.
  - intros t Ht. destruct (Hrange t Ht) as [R1 R2]. split; auto. split. apply Xd. change (X t ^ (2*3)) with (X t ^ 6). rewrite R2.
    pose proof (Hw t) as W0. pose proof (sqrt_lt_R0 _ W0) as Hs. pose proof (sqrt_sqrt _ (Rlt_le _ _ W0)) as Hss.
    assert (C0 : 0 < cos (t/2)) by (apply cos_gt_0; lra). pose proof (D_pos 2 b ltac:(lra) Hb t) as HD. pose proof (D_sq 2 b ltac:(lra) Hb t) as HDD.
    replace (cos t) with (cos (2*(t/2))) in HDD by (f_equal; field). replace (sin t) with (sin (2*(t/2))) in HDD by (f_equal; field).
    rewrite cos_2a, sin_2a in HDD.
    set (y := sqrt (w t)) in *. set (d := D 2 b t) in *. set (s := sin (t/2)) in *. set (c := cos (t/2)) in *.
    rewrite (sqrt_is _ (q*h*c*d/(2*(w t*y)))).
    + unfold k. fold d. field. repeat split; lra.
    + apply Rmult_le_pos. left. repeat apply Rmult_lt_0_compat; auto. left. apply Rinv_0_lt_compat. nra.
    + transitivity ((q*q)*(h*h)*(c*c)*(d*d)/(4*(w t*w t*(y*y)))). field. split; lra.
      rewrite Hss, HDD, Hqq, Hhh. replace ((b*(2*s*c))^2) with (4*(b*b)*(s*s)*(c*c)) by ring. rewrite Hbb.
      assert (Ew : w t * w t * w t - s^6 = 3*q*(c*c)*((c*c-s*s)^2 + (2+q)*(s*s)*(c*c)) + q*c^6*(q*q-3)) by (unfold w; fold s c; ring).
      rewrite Hqq in Ew. replace (1 - s^6/(w t*w t*w t)) with ((w t * w t * w t - s^6)/(w t*w t*w t)) by (field; lra). rewrite Ew. field. lra.
Qed.

(* an integrand that changes its sign when t is reflected at the middle has no integral *)
Lemma RInt_odd (f : R -> R) T : (forall t, continuous f t) -> (forall t, f (T - t) = - f t) -> RInt f 0 T = 0.
Proof.
  intros Hc Ho. assert (Hx : forall a b, ex_RInt f a b) by (intros; apply (ex_RInt_continuous (V := R_CompleteNormedModule)); auto).
  pose proof (RInt_comp_lin (V := R_CompleteNormedModule) f (-1) T 0 T (Hx _ _)) as K.
  replace (-1*0 + T) with T in K by ring. replace (-1*T + T) with 0 in K by ring.
  rewrite <- (opp_RInt_swap (V := R_CompleteNormedModule) f 0 T) in K by auto.
  rewrite (RInt_ext _ f) in K.
  2:{ intros t _. replace (-1*t + T) with (T - t) by ring. rewrite Ho. unfold scal; simpl; unfold mult; simpl.
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  unfold opp in K; simpl in K. set (I := RInt f 0 T) in *. change (@eq R I (- I)) in K. change (@eq R I 0). lra.
Qed.

(* x² = p(1 + σ)/(1 - qσ) with p = sqrt 2 - 1, q = p², σ = -cos t/sqrt (1 + q sin² t) *)
Section Quarter.
Let p := sqrt 2 - 1.
Let q := p * p.
Let b := (3 + p) / 2.
Let a := sqrt (2 + p).

Lemma p_range : 0 < p < 1 /\ q = 1 - 2*p.
Proof.
  assert (Hs : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra). pose proof (sqrt_lt_R0 2 ltac:(lra)). unfold q, p. split. split; nra. lra.
Qed.
Let Hp : 0 < p < 1 := proj1 p_range.
Let Hq : q = 1 - 2*p := proj2 p_range.
Let Hq0 : 0 < q < 1.
Proof. unfold q. nra. Qed.
Let Hb : 0 < b.
Proof. unfold b. lra. Qed.
Let Ha : 0 < a.
Proof. apply sqrt_lt_R0. lra. Qed.
Let Haa : a * a = 2 + p.
Proof. apply sqrt_sqrt. lra. Qed.
Let Hab : b * b * (1 - q) = a * a.
Proof. rewrite Haa. unfold b. replace (1 - q) with (2 * p) by lra. unfold q in Hq. nra. Qed.

Let r t := sqrt (1 + q * sin t ^ 2).
Let sigma t := - cos t / r t.
Let y t := p * (1 + sigma t) / (1 - q * sigma t).
Let X t := sqrt (y t).
Let k t := (2 + p) / 4 * (1 - q * sigma t) / D a b t.

Lemma r_pos t : 0 < r t /\ r t * r t = 1 + q * sin t ^ 2.
Proof.
  pose proof (pow2_ge_0 (sin t)). assert (0 < 1 + q * sin t ^ 2) by nra. split. apply sqrt_lt_R0; auto. apply sqrt_sqrt; lra.
Qed.

(* the three factors under the root *)
Lemma sigma_factors t : let s := sigma t in
  (1 - s*s) * (r t * r t) = (1 + q) * sin t ^ 2 /\
  b * b * ((1 - q*q*s*s) * (r t * r t)) = (1 + q) * (D a b t * D a b t) /\
  (1 + q*s*s) * (r t * r t) = 1 + q /\ -1 <= s <= 1.
Proof.
  intros s. destruct (r_pos t) as [R0 RR]. pose proof (sin2_cos2 t) as Hsc. unfold Rsqr in Hsc. rewrite (D_sq a b Ha Hb).
  assert (Es : s * s * (r t * r t) = cos t * cos t) by (unfold s, sigma; field; lra).
  assert (F1 : (1 - s*s) * (r t * r t) = (1 + q) * sin t ^ 2).
  { replace ((1 - s*s) * (r t * r t)) with (r t * r t - s*s*(r t * r t)) by ring. rewrite Es, RR. replace (cos t * cos t) with (1 - sin t * sin t) by lra. ring. }
  repeat split; auto.
  - replace ((1 - q*q*s*s) * (r t * r t)) with (r t * r t - q*q*(s*s*(r t * r t))) by ring. rewrite Es, RR.
    replace ((a * cos t)^2) with (a*a*(cos t * cos t)) by ring. rewrite <- Hab. replace (cos t * cos t) with (1 - sin t * sin t) by lra. ring.
  - replace ((1 + q*s*s) * (r t * r t)) with (r t * r t + q*(s*s*(r t * r t))) by ring. rewrite Es, RR. replace (cos t * cos t) with (1 - sin t * sin t) by lra. ring.
  - assert (0 <= (1 - s*s) * (r t * r t)) by (rewrite F1; pose proof (pow2_ge_0 (sin t)); nra). assert (0 < r t * r t) by nra.
    assert (0 <= 1 - s*s) by nra. nra.
  - assert (0 <= (1 - s*s) * (r t * r t)) by (rewrite F1; pose proof (pow2_ge_0 (sin t)); nra). assert (0 < r t * r t) by nra.
    assert (0 <= 1 - s*s) by nra. nra.
Qed.

Lemma sigma_inside t : 0 < t < PI -> -1 < sigma t < 1.
Proof.
  intros Ht. destruct (sigma_factors t) as [F1 [_ [_ F4]]]. destruct (r_pos t) as [R0 _]. assert (0 < sin t) by (apply sin_gt_0; lra).
  assert (0 < (1 + q) * sin t ^ 2) by (pose proof (pow_lt (sin t) 2 H); nra). assert (0 < r t * r t) by nra.
  set (s := sigma t) in *. split; apply Rnot_le_lt; intro L.
  - replace s with (-1) in F1 by lra. lra.
  - replace s with 1 in F1 by lra. lra.
Qed.

Lemma sigma_derive t : is_derive sigma t ((1 + q) * sin t / (r t * r t * r t)).
Proof.
  destruct (r_pos t) as [R0 RR]. pose proof (sin2_cos2 t) as Hsc. unfold Rsqr in Hsc. unfold sigma, r. auto_derive.
  - replace (1 + q * (sin t * (sin t * 1))) with (1 + q * sin t ^ 2) by ring. fold (r t). rewrite <- RR. repeat split; nra.
  - replace (1 + q * (sin t * (sin t * 1))) with (1 + q * sin t ^ 2) by ring. fold (r t).
    transitivity ((sin t * (r t * r t) + cos t * cos t * q * sin t) / (r t * r t * r t)). field. lra.
    f_equal. rewrite RR. replace (cos t * cos t) with (1 - sin t * sin t) by lra. ring.
Qed.

Lemma v_pos t : 0 < 1 - q * sigma t.
Proof. destruct (sigma_factors t) as [_ [_ [_ F4]]]. nra. Qed.

Lemma y_derive t : is_derive y t (p * (1 + q) * ((1 + q) * sin t / (r t * r t * r t)) / (1 - q * sigma t)^2).
Proof.
  pose proof (v_pos t) as V. destruct (r_pos t) as [R0 _].
  evar_last. apply (is_derive_comp (fun s => p * (1 + s) / (1 - q * s)) sigma t). auto_derive. lra. reflexivity. apply sigma_derive.
  unfold scal; simpl; unfold mult; simpl. field. split; lra.
Qed.

Lemma quarter_root t : 0 < t < PI ->
  sqrt (1 - X t ^ 8) = 2 * p * (1 + q)^2 * sin t * D a b t / ((2 + p) * X t * (r t * r t * r t) * (1 - q * sigma t)^3).
Proof.
  intros Ht. pose proof (v_pos t) as V. destruct (r_pos t) as [R0 _]. destruct (sigma_inside t Ht) as [S1 S2].
  destruct (sigma_factors t) as [F1 [F2 [F3 _]]]. pose proof (D_pos a b Ha Hb t) as HD. assert (S0 : 0 < sin t) by (apply sin_gt_0; lra).
  assert (Y0 : 0 < y t) by (unfold y; apply Rdiv_lt_0_compat; auto; nra). assert (X0 : 0 < X t) by (apply sqrt_lt_R0; auto).
  assert (XX : X t * X t = y t) by (apply sqrt_sqrt; lra).
  apply sqrt_is. left. apply Rdiv_lt_0_compat; repeat apply Rmult_lt_0_compat; try apply pow_lt; lra.
  set (s := sigma t) in *. set (v := 1 - q * s) in *. set (d := D a b t) in *. set (rr := r t) in *. set (x := X t) in *.
  set (K := (1 + q) * (1 - s) * (1 + q*s) * (1 + q*s*s) / v^4).
  assert (P2 : p^2 = 1 - 2*p) by (rewrite <- Hq; unfold q; ring). assert (P3 : p^3 = p - 2*p^2) by (replace (p^3) with (p * p^2) by ring; rewrite P2 at 1; ring).
  assert (Pq : p = 2*q + p*q) by (rewrite Hq; replace (p*(1 - 2*p)) with (p - 2*p^2) by ring; lra).
  transitivity (2 * (1 - q) * K / 2).
  - transitivity (4 * p^2 * (1 + q) * ((1 + q) * sin t ^ 2) * ((1 + q) * (d * d)) * (1 + q) / ((2 + p)^2 * (x * x) * (rr*rr)^3 * v^6)).
    field. repeat split; lra.
    rewrite <- F1, <- F2, XX. rewrite <- F3 at 2. unfold y. fold s. fold v.
    transitivity (4 * p * (b * b) / (2 + p)^2 * K). unfold K. replace (1 - q*q*s*s) with (v * (1 + q*s)) by (unfold v; ring).
    replace (1 - s*s) with ((1 - s) * (1 + s)) by ring. field. repeat split; lra.
    replace (4 * p * (b * b) / (2 + p)^2) with (2 * p).
    replace (2 * (1 - q)) with (4 * p) by lra. field.
    unfold b. apply Rmult_eq_reg_r with ((2+p)^2). 2: apply Rgt_not_eq, pow_lt; lra. field_simplify; [|lra].
    lra.
  - replace (x^8) with ((x*x)^4) by ring. rewrite XX. unfold y. fold s. fold v. unfold K.
    replace (1 - (p * (1+s)/v)^4) with ((v - p*(1+s)) * (v + p*(1+s)) * (v^2 + p*p*(1+s)^2) / v^4) by (field; lra).
    replace (v - p*(1+s)) with ((1-p)*(1-s)) by (unfold v; rewrite Hq; ring).
    replace (v + p*(1+s)) with ((1+p)*(1+q*s)) by (symmetry; unfold v; transitivity (1 - q*s + p + p*s); [ring | rewrite Pq at 2; ring]).
    replace (v^2 + p*p*(1+s)^2) with ((1+q)*(1+q*s*s)) by (change (p*p) with q; unfold v; ring).
    replace (2 * (1 - q)) with (2 * ((1 - p) * (1 + p))) by (unfold q; ring). field. lra.
Qed.
Lemma X_derive t : 0 < t < PI -> is_derive X t (k t * sqrt (1 - X t ^ (2*4))).
Proof.
  intros Ht. pose proof (v_pos t) as V. destruct (r_pos t) as [R0 _]. destruct (sigma_inside t Ht) as [S1 S2]. pose proof (D_pos a b Ha Hb t) as HD.
  assert (Y0 : 0 < y t) by (unfold y; apply Rdiv_lt_0_compat; auto; nra). assert (X0 : 0 < X t) by (apply sqrt_lt_R0; auto).
  change (2*4)%nat with 8%nat. rewrite quarter_root by auto.
  assert (Ds : is_derive sqrt (y t) (/ (2 * sqrt (y t)))) by (auto_derive; [exact Y0 | field; apply Rgt_not_eq, X0]).
  evar_last. apply (is_derive_comp sqrt y t _ _ Ds (y_derive t)). change (sqrt (y t)) with (X t).
  unfold scal; simpl; unfold mult; simpl. unfold k. set (x := X t) in *. clearbody x. field. repeat split; lra.
Qed.

Lemma X_range t : 0 <= X t <= 1 /\ continuous X t.
Proof.
  pose proof (v_pos t) as V. destruct (sigma_factors t) as [_ [_ [_ S1]]]. assert (P2 : p^2 = 1 - 2*p) by (rewrite <- Hq; unfold q; ring).
  assert (Y1 : 0 <= y t <= 1).
  { unfold y. split. apply Rmult_le_pos. apply Rmult_le_pos; lra. left. apply Rinv_0_lt_compat; auto.
    apply Rmult_le_reg_r with (1 - q * sigma t); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
    assert (0 <= (1 - p) * (1 - sigma t)) by (apply Rmult_le_pos; lra). nra. }
  split. split. apply sqrt_pos. unfold X. rewrite <- sqrt_1. apply sqrt_le_1; lra.
  apply (continuous_comp y sqrt). apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply y_derive.
  apply continuity_pt_filterlim, continuity_pt_sqrt. lra.
Qed.

Lemma k_continuous t : continuous k t.
Proof.
  apply (continuous_ext (fun t => ((2 + p) / 4 * (1 - q * sigma t)) * (1 / D a b t))).
  { intros u. unfold k. pose proof (D_pos a b Ha Hb u). match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra. }
  apply (continuous_mult (K := R_AbsRing) (fun t => (2 + p) / 4 * (1 - q * sigma t))). 2: apply D_continuous; auto.
  apply (ex_derive_continuous (V := R_NormedModule)). eexists.
  apply (is_derive_comp (fun s => (2 + p) / 4 * (1 - q * s)) sigma t). auto_derive; [auto | reflexivity]. apply sigma_derive.
Qed.

Lemma quarter_kappa i : kappa (INR (S i) / INR 4) = RInt (fun t => INR (S i) * X t ^ i * k t) 0 PI.
Proof.
  pose proof PI_RGT_0 as Hpi. apply (kappa_substitution i 3 X (fun t => k t * sqrt (1 - X t ^ (2*4))) k PI); auto.
  - intros t _. apply X_range.
  - unfold X, y, sigma, r. rewrite sin_0, cos_0. replace (1 + q*0^2) with 1 by ring. rewrite sqrt_1.
    replace (p * (1 + - (1) / 1) / (1 - q * (- (1) / 1))) with 0 by (field; lra). apply sqrt_0.
  - unfold X, y, sigma, r. rewrite sin_PI, cos_PI. replace (1 + q*0^2) with 1 by ring. rewrite sqrt_1.
    replace (p * (1 + - (-1) / 1) / (1 - q * (- (-1) / 1))) with 1. apply sqrt_1. rewrite Hq. field. lra.
  - intros t. apply (continuous_mult (K := R_AbsRing) (fun t => INR (S i) * X t ^ i) k). 2: apply k_continuous.
    apply (continuous_comp X (fun x => INR (S i) * x ^ i)). apply X_range. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
  - intros t Ht. pose proof (v_pos t) as V. destruct (sigma_inside t Ht) as [S1 S2].
    assert (P2 : p^2 = 1 - 2*p) by (rewrite <- Hq; unfold q; ring).
    assert (Y0 : 0 < y t) by (unfold y; apply Rdiv_lt_0_compat; auto; nra).
    assert (Y1 : y t < 1).
    { unfold y. apply Rmult_lt_reg_r with (1 - q * sigma t); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
      assert (0 < (1 - p) * (1 - sigma t)) by (apply Rmult_lt_0_compat; lra). nra. }
    split; [split|]. apply sqrt_lt_R0; auto. unfold X. rewrite <- sqrt_1. apply sqrt_lt_1; lra. split; auto. apply X_derive; auto.
Qed.

(* σ has no share in the integral *)
Lemma quarter_integral c e : is_RInt (fun t => c * (1 / D a b t) + e * (sigma t / D a b t)) 0 PI (c * (PI / agm 1 (1 + sqrt 2))).
Proof.
  assert (Co : forall t, continuous (fun t => sigma t / D a b t) t).
  { intros t. apply (continuous_ext (fun t => sigma t * (1 / D a b t))).
    intros u. unfold Rdiv. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
    apply (continuous_mult (K := R_AbsRing) sigma). 2: apply D_continuous; auto.
    apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply sigma_derive. }
  assert (Hodd : RInt (fun t => sigma t / D a b t) 0 PI = 0).
  { apply RInt_odd; auto. intros t. unfold sigma, r, D. rewrite sin_PI_x, cos_minus, cos_PI, sin_PI.
    replace (a * (-1 * cos t + 0 * sin t)) with (- (a * cos t)) by ring. replace ((- (a * cos t))^2) with ((a * cos t)^2) by ring.
    unfold Rdiv. ring. }
  assert (Em : agm a b = agm 1 (1 + sqrt 2)).
  { rewrite agm_swap, <- (agm_step 1 (1 + sqrt 2)) by auto. f_equal. unfold b, p. field. unfold a, p. f_equal. ring. }
  replace (c * (PI / agm 1 (1 + sqrt 2))) with (c * (PI / agm a b) + e * 0) by (rewrite <- Em; ring).
  apply (is_RInt_plus (V := R_NormedModule) (fun t => c * (1 / D a b t))).
  - rewrite <- (elliptic_agm a b Ha Hb). apply (is_RInt_scal (V := R_NormedModule) (fun t => 1 / D a b t)).
    apply (RInt_correct (V := R_CompleteNormedModule)), ex_elliptic; auto.
  - apply (is_RInt_scal (V := R_NormedModule) (fun t => sigma t / D a b t)). rewrite <- Hodd at 2.
    apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto.
Qed.

(** κ_¼ = π(1 + sqrt 2)/(4 agm(1, 1 + sqrt 2)), *)
Theorem kappa_quarter : kappa (/4) = PI * (1 + sqrt 2) / (4 * agm 1 (1 + sqrt 2)).
Proof.
  replace (/4) with (INR 1 / INR 4) by (simpl; field). rewrite (quarter_kappa 0). apply (is_RInt_unique (V := R_CompleteNormedModule)).
  pose proof (agm_pos 1 (1 + sqrt 2) ltac:(lra) ltac:(pose proof (sqrt_pos 2); lra)) as Hm.
  replace (PI * (1 + sqrt 2) / (4 * agm 1 (1 + sqrt 2))) with ((2 + p) / 4 * (PI / agm 1 (1 + sqrt 2))) by (unfold p; field; lra).
  apply (is_RInt_ext (fun t => (2 + p) / 4 * (1 / D a b t) + - ((2 + p) / 4 * q) * (sigma t / D a b t))). 2: apply quarter_integral.
  intros t _. unfold k. pose proof (D_pos a b Ha Hb t). simpl INR. simpl pow. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.

(** and κ_¾ by the same substitution: 3 κ_¼/(1 + sqrt 2). *)
Theorem kappa_three_quarters : kappa (3/4) = 3 * kappa (/4) / (1 + sqrt 2).
Proof.
  pose proof (agm_pos 1 (1 + sqrt 2) ltac:(lra) ltac:(pose proof (sqrt_pos 2); lra)) as Hm. pose proof (sqrt_pos 2) as Hs.
  assert (P2 : p * (1 + sqrt 2) = 1) by (replace (1 + sqrt 2) with (2 + p) by (unfold p; ring); unfold q in Hq; lra).
  rewrite kappa_quarter. replace (3/4) with (INR 3 / INR 4) by (simpl; field).
  rewrite (quarter_kappa 2). apply (is_RInt_unique (V := R_CompleteNormedModule)).
  replace (3 * (PI * (1 + sqrt 2) / (4 * agm 1 (1 + sqrt 2))) / (1 + sqrt 2)) with (3 / 4 * (p * (1 + sqrt 2)) * (PI / agm 1 (1 + sqrt 2)))
    by (rewrite P2; field; lra).
  replace (1 + sqrt 2) with (2 + p) at 1 by (unfold p; ring).
  apply (is_RInt_ext (fun t => 3/4 * (p * (2 + p)) * (1 / D a b t) + 3/4 * (p * (2 + p)) * (sigma t / D a b t))). 2: apply quarter_integral.
  intros t _. pose proof (v_pos t) as V. pose proof (D_pos a b Ha Hb t). destruct (X_range t) as [[X0 _] _].
  assert (XX : X t ^ 2 = y t).
  { replace (X t ^ 2) with (X t * X t) by ring. apply sqrt_sqrt. unfold y. destruct (sigma_factors t) as [_ [_ [_ S1]]].
    apply Rmult_le_pos. apply Rmult_le_pos; lra. left. apply Rinv_0_lt_compat; auto. }
  rewrite XX. unfold k, y. simpl INR. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra.
Qed.
End Quarter.

(** κ_⅔ = 2 κ_⅓/sqrt 3, by x² = 3z⁴/(4 - z⁶). *)
Theorem kappa_two_thirds : kappa (2/3) = 2 * kappa (/3) / sqrt 3.
Proof.
  set (h := sqrt 3). assert (Hh : 0 < h) by (apply sqrt_lt_R0; lra). assert (Hhh : h * h = 3) by (apply sqrt_sqrt; lra).
  set (X := fun z => h * z^2 / sqrt (4 - z^6)). replace (2/3) with (INR 2 / INR 3) by (simpl; field).
  replace (/3) with (INR 1 / INR 3) by (simpl; field).
  assert (Z : forall z, 0 <= z <= 1 -> 0 <= z^6 <= 1).
  { intros z Hz. split. apply pow_le; lra. rewrite <- (pow1 6). apply pow_incr; lra. }
  assert (Xd : forall z, 0 <= z <= 1 -> is_derive X z (h * z * (8 + z^6) / ((4 - z^6) * sqrt (4 - z^6)))).
  { intros z Hz. specialize (Z z Hz). assert (W0 : 0 < 4 - z^6) by lra. pose proof (sqrt_lt_R0 _ W0) as Hs.
    pose proof (sqrt_sqrt _ (Rlt_le _ _ W0)) as Hss. unfold X. auto_derive.
    - replace (4 + - (z*(z*(z*(z*(z*(z*1))))))) with (4 - z^6) by ring. repeat split; auto. lra.
    - replace (4 + - (z*(z*(z*(z*(z*(z*1))))))) with (4 - z^6) by ring. set (s := sqrt (4 - z^6)) in *.
      assert (E : 4 - z^6 = s * s) by auto. assert (E6 : z^6 = 4 - s*s) by lra. rewrite E.
      transitivity (h * z * (2 * (s*s) + 3 * z^6) / (s*s*s)). field. lra. rewrite E6. field. lra. }
  assert (XR : forall z, 0 < z < 1 -> 0 < X z < 1 /\ sqrt (1 - X z ^ 6) = (8 + z^6) * sqrt (1 - z^6) / ((4 - z^6) * sqrt (4 - z^6))).
  { intros z Hz. assert (Z1 : 0 < z^6 < 1) by (split; [apply pow_lt; lra | apply pow_lt_1_compat; [lra | lia]]).
    assert (W0 : 0 < 4 - z^6) by lra. pose proof (sqrt_lt_R0 _ W0) as Hs. pose proof (sqrt_sqrt _ (Rlt_le _ _ W0)) as Hss.
    pose proof (sqrt_lt_R0 (1 - z^6) ltac:(lra)) as Hu. pose proof (sqrt_sqrt (1 - z^6) ltac:(lra)) as Huu.
    assert (X0 : 0 < X z) by (unfold X; apply Rdiv_lt_0_compat; auto; apply Rmult_lt_0_compat; auto; apply pow_lt; lra).
    assert (XX : X z * X z = 3 * z^4 / (4 - z^6)).
    { unfold X. set (s := sqrt (4 - z^6)) in *. rewrite <- Hss, <- Hhh. field. lra. }
    assert (E6 : 1 - X z ^ 6 = (8 + z^6)^2 * (1 - z^6) / (4 - z^6)^3).
    { replace (X z ^ 6) with ((X z * X z)^3) by ring. rewrite XX. field. lra. }
    split.
    - split; auto. assert (0 < 1 - X z ^ 6) by (rewrite E6; apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply pow_lt|]; lra | apply pow_lt; lra]).
      apply Rnot_le_lt. intro L. pose proof (pow_R1_Rle (X z) 6 L). lra.
    - apply sqrt_is. left. apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; lra. rewrite E6. set (u := sqrt (1 - z^6)) in *.
      set (s := sqrt (4 - z^6)) in *. transitivity ((8 + z^6)^2 * (u*u) / ((4 - z^6)^2 * (s*s))). field. lra. rewrite Huu, Hss. field. lra. }
  set (K1 := fun z => Phi 1 1 (INR 1 / INR 3) (X z ^ 3)). set (K2 := fun z => Phi 1 1 (INR 2 / INR 3) (z ^ 3)).
  destruct (MVT_gen (fun z => K1 z - h / 2 * K2 z) 0 1 (fun _ => 0)) as [c [_ Hc]].
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. destruct (XR z Hz) as [R1 R2]. specialize (Z z ltac:(lra)). evar_last.
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule) K1 (fun z => h / 2 * K2 z)).
    apply (Phi_pow 0 2 X _ z R1 (Xd z ltac:(lra))). apply (is_derive_scal K2). apply (Phi_pow 1 2 (fun z => z) 1 z Hz).
    apply (is_derive_id (K := R_AbsRing)). change (X z ^ (2*3)) with (X z ^ 6). change (z ^ (2*3)) with (z ^ 6). rewrite R2.
    assert (z^6 < 1) by (apply pow_lt_1_compat; [lra | lia]). pose proof (sqrt_lt_R0 (1 - z^6) ltac:(lra)) as Hu.
    pose proof (sqrt_lt_R0 (4 - z^6) ltac:(lra)) as Hs.
    set (u := sqrt (1 - z^6)) in *. set (s := sqrt (4 - z^6)) in *. unfold minus, plus, opp; simpl INR. simpl (_ ^ 0). simpl (_ ^ 1).
    change (1 * 1 * (h * z * (8 + z^6) / ((4 - z^6) * s)) / ((8 + z^6) * u / ((4 - z^6) * s)) + - (h/2 * ((1 + 1) * (z * 1) * 1 / u)) = 0).
    field. repeat split; lra.
  - intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply continuity_pt_filterlim.
    apply (continuous_minus (V := R_NormedModule) K1 (fun z => h / 2 * K2 z)).
    + apply (Phi_pow_continuous 0 2 X).
      * destruct (Req_dec z 0) as [->|N0]; [|destruct (Req_dec z 1) as [->|N1]].
        unfold X. rewrite pow_i by lia. unfold Rdiv. lra.
        unfold X. rewrite !pow1. replace (4 - 1) with 3 by ring. fold h. replace (h * 1 / h) with 1 by (field; lra). lra.
        destruct (XR z ltac:(lra)). lra.
      * apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply Xd; auto.
    + apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (h / 2) K2). apply (Phi_pow_continuous 1 2 (fun z => z)); auto.
      apply continuous_id.
  - unfold K1, K2 in Hc. replace (X 1) with 1 in Hc by (unfold X; rewrite !pow1; replace (4 - 1) with 3 by ring; fold h; field; lra).
    replace (X 0) with 0 in Hc by (unfold X; rewrite pow_i by lia; unfold Rdiv; ring).
    destruct (Phi_ends (INR 1 / INR 3) 2) as [E1 E2]. destruct (Phi_ends (INR 2 / INR 3) 2) as [E3 E4]. rewrite E1, E2, E3, E4 in Hc.
    apply Rmult_eq_reg_r with h; [|lra]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
