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

Lemma prove_step_hysteresis_1 : step_hysteresis_1.
Proof. unfold step_hysteresis_1. step. Qed.

Lemma prove_step_hysteresis_2 : step_hysteresis_2.
Proof. unfold step_hysteresis_2. step. Qed.

Lemma prove_step_hysteresis_3 : step_hysteresis_3.
Proof. unfold step_hysteresis_3. step. Qed.

Lemma prove_step_hysteresis_4 : step_hysteresis_4.
Proof. unfold step_hysteresis_4. step. Qed.

Lemma prove_step_hysteresis_5 : step_hysteresis_5.
Proof. unfold step_hysteresis_5. step. Qed.

Lemma prove_step_hysteresis_6 : step_hysteresis_6.
Proof. unfold step_hysteresis_6. step. Qed.

Lemma prove_step_hysteresis_7 : step_hysteresis_7.
Proof. unfold step_hysteresis_7. step. Qed.

Lemma prove_step_hysteresis_8 : step_hysteresis_8.
Proof.
  unfold step_hysteresis_8. intros n E w C kap t. intros. cbv zeta.
  assert (pos_w : 0 < t ^ 2 * w) by (apply Rmult_lt_0_compat; [apply pow_lt |]; assumption).
  assert (pos_n : 0 < n) by lra. assert (not_half : n <> 1 / 2) by lra.
  pose proof (prove_step_work_jump_in_1 n E (t ^ 2 * w) C kap) as lost. cbv zeta in lost.
  rewrite lost by assumption. field. lra.
Qed.

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

(** Springs of the stiffness xⁿ under a paraboloid. *)
Lemma int_graded n d c a : 0 < n -> 0 < a -> RInt (fun x => Rpower x n * (d - x^2 / c)) 0 a
  = d * (Rpower a (n+1) / (n+1)) - / c * (Rpower a (n+2+1) / (n+2+1)).
Proof.
  intros Hn Ha. apply is_RInt_unique. apply (is_RInt_ext (fun x => d * Rpower x n - / c * Rpower x (n+2))).
  { intros x Hx. rewrite Rmin_left in Hx by lra. rewrite Rpower_plus, Rpower_two by lra.
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. unfold Rdiv. ring. }
  apply (is_RInt_minus (V := R_NormedModule) (fun x => d * Rpower x n)); apply is_int_power; lra.
Qed.

(** √a g' of a power law, which tells its regime. *)
Lemma line_of_power n C kap a : 0 < a ->
  Derive (fun a => sqrt a * Derive (fun a => kap * C * Rpower a n) a) a = kap * C * n * (n - 1/2) * Rpower a (n - 1) / sqrt a.
Proof.
  intros Ha. assert (Hs : 0 < sqrt a) by (apply sqrt_lt_R0; assumption).
  rewrite (Derive_ext_loc _ (fun a => sqrt a * (kap * C * (n * Rpower a (n - 1)))) a).
  - apply is_derive_unique. unfold Rpower. auto_derive. repeat split; lra.
    fold (Rpower a (n - 1)). assert (E : sqrt a * sqrt a = a) by (apply sqrt_sqrt; lra).
    change (exp ((n + - 1) * ln a)) with (Rpower a (n - 1)). set (p := Rpower a (n - 1)).
    set (s := sqrt a) in *. replace (/ a) with (/ (s * s)) by (rewrite E; reflexivity). field. lra.
  - exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy. f_equal.
    apply is_derive_unique. apply (is_derive_scal (fun a => Rpower a n)). apply is_derive_Rpower. lra.
Qed.


(** α of a fold and P, and the slope of P, with p² = sin ψ and q² = cos ψ. *)
Lemma wave_in_roots theta : 0 < theta < PI / 2 -> exists p q, 0 < p /\ 0 < q /\ sin theta = p*p /\ cos theta = q*q /\
  p*p*(p*p) + q*q*(q*q) = 1 /\ alpha_f theta = 4*(p*p*p)*(q*q*q*q*q) /\
  (forall alpha, P_w theta alpha = p*p*(p*p) - alpha*(p/q)) /\
  (forall alpha, Derive (fun theta => P_w theta alpha) theta = 2*(p*p)*(q*q) - alpha/(2*p*(q*q*q))).
Proof.
  intros H. assert (Hs : 0 < sin theta) by (apply sin_gt_0; lra). assert (Hc : 0 < cos theta) by (apply cos_gt_0; lra).
  pose proof (sin2_cos2 theta) as H1. unfold Rsqr in H1.
  destruct (square_of _ Hs) as [p [Hp Ep]]. destruct (square_of _ Hc) as [q [Hq Eq]].
  assert (Er : sqrt (sin theta / cos theta) = p/q).
  { rewrite Ep, Eq. replace (p*p/(q*q)) with ((p/q)*(p/q)) by (field; lra). apply sqrt_square. left. apply Rdiv_lt_0_compat; lra. }
  exists p, q. split; auto. split; auto. split; auto. split; auto. split. { rewrite <- Ep, <- Eq. exact H1. }
  split; [|split].
  - unfold alpha_f. rewrite Rpower_3_half by assumption. replace (5/2) with (2 + 1/2) by field.
    rewrite Rpower_plus, Rpower_two, Rpower_half by assumption. rewrite Ep, Eq. rewrite !sqrt_square by lra. ring.
  - intros alpha. unfold P_w. rewrite Er, Ep. ring.
  - intros alpha. apply is_derive_unique. unfold P_w. auto_derive.
    { repeat split; try lra. apply Rdiv_lt_0_compat; assumption. }
    change (sin theta * / cos theta) with (sin theta / cos theta). rewrite Er.
    assert (Ho : (p*p)*(p*p) = 1 - (q*q)*(q*q)) by (rewrite <- Ep, <- Eq; lra).
    rewrite Ep, Eq. field_simplify_eq; [|nonzero].
    replace (p^4) with (1 - q^4) by (replace (p^4) with ((p*p)*(p*p)) by ring; rewrite Ho; ring). ring.
Qed.

Lemma prove_step_media_1 : step_media_1.
Proof. unfold step_media_1. step. Qed.

Lemma prove_step_media_2 : step_media_2.
Proof. unfold step_media_2. step. Qed.

Lemma prove_step_media_3 : step_media_3.
Proof. unfold step_media_3. step. Qed.

Lemma prove_step_media_4 : step_media_4.
Proof. unfold step_media_4. step. Qed.

Lemma prove_step_media_5 : step_media_5.
Proof. unfold step_media_5. step. Qed.

Lemma prove_step_media_6 : step_media_6.
Proof. unfold step_media_6. step. Qed.

Lemma prove_step_media_7 : step_media_7.
Proof. unfold step_media_7. step. Qed.

Lemma prove_step_graded_2 : step_graded_2.
Proof. unfold step_graded_2. step. Qed.

Lemma prove_step_graded_3 : step_graded_3.
Proof. unfold step_graded_3. step. Qed.

Lemma prove_step_graded_4 : step_graded_4.
Proof. unfold step_graded_4. step. Qed.

Lemma prove_step_graded_5 : step_graded_5.
Proof. unfold step_graded_5. step. Qed.

Lemma prove_step_graded_6 : step_graded_6.
Proof. unfold step_graded_6. step. Qed.

Lemma prove_step_graded_7 : step_graded_7.
Proof. unfold step_graded_7. step. Qed.

Lemma prove_step_graded_8 : step_graded_8.
Proof. unfold step_graded_8. step. Qed.

Lemma prove_step_graded_9 : step_graded_9.
Proof. unfold step_graded_9. step. Qed.

Lemma prove_step_graded_10 : step_graded_10.
Proof. unfold step_graded_10. step. Qed.

Lemma prove_step_graded_11 : step_graded_11.
Proof.
  unfold step_graded_11.
  intros n E w Rad Hn HE Hw HR. cbv zeta. assert (Ha : 0 < a_p n E w Rad) by apply Rp_pos. pose proof PI_RGT_0.
    set (K := sqrt (2*PI*w/E)). set (f := fun y => 2*E*(2/((1+n)^2*(n+3)*Rad) * Rpower y (n+3) - K/(n+1) * Rpower y
      ((n+3)/2))).
    rewrite (Derive_ext_loc _ f).
    - replace 0 with (2*E*(2/((1+n)^2*(n+3)*Rad) * ((n+3) * Rpower (a_p n E w Rad) (n+3-1)) - K/(n+1) * ((n+3)/2 *
      Rpower (a_p n E w Rad) ((n+3)/2-1)))).
      + apply is_derive_unique. unfold f. apply (is_derive_scal (fun y => 2/((1+n)^2*(n+3)*Rad) * Rpower y (n+3) -
      K/(n+1) * Rpower y ((n+3)/2))).
        apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
        apply (is_derive_scal (fun y => Rpower y (n+3))). apply is_derive_Rpower; assumption.
        apply (is_derive_scal (fun y => Rpower y ((n+3)/2))). apply is_derive_Rpower; assumption.
      + assert (Eq : Rpower (a_p n E w Rad) (n+3-1) = K * ((3+n)*(1+n)*Rad/4) * Rpower (a_p n E w Rad) ((n+3)/2-1)) by
      (unfold K, a_p, B; mono).
        rewrite Eq. field. repeat split; lra.
    - exists (mkposreal _ Ha). intros y Hy. change (Rabs (y - a_p n E w Rad) < a_p n E w Rad) in Hy. apply Rabs_def2
      in Hy. assert (Hp : 0 < y) by lra.
      unfold F_p, d_p, f. rewrite int_graded by assumption.
      assert (Es : sqrt (2*PI*w*Rpower y (1-n)/E) * Rpower y (n+1) = K * Rpower y ((n+3)/2)) by (unfold K; mono).
      assert (E2 : y ^ 2 * Rpower y (n+1) = Rpower y (n+3)) by (rewrite <- Rpower_pow by assumption; rewrite <-
      Rpower_plus; f_equal; simpl; ring).
      replace (n+2+1) with (n+3) by ring. set (s := sqrt (2*PI*w*Rpower y (1-n)/E)) in *. set (u := Rpower y (n+1)) in
      *. set (v := Rpower y (n+3)) in *. set (z := Rpower y ((n+3)/2)) in *.
      replace (2*E*((y^2/((1+n)*Rad) - s)*(u/(n+1)) - /((1+n)*Rad)*(v/(n+3)))) with (2*E*((y^2*u)/((1+n)^2*Rad) -
      (s*u)/(n+1) - v/((1+n)*Rad*(n+3)))) by (field; repeat split; lra).
      rewrite E2, Es. field. repeat split; lra.
Qed.

Lemma prove_step_graded_12 : step_graded_12.
Proof.
  unfold step_graded_12.
  intros n E w Rad Hn HE Hw HR. cbv zeta. unfold F_p. rewrite int_graded by (lra || apply Rp_pos). assert (Ha : 0 <
      a_p n E w Rad) by apply Rp_pos. unfold d_p. assert (Es : sqrt (2*PI*w*Rpower (a_p n E w Rad) (1-n)/E) * Rpower
      (a_p n E w Rad) (n+1) = (3+n)*(1+n)*Rad*(PI*w/E)/2) by (pose proof PI_RGT_0; unfold a_p, B; mono). assert (Eq :
      Rpower (a_p n E w Rad) (n+2+1) = (3+n)^2*(1+n)^2*Rad^2*(PI*w/E)/8) by (pose proof PI_RGT_0; unfold a_p, B;
      mono). assert (E2 : a_p n E w Rad ^ 2 * Rpower (a_p n E w Rad) (n+1) = Rpower (a_p n E w Rad) (n+2+1)) by
      (rewrite <- Rpower_pow by assumption; rewrite <- Rpower_plus; f_equal; simpl; ring). set (a := a_p n E w Rad) in
      *. set (s := sqrt _) in *. set (u := Rpower a (n+1)) in *. set (v := Rpower a (n+2+1)) in *. replace
      (2*E*((a^2/((1+n)*Rad) - s)*(u/(n+1)) - /((1+n)*Rad)*(v/(n+2+1)))) with (2*E*((a^2*u)/((1+n)^2*Rad) -
      (s*u)/(n+1) - v/((1+n)*Rad*(n+3)))) by (field; repeat split; lra). rewrite E2, Es, Eq. field. repeat split; lra.
Qed.

Lemma prove_step_line_contact_1 : step_line_contact_1.
Proof.
  unfold step_line_contact_1.
  intros n Hn. pose proof (proj1 (Kappa.kappa_recurrences n Hn)) as Hp. assert (Hk : 0 < Definitions.kappa n) by
      (apply Kappa.kappa_pos; lra). apply (Rmult_eq_reg_r (Definitions.kappa n * (n + 1))); [|nra]. replace (n *
      Definitions.kappa (n + 1) / (n + 1) * (Definitions.kappa n * (n + 1))) with (n * (Definitions.kappa n *
      Definitions.kappa (n + 1))) by (field; lra). rewrite Hp. field. lra.
Qed.

Lemma prove_step_line_contact_2 : step_line_contact_2.
Proof. unfold step_line_contact_2. step. Qed.

Lemma prove_step_line_contact_3 : step_line_contact_3.
Proof.
  unfold step_line_contact_3.
  intros. cbv zeta. unfold a_c, B, N. pose proof PI_RGT_0. mono.
Qed.

Lemma prove_step_line_contact_4 : step_line_contact_4.
Proof.
  unfold step_line_contact_4.
  intros E w Rad HE Hw HR. cbv zeta. pose proof PI_RGT_0. rewrite prove_step_line_contact_2 by (lra || pos). replace
      (-((2*2-1)/(2*2) * sqrt (2*PI*E*w*a_c 2 E w (1/(2*Rad)) (PI/2)))) with (-(3/4) * sqrt (2*PI*E*w*a_c 2 E w
      (1/(2*Rad)) (PI/2))) by field. rewrite Rpow_mult_distr. assert (Hq : sqrt (2*PI*E*w*a_c 2 E w (1/(2*Rad))
      (PI/2))^3 = 4*PI*E*w^2*Rad) by (unfold a_c, B, N; mono). rewrite Hq. field.
Qed.

Lemma prove_step_line_contact_7 : step_line_contact_7.
Proof.
  unfold step_line_contact_7.
  intros n E w C kap Hn HE Hw HC Hk. assert (Ha : 0 < a_0 n E w C kap) by apply Rp_pos. set (a := a_0 n E w C kap) in
      *. clearbody a. assert (I : RInt (fun x => 2*w*Rpower (x/a) (2*n-1)) 0 a = (2*w*Rpower a (-(2*n-1))) * (Rpower a
      (2*n-1+1) / (2*n-1+1))). { apply is_RInt_unique. apply (is_RInt_ext (fun x => (2*w*Rpower a (-(2*n-1))) * Rpower
      x (2*n-1))). { intros x Hx. rewrite Rmin_left in Hx by lra. unfold Rdiv. rewrite <- Rpower_mult_distr by (try
      apply Rinv_0_lt_compat; lra). replace (Rpower (/a) (2*n-1)) with (Rpower a (-(2*n-1))) by (unfold Rpower;
      rewrite ln_Rinv by lra; f_equal; ring). match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. } apply
      is_int_power; lra. } rewrite I, Rpower_Ropp, Rpower_plus, Rpower_1 by lra. pose proof (Rp_pos a (2*n-1)). field.
      repeat split; lra.
Qed.

Lemma prove_step_wave_2 : step_wave_2.
Proof. unfold step_wave_2. step. Qed.

Lemma prove_step_wave_3 : step_wave_3.
Proof.
  unfold step_wave_3.
  intros theta alpha H Ha. destruct (wave_in_roots theta H) as (p & q & Hp & Hq & Es & Ec & Ho & Ea & EP & ED).
      rewrite EP, Es, Ec. field. lra.
Qed.

Lemma prove_step_wave_4 : step_wave_4.
Proof.
  unfold step_wave_4.
  intros theta H. cbv zeta. destruct (wave_in_roots theta H) as (p & q & Hp & Hq & Es & Ec & Ho & Ea & EP & ED).
      rewrite ED, Ea. field. lra.
Qed.

Lemma prove_step_wave_5 : step_wave_5.
Proof.
  unfold step_wave_5.
  intros theta H. cbv zeta. destruct (wave_in_roots theta H) as (p & q & Hp & Hq & Es & Ec & Ho & Ea & EP & ED).
      rewrite EP, Ea, Es. replace (4*(p*p*p)*(q*q*q*q*q)*(p/q)) with (4*(p*p*(p*p))*(q*q*(q*q))) by (field; lra).
      replace (q*q*(q*q)) with (1 - p*p*(p*p)) by lra. ring.
Qed.

Lemma prove_step_wave_6 : step_wave_6.
Proof.
  unfold step_wave_6.
  intros theta H. assert (Hs : 0 < sin theta) by (apply sin_gt_0; lra). assert (Hc : 0 < cos theta) by (apply
      cos_gt_0; lra). pose proof (sin2_cos2 theta) as H1. unfold Rsqr in H1. rewrite (Derive_ext_loc _ (fun t =>
      4*(sin t * sqrt (sin t))*(cos t * cos t * sqrt (cos t))) theta). match goal with |- Derive ?f ?x = _ => assert
      (D : is_derive f x (4*((cos x * sqrt (sin x) + sin x * (cos x / (2*sqrt (sin x)))) * (cos x*cos x*sqrt (cos x))
      + sin x * sqrt (sin x) * (-2*sin x*cos x*sqrt (cos x) - cos x*cos x*sin x/(2*sqrt (cos x)))))) by (auto_derive;
      [repeat split; assumption | unfold Rdiv; field; split; apply Rgt_not_eq, sqrt_lt_R0; assumption]) end. rewrite
      (is_derive_unique _ _ _ D), Rpower_half, Rpower_3_half by assumption. destruct (square_of _ Hs) as [p [Hp Ep]].
      destruct (square_of _ Hc) as [q [Hq Eq]]. rewrite Ep, Eq in *. rewrite !sqrt_square by lra. replace (3 - 8 *
      (p*p)^2) with (3 * (q*q)^2 - 5 * (p*p)^2) by nra. field. lra. exists (mkposreal (Rmin theta (PI/2 - theta))
      ltac:(apply Rmin_glb_lt; lra)). intros y Hy. change (Rabs (y - theta) < Rmin theta (PI/2 - theta)) in Hy. pose
      proof (Rmin_l theta (PI/2 - theta)). pose proof (Rmin_r theta (PI/2 - theta)). apply Rabs_def2 in Hy. assert (0
      < sin y) by (apply sin_gt_0; lra). assert (0 < cos y) by (apply cos_gt_0; lra). unfold alpha_f. rewrite
      Rpower_3_half by assumption. replace (5/2) with (2 + 1/2) by field. rewrite Rpower_plus, Rpower_two, Rpower_half
      by assumption. ring.
Qed.

Lemma prove_step_wave_7 : step_wave_7.
Proof. unfold step_wave_7. step. Qed.

Lemma prove_step_wave_8 : step_wave_8.
Proof.
  unfold step_wave_8.
  intros theta H. cbv zeta. destruct (wave_in_roots theta H) as (p & q & Hp & Hq & Es & Ec & Ho & Ea & EP & ED).
      rewrite EP, Es, Ec. replace ((p*p)^3*(q*q)) with ((p*p*p*q)*(p*p*p*q)) by ring. rewrite sqrt_square by (repeat
      apply Rmult_le_pos; lra). field. lra.
Qed.

Lemma prove_step_wave_9 : step_wave_9.
Proof.
  unfold step_wave_9.
  intros theta H. pose proof (sin2_cos2 theta) as H1. unfold Rsqr in H1. apply is_derive_unique. auto_derive; auto.
      replace (4 * sin theta ^ 2) with (3 * sin theta^2 + sin theta^2) by ring. set (s := sin theta) in *. set (c :=
      cos theta) in *. nra.
Qed.

Lemma prove_step_wave_10 : step_wave_10.
Proof. unfold step_wave_10. step. Qed.

Lemma prove_step_wave_11 : step_wave_11.
Proof. unfold step_wave_11. step. Qed.

Lemma prove_step_wave_approach_1 : step_wave_approach_1.
Proof.
  unfold step_wave_approach_1.
  intros theta Ls H HL Hn. cbv zeta. destruct (wave_in_roots theta H) as (p & q & Hp & Hq & Es & Ec & Ho & Ea & EP &
      ED). rewrite ED, EP, Ea. rewrite Es, Ec in *. field. repeat split; try lra; intro; apply Hn; lra.
Qed.

Lemma prove_step_wave_approach_2 : step_wave_approach_2.
Proof. unfold step_wave_approach_2. step. Qed.

Lemma prove_step_wave_approach_3 : step_wave_approach_3.
Proof. unfold step_wave_approach_3. step. Qed.

Lemma prove_step_wave_approach_4 : step_wave_approach_4.
Proof. unfold step_wave_approach_4. step. Qed.

Lemma prove_step_wave_approach_5 : step_wave_approach_5.
Proof. unfold step_wave_approach_5. step. Qed.

Lemma prove_step_paper_statements_1 : step_paper_statements_1.
Proof.
  unfold step_paper_statements_1.
  begin. positive (2 * sqrt (PI * w / (2 * E)) * sqrt a).
Qed.

Lemma prove_step_paper_statements_2 : step_paper_statements_2.
Proof. unfold step_paper_statements_2. step. Qed.

Lemma prove_step_paper_statements_3 : step_paper_statements_3.
Proof. unfold step_paper_statements_3. field. Qed.

Lemma prove_step_paper_statements_4 : step_paper_statements_4.
Proof. unfold step_paper_statements_4. step. Qed.

Lemma prove_step_paper_statements_5 : step_paper_statements_5.
Proof.
  unfold step_paper_statements_5.
  intros. rewrite line_of_power by assumption. apply Rlt_gt, Rdiv_lt_0_compat; [|apply sqrt_lt_R0; assumption]. repeat
      apply Rmult_lt_0_compat; try lra. apply Rp_pos.
Qed.

Lemma prove_step_paper_statements_6 : step_paper_statements_6.
Proof.
  unfold step_paper_statements_6.
  intros. rewrite line_of_power by assumption. assert (0 < kap * C * n * (1/2 - n) * Rpower a (n-1) / sqrt a);
      [|unfold Rdiv in *; nra]. apply Rdiv_lt_0_compat; [|apply sqrt_lt_R0; assumption]. repeat apply
      Rmult_lt_0_compat; try lra. apply Rp_pos.
Qed.

Lemma prove_step_paper_statements_8 : step_paper_statements_8.
Proof.
  unfold step_paper_statements_8.
  intros n E w C kap Hn Hh HE Hw HC Hk. cbv zeta. rewrite line_of_power by (apply Rp_pos). begin. slopes. exponents.
      try match goal with H : Rpower _ _ = _ |- _ => rewrite ?H; clear H end. algebra.
Qed.

Lemma prove_step_paper_statements_9 : step_paper_statements_9.
Proof.
  unfold step_paper_statements_9.
  begin. negative (2 * (2 * n + 1) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a * sqrt a)).
Qed.

Lemma prove_step_paper_statements_10 : step_paper_statements_10.
Proof.
  unfold step_paper_statements_10.
  begin. positive (2 * (1 - 2 * n) / (n + 1) * E * sqrt (PI * w / (2 * E)) * (a * sqrt a)).
Qed.
