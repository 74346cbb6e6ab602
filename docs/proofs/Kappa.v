(** Section 4 of the paper: the factor κ_n of (1.12), from its integral alone: recurrences, values, growth, bounds, limits,
    what determines it, and its Gamma functions. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers.
Open Scope R_scope.

Lemma sin_range t : 0 < t < PI/2 -> 0 < sin t < 1.
Proof.
  intros Ht. split. apply sin_gt_0; lra.
  rewrite <- sin_PI2. apply sin_increasing_1; lra.
Qed.

Lemma cont_pw_sin s t : 0 < s -> continuous (fun t => pw s (sin t)) t.
Proof.
  intros Hs. apply (continuous_comp sin (pw s)). 2: apply continuous_pw; auto.
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma ex_W s a b : 0 < s -> ex_RInt (fun t => pw s (sin t)) a b.
Proof. intros. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros; apply cont_pw_sin; auto. Qed.

(* d/dt (cos t sin^(s+1) t), as in 1.1 of docs/derivations.md *)
Lemma parts_derive s t : 0 < s -> 0 <= sin t ->
  is_derive (fun t => cos t * pw (s+1) (sin t)) t ((s+1) * pw s (sin t) - (s+2) * pw (s+2) (sin t)).
Proof.
  intros Hs Ht.
  replace ((s+1) * pw s (sin t) - (s+2) * pw (s+2) (sin t))
    with (- sin t * pw (s+1) (sin t) + cos t * (cos t * ((s+1) * pw s (sin t)))).
  - apply (is_derive_mult cos (fun t => pw (s+1) (sin t))).
    + auto_derive; auto; ring.
    + apply (is_derive_comp (pw (s+1)) sin). apply is_derive_pw; auto. auto_derive; auto; ring.
    + intros; apply Rmult_comm.
  - destruct Ht as [Ht|Ht].
    + rewrite !pw_pos by auto. replace (s+2) with (s+1+1) by ring. rewrite !Rpower_plus, !Rpower_1 by auto.
      pose proof (sin2_cos2 t) as H. unfold Rsqr in H.
      replace (cos t * (cos t * ((s+1) * Rpower (sin t) s))) with (cos t * cos t * ((s+1) * Rpower (sin t) s)) by ring.
      replace (cos t * cos t) with (1 - sin t * sin t) by lra. ring.
    + rewrite !pw_neg by lra. ring.
Qed.

(* the equality of integrals of 1.1: (s+1) W(s) = (s+2) W(s+2) *)
Lemma W_recurrence s : 0 < s -> (s+2) * W (s+2) = (s+1) * W s.
Proof.
  intros Hs. pose proof PI_RGT_0.
  assert (H1 : is_RInt (fun t => (s+1) * pw s (sin t) - (s+2) * pw (s+2) (sin t)) 0 (PI/2)
     (minus (cos (PI/2) * pw (s+1) (sin (PI/2))) (cos 0 * pw (s+1) (sin 0)))).
  { apply (is_RInt_derive (fun t => cos t * pw (s+1) (sin t))).
    - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply parts_derive; auto.
      apply sin_ge_0; lra.
    - intros t _. apply (continuous_minus (V := R_NormedModule)); 
      apply (continuous_scal_r (V := R_NormedModule)); apply cont_pw_sin; lra. }
  rewrite cos_PI2, sin_0, (pw_neg _ 0) in H1 by lra.
  replace (minus (0 * pw (s+1) (sin (PI/2))) (cos 0 * 0)) with 0 in H1
    by (unfold minus, plus, opp; simpl; ring).
  assert (H2 : is_RInt (fun t => (s+1) * pw s (sin t) - (s+2) * pw (s+2) (sin t)) 0 (PI/2)
     ((s+1) * W s - (s+2) * W (s+2))).
  { apply (is_RInt_minus (V := R_NormedModule) (fun t => (s+1) * pw s (sin t)));
    apply (is_RInt_scal (V := R_NormedModule)); apply (RInt_correct (V := R_CompleteNormedModule)); apply ex_W; lra. }
  apply (is_RInt_unique (V := R_CompleteNormedModule)) in H1. apply (is_RInt_unique (V := R_CompleteNormedModule)) in H2.
  change (@eq R (RInt (fun t => (s+1) * pw s (sin t) - (s+2) * pw (s+2) (sin t)) 0 (PI/2)) 0) in H1.
  rewrite H1 in H2. lra.
Qed.

Lemma kappa_step n : 0 < n -> kappa (n+2) = kappa n * (n+2) / (n+1).
Proof.
  intros Hn. unfold kappa. pose proof (W_recurrence (n+1) ltac:(lra)) as H.
  replace (n+2+1) with (n+1+2) by ring. rewrite H. field. lra.
Qed.

(* kappa_1 = PI/2 and kappa_2 = 2, from antiderivatives *)
Lemma W_2 : W 2 = PI/4.
Proof.
  pose proof PI_RGT_0. apply is_RInt_unique.
  apply (is_RInt_ext (fun t => (sin t)^2)).
  { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. rewrite pw_pos by (apply sin_gt_0; lra).
    replace 2 with (1+1) by ring. rewrite Rpower_plus, Rpower_1 by (apply sin_gt_0; lra). 
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  replace (PI/4) with (minus ((PI/2 - sin (PI/2) * cos (PI/2))/2) ((0 - sin 0 * cos 0)/2)).
  2:{ rewrite cos_PI2, sin_0. unfold minus, plus, opp; simpl. field. }
  apply (is_RInt_derive (fun t => (t - sin t * cos t)/2)).
  - intros t _. auto_derive; auto. pose proof (sin2_cos2 t) as H1. unfold Rsqr in H1. nra.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma W_3 : W 3 = 2/3.
Proof.
  pose proof PI_RGT_0. apply is_RInt_unique.
  apply (is_RInt_ext (fun t => (sin t)^3)).
  { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. rewrite pw_pos by (apply sin_gt_0; lra).
    replace 3 with (1+1+1) by ring. rewrite !Rpower_plus, Rpower_1 by (apply sin_gt_0; lra). 
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  replace (2/3) with (minus ((cos (PI/2))^3/3 - cos (PI/2)) ((cos 0)^3/3 - cos 0)).
  2:{ rewrite cos_PI2, cos_0. unfold minus, plus, opp; simpl. field. }
  apply (is_RInt_derive (fun t => (cos t)^3/3 - cos t)).
  - intros t _. auto_derive; auto. pose proof (sin2_cos2 t) as H1. unfold Rsqr in H1.
    replace (sin t ^3) with (sin t * (sin t * sin t)) by ring.
    replace (sin t * sin t) with (1 - cos t * cos t) by lra. field.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma kappa_1 : kappa 1 = PI/2.
Proof. unfold kappa. replace (1+1) with 2 by ring. rewrite W_2. field. Qed.
Lemma kappa_2 : kappa 2 = 2.
Proof. unfold kappa. replace (2+1) with 3 by ring. rewrite W_3. field. Qed.

(* W falls: s < s' -> W s' < W s *)
Lemma W_falls s s' : 0 < s -> s < s' -> W s' < W s.
Proof.
  intros Hs H. pose proof PI_RGT_0. apply RInt_lt; try lra;
  try (intros; apply cont_pw_sin; lra).
  intros t Ht. destruct (sin_range t Ht) as [H1 H2]. rewrite !pw_pos by auto.
  unfold Rpower. apply exp_increasing. assert (ln (sin t) < 0). { rewrite <- ln_1. apply ln_increasing; auto. } nra.
Qed.

Lemma W_pos s : 0 < s -> 0 < W s.
Proof.
  intros Hs. pose proof PI_RGT_0. apply RInt_gt_0; try lra; try (intros; apply cont_pw_sin; lra).
  intros t Ht. rewrite pw_pos by (apply sin_range; auto). apply Rp_pos.
Qed.

(* V s = (s+1) W(s) W(s+1) has period 1 and is PI/2 at 2; W falls, so it is PI/2 everywhere. *)
Definition V s := (s+1) * (W s * W (s+1)).

Lemma V_period s : 0 < s -> V (s+1) = V s.
Proof.
  intros Hs. unfold V. pose proof (W_recurrence s Hs) as H.
  replace (s+1+1) with (s+2) by ring.
  transitivity (W (s+1) * ((s+2) * W (s+2))). ring. rewrite H. ring.
Qed.

Lemma V_period_nat s m : 0 < s -> V (s + INR m) = V s.
Proof.
  intros Hs. induction m. simpl. f_equal; ring.
  rewrite S_INR. replace (s + (INR m + 1)) with (s + INR m + 1) by ring. rewrite V_period; auto.
  pose proof (pos_INR m). lra.
Qed.

Lemma V_2 : V 2 = PI/2.
Proof. unfold V. replace (2+1) with 3 by ring. rewrite W_2, W_3. field. Qed.

Lemma V_at_nat m : V (2 + INR m) = PI/2.
Proof. rewrite V_period_nat by lra. apply V_2. Qed.

Lemma V_between s t : 0 < s -> s <= t -> V t <= (t+1) / (s+1) * V s.
Proof.
  intros Hs Ht. unfold V. 
  replace ((t+1)/(s+1) * ((s+1) * (W s * W (s+1)))) with ((t+1) * (W s * W (s+1))) by (field; lra).
  apply Rmult_le_compat_l. lra.
  assert (W t <= W s) by (destruct Ht as [Ht|Ht]; [left; apply W_falls|subst]; lra).
  assert (W (t+1) <= W (s+1)) by (destruct Ht as [Ht|Ht]; [left; apply W_falls|subst]; lra).
  pose proof (W_pos t ltac:(lra)). pose proof (W_pos (t+1) ltac:(lra)). nra.
Qed.

Lemma arch x A : (forall m, x <= A / (INR m + 1)) -> x <= 0.
Proof.
  intros H. destruct (Rle_dec x 0) as [|Hx]; auto. apply Rnot_le_lt in Hx. exfalso.
  destruct (Rle_dec A 0) as [HA|HA].
  - specialize (H 0%nat). simpl in H. lra.
  - apply Rnot_le_lt in HA. assert (HD : 0 < A / x) by (apply Rdiv_lt_0_compat; auto).
    set (m := Z.to_nat (up (A / x))). specialize (H m).
    assert (Hm : A / x < INR m).
    { unfold m. rewrite INR_IZR_INZ, Z2Nat.id. destruct (archimed (A/x)); lra.
      apply le_IZR. destruct (archimed (A/x)); lra. }
    assert (A < INR m * x).
    { apply Rmult_lt_compat_r with (r := x) in Hm; auto. unfold Rdiv in Hm. rewrite Rmult_assoc, Rinv_l in Hm; lra. }
    assert (H1 : x * (INR m + 1) <= A).
    { apply Rmult_le_compat_r with (r := INR m + 1) in H. unfold Rdiv in H. rewrite Rmult_assoc, Rinv_l in H; lra. lra. }
    nra.
Qed.

Lemma V_pos s : 0 < s -> 0 < V s.
Proof.
  intros Hs. unfold V. pose proof (W_pos s Hs). pose proof (W_pos (s+1) ltac:(lra)).
  repeat apply Rmult_lt_0_compat; lra.
Qed.

Lemma V_constant s : 0 < s -> V s = PI/2.
Proof.
  intros Hs. pose proof PI_RGT_0 as Hpi. pose proof (V_pos s Hs) as HV.
  set (k := Z.to_nat (up s)).
  assert (Hk : s <= INR k).
  { unfold k. rewrite INR_IZR_INZ, Z2Nat.id. destruct (archimed s); lra.
    apply le_IZR. destruct (archimed s); lra. }
  assert (Hshift : forall m, V (s + (INR m + 2)) = V s).
  { intros m. replace (s + (INR m + 2)) with (s + INR (m + 2)) by (rewrite plus_INR; simpl; ring).
    apply V_period_nat; auto. }
  apply Rle_antisym.
  - apply Rminus_le. apply arch with (PI/2*s). intros m. pose proof (pos_INR m) as Hm.
    pose proof (V_between (2 + INR m) (s + (INR m + 2)) ltac:(lra) ltac:(lra)) as H1.
    rewrite Hshift, V_at_nat in H1.
    apply Rle_trans with (PI/2 * s / (INR m + 3)).
    + apply Rplus_le_reg_r with (PI/2). apply Rle_trans with (1 := ltac:(lra) : V s - PI/2 + PI/2 <= V s).
      apply Rle_trans with (1 := H1). right. field. lra.
    + apply Rmult_le_compat_l. nra. apply Rinv_le_contravar; lra.
  - apply Rminus_le. apply arch with (INR k * V s). intros m. pose proof (pos_INR m) as Hm.
    pose proof (V_between (s + (INR m + 2)) (2 + INR (m + k)) ltac:(lra) ltac:(rewrite plus_INR; lra)) as H2.
    rewrite Hshift, V_at_nat, plus_INR in H2.
    apply Rle_trans with (INR k * V s / (s + INR m + 3)).
    + apply Rplus_le_reg_r with (V s). apply Rle_trans with (PI/2). lra. apply Rle_trans with (1 := H2).
      replace ((2 + (INR m + INR k) + 1) / (s + (INR m + 2) + 1) * V s)
        with ((INR k - s) * V s / (s + INR m + 3) + V s) by (field; lra).
      apply Rplus_le_compat_r. apply Rmult_le_compat_r. left; apply Rinv_0_lt_compat; lra. nra.
    + apply Rmult_le_compat_l. pose proof (pos_INR k). nra. apply Rinv_le_contravar; lra.
Qed.

Lemma kappa_pos n : 0 < n -> 0 < kappa n.
Proof. intros. unfold kappa. pose proof (W_pos (n+1) ltac:(lra)). nra. Qed.

(* kappa_n kappa_(n+1) = PI (n+1)/2 for every real n > 0, from the integral alone: no Gamma function *)
Lemma kappa_product n : 0 < n -> kappa n * kappa (n+1) = PI * (n+1) / 2.
Proof.
  intros Hn. pose proof (V_constant (n+1) ltac:(lra)) as H. unfold kappa, V in *.
  replace (n+1+1) with (n+2) in * by ring.
  replace ((n+1) * W (n+1) * ((n+2) * W (n+2))) with ((n+1) * ((n+2) * (W (n+1) * W (n+2)))) by ring.
  rewrite H. field.
Qed.

(* kappa_n = PI/(2 W(n)); so it grows, as W falls *)
Lemma kappa_W n : 0 < n -> kappa n = PI / (2 * W n).
Proof.
  intros Hn. pose proof (V_constant n Hn) as H. pose proof (W_pos n Hn). unfold kappa, V in *.
  replace PI with (2 * (PI/2)) by field. rewrite <- H. field. lra.
Qed.

(** κ_n grows with n. *)
Theorem kappa_growth n m : 0 < n -> n < m -> kappa n < kappa m.
Proof.
  intros Hn Hm. rewrite !kappa_W by lra. pose proof (W_falls n m Hn Hm). pose proof (W_pos m ltac:(lra)).
  pose proof PI_RGT_0. apply Rmult_lt_compat_l; auto. apply Rinv_lt_contravar; nra.
Qed.

(** κ_n² lies below π(n+1)/2. *)
Theorem kappa_upper n : 0 < n -> kappa n ^ 2 < PI * (n+1) / 2.
Proof.
  intros Hn. pose proof (kappa_growth n (n+1) Hn ltac:(lra)). pose proof (kappa_pos n Hn).
  rewrite <- kappa_product by auto. nra.
Qed.

Lemma kappa_lower_above_1 n : 1 < n -> PI * n / 2 < kappa n ^ 2.
Proof.
  intros Hn. pose proof (kappa_growth (n-1) n ltac:(lra) ltac:(lra)). pose proof (kappa_pos (n-1) ltac:(lra)).
  pose proof (kappa_product (n-1) ltac:(lra)) as H1. replace (n-1+1) with n in H1 by ring. nra.
Qed.

(** What determines κ: a function that is positive, does not fall and has the product of kappa-recurrences is κ. *)
Theorem kappa_unique (K : R -> R) :
  (forall n, 0 < n -> 0 < K n) ->
  (forall n m, 0 < n -> n <= m -> K n <= K m) ->
  (forall n, 0 < n -> K n * K (n+1) = PI * (n+1) / 2) ->
  forall n, 0 < n -> K n = kappa n.
Proof.
  intros Kpos Kmono Kprod. pose proof PI_RGT_0 as Hpi.
  (* the ratio has period 2, and its square lies between n/(n+1) and (n+1)/n *)
  assert (Kstep : forall n, 0 < n -> K (n+2) = K n * (n+2)/(n+1)).
  { intros n Hn. pose proof (Kprod n Hn) as H1. pose proof (Kprod (n+1) ltac:(lra)) as H2.
    replace (n+1+1) with (n+2) in H2 by ring.
    pose proof (Kpos n Hn). pose proof (Kpos (n+1) ltac:(lra)).
    apply Rmult_eq_reg_l with (K (n+1)); [|lra]. rewrite H2.
    replace (K (n+1) * (K n * (n+2)/(n+1))) with (K n * K (n+1) * (n+2)/(n+1)) by (field; lra).
    rewrite H1. field. lra. }
  assert (Hper : forall n m, 0 < n -> K (n + INR m * 2) / kappa (n + INR m * 2) = K n / kappa n).
  { intros n m Hn. induction m.
    - simpl. replace (n + 0*2) with n by ring. auto.
    - rewrite S_INR. replace (n + (INR m + 1)*2) with (n + INR m * 2 + 2) by ring.
      pose proof (pos_INR m). assert (Hq : 0 < n + INR m * 2) by lra.
      rewrite Kstep, kappa_step by auto. rewrite <- IHm.
      pose proof (kappa_pos _ Hq). field. repeat split; lra. }
  assert (Hone : forall n, 1 < n -> K n <= (n+1)/n * kappa n /\ kappa n <= (n+1)/n * K n).
  { intros n Hn. 
    assert (KU : K n * K n <= PI * (n+1)/2). { rewrite <- Kprod by lra. apply Rmult_le_compat_l. left; apply Kpos; lra. apply Kmono; lra. }
    assert (KL : PI * n/2 <= K n * K n).
    { pose proof (Kprod (n-1) ltac:(lra)) as H1. replace (n-1+1) with n in H1 by ring. rewrite <- H1.
      apply Rmult_le_compat_r. left; apply Kpos; lra. apply Kmono; lra. }
    pose proof (kappa_upper n ltac:(lra)) as U. pose proof (kappa_lower_above_1 n Hn) as L.
    pose proof (Kpos n ltac:(lra)) as P1. pose proof (kappa_pos n ltac:(lra)) as P2.
    simpl in U, L. rewrite Rmult_1_r in U, L.
    assert (Hr : 1 < (n+1)/n). { apply Rmult_lt_reg_r with n. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    assert (Hn1 : PI * (n+1)/2 = (n+1)/n * (PI * n/2)) by (field; lra).
    set (r := (n+1)/n) in *. set (p := PI*n/2) in *. assert (0 < p) by (unfold p; nra).
    rewrite Hn1 in *. clear Hn1.
    assert (Hsq : forall x y, 0 < x -> 0 < y -> x * x <= r * p -> p <= y * y -> x <= r * y).
    { intros x y Hx Hy H1 H2. apply Rnot_lt_le. intro H3. assert (0 < r * y) by nra.
      pose proof (Rmult_le_0_lt_compat (r*y) x (r*y) x ltac:(lra) ltac:(lra) H3 H3).
      assert (r * r * p <= r * r * (y*y)) by (apply Rmult_le_compat_l; nra). assert (r * p < r * (r * p)) by nra. lra. }
    split; apply Hsq; lra. }
  intros n Hn. pose proof (kappa_pos n Hn) as P2. pose proof (Kpos n Hn) as P1.
  apply Rle_antisym; apply Rminus_le.
  - apply arch with (kappa n). intros m. pose proof (pos_INR m) as Hm.
    assert (Hq : 1 < n + INR (m+1) * 2) by (rewrite plus_INR; simpl; lra).
    destruct (Hone _ Hq) as [H1 _]. pose proof (Hper n (m+1)%nat Hn) as H2.
    set (q := n + INR (m+1) * 2) in *. pose proof (kappa_pos q ltac:(lra)) as P3.
    assert (H3 : K n / kappa n <= (q+1)/q).
    { rewrite <- H2. apply Rmult_le_reg_r with (kappa q); auto. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra. }
    assert (H4 : K n <= (q+1)/q * kappa n).
    { apply Rmult_le_compat_r with (r := kappa n) in H3. unfold Rdiv at 1 in H3. rewrite Rmult_assoc, Rinv_l in H3; lra. lra. }
    replace ((q+1)/q * kappa n) with (kappa n + kappa n * / q) in H4 by (field; lra).
    assert (/ q <= / (INR m + 1)). { apply Rinv_le_contravar. lra. unfold q. rewrite plus_INR; simpl; lra. }
    unfold Rdiv. nra.
  - apply arch with (K n). intros m. pose proof (pos_INR m) as Hm.
    assert (Hq : 1 < n + INR (m+1) * 2) by (rewrite plus_INR; simpl; lra).
    destruct (Hone _ Hq) as [_ H1]. pose proof (Hper n (m+1)%nat Hn) as H2.
    set (q := n + INR (m+1) * 2) in *. pose proof (kappa_pos q ltac:(lra)) as P3. pose proof (Kpos q ltac:(lra)) as P4.
    assert (H3 : kappa n / K n <= (q+1)/q).
    { replace (kappa n / K n) with (kappa q / K q).
      apply Rmult_le_reg_r with (K q); auto. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l; lra.
      replace (kappa q / K q) with (/ (K q / kappa q)) by (field; lra). rewrite H2. field; lra. }
    assert (H4 : kappa n <= (q+1)/q * K n).
    { apply Rmult_le_compat_r with (r := K n) in H3. unfold Rdiv at 1 in H3. rewrite Rmult_assoc, Rinv_l in H3; lra. lra. }
    replace ((q+1)/q * K n) with (K n + K n * / q) in H4 by (field; lra).
    assert (/ q <= / (INR m + 1)). { apply Rinv_le_contravar. lra. unfold q. rewrite plus_INR; simpl; lra. }
    unfold Rdiv. nra.
Qed.

(** The recurrences of κ: the product of neighbours, and the step from n to n + 2. *)
Theorem kappa_recurrences n : 0 < n ->
  kappa n * kappa (n+1) = PI * (n+1) / 2 /\ kappa (n+2) = kappa n * (n+2) / (n+1).
Proof. intros Hn. split. apply kappa_product; auto. apply kappa_step; auto. Qed.

(** The values that textbooks have: cone, paraboloid, and the next two. *)
Theorem kappa_values : kappa 1 = PI/2 /\ kappa 2 = 2 /\ kappa 3 = 3*PI/4 /\ kappa 4 = 8/3.
Proof.
  repeat split. apply kappa_1. apply kappa_2.
  - replace 3 with (1+2) by ring. rewrite kappa_step, kappa_1 by lra. field.
  - replace 4 with (2+2) by ring. rewrite kappa_step, kappa_2 by lra. field.
Qed.

(** κ_n² lies above πn/2, for every n > 0: κ_n²/n falls from n to n + 2, and is large enough beyond n = 1. *)
Theorem kappa_lower n : 0 < n -> PI * n / 2 < kappa n ^ 2.
Proof.
  intros Hn. pose proof PI_RGT_0 as Hpi. pose proof (kappa_lower_above_1 (n+2) ltac:(lra)) as H1.
  rewrite kappa_step in H1 by auto. pose proof (kappa_pos n Hn) as Hk. set (k := kappa n) in *.
  replace ((k * (n+2)/(n+1))^2) with (k^2 * ((n+2)^2/(n+1)^2)) in H1 by (field; lra).
  assert (H2 : 0 < (n+2)^2/(n+1)^2) by (apply Rdiv_lt_0_compat; apply pow_lt; lra).
  apply Rmult_lt_reg_r with ((n+2)^2/(n+1)^2); auto. apply Rlt_trans with (2 := H1).
  apply Rmult_lt_reg_r with (2*(n+1)^2). apply Rmult_lt_0_compat. lra. apply pow_lt; lra.
  replace (PI*n/2*((n+2)^2/(n+1)^2)*(2*(n+1)^2)) with (PI*(n+2)*(n*(n+2))) by (field; lra).
  replace (PI*(n+2)/2*(2*(n+1)^2)) with (PI*(n+2)*(n+1)^2) by field.
  apply Rmult_lt_compat_l; nra.
Qed.

Lemma W_1 : W 1 = 1.
Proof.
  pose proof PI_RGT_0. apply is_RInt_unique. apply (is_RInt_ext sin).
  { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. assert (0 < sin t) by (apply sin_gt_0; lra).
    rewrite pw_pos, Rpower_1 by auto. auto. }
  replace 1 with (minus (- cos (PI/2)) (- cos 0)).
  2:{ rewrite cos_PI2, cos_0. unfold minus, plus, opp; simpl. ring. }
  apply (is_RInt_derive (fun t => - cos t)).
  - intros t _. auto_derive; auto. ring.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma W_below n : 0 < n -> W n < PI/2.
Proof.
  intros Hn. pose proof PI_RGT_0. replace (PI/2) with (RInt (fun _ => 1) 0 (PI/2)).
  2:{ rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. }
  apply RInt_lt; try lra; intros.
  - apply continuous_const.
  - apply cont_pw_sin; auto.
  - destruct (sin_range x H0). rewrite pw_pos by auto. unfold Rpower.
    assert (ln (sin x) < 0) by (rewrite <- ln_1; apply ln_increasing; auto).
    rewrite <- exp_0. apply exp_increasing. nra.
Qed.

(** κ_n lies between 1 and 1 + n ... *)
Theorem kappa_small n : 0 < n -> 1 < kappa n < 1 + n.
Proof.
  intros Hn. pose proof PI_RGT_0. split.
  - rewrite kappa_W by auto. pose proof (W_below n Hn). pose proof (W_pos n Hn).
    apply Rmult_lt_reg_r with (2 * W n). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
  - unfold kappa. pose proof (W_falls 1 (n+1) ltac:(lra) ltac:(lra)). rewrite W_1 in *. nra.
Qed.

(** ... so it tends to 1 as n tends to 0. *)
Theorem kappa_at_0 : filterlim kappa (at_right 0) (locally 1).
Proof.
  apply filterlim_locally. intros eps. exists eps. intros n Hn H0. change (Rabs (n - 0) < eps) in Hn.
  destruct (kappa_small n H0). change (Rabs (kappa n - 1) < eps). rewrite Rabs_pos_eq in Hn by lra. apply Rabs_def1; lra.
Qed.

(** (1.12) with Gamma functions, as it is printed and without its 0·∞ at n = 0. By the theorem of Bohr and Mollerup
    ([gamma_unique], [gamma_exists]) Euler's Γ is the one function on the positive numbers that is positive, has Γ(z+1) = zΓ(z), a
    convex logarithm and Γ(1) = 1; here any function G with the first three will do. *)
Theorem eq_1_12_gamma (G : R -> R) :
  (forall z, 0 < z -> 0 < G z) ->
  (forall z, 0 < z -> G (z+1) = z * G z) ->
  (forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (G (t*x + (1-t)*y)) <= t * ln (G x) + (1-t) * ln (G y)) ->
  forall n, 0 < n ->
  kappa n = sqrt PI / 2 * (n * G (n/2)) / G ((n+1)/2) /\ kappa n = sqrt PI * G (1 + n/2) / G ((n+1)/2).
Proof.
  intros Gpos Gstep Gconv. pose proof PI_RGT_0 as Hpi. pose proof (sqrt_lt_R0 PI Hpi) as Hs.
  set (K := fun n => sqrt PI * G (1 + n/2) / G ((n+1)/2)).
  assert (Hhalf : forall x y, 0 < x -> x < y -> ln (G (x + /2)) + ln (G y) <= ln (G x) + ln (G (y + /2))).
  { (* x + 1/2 and y lie between x and y + 1/2 *)
    intros x y Hx Hy. set (t := (/2) / (y + /2 - x)).
    assert (Ht : 0 <= t <= 1).
    { unfold t. split. apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat. lra.
      apply Rmult_le_reg_r with (y + /2 - x). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    pose proof (Gconv x (y + /2) t ltac:(lra) ltac:(lra) Ht) as H1.
    pose proof (Gconv x (y + /2) (1 - t) ltac:(lra) ltac:(lra) ltac:(lra)) as H2.
    replace (t * x + (1-t) * (y + /2)) with y in H1 by (unfold t; field; lra).
    replace ((1-t) * x + (1-(1-t)) * (y + /2)) with (x + /2) in H2 by (unfold t; field; lra). lra. }
  assert (HK : forall n, 0 < n -> K n = kappa n).
  { apply kappa_unique.
    - intros n Hn. unfold K. pose proof (Gpos (1+n/2) ltac:(lra)). pose proof (Gpos ((n+1)/2) ltac:(lra)). pos.
    - intros n m Hn [Hm|Hm]; [|subst; lra]. pose proof (Hhalf ((n+1)/2) ((m+1)/2) ltac:(lra) ltac:(lra)) as H1.
      replace ((n+1)/2 + /2) with (1 + n/2) in H1 by field. replace ((m+1)/2 + /2) with (1 + m/2) in H1 by field.
      pose proof (Gpos (1+n/2) ltac:(lra)). pose proof (Gpos ((n+1)/2) ltac:(lra)).
      pose proof (Gpos (1+m/2) ltac:(lra)). pose proof (Gpos ((m+1)/2) ltac:(lra)).
      assert (H6 : G (1+n/2) / G ((n+1)/2) <= G (1+m/2) / G ((m+1)/2)).
      { rewrite <- (exp_ln (G (1+n/2) / G ((n+1)/2))), <- (exp_ln (G (1+m/2) / G ((m+1)/2))) by pos.
        rewrite !ln_div by auto.
        assert (ln (G (1+n/2)) - ln (G ((n+1)/2)) <= ln (G (1+m/2)) - ln (G ((m+1)/2))) as [H6|H6] by lra.
        left. apply exp_increasing; auto. rewrite H6. lra. }
      unfold K, Rdiv. rewrite !Rmult_assoc. apply Rmult_le_compat_l. lra. exact H6.
    - intros n Hn. unfold K. replace (1 + (n+1)/2) with ((n+1)/2 + 1) by ring. rewrite Gstep by lra.
      replace ((n+1+1)/2) with (1 + n/2) by field.
      pose proof (Gpos (1+n/2) ltac:(lra)). pose proof (Gpos ((n+1)/2) ltac:(lra)).
      replace PI with (sqrt PI * sqrt PI) at 3 by (apply sqrt_sqrt; lra). field. split; lra. }
  intros n Hn. rewrite <- HK by auto. unfold K. split; auto. replace (1 + n/2) with (n/2 + 1) by ring.
  rewrite Gstep by lra. field. apply Rgt_not_eq, Gpos. lra.
Qed.

Lemma kappa_2_nat (K : R -> R) n m : (forall n, 0 < n -> K (n+2) = K n * (n+2)/(n+1)) -> 0 < n ->
  K (n + 2 * INR m) / kappa (n + 2 * INR m) = K n / kappa n.
Proof.
  intros Kstep Hn. induction m.
  - simpl. replace (n + 2*0) with n by ring. auto.
  - rewrite S_INR. replace (n + 2*(INR m + 1)) with (n + 2*INR m + 2) by ring. pose proof (pos_INR m).
    rewrite Kstep, kappa_step by lra. rewrite <- IHm. pose proof (kappa_pos (n + 2*INR m) ltac:(lra)).
    field. repeat split; lra.
Qed.

(** Another such theorem, of use to series: a function that does not fall, has κ's step from n to n + 2 and the value 2 at 2 is
    κ. *)
Theorem kappa_unique_step (K : R -> R) :
  (forall n m, 0 < n -> n <= m -> K n <= K m) ->
  (forall n, 0 < n -> K (n+2) = K n * (n+2)/(n+1)) -> K 2 = 2 ->
  forall n, 0 < n -> K n = kappa n.
Proof.
  intros Kmono Kstep K2.
  set (q := fun n => K n / kappa n).
  (* q has period 2, and q (n) <= (1 + 1/(m+1)) q (m') for n, m' of the same turn: K and kappa grow, and a turn is little *)
  assert (Hle : forall n m, 0 < n -> n <= m -> m <= n + 2 -> 0 <= K n -> q n <= q m).
  { intros n m Hn Hnm Hmn HKn. apply Rminus_le. apply arch with (q n). intros k. pose proof (pos_INR k) as Hk.
    set (j := 2 * INR k).
    assert (Hqn : q n = K (n + j) / kappa (n + j)) by (symmetry; apply kappa_2_nat; auto).
    assert (Hqm : q m = K (m + j) / kappa (m + j)) by (symmetry; apply kappa_2_nat; auto; lra).
    assert (Hj : 0 <= j) by (unfold j; lra).
    pose proof (kappa_pos (n+j) ltac:(lra)) as P1. pose proof (kappa_pos (m+j) ltac:(lra)) as P2.
    assert (Hq0 : 0 <= q n). { unfold q. apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat, kappa_pos; auto. }
    assert (H1 : kappa (m+j) <= kappa (n+j) * (n+j+2)/(n+j+1)).
    { rewrite <- kappa_step by lra. destruct Hmn as [Hmn|Hmn].
      left. apply kappa_growth; lra. subst m. right. f_equal. ring. }
    assert (H2 : q n * kappa (n+j) <= q m * kappa (m+j)).
    { rewrite Hqn, Hqm. unfold Rdiv. rewrite !Rmult_assoc, !Rinv_l, !Rmult_1_r by lra. apply Kmono; lra. }
    assert (Hq1 : 0 <= q m). { apply Rnot_lt_le. intro. assert (q m * kappa (m+j) < 0) by nra. nra. }
    assert (H3 : q n <= q m * ((n+j+2)/(n+j+1))).
    { apply Rmult_le_reg_r with (kappa (n+j)); auto. apply Rle_trans with (1 := H2).
      replace (q m * ((n+j+2)/(n+j+1)) * kappa (n+j)) with (q m * (kappa (n+j) * (n+j+2)/(n+j+1))) by (field; lra).
      apply Rmult_le_compat_l; auto. }
    apply Rmult_le_reg_r with (n+j+2). lra.
    assert (H4 : q n * (n+j+1) <= q m * (n+j+2)).
    { apply Rmult_le_compat_r with (r := n+j+1) in H3; [|lra]. unfold Rdiv in H3. 
      rewrite !Rmult_assoc, Rinv_l, Rmult_1_r in H3 by lra. lra. }
    assert (q n <= q n / (INR k + 1) * (n+j+2)).
    { unfold Rdiv. rewrite Rmult_assoc. rewrite <- (Rmult_1_r (q n)) at 1. apply Rmult_le_compat_l; auto.
      apply Rmult_le_reg_l with (INR k + 1). lra. rewrite <- Rmult_assoc, Rinv_r by lra. unfold j. lra. }
    lra. }
  assert (Kn2 : forall n, 0 < n -> n <= 2 -> 0 <= K n).
  { intros n Hn H2. pose proof (Kmono 2 (n+2) ltac:(lra) ltac:(lra)) as H. rewrite K2, Kstep in H by auto.
    assert (0 < (n+2)/(n+1)) by (apply Rdiv_lt_0_compat; lra). unfold Rdiv in *. rewrite Rmult_assoc in H.
    set (x := _ * _) in *. apply Rnot_lt_le. intro. assert (K n * ((n+2) * / (n+1)) < 0) by nra. unfold x in H. lra. }
  assert (Hall : forall n, 0 < n -> 0 <= K n).
  { intros n Hn. destruct (Rle_dec n 2). auto. apply Rle_trans with (K 2). lra. apply Kmono; lra. }
  assert (q2 : q 2 = 1). { unfold q. rewrite K2, kappa_2. field. }
  assert (Hone : forall n, 0 < n -> n <= 2 -> q n = 1).
  { intros n Hn H2. apply Rle_antisym.
    - rewrite <- q2. apply Hle; auto; lra.
    - assert (q (n+2) = q n). { pose proof (kappa_2_nat K n 1 Kstep Hn) as H. simpl in H.
        replace (n + 2*1) with (n+2) in H by ring. exact H. }
      rewrite <- H, <- q2. apply Hle; lra. }
  intros n Hn.
  assert (Hq : q n = 1).
  { destruct (Rle_dec n 2). auto.
    (* n = n' + 2 m with 0 < n' <= 2 *)
    set (m := Z.to_nat (up (n/2) - 1)). 
    assert (Hup : (1 <= up (n/2))%Z). { apply le_IZR. destruct (archimed (n/2)). lra. }
    assert (Hm : INR m = IZR (up (n/2)) - 1).
    { unfold m. rewrite INR_IZR_INZ, Z2Nat.id by lia. rewrite minus_IZR. auto. }
    destruct (archimed (n/2)) as [A1 A2].
    destruct (Req_dec (n - 2*INR m) 0) as [Hz|Hz].
    - destruct m as [|m']. simpl in Hz. lra.
      pose proof (kappa_2_nat K 2 m' Kstep ltac:(lra)) as H. rewrite S_INR in Hz.
      replace (2 + 2*INR m') with n in H by lra. unfold q at 1. rewrite H. apply q2.
    - assert (0 < n - 2*INR m) by (rewrite Hm in *; lra). 
      pose proof (kappa_2_nat K (n - 2*INR m) m Kstep ltac:(lra)) as H1.
      replace (n - 2*INR m + 2*INR m) with n in H1 by ring. unfold q at 1. rewrite H1. apply Hone; auto.
      rewrite Hm. lra. }
  unfold q in Hq. pose proof (kappa_pos n Hn). apply Rmult_eq_reg_r with (/ kappa n). 2:{ apply Rinv_neq_0_compat; lra. }
  rewrite Rinv_r by lra. exact Hq.
Qed.
