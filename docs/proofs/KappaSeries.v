(** The series for κ without the Gamma function: one bit a term (Gauss), and three bits a term with its remainder, as the program
    sums them. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa.
Open Scope R_scope.

(** The terms of f(b, c) = 2F1(1, b; c; 1/2): t_0 = 1, t_(j+1) = t_j (b + j)/(2(c + j)); and their sum. *)
Fixpoint term b c (j : nat) : R := match j with O => 1 | S j => term b c j * ((b + INR j) / (2 * (c + INR j))) end.
Definition f b c := Series (term b c).

(** All sums below have 0 < b and a ratio of terms that stays below 1. *)
Definition good b c := 0 < b /\ 0 < c /\ b < 2 * c.

Section Terms.
Variables b c : R.
Hypothesis G : good b c.

Lemma ratio_range j : 0 < (b + INR j) / (2 * (c + INR j)) < 1.
Proof.
  destruct G as [Hb [Hc H]]. pose proof (pos_INR j). split. apply Rdiv_lt_0_compat; lra.
  apply Rmult_lt_reg_r with (2 * (c + INR j)). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma term_pos j : 0 < term b c j.
Proof. induction j; simpl. lra. apply Rmult_lt_0_compat; auto. apply ratio_range. Qed.

(** the ratio is largest at j = 0, or below 1/2 *)
Definition bound := Rmax (/2) (b / (2*c)).
Lemma bound_range : 0 < bound < 1.
Proof.
  destruct G as [Hb [Hc H]]. unfold bound. assert (b/(2*c) < 1).
  { apply Rmult_lt_reg_r with (2*c). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  unfold Rmax. destruct Rle_dec; lra.
Qed.
Lemma ratio_bound j : (b + INR j) / (2 * (c + INR j)) <= bound.
Proof.
  destruct G as [Hb [Hc H]]. pose proof (pos_INR j) as Hj. unfold bound.
  destruct (Rle_dec b c) as [L|L].
  - apply Rle_trans with (/2). 2: apply Rmax_l. apply Rmult_le_reg_r with (2*(c + INR j)). lra.
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - apply Rle_trans with (b/(2*c)). 2: apply Rmax_r. apply Rmult_le_reg_r with (2*(c + INR j)). lra.
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. apply Rmult_le_reg_r with c. lra.
    replace (b * / (2*c) * (2*(c + INR j)) * c) with (b*(c + INR j)) by (field; lra). nra.
Qed.

Lemma term_bound j : term b c j <= bound ^ j.
Proof.
  pose proof bound_range. induction j; simpl. lra. rewrite (Rmult_comm bound).
  apply Rmult_le_compat; auto. left; apply term_pos. left; apply ratio_range. apply ratio_bound.
Qed.

Lemma ex_f : ex_series (term b c).
Proof.
  pose proof bound_range. apply (ex_series_le (K := R_AbsRing) (V := R_CompleteNormedModule) _ (fun j => bound ^ j)).
  - intros j. change (Rabs (term b c j) <= bound ^ j). rewrite Rabs_pos_eq. apply term_bound. left; apply term_pos.
  - apply ex_series_geom. rewrite Rabs_pos_eq; lra.
Qed.

Lemma term_limit : is_lim_seq (term b c) 0.
Proof. apply ex_series_lim_0, ex_f. Qed.

(** f(b, c) = 1 + (b/2c) f(b+1, c+1) *)
Lemma term_shift j : term b c (S j) = b / (2*c) * term (b+1) (c+1) j.
Proof.
  destruct G as [Hb [Hc H]]. induction j. simpl. field. lra.
  change (term b c (S (S j))) with (term b c (S j) * ((b + INR (S j)) / (2 * (c + INR (S j))))). rewrite IHj, S_INR.
  change (term (b+1) (c+1) (S j)) with (term (b+1) (c+1) j * ((b + 1 + INR j) / (2 * (c + 1 + INR j)))).
  pose proof (pos_INR j). field. lra.
Qed.
End Terms.

Lemma good_up b c : good b c -> good (b+1) (c+1).
Proof. unfold good. lra. Qed.
Lemma good_right b c : good b c -> good b (c+1).
Proof. unfold good. lra. Qed.

Lemma f_first b c : good b c -> f b c = 1 + b / (2*c) * f (b+1) (c+1).
Proof.
  intros G. unfold f. rewrite (Series_incr_1 (term b c)) by (apply ex_f; auto).
  rewrite <- Series_scal_l. simpl (term b c 0). f_equal. apply Series_ext. intros j. apply term_shift; auto.
Qed.

(** sums that telescope *)
Lemma telescope (u v : nat -> R) : (forall j, u j = v j - v (S j)) -> is_lim_seq v 0 -> is_series u (v O).
Proof.
  intros H L. unfold is_series. change (is_lim_seq (sum_n u) (v O)).
  apply (is_lim_seq_ext (fun n => v O - v (S n))).
  { intros n. induction n. rewrite sum_O, H. auto. rewrite sum_Sn, <- IHn, H. unfold plus; simpl. ring. }
  replace (Finite (v O)) with (Finite (v O - 0)) by (f_equal; ring). apply is_lim_seq_minus'.
  apply is_lim_seq_const. apply (is_lim_seq_incr_1 v 0); auto.
Qed.

Lemma term_right b c j : 0 < c -> term b (c+1) j = term b c j * (c / (c + INR j)).
Proof.
  intros Hc. induction j. simpl. field. lra.
  change (term b (c+1) (S j)) with (term b (c+1) j * ((b + INR j) / (2 * (c + 1 + INR j)))). rewrite IHj.
  change (term b c (S j)) with (term b c j * ((b + INR j) / (2 * (c + INR j)))). rewrite S_INR.
  pose proof (pos_INR j). field. lra.
Qed.

(** f(b, c) = 2 - ((c-b)/c) f(b, c+1) *)
Lemma f_second b c : good b c -> f b c = 2 - (c - b) / c * f b (c+1).
Proof.
  intros G. pose proof G as [Hb [Hc Hbc]].
  assert (T : is_series (fun j => term b c j + (c - b) / c * term b (c+1) j) (2 * term b c O)).
  { apply (telescope _ (fun j => 2 * term b c j)).
    - intros j. rewrite term_right by auto. change (term b c (S j)) with (term b c j * ((b + INR j) / (2 * (c + INR j)))).
      pose proof (pos_INR j). field. lra.
    - replace (Finite 0) with (Rbar_mult 2 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l. apply term_limit; auto. }
  apply is_series_unique in T. rewrite Series_plus in T. rewrite Series_scal_l in T. simpl in T. unfold f. lra.
  apply ex_f; auto. apply (ex_series_scal (K := R_AbsRing) (V := R_NormedModule)). apply ex_f, good_right; auto.
Qed.

Lemma f_positive b c : good b c -> 0 < f b c.
Proof.
  intros G. rewrite f_first by auto. destruct G as [Hb [Hc H]].
  assert (0 <= f (b+1) (c+1)).
  { unfold f. replace 0 with (Series (fun j => 0 * term (b+1) (c+1) j)) by (rewrite Series_scal_l; ring).
    assert (G1 : good (b+1) (c+1)) by (unfold good; lra).
    apply Series_le. 2: apply ex_f; auto. intros j. pose proof (term_pos (b+1) (c+1) G1 j). lra. }
  assert (0 < b/(2*c)) by (apply Rdiv_lt_0_compat; lra). nra.
Qed.

(** Where b <= c, f is at most 2. *)
Lemma f_at_most_2 b c : good b c -> b <= c -> f b c <= 2.
Proof.
  intros G H. rewrite f_second by auto. pose proof (f_positive b (c+1) (good_right b c G)). destruct G as [Hb [Hc _]].
  assert (0 <= (c - b)/c). { apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat; auto. } nra.
Qed.

(** Two turns at once. *)
Lemma f_turn b c : good b c -> f b c = (b + c)/c - b*(c-b)/(2*c*(c+1)) * f (b+1) (c+2).
Proof.
  intros G. rewrite f_first, f_second by (try apply good_up; auto). destruct G as [Hb [Hc H]].
  replace (c+1+1) with (c+2) by ring. field. lra.
Qed.

Lemma good_n n : 0 < n -> good n (1 + n/2).
Proof. unfold good. lra. Qed.

Lemma f_grows n m : 0 < n -> n <= m -> f n (1 + n/2) <= f m (1 + m/2).
Proof.
  intros Hn Hm. apply Series_le. 2: apply ex_f, good_n; lra. intros j. split. left. apply term_pos, good_n; auto.
  induction j. simpl; lra. simpl term. apply Rmult_le_compat; auto. left; apply term_pos, good_n; auto.
  left; apply ratio_range, good_n; auto. pose proof (pos_INR j).
  apply Rmult_le_reg_r with (2*(1 + n/2 + INR j) * (2*(1 + m/2 + INR j))). apply Rmult_lt_0_compat; lra.
  replace ((n + INR j)/(2*(1 + n/2 + INR j))*(2*(1 + n/2 + INR j)*(2*(1 + m/2 + INR j)))) with ((n + INR j)*(2*(1 + m/2 + INR j))) by (field; lra).
  replace ((m + INR j)/(2*(1 + m/2 + INR j))*(2*(1 + n/2 + INR j)*(2*(1 + m/2 + INR j)))) with ((m + INR j)*(2*(1 + n/2 + INR j))) by (field; lra).
  nra.
Qed.

Lemma term_two n j : 0 < n -> term (n+2) (1 + (n+2)/2) j = term n (1 + n/2) j * ((n + INR j)*(n + INR j + 1)/(n*(n+1)) * ((n+2)/(n + 2 + 2*INR j))).
Proof.
  intros Hn. induction j. simpl. field. lra. simpl term. rewrite IHj. rewrite S_INR. pose proof (pos_INR j). field. lra.
Qed.

Lemma n_term_limit n : 0 < n -> is_lim_seq (fun j => INR j * term n (1 + n/2) j) 0.
Proof.
  intros Hn. pose proof (good_n n Hn) as G. destruct (bound_range n (1 + n/2) G) as [B1 B2]. set (q := bound n (1 + n/2)) in *.
  (* j q^j <= r^j/h with r = sqrt q = 1/(1 + h) *)
  set (r := sqrt q). assert (Hr : 0 < r < 1).
  { unfold r. split. apply sqrt_lt_R0; auto. rewrite <- sqrt_1. apply sqrt_lt_1; lra. }
  assert (Hrr : r * r = q) by (apply sqrt_sqrt; lra). set (h := / r - 1).
  assert (Hh : 0 < h). { unfold h. assert (1 < / r). { rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. } lra. }
  apply is_lim_seq_le_le with (fun _ => 0) (fun j => / h * r^j).
  - intros j. pose proof (pos_INR j). pose proof (term_pos n (1 + n/2) G j). pose proof (term_bound n (1 + n/2) G j) as H1. fold q in H1.
    split. nra. apply Rle_trans with (INR j * q^j). apply Rmult_le_compat_l; auto.
    rewrite <- Hrr, Rpow_mult_distr, <- Rmult_assoc. assert (Hp : 0 < r^j) by (apply pow_lt; lra). apply Rmult_le_compat_r. lra.
    pose proof (poly j h Hh) as H2. replace (1 + h) with (/ r) in H2 by (unfold h; ring). rewrite <- Rinv_pow in H2 by lra.
    apply Rmult_le_reg_r with (h * / r^j). apply Rmult_lt_0_compat; auto. apply Rinv_0_lt_compat; auto.
    replace (INR j * r^j * (h * / r^j)) with (INR j * h) by (field; lra). replace (/ h * (h * / r^j)) with (/ r^j) by (field; lra). lra.
  - apply is_lim_seq_const.
  - replace (Finite 0) with (Rbar_mult (/ h) 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l. apply is_lim_seq_geom. rewrite Rabs_pos_eq; lra.
Qed.

Lemma f_step n : 0 < n -> f (n+2) (1 + (n+2)/2) = f n (1 + n/2) * (n+2)/(n+1).
Proof.
  intros Hn. pose proof (good_n n Hn) as G.
  assert (T : is_series (fun j => (n+1) * term (n+2) (1 + (n+2)/2) j - (n+2) * term n (1 + n/2) j) ((n+2)/n * (INR 0 * term n (1 + n/2) 0))).
  { apply (telescope _ (fun j => (n+2)/n * (INR j * term n (1 + n/2) j))).
    - intros j. rewrite term_two by auto. simpl term. rewrite S_INR. pose proof (pos_INR j). field. lra.
    - replace (Finite 0) with (Rbar_mult ((n+2)/n) 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l, n_term_limit; auto. }
  apply is_series_unique in T. simpl INR in T. rewrite Rmult_0_l, Rmult_0_r in T.
  rewrite Series_minus, !Series_scal_l in T.
  change (Series (term (n+2) (1 + (n+2)/2))) with (f (n+2) (1 + (n+2)/2)) in T. change (Series (term n (1 + n/2))) with (f n (1 + n/2)) in T.
  apply Rmult_eq_reg_l with (n+1); [|lra]. replace ((n+1)*(f n (1+n/2)*(n+2)/(n+1))) with ((n+2)*f n (1+n/2)) by (field; lra). lra.
  apply (ex_series_scal (K := R_AbsRing) (V := R_NormedModule)). apply ex_f, good_n; lra.
  apply (ex_series_scal (K := R_AbsRing) (V := R_NormedModule)). apply ex_f; auto.
Qed.

Lemma f_2 : f 2 2 = 2.
Proof.
  unfold f. rewrite (Series_ext _ (fun j => (/2)^j)). rewrite Series_geom. field. rewrite Rabs_pos_eq; lra.
  induction n. auto. simpl. rewrite IHn. pose proof (pos_INR n). field. lra.
Qed.

(** Gauss: κ_n is the sum of the products of (n + j)/(n + 2 + 2j), positive terms of which each is at most a fixed part of the
    one before. *)
Theorem kappa_series n : 0 < n -> is_series (term n (1 + n/2)) (kappa n).
Proof.
  intros Hn. replace (kappa n) with (f n (1 + n/2)). apply Series_correct, ex_f, good_n; auto.
  apply (kappa_unique_step (fun n => f n (1 + n/2))); auto.
  - intros. apply f_grows; auto.
  - intros. apply f_step; auto.
  - replace (1 + 2/2) with 2 by field. apply f_2.
Qed.

(** Three bits a term: with x = n/2, P_0 = 1, P_(m+1) = -P_m (2x + m)(1 - x + m)/(2(x + 1 + 2m)(x + 2 + 2m)). *)
Fixpoint P x (m : nat) : R := match m with O => 1
  | S m => - P x m * ((2*x + INR m) * (1 - x + INR m) / (2 * (x + 1 + 2*INR m) * (x + 2 + 2*INR m))) end.
Definition turn x (m : nat) := P x m * (3*x + 1 + 3*INR m) / (x + 1 + 2*INR m).

Lemma good_m n m : 0 < n -> good (n + INR m) (1 + n/2 + 2*INR m).
Proof. intros. pose proof (pos_INR m). unfold good. lra. Qed.

(** κ_n is the sum of the first M turns and P_M f(n + M, 1 + n/2 + 2M), exactly, *)
Theorem kappa_series_turns n M : 0 < n ->
  kappa n = sum_f_R0 (turn (n/2)) M + P (n/2) (S M) * f (n + INR (S M)) (1 + n/2 + 2*INR (S M)).
Proof.
  intros Hn.
  assert (H0 : kappa n = P (n/2) 0 * f (n + INR 0) (1 + n/2 + 2*INR 0)).
  { simpl. replace (n + 0) with n by ring. replace (1 + n/2 + 2*0) with (1 + n/2) by ring. rewrite Rmult_1_l.
    symmetry. apply is_series_unique, kappa_series; auto. }
  assert (Hstep : forall m, P (n/2) m * f (n + INR m) (1 + n/2 + 2*INR m) = turn (n/2) m + P (n/2) (S m) * f (n + INR (S m)) (1 + n/2 + 2*INR (S m))).
  { intros m. rewrite f_turn by (apply good_m; auto). unfold turn. simpl P. rewrite S_INR.
    replace (n + INR m + 1) with (n + (INR m + 1)) by ring. replace (1 + n/2 + 2*INR m + 2) with (1 + n/2 + 2*(INR m + 1)) by ring.
    pose proof (pos_INR m). field. lra. }
  induction M. simpl sum_f_R0. rewrite H0. apply Hstep.
  rewrite IHM. rewrite Hstep. simpl sum_f_R0. ring.
Qed.

Lemma factor_range x m : 0 < x -> Rabs ((2*x + INR m) * (1 - x + INR m) / (2 * (x + 1 + 2*INR m) * (x + 2 + 2*INR m))) < 1 /\
  (x - 1 <= INR m -> Rabs ((2*x + INR m) * (1 - x + INR m) / (2 * (x + 1 + 2*INR m) * (x + 2 + 2*INR m))) <= /8).
Proof.
  intros Hx. pose proof (pos_INR m) as Hm. set (k := INR m) in *.
  assert (Hp : 0 < 2*(x + 1 + 2*k)*(x + 2 + 2*k)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (Hdiv : forall y z, y < z * (2*(x + 1 + 2*k)*(x + 2 + 2*k)) -> y / (2*(x + 1 + 2*k)*(x + 2 + 2*k)) < z).
  { intros y z H. apply Rmult_lt_reg_r with (2*(x + 1 + 2*k)*(x + 2 + 2*k)); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  split.
  - apply Rabs_def1. apply Hdiv. nra. apply Ropp_lt_cancel. rewrite Ropp_involutive.
    replace (- ((2*x + k)*(1 - x + k)/(2*(x + 1 + 2*k)*(x + 2 + 2*k)))) with (- ((2*x + k)*(1 - x + k))/(2*(x + 1 + 2*k)*(x + 2 + 2*k))) by (field; lra).
    apply Hdiv. nra.
  - intros H. rewrite Rabs_pos_eq. left. apply Hdiv. pose proof (pow2_ge_0 (3*x - 5/6)). nra.
    apply Rmult_le_pos. nra. left. apply Rinv_0_lt_compat; auto.
Qed.

(** and what is left over is bounded: from m >= x - 1 on P falls by eight a turn, f is at most 2, so that k turns later no more
    than 2/8^k is left. This is the bound that the program uses. *)
Theorem kappa_series_remainder n M k : 0 < n -> n/2 - 1 <= INR M ->
  Rabs (P (n/2) (M + k) * f (n + INR (M + k)) (1 + n/2 + 2*INR (M + k))) <= 2 * (/8)^k /\
  Rabs (P (n/2) (M + k) * f (n + INR (M + k)) (1 + n/2 + 2*INR (M + k))) <= 2 * Rabs (P (n/2) (M + k)).
Proof.
  intros Hn HM. assert (Hx : 0 < n/2) by lra. set (x := n/2) in *.
  assert (H1 : forall m, Rabs (P x m) <= 1).
  { induction m. simpl. rewrite Rabs_R1. lra. simpl P. rewrite Rabs_mult, Rabs_Ropp. destruct (factor_range x m Hx) as [F _].
    pose proof (Rabs_pos (P x m)). pose proof (Rabs_pos ((2*x + INR m) * (1 - x + INR m) / (2 * (x + 1 + 2*INR m) * (x + 2 + 2*INR m)))). nra. }
  assert (H2 : Rabs (P x (M + k)) <= (/8)^k).
  { induction k. rewrite Nat.add_0_r. simpl. apply H1. rewrite Nat.add_succ_r. simpl P. simpl pow. rewrite Rabs_mult, Rabs_Ropp, Rmult_comm.
    destruct (factor_range x (M + k) Hx) as [_ F]. apply Rmult_le_compat; try apply Rabs_pos; auto. apply F.
    rewrite plus_INR. pose proof (pos_INR k). lra. }
  assert (G : good (n + INR (M + k)) (1 + x + 2*INR (M + k))) by (apply good_m; auto).
  pose proof (f_positive _ _ G) as F1. 
  assert (F2 : f (n + INR (M + k)) (1 + x + 2*INR (M + k)) <= 2).
  { apply f_at_most_2; auto. rewrite plus_INR. pose proof (pos_INR k). unfold x in *. lra. }
  rewrite Rabs_mult, (Rabs_pos_eq (f _ _)) by lra. pose proof (Rabs_pos (P x (M + k))). split; nra.
Qed.

(** So the turns sum to κ_n. *)
Theorem kappa_series_three_bits n : 0 < n -> is_series (turn (n/2)) (kappa n).
Proof.
  intros Hn. set (M := Z.to_nat (up (n/2))).
  assert (HM : n/2 < INR M).
  { unfold M. destruct (archimed (n/2)). rewrite INR_IZR_INZ, Z2Nat.id. lra. apply le_IZR. lra. }
  clearbody M. unfold is_series. change (is_lim_seq (sum_n (turn (n/2))) (kappa n)).
  apply (is_lim_seq_incr_n _ M).
  assert (Hg : is_lim_seq (fun k => 2 * (/8)^(S k)) 0).
  { replace (Finite 0) with (Rbar_mult 2 0) by (simpl; f_equal; ring). apply is_lim_seq_scal_l.
    apply (is_lim_seq_incr_1 (fun k => (/8)^k) 0). apply is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  assert (Hb : forall k, Rabs (kappa n - sum_n (turn (n/2)) (k + M)) <= 2 * (/8)^(S k)).
  { intros k. rewrite sum_n_Reals, (kappa_series_turns n (k + M) Hn). replace (S (k + M)) with (M + S k)%nat by lia.
    replace (_ + _ - _) with (P (n/2) (M + S k) * f (n + INR (M + S k)) (1 + n/2 + 2*INR (M + S k))) by ring.
    apply kappa_series_remainder; auto. lra. }
  apply is_lim_seq_le_le with (fun k => kappa n - 2 * (/8)^(S k)) (fun k => kappa n + 2 * (/8)^(S k)).
  - intros k. specialize (Hb k). apply Rabs_le_between in Hb. lra.
  - replace (Finite (kappa n)) with (Finite (kappa n - 0)) by (f_equal; ring). apply is_lim_seq_minus'; auto. apply is_lim_seq_const.
  - replace (Finite (kappa n)) with (Finite (kappa n + 0)) by (f_equal; ring). apply is_lim_seq_plus'; auto. apply is_lim_seq_const.
Qed.
