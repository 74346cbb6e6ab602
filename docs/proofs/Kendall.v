(** Kendall's flat punch as the limit of the profiles f = δ (r/R)^n for large n. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw.
Open Scope R_scope.

Section Kendall.
Variables E w R0 delta : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HR : 0 < R0) (Hd : 0 < delta).

(** The coefficient C of the profile δ (r/R)^n. *)
Definition punch n := delta * Rpower R0 (- n).
Notation ac n := (ac E w (punch n) n).
Notation B := (B E w).

Lemma punch_pos n : 0 < punch n.
Proof. unfold punch. pos. Qed.

Lemma ln_ac_punch n : 1/2 < n -> ln (ac n) - ln R0 = (ln (B * R0 / delta^2) - 2 * ln n - 2 * ln (kappa n)) / (2*n - 1).
Proof.
  intros Hn. pose proof (kappa_pos n ltac:(lra)) as Hk. pose proof (B_pos E w HE Hw) as HB. pose proof (punch_pos n) as HC.
  unfold Definitions.ac. rewrite ln_Rpower, (lnBN E w (punch n) n) by (auto; lra). unfold N, punch.
  rewrite !ln_mult, ln_Rpower, ln_div, ln_mult, ln_pow' by pos. simpl INR. field. lra.
Qed.

Lemma div_sqrt n : 0 < n -> 2 / sqrt n * n = 2 * sqrt n.
Proof.
  intros Hn. pose proof (sqrt_sqrt n ltac:(lra)) as H. pose proof (sqrt_lt_R0 n Hn) as Hs. set (s := sqrt n) in *. clearbody s.
  rewrite <- H. field. lra.
Qed.

Lemma ln_over n : 1 < n -> 0 <= ln n / n <= 2 / sqrt n.
Proof.
  intros Hn. assert (Hs : 0 < sqrt n) by (apply sqrt_lt_R0; lra). pose proof (sqrt_sqrt n ltac:(lra)) as Hq.
  assert (H0 : 0 < ln n) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (H1 : ln n <= 2 * sqrt n).
  { replace (ln n) with (2 * ln (sqrt n)) by (rewrite ln_sqrt by lra; field). apply Rmult_le_compat_l. lra.
    left. rewrite <- (ln_exp (sqrt n)) at 2. apply ln_increasing; auto. pose proof (exp_ineq1 (sqrt n) ltac:(lra)). lra. }
  split. apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat. lra.
  apply Rmult_le_reg_r with n. lra. replace (ln n / n * n) with (ln n) by (field; lra).
  rewrite div_sqrt by lra. auto.
Qed.

Lemma inv_sqrt_limit : is_lim (fun n => / sqrt n) p_infty 0.
Proof.
  replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_inv. 2: discriminate.
  exact filterlim_sqrt_p.
Qed.

(** For large n the critical radius tends to R, *)
Theorem kendall_radius : is_lim (fun n => ac n) p_infty R0.
Proof.
  set (c := Rabs (ln (B * R0 / delta^2))).
  assert (Hlog : is_lim (fun n => ln (ac n) - ln R0) p_infty 0).
  { (* |ln a_c - ln R| <= (c + 2 ln n + 2 ln (1 + n))/n <= (c + 8)/sqrt n for n > 1 *)
    apply (is_lim_le_le_loc (fun n => - ((c + 12) * / sqrt n)) (fun n => (c + 12) * / sqrt n)).
    - exists 2. intros n Hn. rewrite ln_ac_punch by lra. destruct (kappa_small n ltac:(lra)) as [K1 K2].
      assert (Hs : 0 < sqrt n) by (apply sqrt_lt_R0; lra). pose proof (sqrt_sqrt n ltac:(lra)) as Hq.
      assert (Hs1 : 1 < sqrt n) by (rewrite <- sqrt_1; apply sqrt_lt_1; lra).
      destruct (ln_over n ltac:(lra)) as [L1 L2].
      assert (L0 : 0 < ln n) by (rewrite <- ln_1; apply ln_increasing; lra).
      assert (Lk0 : 0 < ln (kappa n)) by (rewrite <- ln_1; apply ln_increasing; lra).
      assert (Lk : ln (kappa n) <= 2 * ln n).
      { left. replace (2 * ln n) with (ln (n*n)) by (rewrite ln_mult; lra). apply ln_increasing. lra. nra. }
      set (q := ln (B * R0 / delta^2)) in *. assert (Hq1 : - c <= q <= c) by (unfold c; apply Rabs_le_between, Rle_refl).
      assert (Hln : ln n <= 2 * sqrt n).
      { apply Rmult_le_compat_r with (r := n) in L2; [|lra]. replace (ln n / n * n) with (ln n) in L2 by (field; lra).
        rewrite div_sqrt in L2 by lra. auto. }
      assert (Habs : Rabs (q - 2 * ln n - 2 * ln (kappa n)) <= (c + 12) * sqrt n).
      { apply Rabs_le. assert (0 <= c) by apply Rabs_pos. split; nra. }
      assert (Hden : Rabs ((q - 2 * ln n - 2 * ln (kappa n)) / (2*n - 1)) <= (c + 12) * / sqrt n).
      { unfold Rdiv. rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by (left; apply Rinv_0_lt_compat; lra).
        apply Rmult_le_reg_r with (2*n - 1). lra. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
        apply Rle_trans with (1 := Habs). assert (0 <= c) by apply Rabs_pos. rewrite Rmult_assoc.
        apply Rmult_le_compat_l. lra. apply Rmult_le_reg_l with (sqrt n); auto. rewrite <- Rmult_assoc, Rinv_r; lra. }
      apply Rabs_le_between in Hden. lra.
    - replace (Finite 0) with (Rbar_opp (Rbar_mult (c + 12) 0)) by (simpl; f_equal; ring). apply is_lim_opp, is_lim_scal_l, inv_sqrt_limit.
    - replace (Finite 0) with (Rbar_mult (c + 12) 0) by (simpl; f_equal; ring). apply is_lim_scal_l, inv_sqrt_limit. }
  apply (is_lim_ext (fun n => R0 * exp (ln (ac n) - ln R0))).
  { intros n. unfold Rminus. rewrite exp_plus, exp_Ropp, !exp_ln by (auto; apply Rp_pos). field. lra. }
  replace (Finite R0) with (Rbar_mult R0 (exp 0)) by (rewrite exp_0; simpl; f_equal; ring). apply is_lim_scal_l.
  apply (is_lim_comp_continuous (fun n => ln (ac n) - ln R0) exp p_infty 0); auto.
  apply continuous_exp.
Qed.

Lemma inv_limit : is_lim (fun n => / (n + 1)) p_infty 0.
Proof.
  replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_inv. 2: discriminate.
  replace p_infty with (Rbar_plus p_infty 1) by reflexivity. apply is_lim_plus with p_infty 1. apply is_lim_id. apply is_lim_const. reflexivity.
Qed.

(** the force at the instability to Kendall's, -sqrt (8πR³Ew), *)
Theorem kendall_force : is_lim (fun n => Fn E w (punch n) n (ac n)) p_infty (- sqrt (8 * PI * R0^3 * E * w)).
Proof.
  pose proof (B_pos E w HE Hw) as HB.
  apply (is_lim_ext_loc (fun n => - (E * sqrt B) * ((4 - 2 * / (n+1)) * Rpower (ac n) (3/2)))).
  { exists 1. intros n Hn. rewrite (eq_1_17_factored E w (punch n) n) by (auto using punch_pos; lra). field. lra. }
  replace (- sqrt (8 * PI * R0^3 * E * w)) with (- (E * sqrt B) * ((4 - 2 * 0) * Rpower R0 (3/2))).
  2:{ replace (sqrt (8 * PI * R0^3 * E * w)) with (4 * E * sqrt B * Rpower R0 (3/2)). ring. unfold Definitions.B. mono. }
  apply (is_lim_scal_l _ (- (E * sqrt B)) p_infty (Finite ((4 - 2 * 0) * Rpower R0 (3/2)))).
  apply (is_lim_mult _ _ p_infty (Finite (4 - 2 * 0)) (Finite (Rpower R0 (3/2)))). 3: exact I.
  - apply (is_lim_minus _ _ p_infty (Finite 4) (Finite (2 * 0))). apply is_lim_const.
    apply (is_lim_scal_l (fun n => / (n+1)) 2 p_infty 0), inv_limit. reflexivity.
  - apply (is_lim_comp_continuous (fun n => ac n) (fun x => Rpower x (3/2)) p_infty R0). apply kendall_radius.
    apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply is_derive_Rpower. auto.
Qed.

(** and the indentation to -Δl(R). *)
Theorem kendall_indentation : is_lim (fun n => dn E w (punch n) n (ac n)) p_infty (- dl E w R0).
Proof.
  pose proof (B_pos E w HE Hw) as HB.
  apply (is_lim_ext_loc (fun n => (/ (n - 1 + 1) - 2) * sqrt (B * ac n))).
  { exists 1. intros n Hn. rewrite (critical_indentation E w (punch n) n) by (auto using punch_pos; lra). field. lra. }
  replace (- dl E w R0) with ((0 - 2) * sqrt (B * R0)) by (rewrite dl_B by auto; ring).
  apply (is_lim_mult _ _ p_infty (Finite (0 - 2)) (Finite (sqrt (B * R0)))). 3: exact I.
  - apply (is_lim_minus _ _ p_infty (Finite 0) (Finite 2)). 2: apply is_lim_const. 2: reflexivity.
    apply (is_lim_comp (fun n => / (n + 1)) (fun n => n - 1) p_infty 0 p_infty). apply inv_limit.
    replace p_infty with (Rbar_plus p_infty (-1)) by reflexivity. apply is_lim_plus with p_infty (-1). apply is_lim_id. apply is_lim_const. reflexivity.
    exists 0. intros; discriminate.
  - apply (is_lim_comp_continuous (fun n => ac n) (fun x => sqrt (B * x)) p_infty R0). apply kendall_radius.
    apply (continuous_comp (fun x => B * x) sqrt). apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. apply continuous_sqrt.
Qed.
End Kendall.
