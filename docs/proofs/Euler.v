(** Euler's Γ exists: the limit of his product has all the properties from which (1.12) is shown. It doubles as Legendre says, which
    gives (1.18) the form with Γ(3/4)². *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Gamma.
Open Scope R_scope.

Lemma ln_gap x y : 0 < x -> 0 < y -> 1 - x/y <= ln y - ln x <= y/x - 1.
Proof.
  assert (H : forall u, 0 < u -> ln u <= u - 1).
  { intros u Hu. pose proof (exp_ineq1_le (ln u)) as K. rewrite exp_ln in K by auto. lra. }
  intros Hx Hy. pose proof (H (x/y) ltac:(pos)) as H1. pose proof (H (y/x) ltac:(pos)) as H2.
  rewrite ln_div in H1, H2 by auto. lra.
Qed.

Lemma ln_concave x y t : 0 < x -> 0 < y -> 0 <= t <= 1 -> t * ln x + (1-t) * ln y <= ln (t*x + (1-t)*y).
Proof.
  intros Hx Hy Ht. set (m := t*x + (1-t)*y). assert (Hm : 0 < m) by (unfold m; nra).
  destruct (ln_gap m x Hm Hx) as [_ H1]. destruct (ln_gap m y Hm Hy) as [_ H2].
  assert (H3 : t * (x/m - 1) + (1-t) * (y/m - 1) = 0) by (unfold m in *; field; lra). nra.
Qed.

(** The logarithm of Euler's product k! / ((z+1) ... (z+k)), and of the whole with M^z/z at M = m + 1. *)
Fixpoint falling (k : nat) (z : R) : R := match k with O => 0 | S j => falling j z + (ln (INR (S j)) - ln (z + INR (S j))) end.
Definition euler (m : nat) z := falling (S m) z - ln z + z * ln (INR (S m)).
Definition Gamma z := exp (real (Lim_seq (fun m => euler m z))).

Lemma INR_S_pos m : 0 < INR (S m).
Proof. rewrite S_INR. pose proof (pos_INR m). lra. Qed.

Lemma euler_step m z : let M := INR (S m) in
  euler (S m) z - euler m z = z * (ln (M + 1) - ln M) - (ln (z + (M + 1)) - ln (M + 1)).
Proof. intros M. unfold euler. change (falling (S (S m)) z) with (falling (S m) z + (ln (INR (S (S m))) - ln (z + INR (S (S m))))).
  rewrite (S_INR (S m)). fold M. ring.
Qed.

(* each factor but the first is at least 1, and they come near to 1 fast enough *)
Lemma euler_bounds m z : 0 < z -> euler m z <= euler (S m) z /\
  euler (S m) z + z * (z+1) / INR (S (S m)) <= euler m z + z * (z+1) / INR (S m).
Proof.
  intros Hz. pose proof (euler_step m z) as H. simpl in H. pose proof (INR_S_pos m) as HM. rewrite (S_INR (S m)).
  change (match m with O => 1 | S _ => INR m + 1 end) with (INR (S m)) in H. set (M := INR (S m)) in *.
  destruct (ln_gap M (M+1) HM ltac:(lra)) as [A1 A2]. destruct (ln_gap (M+1) (z + (M+1)) ltac:(lra) ltac:(lra)) as [B1 B2].
  assert (C1 : z * (1 - M/(M+1)) = (z + (M+1))/(M+1) - 1) by (field; lra).
  assert (C2 : z * ((M+1)/M - 1) - (1 - (M+1)/(z+(M+1))) <= z*(z+1)/M - z*(z+1)/(M+1)).
  { replace (z * ((M+1)/M - 1) - (1 - (M+1)/(z+(M+1)))) with (z*(z+1) * (/M * / (z+(M+1)))) by (field; lra).
    replace (z*(z+1)/M - z*(z+1)/(M+1)) with (z*(z+1) * (/M * / (M+1))) by (field; lra).
    apply Rmult_le_compat_l. nra. apply Rmult_le_compat_l. left; apply Rinv_0_lt_compat; auto. apply Rinv_le_contravar; lra. }
  split; nra.
Qed.

Lemma euler_lim z : 0 < z -> is_lim_seq (fun m => euler m z) (ln (Gamma z)).
Proof.
  intros Hz. unfold Gamma. rewrite ln_exp. apply Lim_seq_correct'.
  apply ex_finite_lim_seq_incr with (euler 0 z + z * (z+1)). intros m. apply euler_bounds; auto.
  assert (H : forall m, euler m z + z * (z+1) / INR (S m) <= euler 0 z + z * (z+1)).
  { induction m. simpl INR. lra. destruct (euler_bounds m z Hz). lra. }
  intros m. specialize (H m). assert (0 < z * (z+1) / INR (S m)) by (pose proof (INR_S_pos m); pos). lra.
Qed.

Lemma ln_shift_lim c : 0 <= c -> is_lim_seq (fun m => ln (INR (S m)) - ln (c + INR (S m))) 0.
Proof.
  intros Hc. apply is_lim_seq_le_le with (fun m => - (c * / INR (S m))) (fun _ => 0).
  - intros m. pose proof (INR_S_pos m) as HM. destruct (ln_gap (INR (S m)) (c + INR (S m)) HM ltac:(lra)) as [A B].
    replace ((c + INR (S m)) / INR (S m) - 1) with (c * / INR (S m)) in B by (field; lra). split. lra.
    assert (ln (INR (S m)) <= ln (c + INR (S m))). { destruct Hc as [Hc|Hc]. left; apply ln_increasing; lra. rewrite <- Hc, Rplus_0_l. lra. } lra.
  - replace (Finite 0) with (Rbar_opp (Rbar_mult c 0)) by (simpl; f_equal; ring). apply -> is_lim_seq_opp. apply is_lim_seq_scal_l.
    replace (Finite 0) with (Rbar_inv p_infty) by auto. apply is_lim_seq_inv. 2: discriminate.
    apply (is_lim_seq_incr_1 INR). apply is_lim_seq_INR.
  - apply is_lim_seq_const.
Qed.

(** There is a function with the properties from which (1.12) is shown, and with Γ(1) = 1: Euler's Γ. *)
Theorem gamma_exists :
  (forall z, 0 < z -> 0 < Gamma z) /\ (forall z, 0 < z -> Gamma (z+1) = z * Gamma z) /\
  (forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (Gamma (t*x + (1-t)*y)) <= t * ln (Gamma x) + (1-t) * ln (Gamma y)) /\
  Gamma 1 = 1.
Proof.
  assert (P : forall z, 0 < Gamma z) by (intros; apply exp_pos). repeat split; auto.
  - intros z Hz. apply ln_inv; auto. apply Rmult_lt_0_compat; auto. rewrite ln_mult by auto.
    assert (F : forall k, falling k (z+1) = falling k z + ln (z+1) - ln (z+1 + INR k)).
    { induction k. simpl. rewrite Rplus_0_r. ring. cbn [falling]. rewrite IHk, S_INR.
      replace (z + 1 + INR k) with (z + (INR k + 1)) by ring. replace (z + 1 + (INR k + 1)) with (z + 1 + INR k + 1) by ring. ring. }
    assert (L1 : is_lim_seq (fun m => euler m (z+1)) (ln (Gamma z) + (ln z + 0))).
    { apply (is_lim_seq_ext (fun m => euler m z + (ln z + (ln (INR (S m)) - ln (z + 1 + INR (S m)))))).
      - intros m. unfold euler. rewrite F. ring.
      - apply is_lim_seq_plus'. apply euler_lim; auto. apply is_lim_seq_plus'. apply is_lim_seq_const. apply ln_shift_lim. lra. }
    apply is_lim_seq_unique in L1. rewrite (is_lim_seq_unique _ _ (euler_lim (z+1) ltac:(lra))) in L1. injection L1. lra.
  - intros x y t Hx Hy Ht. assert (Hm : 0 < t*x + (1-t)*y) by nra.
    assert (F : forall k, falling k (t*x + (1-t)*y) <= t * falling k x + (1-t) * falling k y).
    { induction k. simpl. lra. cbn [falling]. pose proof (INR_S_pos k) as HM. set (M := INR (S k)) in *.
      pose proof (ln_concave (x + M) (y + M) t ltac:(lra) ltac:(lra) Ht) as K.
      replace (t*(x+M) + (1-t)*(y+M)) with (t*x + (1-t)*y + M) in K by ring. lra. }
    apply (is_lim_seq_le (fun m => euler m (t*x + (1-t)*y)) (fun m => t * euler m x + (1-t) * euler m y)
      (ln (Gamma (t*x + (1-t)*y))) (t * ln (Gamma x) + (1-t) * ln (Gamma y))).
    + intros m. unfold euler. pose proof (F (S m)). pose proof (ln_concave x y t Hx Hy Ht). lra.
    + apply euler_lim; auto.
    + apply is_lim_seq_plus'; [apply (is_lim_seq_scal_l _ t (ln (Gamma x))) | apply (is_lim_seq_scal_l _ (1-t) (ln (Gamma y)))]; apply euler_lim; auto.
  - apply ln_inv; auto. lra. rewrite ln_1.
    assert (F : forall k, falling k 1 = - ln (1 + INR k)).
    { induction k. simpl. rewrite Rplus_0_r, ln_1. ring. cbn [falling]. rewrite IHk, S_INR. replace (INR k + 1) with (1 + INR k) by ring. ring. }
    pose proof (ln_shift_lim 1 ltac:(lra)) as L. apply is_lim_seq_unique in L.
    pose proof (is_lim_seq_unique _ _ (euler_lim 1 ltac:(lra))) as L1.
    rewrite (Lim_seq_ext _ (fun m => ln (INR (S m)) - ln (1 + INR (S m)))) in L1.
    rewrite L in L1. injection L1. auto. intros m. unfold euler. rewrite F, ln_1. ring.
Qed.

(** What follows holds for every function with these properties, and so for Γ. *)
Section Doubling.
Variable G : R -> R.
Hypotheses (Gpos : forall z, 0 < z -> 0 < G z) (Gstep : forall z, 0 < z -> G (z+1) = z * G z).
Hypothesis Gconv : forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (G (t*x + (1-t)*y)) <= t * ln (G x) + (1-t) * ln (G y).
Hypothesis G1 : G 1 = 1.

(** Γ(1/2)² = π. *)
Theorem gamma_half : G (/2) = sqrt PI.
Proof.
  pose proof PI_RGT_0. destruct (eq_1_12_gamma G Gpos Gstep Gconv 1 ltac:(lra)) as [H1 _]. rewrite kappa_1 in H1.
  replace ((1+1)/2) with 1 in H1 by field. replace (1/2) with (/2) in H1 by field. rewrite G1 in H1.
  pose proof (sqrt_lt_R0 PI H) as Hs. pose proof (sqrt_sqrt PI ltac:(lra)) as Hq. apply Rmult_eq_reg_l with (sqrt PI); lra.
Qed.

(** Legendre: the product of Γ at two places half a unit apart. *)
Theorem gamma_duplication z : 0 < z -> G z * G (z + /2) = Rpower 2 (1 - 2*z) * sqrt PI * G (2*z).
Proof.
  intros Hz. pose proof PI_RGT_0 as Hpi. pose proof (sqrt_lt_R0 PI Hpi) as Hs.
  set (H := fun z => Rpower 2 (z-1) / sqrt PI * (G (z/2) * G ((z+1)/2))).
  assert (Hpos : forall z, 0 < z -> 0 < H z).
  { intros y Hy. unfold H. pose proof (Gpos (y/2) ltac:(lra)). pose proof (Gpos ((y+1)/2) ltac:(lra)). pos. }
  assert (HH : G (2*z) = H (2*z)).
  { apply gamma_unique; auto; try lra.
    - intros y Hy. unfold H. replace ((y+1+1)/2) with (y/2+1) by field. rewrite Gstep by lra.
      replace (y+1-1) with (y-1+1) by ring. rewrite Rpower_plus, Rpower_1 by lra. field. lra.
    - intros x y t Hx Hy Ht. assert (Hm : 0 < t*x + (1-t)*y) by nra.
      assert (L : forall u, 0 < u -> ln (H u) = (u-1) * ln 2 - ln (sqrt PI) + (ln (G (u/2)) + ln (G ((u+1)/2)))).
      { intros u Hu. unfold H. pose proof (Gpos (u/2) ltac:(lra)). pose proof (Gpos ((u+1)/2) ltac:(lra)).
        rewrite ln_mult, ln_div, ln_Rpower, ln_mult by pos. ring. }
      rewrite !L by auto. pose proof (Gconv (x/2) (y/2) t ltac:(lra) ltac:(lra) Ht) as K1.
      pose proof (Gconv ((x+1)/2) ((y+1)/2) t ltac:(lra) ltac:(lra) Ht) as K2.
      replace (t*(x/2) + (1-t)*(y/2)) with ((t*x + (1-t)*y)/2) in K1 by field.
      replace (t*((x+1)/2) + (1-t)*((y+1)/2)) with ((t*x + (1-t)*y + 1)/2) in K2 by field. lra.
    - unfold H. replace (1-1) with 0 by ring. replace ((1+1)/2) with 1 by field. replace (1/2) with (/2) by field.
      rewrite Rpower_O, G1, gamma_half by lra. field. lra. }
  rewrite HH. unfold H. replace (2*z/2) with z by field. replace ((2*z+1)/2) with (z + /2) by field.
  replace (1 - 2*z) with (- (2*z-1)) by ring. rewrite Rpower_Ropp. pose proof (Rp_pos 2 (2*z-1)). field. lra.
Qed.

(** (1.18) as it is printed: κ_½ = (1/4) π^(3/2) sqrt 2 / Γ(3/4)². *)
Theorem eq_1_18_gamma : kappa (/2) = 1/4 * (Rpower PI (3/2) * sqrt 2 / G (3/4) ^ 2).
Proof.
  pose proof PI_RGT_0 as Hpi. destruct (eq_1_12_gamma G Gpos Gstep Gconv (/2) ltac:(lra)) as [H1 _]. rewrite H1.
  pose proof (gamma_duplication (/4) ltac:(lra)) as D. replace (/4 + /2) with (3/4) in D by field.
  replace (2 * /4) with (/2) in D by field. rewrite gamma_half in D. replace (1 - /2) with (/2) in D by field.
  rewrite Rpower_sqrt in D by lra. replace (/2/2) with (/4) by field. replace ((/2+1)/2) with (3/4) by field.
  replace (3/2) with (1 + /2) by field. rewrite Rpower_plus, Rpower_1, Rpower_sqrt by auto.
  pose proof (sqrt_sqrt PI ltac:(lra)) as Hq. pose proof (Gpos (3/4) ltac:(lra)) as Hp.
  replace (G (/4)) with (sqrt 2 * PI / G (3/4)). field. lra.
  apply Rmult_eq_reg_r with (G (3/4)). 2: lra. rewrite D. rewrite <- Hq at 1. field. lra.
Qed.
End Doubling.
