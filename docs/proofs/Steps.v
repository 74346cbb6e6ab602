(** The statements of `Statements.v` that normal forms decide, as Coq decides them: `step` takes derivatives by their rules, integrals of
    powers by their values, splits real powers and roots, and leaves a field. What has its own proof has a comment or a
    theorem. What is left out stands in left_out.tsv beside the table of theorems. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Powers.
Require MDR.Definitions MDR.Kappa.
Require Import MDR.Statements MDR.StepTactics.
Open Scope R_scope.

Lemma prove_step_1_1_2 : step_1_1_2.
Proof. unfold step_1_1_2. step. Qed.

Lemma prove_step_1_1_3 : step_1_1_3.
Proof.
  unfold step_1_1_3. begin. slopes. exponents. atoms. field_simplify_eq; [|nonzero]. replace (cos theta ^ 2) with (1 -
    sin theta ^ 2) by (pose proof (sin2_cos2 theta); unfold Rsqr in *; lra). ring.
Qed.

Lemma prove_step_1_1_4 : step_1_1_4.
Proof.
  unfold step_1_1_4. begin. exponents. atoms. replace (cos theta ^ 2) with (1 - sin theta ^ 2) by (pose proof
    (sin2_cos2 theta); unfold Rsqr in *; lra). field. nonzero.
Qed.

Lemma prove_step_1_2_2 : step_1_2_2.
Proof. unfold step_1_2_2. step. Qed.

Lemma prove_step_1_2_3 : step_1_2_3.
Proof. unfold step_1_2_3. scaling. Qed.

Lemma prove_step_1_3_2 : step_1_3_2.
Proof. unfold step_1_3_2. step. Qed.

Lemma prove_step_1_3_3 : step_1_3_3.
Proof. unfold step_1_3_3. step. Qed.

Lemma prove_step_1_4_2 : step_1_4_2.
Proof. unfold step_1_4_2. step. Qed.

Lemma prove_step_1_4_3 : step_1_4_3.
Proof. unfold step_1_4_3. step. Qed.

Lemma prove_step_1_4_4 : step_1_4_4.
Proof. unfold step_1_4_4. step. Qed.

Lemma prove_step_1_4_5 : step_1_4_5.
Proof. unfold step_1_4_5. scaling. Qed.

Lemma prove_step_1_5_1 : step_1_5_1.
Proof. unfold step_1_5_1. step. Qed.

Lemma prove_step_1_5_2 : step_1_5_2.
Proof. unfold step_1_5_2. step. Qed.

Lemma prove_step_1_6_1 : step_1_6_1.
Proof. unfold step_1_6_1. step. Qed.

Lemma prove_step_1_6_2 : step_1_6_2.
Proof. unfold step_1_6_2. step. Qed.

Lemma prove_step_1_6_3 : step_1_6_3.
Proof. unfold step_1_6_3. step. Qed.

Lemma prove_step_1_7_1 : step_1_7_1.
Proof.
  unfold step_1_7_1. begin. slopes. assert (sqrt (2 * PI * a * w / E) * sqrt (2 * PI * a * w / E) = 2 * PI * a * w /
    E) as Hl by (apply sqrt_sqrt; left; pos). generalize dependent (sqrt (2 * PI * a * w / E)). intros l Hd Hl.
    replace w with (l * l * E / (2 * PI * a)) by (rewrite Hl; field; nonzero). field. pose proof PI_RGT_0. repeat
    split; first [lra | intro H5; apply Hd; rewrite H5; ring].
Qed.

Lemma prove_step_1_8_1 : step_1_8_1.
Proof. unfold step_1_8_1. begin. positive (E * (2 * sqrt (2 * PI * a * w / E) * delta + delta ^ 2)). Qed.

Lemma prove_step_1_9_1 : step_1_9_1.
Proof. unfold step_1_9_1. begin. negative (E * (2 * y * delta + delta ^ 2)). Qed.

Lemma prove_step_1_9_2 : step_1_9_2.
Proof. unfold step_1_9_2. begin. negative (E * (2 * y * delta + delta ^ 2)). Qed.

Lemma prove_step_1_9_3 : step_1_9_3.
Proof. unfold step_1_9_3. begin. negative (2 * PI * a * w). Qed.

Lemma prove_step_1_10_1 : step_1_10_1.
Proof. unfold step_1_10_1. step. Qed.

Lemma prove_step_1_10_2 : step_1_10_2.
Proof. unfold step_1_10_2. step. Qed.

Lemma prove_step_1_11_1 : step_1_11_1.
Proof. unfold step_1_11_1. step. Qed.

Lemma prove_step_1_11_2 : step_1_11_2.
Proof. unfold step_1_11_2. step. Qed.

Lemma prove_step_1_11_3 : step_1_11_3.
Proof. unfold step_1_11_3. begin. positive ((2 * n - 1) * sqrt (PI * w / (2 * E)) / sqrt a). Qed.

Lemma prove_step_1_11_4 : step_1_11_4.
Proof. unfold step_1_11_4. begin. negative ((1 - 2 * n) * sqrt (PI * w / (2 * E)) / sqrt a). Qed.

Lemma prove_step_1_12_2 : step_1_12_2.
Proof.
  unfold step_1_12_2. intros n Gamma Hn [_ [H1 [H2 _]]]. replace (1 + n / 2) with (n / 2 + 1) by ring. rewrite H2 by
    lra. pose proof (H1 ((n + 1) / 2) ltac:(lra)). field. lra.
Qed.

Lemma prove_step_1_12_3 : step_1_12_3.
Proof. unfold step_1_12_3. pose proof Kappa.kappa_values. tauto. Qed.

Lemma prove_step_1_12_4 : step_1_12_4.
Proof. unfold step_1_12_4. pose proof Kappa.kappa_values. tauto. Qed.

Lemma prove_step_kappa_recurrences_1 : step_kappa_recurrences_1.
Proof.
  unfold step_kappa_recurrences_1. intros n Gamma Hn [_ [H1 [H2 H3]]]. rewrite (proj1 (Kappa.eq_1_12_gamma Gamma H1 H2
    H3 n Hn)). unfold Rdiv. ring.
Qed.

Lemma prove_step_kappa_recurrences_2 : step_kappa_recurrences_2.
Proof. unfold step_kappa_recurrences_2. intros n Hn. apply (Kappa.kappa_recurrences n Hn). Qed.

Lemma prove_step_kappa_recurrences_3 : step_kappa_recurrences_3.
Proof. unfold step_kappa_recurrences_3. intros n Hn. apply (Kappa.kappa_recurrences n Hn). Qed.

Lemma prove_step_kappa_recurrences_4 : step_kappa_recurrences_4.
Proof. unfold step_kappa_recurrences_4. pose proof Kappa.kappa_values. tauto. Qed.

Lemma prove_step_kappa_recurrences_5 : step_kappa_recurrences_5.
Proof. unfold step_kappa_recurrences_5. pose proof Kappa.kappa_values. tauto. Qed.

Lemma prove_step_kappa_growth_1 : step_kappa_growth_1.
Proof. unfold step_kappa_growth_1. begin. slopes. exponents. atoms. field. nonzero. Qed.

Lemma prove_step_kappa_growth_2 : step_kappa_growth_2.
Proof. unfold step_kappa_growth_2. begin. positive (2 * eps / (n * (n + eps))). Qed.

Lemma prove_step_kappa_series_2 : step_kappa_series_2.
Proof. unfold step_kappa_series_2. step. Qed.

Lemma prove_step_kappa_series_3 : step_kappa_series_3.
Proof. unfold step_kappa_series_3. step. Qed.

Lemma prove_step_kappa_series_4 : step_kappa_series_4.
Proof. unfold step_kappa_series_4. step. Qed.

Lemma prove_step_kappa_series_5 : step_kappa_series_5.
Proof. unfold step_kappa_series_5. step. Qed.

Lemma prove_step_kappa_series_6 : step_kappa_series_6.
Proof. unfold step_kappa_series_6. step. Qed.

Lemma prove_step_kappa_series_7 : step_kappa_series_7.
Proof. unfold step_kappa_series_7. step. Qed.

Lemma prove_step_kappa_series_8 : step_kappa_series_8.
Proof. unfold step_kappa_series_8. step. Qed.

Lemma prove_step_kappa_series_9 : step_kappa_series_9.
Proof. unfold step_kappa_series_9. step. Qed.

Lemma prove_step_kappa_series_10 : step_kappa_series_10.
Proof. unfold step_kappa_series_10. step. Qed.

Lemma prove_step_kappa_series_11 : step_kappa_series_11.
Proof. unfold step_kappa_series_11. step. Qed.

Lemma prove_step_kappa_series_12 : step_kappa_series_12.
Proof. unfold step_kappa_series_12. step. Qed.

Lemma prove_step_kappa_elliptic_9 : step_kappa_elliptic_9.
Proof.
  unfold step_kappa_elliptic_9. intros n Hn. pose proof (Kappa.kappa_pos n Hn). destruct (Kappa.kappa_recurrences n
    Hn) as [H1 _]. apply Rmult_eq_reg_l with (Definitions.kappa n); [rewrite H1; field|]; lra.
Qed.

Lemma prove_step_1_13_1 : step_1_13_1.
Proof. unfold step_1_13_1. step. Qed.

Lemma prove_step_1_13_2 : step_1_13_2.
Proof. unfold step_1_13_2. scaling. Qed.

Lemma prove_step_1_14_1 : step_1_14_1.
Proof. unfold step_1_14_1. step. Qed.

Lemma prove_step_1_14_2 : step_1_14_2.
Proof. unfold step_1_14_2. step. Qed.

Lemma prove_step_1_15_5 : step_1_15_5.
Proof.
  unfold step_1_15_5. intros n E w C kap Hn Hh HE Hw HC Hk. replace (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) with
    (B E w / (N n C kap) ^ 2) by (unfold B, N; field; nonzero). fold (a_c n E w C kap). step.
Qed.

Lemma prove_step_1_15_6 : step_1_15_6.
Proof. unfold step_1_15_6. scaling. Qed.

Lemma prove_step_1_15_7 : step_1_15_7.
Proof.
  unfold step_1_15_7. intros. cbv zeta. replace (Definitions.kappa 2) with 2 by (symmetry; apply Kappa.kappa_values).
    unfold a_c, B, N. mono.
Qed.

Lemma prove_step_1_15_8 : step_1_15_8.
Proof. unfold step_1_15_8. begin. positive ((2 * n - 1) / 2 * sqrt (PI * w / (2 * E)) / (a * sqrt a)). Qed.

Lemma prove_step_1_15_9 : step_1_15_9.
Proof. unfold step_1_15_9. begin. negative ((1 - 2 * n) / 2 * sqrt (PI * w / (2 * E)) / (a * sqrt a)). Qed.

Lemma prove_step_1_16_1 : step_1_16_1.
Proof. unfold step_1_16_1. step. Qed.

Lemma prove_step_1_16_2 : step_1_16_2.
Proof. unfold step_1_16_2. step. Qed.

Lemma prove_step_1_16_3 : step_1_16_3.
Proof. unfold step_1_16_3. step. Qed.

Lemma prove_step_1_16_4 : step_1_16_4.
Proof. unfold step_1_16_4. step. Qed.

Lemma prove_step_1_17_3 : step_1_17_3.
Proof. unfold step_1_17_3. step. Qed.

Lemma prove_step_1_17_1 : step_1_17_1.
Proof.
  unfold step_1_17_1. intros n E w C kap Hn Hh HE Hw HC Hk. rewrite prove_step_1_17_3 by assumption. f_equal. unfold
    a_c, B, N. mono.
Qed.

Lemma prove_step_1_17_4 : step_1_17_4.
Proof.
  unfold step_1_17_4. begin. negative (2 * (2 * n + 1) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a * sqrt a)).
Qed.

Lemma prove_step_1_17_5 : step_1_17_5.
Proof.
  unfold step_1_17_5. intros. cbv zeta. replace (Definitions.kappa 2) with 2 by (symmetry; apply Kappa.kappa_values).
    rewrite prove_step_1_17_3 by (lra || pos). assert (E * sqrt (B E w) * Rpower (a_c 2 E w (1 / (2 * Rad)) 2) (3 / 2)
    = PI * w * Rad / 4) as Hq by (unfold a_c, B, N; mono). rewrite !Rmult_assoc in *. rewrite Hq. field.
Qed.

Lemma prove_step_critical_indentation_1 : step_critical_indentation_1.
Proof. unfold step_critical_indentation_1. step. Qed.

Lemma prove_step_critical_indentation_2 : step_critical_indentation_2.
Proof.
  unfold step_critical_indentation_2. begin. negative ((2 * n - 1) / n * sqrt (PI * w / (2 * E)) * sqrt a).
Qed.

Lemma prove_step_critical_indentation_3 : step_critical_indentation_3.
Proof.
  unfold step_critical_indentation_3. begin. positive ((1 - 2 * n) / n * sqrt (PI * w / (2 * E)) * sqrt a).
Qed.

Lemma prove_step_critical_indentation_4 : step_critical_indentation_4.
Proof. unfold step_critical_indentation_4. step. Qed.

Lemma prove_step_critical_indentation_5 : step_critical_indentation_5.
Proof. unfold step_critical_indentation_5. intros. unfold a_z, a_c, B, N. mono. Qed.

Lemma prove_step_critical_indentation_7 : step_critical_indentation_7.
Proof.
  unfold step_critical_indentation_7. begin. negative (2 * (2 * n + 1) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a *
    sqrt a)).
Qed.

Lemma prove_step_1_18_2 : step_1_18_2.
Proof. unfold step_1_18_2. step. Qed.

Lemma prove_step_1_19_1 : step_1_19_1.
Proof. unfold step_1_19_1. step. Qed.

Lemma prove_step_1_19_2 : step_1_19_2.
Proof. unfold step_1_19_2. step. Qed.

Lemma prove_step_1_19_3 : step_1_19_3.
Proof. unfold step_1_19_3. begin. positive (t * sqrt (2 * PI * w * a / E)). Qed.

Lemma prove_step_1_19_4 : step_1_19_4.
Proof. unfold step_1_19_4. begin. negative (t * sqrt (2 * PI * w * a / E)). Qed.

Lemma prove_step_threshold_force_1 : step_threshold_force_1.
Proof. unfold step_threshold_force_1. step. Qed.

Lemma prove_step_threshold_force_2 : step_threshold_force_2.
Proof. unfold step_threshold_force_2. step. Qed.

Lemma prove_step_threshold_force_3 : step_threshold_force_3.
Proof. unfold step_threshold_force_3. begin. negative (2 * E * a * sqrt (2 * PI * w * a / E) * t / 3). Qed.

Lemma prove_step_threshold_force_4 : step_threshold_force_4.
Proof. unfold step_threshold_force_4. begin. positive (E * t * sqrt (2 * PI * w * a / E)). Qed.

Lemma prove_step_critical_force_1 : step_critical_force_1.
Proof. unfold step_critical_force_1. step. Qed.

Lemma prove_step_critical_force_2 : step_critical_force_2.
Proof. unfold step_critical_force_2. step. Qed.

Lemma prove_step_critical_force_3 : step_critical_force_3.
Proof. unfold step_critical_force_3. step. Qed.

Lemma prove_step_critical_force_4 : step_critical_force_4.
Proof. unfold step_critical_force_4. step. Qed.

Lemma prove_step_critical_force_5 : step_critical_force_5.
Proof. unfold step_critical_force_5. intros. unfold a_F, a_c, B, N. mono. Qed.

Lemma prove_step_critical_force_6 : step_critical_force_6.
Proof. unfold step_critical_force_6. step. Qed.

Lemma prove_step_critical_force_7 : step_critical_force_7.
Proof. unfold step_critical_force_7. step. Qed.

Lemma prove_step_critical_force_8 : step_critical_force_8.
Proof. unfold step_critical_force_8. step. Qed.

Lemma prove_step_critical_force_9 : step_critical_force_9.
Proof.
  unfold step_critical_force_9. begin. negative (2 * (2 * n - 1) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a * sqrt
    a)).
Qed.

Lemma prove_step_critical_force_10 : step_critical_force_10.
Proof.
  unfold step_critical_force_10. begin. positive (2 * (1 - 2 * n) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a * sqrt
    a)).
Qed.

Lemma prove_step_critical_force_11 : step_critical_force_11.
Proof.
  unfold step_critical_force_11. intros. cbv zeta. replace (Definitions.kappa 2) with 2 by (symmetry; apply
    Kappa.kappa_values). rewrite prove_step_critical_force_8 by (lra || pos). assert (E * sqrt (B E w) * Rpower (a_F 2
    E w (1 / (2 * Rad)) 2) (3 / 2) = 3 * (PI * w * Rad / 4)) as Hq by (unfold a_F, B, N; mono). rewrite !Rmult_assoc
    in *. rewrite Hq. field.
Qed.

Lemma prove_step_critical_force_12 : step_critical_force_12.
Proof.
  unfold step_critical_force_12. begin. positive (3 * E * (2 * n - 1) * sqrt (PI * w / (2 * E)) / sqrt a).
Qed.

Lemma prove_step_critical_force_13 : step_critical_force_13.
Proof.
  unfold step_critical_force_13. begin. negative (3 * E * (1 - 2 * n) * sqrt (PI * w / (2 * E)) / sqrt a).
Qed.

Lemma prove_step_maugis_dugdale_1 : step_maugis_dugdale_1.
Proof. unfold step_maugis_dugdale_1. step. Qed.

Lemma prove_step_maugis_dugdale_2 : step_maugis_dugdale_2.
Proof.
  unfold step_maugis_dugdale_2. begin. slopes. pose proof (sin2_cos2 theta). unfold Rsqr in *. nra.
Qed.

Lemma prove_step_maugis_dugdale_3 : step_maugis_dugdale_3.
Proof. unfold step_maugis_dugdale_3. step. Qed.

Lemma prove_step_maugis_dugdale_4 : step_maugis_dugdale_4.
Proof. unfold step_maugis_dugdale_4. step. Qed.

Lemma prove_step_maugis_dugdale_5 : step_maugis_dugdale_5.
Proof. unfold step_maugis_dugdale_5. step. Qed.

Lemma prove_step_maugis_dugdale_6 : step_maugis_dugdale_6.
Proof. unfold step_maugis_dugdale_6. step. Qed.

Lemma prove_step_maugis_dugdale_7 : step_maugis_dugdale_7.
Proof.
  unfold step_maugis_dugdale_7. intros. cbv zeta. replace (Definitions.kappa 2) with 2 by (symmetry; apply
    Kappa.kappa_values). unfold dl, a_F, B, N. mono.
Qed.

Lemma prove_step_critical_machine_1 : step_critical_machine_1.
Proof. unfold step_critical_machine_1. step. Qed.

Lemma prove_step_critical_machine_2 : step_critical_machine_2.
Proof. unfold step_critical_machine_2. step. Qed.

Lemma prove_step_critical_machine_3 : step_critical_machine_3.
Proof. unfold step_critical_machine_3. step. Qed.

Lemma prove_step_critical_machine_4 : step_critical_machine_4.
Proof. unfold step_critical_machine_4. step. Qed.

Lemma prove_step_critical_machine_5 : step_critical_machine_5.
Proof. unfold step_critical_machine_5. step. Qed.

Lemma prove_step_critical_machine_6 : step_critical_machine_6.
Proof. unfold step_critical_machine_6. step. Qed.

Lemma prove_step_critical_machine_7 : step_critical_machine_7.
Proof. unfold step_critical_machine_7. step. Qed.

Lemma prove_step_critical_machine_8 : step_critical_machine_8.
Proof. unfold step_critical_machine_8. begin. positive (4 * E * k / (k + 2 * E * a) ^ 2). Qed.

Lemma prove_step_critical_machine_9 : step_critical_machine_9.
Proof. unfold step_critical_machine_9. step. Qed.

Lemma prove_step_critical_machine_10 : step_critical_machine_10.
Proof. unfold step_critical_machine_10. step. Qed.

Lemma prove_step_critical_machine_11 : step_critical_machine_11.
Proof. unfold step_critical_machine_11. step. Qed.

Lemma prove_step_machine_folds_1 : step_machine_folds_1.
Proof. unfold step_machine_folds_1. step. Qed.

Lemma prove_step_machine_folds_2 : step_machine_folds_2.
Proof. unfold step_machine_folds_2. step. Qed.

Lemma prove_step_machine_folds_3 : step_machine_folds_3.
Proof. unfold step_machine_folds_3. step. Qed.

Lemma prove_step_machine_folds_4 : step_machine_folds_4.
Proof. unfold step_machine_folds_4. step. Qed.

Lemma prove_step_machine_folds_5 : step_machine_folds_5.
Proof. unfold step_machine_folds_5. step. Qed.

Lemma prove_step_machine_folds_6 : step_machine_folds_6.
Proof. unfold step_machine_folds_6. step. Qed.

Lemma prove_step_machine_half_1 : step_machine_half_1.
Proof. unfold step_machine_half_1. step. Qed.

Lemma prove_step_machine_half_2 : step_machine_half_2.
Proof.
  unfold step_machine_half_2. intros E k rho HE Hk Hr H1 H2. unfold a_k in *. cbv zeta in *. unfold lam. assert (3 -
    rho <> 0) by (intro H3; apply H1; rewrite H3; ring). field. split. 2: nonzero. intro H3. apply H2. apply
    Rmult_eq_reg_r with (2 * E * (3 - rho)). 2: assumption. field_simplify; nra.
Qed.

Lemma prove_step_universal_curves_1 : step_universal_curves_1.
Proof. unfold step_universal_curves_1. step. Qed.

Lemma prove_step_universal_curves_2 : step_universal_curves_2.
Proof. unfold step_universal_curves_2. step. Qed.

Lemma prove_step_universal_curves_3 : step_universal_curves_3.
Proof. unfold step_universal_curves_3. step. Qed.

Lemma prove_step_work_pull_off_1 : step_work_pull_off_1.
Proof. unfold step_work_pull_off_1. step. Qed.

Lemma prove_step_work_pull_off_2 : step_work_pull_off_2.
Proof.
  unfold step_work_pull_off_2. begin. match goal with |- Derive ?f a = _ => rewrite (Derive_ext_loc f (fun a => E * (d
    ^ 2 * a - 2 * d * (kap * C) * (Rpower a (n + 1) / (n + 1)) + (kap * C) ^ 2 * (Rpower a (2 * n + 1) / (2 * n + 1)))
    - PI * a ^ 2 * w)) end. finish. exists (mkposreal a ltac:(assumption)). intros y Hy. change (Rabs (y - a) < a) in
    Hy. apply Rabs_def2 in Hy. rewrite int_gap_square by lra. reflexivity.
Qed.

Lemma prove_step_work_pull_off_3 : step_work_pull_off_3.
Proof. unfold step_work_pull_off_3. step. Qed.

Lemma prove_step_work_pull_off_4 : step_work_pull_off_4.
Proof.
  unfold step_work_pull_off_4. begin. positive (n * (2 * n - 1) / ((n + 1) * (2 * n + 1)) * PI * a ^ 2 * w).
Qed.

Lemma prove_step_work_pull_off_5 : step_work_pull_off_5.
Proof. unfold step_work_pull_off_5. step. Qed.

Lemma prove_step_work_jump_in_1 : step_work_jump_in_1.
Proof. unfold step_work_jump_in_1. step. Qed.

Lemma prove_step_work_jump_in_2 : step_work_jump_in_2.
Proof. unfold step_work_jump_in_2. begin. negative ((2 * n - 1) / (2 * n + 1) * PI * a ^ 2 * w). Qed.

Lemma prove_step_work_jump_in_3 : step_work_jump_in_3.
Proof. unfold step_work_jump_in_3. begin. positive ((1 - 2 * n) / (2 * n + 1) * PI * a ^ 2 * w). Qed.

Lemma prove_step_work_jump_in_4 : step_work_jump_in_4.
Proof. unfold step_work_jump_in_4. step. Qed.

Lemma prove_step_kendall_1 : step_kendall_1.
Proof. unfold step_kendall_1. intros. cbv zeta. unfold a_c, B, N. mono. Qed.

Lemma prove_step_kendall_4 : step_kendall_4.
Proof. unfold step_kendall_4. step. Qed.

Lemma prove_step_kendall_5 : step_kendall_5.
Proof. unfold step_kendall_5. step. Qed.

Lemma prove_step_kendall_6 : step_kendall_6.
Proof. unfold step_kendall_6. step. Qed.

Lemma prove_step_wavy_2 : step_wavy_2.
Proof.
  unfold step_wavy_2. intros. cbv zeta. replace (Definitions.kappa 2) with 2 by (symmetry; apply Kappa.kappa_values).
    field. nonzero.
Qed.
