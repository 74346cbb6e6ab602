(** Sections 3 and 4 of the paper: where the force turns tensile below n = 1/2 (erratum 4). *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw.
Open Scope R_scope.

Section R.
Variables E w C n : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hn : 0 < n) (Hh : n < 1/2).
Notation kap := (kappa n).
Let Hk : 0 < kap := kappa_pos n Hn.
Notation ac := (ac E w C n).
Notation dn := (dn E w C n).
Notation Fn := (Fn E w C n).
Notation dl := (dl E w).
Notation B := (B E w).
Notation N := (N C n).
Notation az := (az E w C n).

Lemma az_ac : az / ac = Rpower (4*(n+1)^2) (1/(2*n-1)).
Proof.
  unfold Definitions.az, Definitions.ac. pose proof (BN_pos E w C n HE Hw HC Hn).
  replace (4*(n+1)^2*B/N^2) with (4*(n+1)^2 * (B/N^2)) by (unfold Rdiv; ring).
  pose proof (pow_lt (n+1) 2 ltac:(lra)). rewrite <- Rpower_mult_distr by (auto; lra).
  pose proof (Rp_pos (B/N^2) (1/(2*n-1))). field. lra.
Qed.

Lemma az_below_ac : 0 < az < ac.
Proof.
  pose proof (ac_pos E w C n) as Ha. split. apply Rp_pos.
  apply Rmult_lt_reg_r with (/ ac). apply Rinv_0_lt_compat; auto. rewrite Rinv_r by lra.
  change (az / ac < 1). rewrite az_ac. unfold Rpower.
  apply Rlt_le_trans with (exp 0); [apply exp_increasing | rewrite exp_0; lra].
  assert (0 < ln (4*(n+1)^2)).
  { rewrite <- ln_1. apply ln_increasing. lra. replace (4*(n+1)^2) with (4 + 8*n + 4*(n*n)) by ring. nra. }
  assert (/ (2*n-1) < 0) by (apply Rinv_lt_0_compat; lra). unfold Rdiv.
  assert (Hneg : forall u v, u < 0 -> 0 < v -> 1 * u * v < 0) by (intros; nra). apply Hneg; auto.
Qed.

(* the force, factored like the slope *)
Lemma force_factored a : 0 < a ->
  Fn a = 2 * E * a * dl a * (exp ((n - /2) * (ln a - ln az)) - 1).
Proof.
  intros Ha. pose proof (B_pos E w HE Hw) as HB. pose proof (N_pos C n HC Hn) as HN.
  unfold Definitions.Fn. rewrite !Rmult_assoc. do 3 f_equal.
  transitivity (n/(n+1)*kap*C*Rpower a n - dl a). ring.
  replace (dl a * (exp ((n - /2)*(ln a - ln az)) - 1)) with (dl a * exp ((n - /2)*(ln a - ln az)) - dl a) by ring. f_equal.
  rewrite dl_pow by auto.
  assert (Hl : ln az = 1/(2*n-1) * (2 * ln (2*(n+1)) + ln B - 2 * ln N)).
  { unfold Definitions.az. rewrite ln_Rpower. f_equal. replace (4*(n+1)^2*B/N^2) with ((2*(n+1))*(2*(n+1))*(B/N^2)) by (field; lra).
    pose proof (BN_pos E w C n HE Hw HC Hn). rewrite !ln_mult, lnBN by (auto; nra). ring. }
  rewrite Hl. replace (n/(n+1)*kap*C) with (2 * exp (ln N - ln (2*(n+1)))).
  2:{ unfold Rminus. rewrite exp_plus, exp_Ropp, !exp_ln by lra. unfold Definitions.N. field. lra. }
  rewrite exp_half_ln by auto. unfold Rpower. rewrite !Rmult_assoc. f_equal. rewrite <- !exp_plus. f_equal. field. lra.
Qed.

(** Erratum 4: on the stable branch of n < 1/2 the force is compressive up to a_z < a_c, and tensile from there to a_c. *)
Theorem erratum_4 a : 0 < a < ac ->
  0 < slope E w C n a /\ (a < az -> 0 < Fn a) /\ (az < a -> Fn a < 0).
Proof.
  intros Ha. split. { apply (slope_sign_below E w C n); auto; lra. }
  assert (Hd : 0 < 2 * E * a * dl a).
  { assert (0 < dl a) by (unfold Definitions.dl; assert (0 < a) by lra; pos). assert (0 < a) by lra. pos. }
  rewrite force_factored by lra. set (k := 2*E*a*dl a) in *.
  split; intros H.
  - assert (ln a < ln az) by (apply ln_increasing; lra).
    assert (1 < exp ((n - /2)*(ln a - ln az))). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
  - assert (ln az < ln a) by (apply ln_increasing; auto; apply Rp_pos).
    assert (exp ((n - /2)*(ln a - ln az)) < 1). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
Qed.

(** The radius without force has a positive indentation, so 0 < d_c at the end of the branch too: the force is tensile at some
    positive indentations, before the contact becomes complete. *)
Theorem erratum_4_indentation : 0 < az < ac /\ Fn az = 0 /\ 0 < dn az < dn ac /\ Fn ac < 0.
Proof.
  pose proof az_below_ac as Hz. pose proof (eq_1_15_maximum E w C n HE Hw HC Hn az Hh ltac:(lra) ltac:(lra)) as H1.
  assert (H2 : Fn az = 0). { rewrite force_factored by lra. replace (_ * (ln az - ln az)) with 0 by ring. rewrite exp_0. ring. }
  assert (Hd : 0 < dl az). { assert (0 < az) by lra. pose proof PI_RGT_0. unfold Definitions.dl. pos. }
  repeat split; auto; try lra. 2: apply eq_1_17_tensile; auto; lra.
  unfold Definitions.Fn in H2. apply Rmult_integral in H2. destruct H2 as [H2|H2]. assert (0 < 2*E*az) by nra. lra.
  unfold Definitions.dn. assert (kap * C * Rpower az n = (n+1)/n * dl az).
  { replace (dl az) with (n/(n+1)*kap*C*Rpower az n) by lra. field. lra. }
  rewrite H. replace ((n+1)/n * dl az - dl az) with (dl az / n) by (field; lra). apply Rdiv_lt_0_compat; auto.
Qed.
End R.

