(** The statements of `Statements.v` that rigorous intervals enclose or sample, and for which there is a theorem. They are listed in
    by_theorem.tsv beside the table of theorems. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import MDR.Powers.
Require MDR.Definitions MDR.Kappa MDR.KappaSeries MDR.Agm MDR.AgmRational MDR.Profiles.
Require Import MDR.Statements.
Open Scope R_scope.

Lemma prove_step_1_12_1 : step_1_12_1.
Proof.
  unfold step_1_12_1. intros n Gamma Hn [_ [H1 [H2 H3]]].
  destruct (Kappa.eq_1_12_gamma Gamma H1 H2 H3 n Hn) as [H _]. unfold Definitions.kappa, Definitions.W in H.
  replace (sqrt PI / 2 * n * Gamma (n/2) / Gamma ((n+1)/2)) with (sqrt PI / 2 * (n * Gamma (n/2)) / Gamma ((n+1)/2)) by (unfold Rdiv; ring).
  rewrite <- H. f_equal. apply RInt_ext. intros t Ht. pose proof PI_RGT_0. rewrite Rmin_left, Rmax_right in Ht by lra.
  symmetry. apply pw_pos. apply sin_gt_0; lra.
Qed.

Lemma prove_step_kappa_growth_3 : step_kappa_growth_3.
Proof. unfold step_kappa_growth_3. intros n Hn. apply Rlt_gt, Kappa.kappa_growth; lra. Qed.

Lemma prove_step_kappa_series_1 : step_kappa_series_1.
Proof.
  unfold step_kappa_series_1, kappa_gamma, KappaSeries.f. intros n Gamma Hn [_ [H1 [H2 H3]]].
  rewrite (is_series_unique _ _ (KappaSeries.kappa_series n Hn)), (proj1 (Kappa.eq_1_12_gamma Gamma H1 H2 H3 n Hn)). unfold Rdiv. ring.
Qed.

Lemma prove_step_kappa_elliptic_2 : step_kappa_elliptic_2.
Proof.
  unfold step_kappa_elliptic_2. intros n Hn. rewrite <- (Agm.gauss_agm 1 n) by lra. apply RInt_ext. intros t _.
  f_equal. f_equal. ring.
Qed.

Lemma prove_step_kappa_elliptic_3 : step_kappa_elliptic_3.
Proof. unfold step_kappa_elliptic_3. replace (1/2) with (/2) by lra. apply Agm.kappa_elliptic. Qed.

Lemma prove_step_kappa_elliptic_4 : step_kappa_elliptic_4.
Proof. unfold step_kappa_elliptic_4. replace (1/3) with (/3) by lra. replace (1/4) with (/4) by lra. apply AgmRational.kappa_third. Qed.

Lemma prove_step_kappa_elliptic_5 : step_kappa_elliptic_5.
Proof. unfold step_kappa_elliptic_5. replace (1/4) with (/4) by lra. apply AgmRational.kappa_quarter. Qed.

Lemma prove_step_kappa_elliptic_7 : step_kappa_elliptic_7.
Proof. unfold step_kappa_elliptic_7. replace (1/3) with (/3) by lra. apply AgmRational.kappa_two_thirds. Qed.

Lemma prove_step_kappa_elliptic_8 : step_kappa_elliptic_8.
Proof. unfold step_kappa_elliptic_8. replace (1/4) with (/4) by lra. apply AgmRational.kappa_three_quarters. Qed.

(* after one step of the means the larger is 1, and sqrt (1 - n²) is below 1 - n²/2 *)
Lemma prove_step_kappa_elliptic_10 : step_kappa_elliptic_10.
Proof.
  unfold step_kappa_elliptic_10. intros n Hn. destruct (Agm.agm_bounds 1 (1 + n) (1 - n) ltac:(lra) ltac:(lra)) as [_ U]. simpl in U.
  assert (S : sqrt ((1 + n) * (1 - n)) < 1 - n^2/2).
  { rewrite <- (sqrt_pow2 (1 - n^2/2)) by nra. apply sqrt_lt_1_alt. assert (0 < (n * n) * (n * n)) by (repeat apply Rmult_lt_0_compat; lra).
    split. nra. replace ((1 - n^2/2)^2) with ((1 + n) * (1 - n) + (n * n) * (n * n) / 4) by field. lra. }
  apply Rle_lt_trans with (1 := U). lra.
Qed.

(* after two the smaller one is (1 - n²)^(1/4) *)
Lemma prove_step_kappa_elliptic_11 : step_kappa_elliptic_11.
Proof.
  unfold step_kappa_elliptic_11. intros n Hn. destruct (Agm.agm_bounds 1 (1 + n) (1 - n) ltac:(lra) ltac:(lra)) as [L _]. simpl in L.
  apply Rlt_le_trans with (2 := L). set (y := n^2/4 + n^4/4). replace (1 - n^2/4 - n^4/4) with (1 - y) by (unfold y; ring).
  assert (Hx : 0 < n^2 < 1/4) by nra. assert (Hy : 0 < y <= 5/16 * n^2) by (unfold y; nra).
  replace ((1 + n + (1 - n))/2) with 1 by field. rewrite Rmult_1_l.
  assert (P : (1 - y)^4 < (1 + n) * (1 - n)).
  { assert (H1 : (1 - y)^4 <= 1 - 4*y + 6*y^2). { replace ((1 - y)^4) with (1 - 4*y + 6*y^2 - y^3*(4 - y)) by ring. assert (0 < y^3*(4 - y)); [|lra]. apply Rmult_lt_0_compat. apply pow_lt; lra. nra. } assert (H2 : y^2 <= 25/256 * (n^2 * n^2)) by nra.
    replace (4*y) with (n^2 + n^2 * n^2) in H1 by (unfold y; field). nra. }
  rewrite <- (sqrt_pow2 (1 - y)) by nra. apply sqrt_lt_1_alt. split. apply pow2_ge_0.
  rewrite <- (sqrt_pow2 ((1 - y)^2)) by apply pow2_ge_0. apply sqrt_lt_1_alt. split. apply pow2_ge_0. replace (((1 - y)^2)^2) with ((1 - y)^4) by ring. exact P.
Qed.

Lemma prove_step_critical_indentation_6 : step_critical_indentation_6.
Proof.
  unfold step_critical_indentation_6. intros n Hn. unfold Rpower.
  enough (H : 1 / (2*n - 1) * ln (4 * (n + 1)^2) < 0) by (apply exp_increasing in H; rewrite exp_0 in H; exact H).
  assert (0 < ln (4 * (n + 1)^2)). { rewrite <- ln_1. apply ln_increasing; nra. }
  assert (1 / (2*n - 1) < 0). { unfold Rdiv. rewrite Rmult_1_l. apply Rinv_lt_0_compat. lra. }
  set (p := 1 / (2*n - 1)) in *. set (l := ln (4 * (n + 1)^2)) in *. nra.
Qed.

Lemma prove_step_1_18_3 : step_1_18_3.
Proof. exact prove_step_kappa_elliptic_3. Qed.

(* κ_½ and its inverse, of which a theorem has twelve digits *)
Ltac digits := replace (1/2) with (/2) by lra; pose proof Agm.eq_1_19_digits; pose proof (Kappa.kappa_pos (/2) ltac:(lra)); lra.

Lemma prove_step_1_18_4 : step_1_18_4.
Proof. unfold step_1_18_4. digits. Qed.

Lemma prove_step_1_18_5 : step_1_18_5.
Proof. unfold step_1_18_5. digits. Qed.

Lemma prove_step_1_19_5 : step_1_19_5.
Proof. unfold step_1_19_5. replace (1/2) with (/2) by lra. exact Agm.eq_1_19_threshold. Qed.

Lemma prove_step_1_19_6 : step_1_19_6.
Proof. unfold step_1_19_6. digits. Qed.

Lemma prove_step_1_19_7 : step_1_19_7.
Proof. unfold step_1_19_7. digits. Qed.

Lemma prove_step_threshold_force_5 : step_threshold_force_5.
Proof.
  unfold step_threshold_force_5. replace (3 / Definitions.kappa (1/2)) with (3 * (1 / Definitions.kappa (1/2))) by (unfold Rdiv; ring). digits.
Qed.

Lemma prove_step_threshold_force_6 : step_threshold_force_6.
Proof.
  unfold step_threshold_force_6. replace (3 / Definitions.kappa (1/2)) with (3 * (1 / Definitions.kappa (1/2))) by (unfold Rdiv; ring). digits.
Qed.

Lemma prove_step_kendall_2 : step_kendall_2.
Proof. unfold step_kendall_2. intros n Hn. apply Rlt_gt, Kappa.kappa_lower; auto. Qed.

Lemma prove_step_kendall_3 : step_kendall_3.
Proof. unfold step_kendall_3. intros n Hn. apply Kappa.kappa_upper; auto. Qed.

Lemma prove_step_wavy_1 : step_wavy_1.
Proof.
  unfold step_wavy_1, Profiles.struve. intros z Hz. pose proof PI_RGT_0.
  set (i := RInt _ _ _ : R). change (@eq R i (PI / 2 * (2 / PI * i))). field. lra.
Qed.

Lemma prove_step_line_contact_5 : step_line_contact_5.
Proof.
  unfold step_line_contact_5. replace (1/2) with (/2) by lra. pose proof Agm.eq_1_19_digits as [_ [L _]].
  assert (P : 3 < PI < 3.141592653590) by (split; interval with (i_prec 80)).
  apply Rlt_gt, (Rmult_lt_reg_r PI). lra. replace (4 * Definitions.kappa (/2) / PI * PI) with (4 * Definitions.kappa (/2)) by (field; lra). lra.
Qed.

Lemma prove_step_line_contact_6 : step_line_contact_6.
Proof.
  unfold step_line_contact_6. replace (1/2) with (/2) by lra. pose proof Agm.eq_1_19_digits as [_ [_ U]].
  assert (P : 3.141592653589 < PI) by interval with (i_prec 80).
  apply (Rmult_lt_reg_r PI). lra. replace (4 * Definitions.kappa (/2) / PI * PI) with (4 * Definitions.kappa (/2)) by (field; lra). lra.
Qed.
