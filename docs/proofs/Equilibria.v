(** Section 3 of the paper: how many equilibria a power law has, at every indentation and at every force, and the shape of its
    energy over all radii: which contacts break and which become complete. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability MDR.PowerLaw.
Open Scope R_scope.

(** Indentation and force have the same form in u = ln a: K e^(qu) (e^(p(u - v)) - 1), up to a sign, with K, q, p > 0. It falls
    from 0 to one minimum, and grows from there without bound. *)
Section Valley.
Variables K q p v mu : R.
Hypotheses (HK : 0 < K) (Hq : 0 < q) (Hp : 0 < p) (Hmu : p * (mu - v) = ln (q / (q + p))).

Definition valley u := K * exp (q*u) * (exp (p*(u - v)) - 1).
Let slope u := K * exp (q*u) * ((q + p) * exp (p*(u - v)) - q).

Lemma valley_derive u : is_derive valley u (slope u).
Proof. unfold valley, slope. auto_derive. auto. unfold Rminus. rewrite ?Rmult_1_l, ?Rmult_1_r. ring. Qed.

Lemma ratio_range : 0 < q / (q + p) < 1.
Proof.
  split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with (q + p). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma at_mu : exp (p*(mu - v)) = q / (q + p).
Proof. rewrite Hmu. apply exp_ln, ratio_range. Qed.

Lemma slope_sign u : (u < mu -> slope u < 0) /\ (mu < u -> 0 < slope u).
Proof.
  pose proof (exp_pos (q*u)) as He. pose proof at_mu as H1. assert (Hke : 0 < K * exp (q*u)) by nra.
  assert (H2 : (q + p) * (q / (q + p)) = q) by (field; lra). unfold slope. split; intros Hu.
  - assert (exp (p*(u - v)) < q / (q + p)). { rewrite <- H1. apply exp_increasing. nra. }
    assert ((q + p) * exp (p*(u - v)) < q). { rewrite <- H2 at 2. apply Rmult_lt_compat_l; lra. } nra.
  - assert (q / (q + p) < exp (p*(u - v))). { rewrite <- H1. apply exp_increasing. nra. }
    assert (q < (q + p) * exp (p*(u - v))). { rewrite <- H2 at 1. apply Rmult_lt_compat_l; lra. } nra.
Qed.

Lemma valley_mvt x y : x < y -> exists z, valley y - valley x = slope z * (y - x) /\ x < z < y.
Proof. intros H. apply MVT_cor2; auto. intros z _. apply is_derive_Reals, valley_derive. Qed.

Lemma valley_falls x y : x < y -> y <= mu -> valley y < valley x.
Proof.
  intros H Hy. destruct (valley_mvt x y H) as [z [E1 E2]]. destruct (slope_sign z) as [S _]. specialize (S ltac:(lra)). nra.
Qed.
Lemma valley_grows x y : mu <= x -> x < y -> valley x < valley y.
Proof.
  intros Hx H. destruct (valley_mvt x y H) as [z [E1 E2]]. destruct (slope_sign z) as [_ S]. specialize (S ltac:(lra)). nra.
Qed.

Lemma valley_negative u : u <= mu -> - (K * exp (q*u)) < valley u < 0.
Proof.
  intros Hu. pose proof (exp_pos (q*u)) as He. pose proof at_mu as H1. pose proof ratio_range as H2.
  pose proof (exp_pos (p*(u - v))) as H3. assert (Hke : 0 < K * exp (q*u)) by nra.
  assert (exp (p*(u - v)) <= q / (q + p)).
  { rewrite <- H1. destruct Hu as [Hu|Hu]. left. apply exp_increasing. nra. subst. lra. }
  unfold valley. split; nra.
Qed.

Lemma valley_near_0 d : d < 0 -> exists u, u < mu /\ d < valley u.
Proof.
  intros Hd. set (u := Rmin (mu - 1) (ln (- d / K) / q)). pose proof (Rmin_l (mu - 1) (ln (- d / K) / q)) as H1.
  pose proof (Rmin_r (mu - 1) (ln (- d / K) / q)) as H2. fold u in H1, H2. exists u. split. lra.
  destruct (valley_negative u ltac:(lra)) as [H3 _]. apply Rle_lt_trans with (2 := H3).
  assert (Hdk : 0 < - d / K) by (apply Rdiv_lt_0_compat; lra).
  assert (H4 : exp (q*u) <= - d / K).
  { rewrite <- (exp_ln (- d / K)) by auto. assert (H5 : q*u <= ln (- d / K)).
    { apply Rmult_le_compat_l with (r := q) in H2; [|lra]. replace (q*(ln (- d / K)/q)) with (ln (- d / K)) in H2 by (field; lra). lra. }
    destruct H5 as [H5|H5]. left. apply exp_increasing; auto. rewrite H5. lra. }
  apply Rmult_le_compat_l with (r := K) in H4; [|lra]. replace (K*(- d / K)) with (- d) in H4 by (field; lra). lra.
Qed.

Lemma valley_high d : exists u, mu < u /\ d < valley u.
Proof.
  set (u := Rmax (mu + 1) (Rmax (v + ln 2 / p) ((Rabs d / K + 1) / q))).
  pose proof (Rmax_l (mu + 1) (Rmax (v + ln 2 / p) ((Rabs d / K + 1) / q))) as H1.
  pose proof (Rmax_r (mu + 1) (Rmax (v + ln 2 / p) ((Rabs d / K + 1) / q))) as H2.
  pose proof (Rmax_l (v + ln 2 / p) ((Rabs d / K + 1) / q)) as H3. pose proof (Rmax_r (v + ln 2 / p) ((Rabs d / K + 1) / q)) as H4.
  fold u in H1, H2. exists u. split. lra.
  assert (H5 : 2 <= exp (p*(u - v))).
  { rewrite <- (exp_ln 2) by lra. assert (H : ln 2 <= p*(u - v)).
    { assert (H : ln 2 / p <= u - v) by lra. apply Rmult_le_compat_l with (r := p) in H; [|lra].
      replace (p*(ln 2 / p)) with (ln 2) in H by (field; lra). lra. }
    destruct H as [H|H]. left. apply exp_increasing; auto. rewrite <- H. lra. }
  assert (H6 : Rabs d / K + 1 <= q*u).
  { assert (H : (Rabs d / K + 1)/q <= u) by lra. apply Rmult_le_compat_l with (r := q) in H; [|lra].
    replace (q*((Rabs d / K + 1)/q)) with (Rabs d / K + 1) in H by (field; lra). lra. }
  assert (H7 : Rabs d / K + 1 < exp (q*u)).
  { pose proof (Rabs_pos d). assert (0 <= Rabs d / K). { apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. }
    pose proof (exp_ineq1 (q*u) ltac:(lra)). lra. }
  apply Rmult_lt_compat_l with (r := K) in H7; [|lra]. replace (K*(Rabs d / K + 1)) with (Rabs d + K) in H7 by (field; lra).
  pose proof (Rle_abs d). pose proof (Rabs_pos d). unfold valley. assert (K * exp (q*u) * 1 <= K * exp (q*u) * (exp (p*(u - v)) - 1)).
  { apply Rmult_le_compat_l; lra. } lra.
Qed.

Lemma valley_between x y d : x < y -> (valley x - d) * (valley y - d) < 0 -> exists z, x < z < y /\ valley z = d.
Proof.
  intros Hxy H. assert (Hc : continuity (fun u => valley u - d)).
  { apply continuity_minus. 2: apply continuity_const; intros ? ?; auto.
    intros u. apply derivable_continuous_pt. eexists. apply is_derive_Reals, valley_derive. }
  destruct (IVT_cor _ x y Hc ltac:(lra) ltac:(lra)) as [z [[[H1|H1] [H2|H2]] H3]]; try (subst; rewrite H3 in H; lra).
  exists z. split; lra.
Qed.

Lemma valley_left d : valley mu < d < 0 -> exists u, u < mu /\ valley u = d.
Proof.
  intros Hd. destruct (valley_near_0 d ltac:(lra)) as [x [H1 H2]].
  destruct (valley_between x mu d H1 ltac:(nra)) as [z [H3 H4]]. exists z. split; auto. lra.
Qed.
Lemma valley_right d : valley mu < d -> exists u, mu < u /\ valley u = d.
Proof.
  intros Hd. destruct (valley_high d) as [y [H1 H2]].
  destruct (valley_between mu y d H1 ltac:(nra)) as [z [H3 H4]]. exists z. split; auto. lra.
Qed.
Lemma valley_right_unique x y : mu <= x -> mu <= y -> valley x = valley y -> x = y.
Proof.
  intros Hx Hy H. destruct (Rtotal_order x y) as [L|[L|L]]; auto.
  pose proof (valley_grows x y Hx L). lra. pose proof (valley_grows y x Hy L). lra.
Qed.
Lemma valley_left_unique x y : x <= mu -> y <= mu -> valley x = valley y -> x = y.
Proof.
  intros Hx Hy H. destruct (Rtotal_order x y) as [L|[L|L]]; auto.
  pose proof (valley_falls x y L Hy). lra. pose proof (valley_falls y x L Hx). lra.
Qed.
Lemma valley_least u : valley mu <= valley u.
Proof.
  destruct (Rtotal_order u mu) as [L|[L|L]]. left. apply valley_falls; lra. subst; lra. left. apply valley_grows; lra.
Qed.
End Valley.

Lemma exclusive P : (none P -> ~ one P /\ ~ two P) /\ (one P -> ~ two P).
Proof.
  unfold none, one, two. split.
  - intros H. split. intros [x [Hx _]]. apply (H x Hx). intros [x [y [_ [Hx _]]]]. apply (H x Hx).
  - intros [x [Hx Hu]] [y [z [Hyz [Hy [Hz _]]]]]. apply Hu in Hy. apply Hu in Hz. lra.
Qed.

(** A function of a > 0 that is a valley in ln a, with its minimum at m. *)
Definition valley_like (f : R -> R) m := 0 < m /\ exists K q p v, 0 < K /\ 0 < q /\ 0 < p /\
  p * (ln m - v) = ln (q / (q + p)) /\ forall a, 0 < a -> f a = valley K q p v (ln a).

Lemma ln_le a b : 0 < a -> a <= b -> ln a <= ln b.
Proof. intros Ha [H|H]. left. apply ln_increasing; auto. subst; lra. Qed.

(** What the four cases have in common: two solutions between the minimum and 0, on both sides of m; one otherwise. *)
Lemma count f m d : valley_like f m ->
  (d < f m -> none (fun a => 0 < a /\ f a = d)) /\
  (d = f m \/ 0 <= d -> one (fun a => 0 < a /\ f a = d)) /\
  (f m < d < 0 -> exists a1 a2, 0 < a1 < m /\ m < a2 /\ f a1 = d /\ f a2 = d /\ two (fun a => 0 < a /\ f a = d)).
Proof.
  intros [Hm [K [q [p [v [HK [Hq [Hp [Hmu Hf]]]]]]]]]. rewrite (Hf m Hm).
  set (mu := ln m) in *. set (h := valley K q p v) in *.
  assert (Hneg : h mu < 0) by (apply (valley_negative K q p v mu HK Hq Hp Hmu); lra).
  assert (Hexp : forall u, f (exp u) = h u) by (intros; rewrite Hf, ln_exp by apply exp_pos; auto).
  split; [|split].
  - intros Hd a [Ha H]. rewrite Hf in H by auto. pose proof (valley_least K q p v mu HK Hq Hp Hmu (ln a)). fold h in H, H0. lra.
  - intros [Hd|Hd].
    + exists m. split. split; auto. rewrite Hf by auto. auto. intros a [Ha H]. rewrite Hf in H by auto. fold h in H.
      apply ln_inv; auto. change (ln a = mu). destruct (Rle_dec (ln a) mu).
      apply (valley_left_unique K q p v mu); auto; try lra. fold h. lra.
      apply (valley_right_unique K q p v mu); auto; try lra. fold h. lra.
    + destruct (valley_right K q p v mu HK Hq Hp d ltac:(fold h; lra)) as [u [Hu1 Hu2]]. exists (exp u). split.
      split. apply exp_pos. rewrite Hexp. auto. intros a [Ha H]. rewrite Hf in H by auto. fold h in H, Hu2.
      apply ln_inv; auto. apply exp_pos. rewrite ln_exp.
      assert (mu < ln a). { apply Rnot_le_lt. intro L. pose proof (valley_negative K q p v mu HK Hq Hp Hmu (ln a) L). fold h in H0. lra. }
      apply (valley_right_unique K q p v mu); auto; try lra. fold h. lra.
  - intros Hd. destruct (valley_left K q p v mu HK Hq Hp Hmu d ltac:(fold h; lra)) as [u1 [U1 D1]].
    destruct (valley_right K q p v mu HK Hq Hp d ltac:(fold h; lra)) as [u2 [U2 D2]]. fold h in D1, D2.
    exists (exp u1), (exp u2).
    assert (E1 : exp u1 < m). { replace m with (exp mu) by (apply exp_ln; auto). apply exp_increasing; auto. }
    assert (E2 : m < exp u2). { replace m with (exp mu) by (apply exp_ln; auto). apply exp_increasing; auto. }
    pose proof (exp_pos u1). pose proof (exp_pos u2). rewrite !Hexp. repeat split; auto.
    exists (exp u1), (exp u2). rewrite !Hexp. repeat split; auto; try lra. intros a [Ha H1]. rewrite Hf in H1 by auto. fold h in H1.
    destruct (Rle_dec (ln a) mu); [left|right]; apply ln_inv; auto; try apply exp_pos; rewrite ln_exp.
    apply (valley_left_unique K q p v mu); auto; try lra. fold h. lra.
    apply (valley_right_unique K q p v mu); auto; try lra. fold h. lra.
Qed.

Lemma count_iff f m d : valley_like f m ->
  (none (fun a => 0 < a /\ f a = d) <-> d < f m) /\
  (one (fun a => 0 < a /\ f a = d) <-> d = f m \/ 0 <= d) /\
  (two (fun a => 0 < a /\ f a = d) <-> f m < d < 0).
Proof.
  intros Hv. destruct (count f m d Hv) as [H0 [H1 H2]]. destruct (exclusive (fun a => 0 < a /\ f a = d)) as [X1 X2].
  assert (H2' : f m < d < 0 -> two (fun a => 0 < a /\ f a = d)) by (intros Hd; destruct (H2 Hd) as [a1 [a2 Ha]]; tauto).
  destruct (Rlt_dec d (f m)) as [L|L].
  { specialize (H0 L). assert (f m < 0).
    { destruct Hv as [Hm [K [q [p [v [HK [Hq [Hp [Hmu Hf]]]]]]]]]. rewrite Hf by auto.
      apply (valley_negative K q p v (ln m) HK Hq Hp Hmu). lra. }
    split; [|split]; split; intros; auto; try tauto; lra. }
  destruct (Req_dec d (f m)) as [L1|L1]; [|destruct (Rle_dec 0 d) as [L2|L2]].
  - assert (O : one (fun a => 0 < a /\ f a = d)) by (apply H1; auto). split; [|split]; split; intros; auto; try tauto; lra.
  - assert (O : one (fun a => 0 < a /\ f a = d)) by (apply H1; auto). split; [|split]; split; intros; auto; try tauto; lra.
  - assert (T : two (fun a => 0 < a /\ f a = d)) by (apply H2'; lra). split; [|split]; split; intros; auto; try tauto; lra.
Qed.

(** Below and above the level d. *)
Lemma level f m d a : valley_like f m -> 0 < a ->
  (d < f m -> d < f a) /\
  (forall b, 0 < b -> f b = d -> b < m -> (a < b -> d < f a) /\ (b < a -> a <= m -> f a < d)) /\
  (forall b, f b = d -> m < b -> (m <= a -> a < b -> f a < d) /\ (b < a -> d < f a)).
Proof.
  intros [Hm [K [q [p [v [HK [Hq [Hp [Hmu Hf]]]]]]]]] Ha. rewrite (Hf m Hm), (Hf a Ha).
  pose proof (valley_falls K q p v (ln m) HK Hq Hp Hmu) as Fa. pose proof (valley_grows K q p v (ln m) HK Hq Hp Hmu) as Gr.
  pose proof (valley_least K q p v (ln m) HK Hq Hp Hmu (ln a)) as Le.
  split; [|split]. lra.
  - intros b Hb H Hbm. rewrite Hf in H by auto. rewrite <- H. split; intros.
    + apply Fa. apply ln_increasing; auto. apply ln_le; auto; lra.
    + apply Fa. apply ln_increasing; auto. apply ln_le; auto; lra.
  - intros b H Hbm. rewrite Hf in H by lra. rewrite <- H. split; intros.
    + apply Gr. apply ln_le; auto. apply ln_increasing; auto.
    + apply Gr. apply ln_le; lra. apply ln_increasing; lra.
Qed.

Section Equilibria.
Variables E w C n : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hn : 0 < n).
Notation kap := (kappa n).
Let Hk : 0 < kap := kappa_pos n Hn.
Notation B := (B E w).
Notation N := (N C n).
Notation dl := (dl E w).
Notation dn := (dn E w C n).
Notation Fn := (Fn E w C n).
Notation Un := (Un E w C n).
Notation ac := (ac E w C n).
Notation a0 := (a0 E w C n).
Notation az := (az E w C n).
Notation aF := (aF E w C n).
Let HB : 0 < B := B_pos E w HE Hw.
Let HN : 0 < N := N_pos C n HC Hn.

Lemma N_kappa : kap * C = exp (ln N - ln n).
Proof. unfold Rminus. rewrite exp_plus, exp_Ropp, !exp_ln by auto. unfold Definitions.N. field. lra. Qed.

Lemma ln_ac : ln ac = 1/(2*n-1) * (ln B - 2 * ln N).
Proof. unfold Definitions.ac. rewrite ln_Rpower. f_equal. apply (lnBN E w C n); auto. Qed.
Lemma ln_scaled s : 0 < s -> ln (Rpower (s^2 * B / N^2) (1/(2*n-1))) = 1/(2*n-1) * (2 * ln s + ln B - 2 * ln N).
Proof.
  intros Hs. rewrite ln_Rpower. f_equal. replace (s^2*B/N^2) with (s*s*(B/N^2)) by (field; lra).
  pose proof (BN_pos E w C n HE Hw HC Hn). rewrite !ln_mult, lnBN by (auto; nra). ring.
Qed.
Lemma ln_a0 : ln a0 = 1/(2*n-1) * (2 * ln (2*n) + ln B - 2 * ln N).
Proof. unfold Definitions.a0. replace (4*n^2) with ((2*n)^2) by ring. apply ln_scaled. lra. Qed.
Lemma ln_az : ln az = 1/(2*n-1) * (2 * ln (2*(n+1)) + ln B - 2 * ln N).
Proof. unfold Definitions.az. replace (4*(n+1)^2) with ((2*(n+1))^2) by ring. apply ln_scaled. lra. Qed.
Lemma ln_aF : ln aF = 1/(2*n-1) * (2 * ln 3 + ln B - 2 * ln N).
Proof. unfold Definitions.aF. replace 9 with (3^2) by ring. apply ln_scaled. lra. Qed.

Lemma sqrtB : sqrt B = exp (/2 * ln B).
Proof. rewrite <- Rpower_sqrt by auto. reflexivity. Qed.

Lemma dn_exp a : 0 < a -> dn a = exp (ln N - ln n + n * ln a) - exp (ln 2 + /2 * ln B + /2 * ln a).
Proof.
  intros Ha. unfold Definitions.dn. rewrite dl_pow, N_kappa, sqrtB by auto. unfold Rpower. rewrite <- !exp_plus. f_equal.
  replace (ln 2 + /2 * ln B + /2 * ln a) with (ln 2 + (/2 * ln B + /2 * ln a)) by ring.
  rewrite (exp_plus (ln 2)), exp_ln, exp_plus by lra. ring.
Qed.
Lemma Fn_exp a : 0 < a -> Fn a = exp (ln (2*E) + ln N - ln (n+1) + (n+1) * ln a) - exp (ln (4*E) + /2 * ln B + 3/2 * ln a).
Proof.
  intros Ha. unfold Definitions.Fn. rewrite dl_pow, sqrtB by auto.
  replace (n/(n+1)*kap*C) with (exp (ln N - ln (n+1))).
  2:{ unfold Rminus. rewrite exp_plus, exp_Ropp, !exp_ln by lra. unfold Definitions.N. field. lra. }
  unfold Rpower. rewrite Rmult_minus_distr_l. f_equal.
  - replace (ln (2*E) + ln N - ln (n+1) + (n+1) * ln a) with (ln (2*E) + (ln a + (ln N - ln (n+1) + n * ln a))) by ring.
    rewrite (exp_plus (ln (2*E))), (exp_plus (ln a)), !exp_ln, (exp_plus (ln N - ln (n+1))) by lra. ring.
  - replace (ln (4*E) + /2 * ln B + 3/2 * ln a) with (ln (4*E) + (ln a + (/2 * ln B + /2 * ln a))) by field.
    rewrite (exp_plus (ln (4*E))), (exp_plus (ln a)), !exp_ln, (exp_plus (/2 * ln B)) by lra. ring.
Qed.

(** exp (x + (q+p) u) - exp (y + q u) is a valley. *)
Lemma as_valley x y q p u : 0 < p -> exp (x + (q+p)*u) - exp (y + q*u) = valley (exp y) q p ((y - x)/p) u.
Proof.
  intros Hp. unfold valley. rewrite Rmult_minus_distr_l, Rmult_1_r, <- !exp_plus. f_equal. f_equal. field. lra.
Qed.

Lemma ln_quot x y : 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof. apply ln_div. Qed.

Lemma dn_valley : 1/2 < n -> valley_like dn ac.
Proof.
  intros Hh. split. apply ac_pos. set (x := ln N - ln n). set (y := ln 2 + /2 * ln B).
  exists (exp y), (/2), (n - /2), ((y - x)/(n - /2)). repeat split; try lra. apply exp_pos.
  - rewrite ln_ac, ln_quot by lra. replace (/2 + (n - /2)) with n by ring. rewrite ln_Rinv by lra. unfold x, y. field. lra.
  - intros a Ha. rewrite <- as_valley by lra. replace (/2 + (n - /2)) with n by ring. apply dn_exp; auto.
Qed.
Lemma dn_hill : n < 1/2 -> valley_like (fun a => - dn a) ac.
Proof.
  intros Hh. split. apply ac_pos. set (x := ln N - ln n). set (y := ln 2 + /2 * ln B).
  exists (exp x), n, (/2 - n), ((x - y)/(/2 - n)). repeat split; try lra. apply exp_pos.
  - rewrite ln_ac, ln_quot by lra. replace (n + (/2 - n)) with (/2) by ring. rewrite ln_Rinv by lra. unfold x, y. field. lra.
  - intros a Ha. rewrite <- as_valley by lra. replace (n + (/2 - n)) with (/2) by ring. rewrite dn_exp by auto. unfold x, y. ring.
Qed.
Lemma Fn_valley : 1/2 < n -> valley_like Fn aF.
Proof.
  intros Hh. split. apply Rp_pos. set (x := ln (2*E) + ln N - ln (n+1)). set (y := ln (4*E) + /2 * ln B).
  exists (exp y), (3/2), (n - /2), ((y - x)/(n - /2)). repeat split; try lra. apply exp_pos.
  - rewrite ln_aF, ln_quot by lra. replace (3/2 + (n - /2)) with (n+1) by field. unfold x, y.
    rewrite (ln_div 3 2), (ln_mult 2 E), (ln_mult 4 E) by lra. replace (ln 4) with (2 * ln 2).
    field. lra. replace 4 with (2*2) by ring. rewrite ln_mult; lra.
  - intros a Ha. rewrite <- as_valley by lra. replace (3/2 + (n - /2)) with (n+1) by field. apply Fn_exp; auto.
Qed.
Lemma Fn_hill : n < 1/2 -> valley_like (fun a => - Fn a) aF.
Proof.
  intros Hh. split. apply Rp_pos. set (x := ln (2*E) + ln N - ln (n+1)). set (y := ln (4*E) + /2 * ln B).
  exists (exp x), (n+1), (/2 - n), ((x - y)/(/2 - n)). repeat split; try lra. apply exp_pos.
  - rewrite ln_aF, ln_quot by lra. replace (n + 1 + (/2 - n)) with (3/2) by field. unfold x, y.
    rewrite (ln_div 3 2), (ln_mult 2 E), (ln_mult 4 E) by lra. replace (ln 4) with (2 * ln 2).
    field. lra. replace 4 with (2*2) by ring. rewrite ln_mult; lra.
  - intros a Ha. rewrite <- as_valley by lra. replace (n + 1 + (/2 - n)) with (3/2) by field. rewrite Fn_exp by auto. unfold x, y. ring.
Qed.

Lemma negate (f : R -> R) d : (forall a, (0 < a /\ - f a = - d) <-> (0 < a /\ f a = d)) ->
  (none (fun a => 0 < a /\ - f a = - d) <-> none (fun a => 0 < a /\ f a = d)) /\
  (one (fun a => 0 < a /\ - f a = - d) <-> one (fun a => 0 < a /\ f a = d)) /\
  (two (fun a => 0 < a /\ - f a = - d) <-> two (fun a => 0 < a /\ f a = d)).
Proof.
  intros H. unfold none, one, two. split; [|split]; split.
  - intros K x Hx. apply (K x), H, Hx.
  - intros K x Hx. apply (K x), H, Hx.
  - intros [x [Hx Hu]]. exists x. split. apply H, Hx. intros y Hy. apply Hu, H, Hy.
  - intros [x [Hx Hu]]. exists x. split. apply H, Hx. intros y Hy. apply Hu, H, Hy.
  - intros [x [y [L [Hx [Hy Hu]]]]]. exists x, y. split; auto. split. apply H, Hx. split. apply H, Hy. intros z Hz. apply Hu, H, Hz.
  - intros [x [y [L [Hx [Hy Hu]]]]]. exists x, y. split; auto. split. apply H, Hx. split. apply H, Hy. intros z Hz. apply Hu, H, Hz.
Qed.

(** (1.11), n > 1/2, for every indentation: no equilibrium beyond the critical one, d < d_c < 0; two at d_c < d < 0; one at d_c
    and at every d >= 0. *)
Theorem eq_1_11_above d : 1/2 < n ->
  (none (fun a => 0 < a /\ dn a = d) <-> d < dn ac) /\
  (one (fun a => 0 < a /\ dn a = d) <-> d = dn ac \/ 0 <= d) /\
  (two (fun a => 0 < a /\ dn a = d) <-> dn ac < d < 0).
Proof. intros Hh. apply count_iff, dn_valley; auto. Qed.

(** (1.11), n < 1/2: one equilibrium at every d <= 0 and at d_c > 0; two at 0 < d < d_c; none beyond. *)
Theorem eq_1_11_below d : n < 1/2 ->
  (none (fun a => 0 < a /\ dn a = d) <-> dn ac < d) /\
  (one (fun a => 0 < a /\ dn a = d) <-> d = dn ac \/ d <= 0) /\
  (two (fun a => 0 < a /\ dn a = d) <-> 0 < d < dn ac).
Proof.
  intros Hh. destruct (count_iff _ _ (- d) (dn_hill Hh)) as [H0 [H1 H2]].
  destruct (negate dn d) as [N0 [N1 N2]]. intros a; split; intros [? ?]; split; auto; lra.
  rewrite <- N0, <- N1, <- N2, H0, H1, H2. repeat split; intros; lra.
Qed.

(** The same under controlled force, n > 1/2: the smallest force F_F < 0 is the pull-off force. *)
Theorem critical_force_above F : 1/2 < n ->
  (none (fun a => 0 < a /\ Fn a = F) <-> F < Fn aF) /\
  (one (fun a => 0 < a /\ Fn a = F) <-> F = Fn aF \/ 0 <= F) /\
  (two (fun a => 0 < a /\ Fn a = F) <-> Fn aF < F < 0).
Proof. intros Hh. apply count_iff, Fn_valley; auto. Qed.

(** n < 1/2: there is a largest force F_F > 0, above which the contact becomes complete. *)
Theorem critical_force_below F : n < 1/2 ->
  (none (fun a => 0 < a /\ Fn a = F) <-> Fn aF < F) /\
  (one (fun a => 0 < a /\ Fn a = F) <-> F = Fn aF \/ F <= 0) /\
  (two (fun a => 0 < a /\ Fn a = F) <-> 0 < F < Fn aF).
Proof.
  intros Hh. destruct (count_iff _ _ (- F) (Fn_hill Hh)) as [H0 [H1 H2]].
  destruct (negate Fn F) as [N0 [N1 N2]]. intros a; split; intros [? ?]; split; auto; lra.
  rewrite <- N0, <- N1, <- N2, H0, H1, H2. repeat split; intros; lra.
Qed.

(** The state at the instability under controlled force; the force is -(3/2)πwR for the paraboloid (theorem
    [critical_force_paraboloid]). *)
Theorem critical_force : n <> 1/2 ->
  dn aF = (3 - 2*n) / n * sqrt (B * aF) /\
  Fn aF = 2 * (1 - 2*n) / (n+1) * E * sqrt B * Rpower aF (3/2).
Proof.
  intros Hh. assert (Ha : 0 < aF) by apply Rp_pos. pose proof ln_aF as Hl.
  assert (H1 : N * Rpower aF n = 3 * (sqrt B * Rpower aF (/2))).
  { apply ln_inv. pos. pos. rewrite !ln_mult, !ln_Rpower, ln_sqrt, Hl by pos. field. lra. }
  assert (H2 : kap * C * Rpower aF n = N * Rpower aF n / n) by (unfold Definitions.N; field; lra).
  split.
  - unfold Definitions.dn. rewrite H2, H1, dl_pow, sqrt_mult, <- (Rpower_sqrt aF) by lra. field. lra.
  - unfold Definitions.Fn. replace (n/(n+1)*kap*C*Rpower aF n) with (n/(n+1)*(kap*C*Rpower aF n)) by ring.
    rewrite H2, H1, dl_pow by auto. replace (3/2) with (1 + /2) by field. rewrite Rpower_plus, Rpower_1 by auto. field. lra.
Qed.

(** From the slope of the energy to its values. *)
Lemma Un_sign a d : 0 < a ->
  E * ((d - kap * C * Rpower a n)^2 - dl a ^ 2) = E * (dn a - d) * (kap * C * Rpower a n + dl a - d).
Proof. intros Ha. unfold Definitions.dn. ring. Qed.

Lemma Un_mvt a b d : 0 < a -> a < b ->
  exists x, a < x < b /\ Un b d - Un a d = E * (dn x - d) * (kap * C * Rpower x n + dl x - d) * (b - a).
Proof.
  intros Ha Hab. destruct (MVT_cor2 (fun a => Un a d) (fun a => E * ((d - kap * C * Rpower a n)^2 - dl a ^ 2)) a b Hab) as [x [H1 H2]].
  { intros x Hx. apply is_derive_Reals, Un_slope; auto; lra. }
  exists x. split; auto. rewrite <- Un_sign by lra. auto.
Qed.

Lemma dl_positive a : 0 < a -> 0 < dl a.
Proof. intros. apply (dl_pos E w HE Hw); auto. Qed.

Lemma Un_grows a b d : 0 < a -> a < b -> (forall x, a < x < b -> d < dn x) -> Un a d < Un b d.
Proof.
  intros Ha Hab H. destruct (Un_mvt a b d Ha Hab) as [x [Hx He]]. specialize (H x Hx). pose proof (dl_positive x ltac:(lra)).
  assert (0 < kap * C * Rpower x n + dl x - d) by (unfold Definitions.dn in H; lra).
  assert (0 < E * (dn x - d) * (kap * C * Rpower x n + dl x - d) * (b - a)). { repeat apply Rmult_lt_0_compat; lra. } lra.
Qed.
Lemma Un_falls a b d : 0 < a -> a < b -> (forall x, a < x < b -> dn x < d < kap * C * Rpower x n + dl x) -> Un b d < Un a d.
Proof.
  intros Ha Hab H. destruct (Un_mvt a b d Ha Hab) as [x [Hx He]]. specialize (H x Hx).
  assert (0 < E * (d - dn x) * (kap * C * Rpower x n + dl x - d) * (b - a)). { repeat apply Rmult_lt_0_compat; lra. } lra.
Qed.

Lemma g_grows a b : 0 < a -> a < b -> kap * C * Rpower a n < kap * C * Rpower b n.
Proof.
  intros Ha Hab. apply Rmult_lt_compat_l. pos. unfold Rpower. apply exp_increasing. apply Rmult_lt_compat_l; auto.
  apply ln_increasing; auto.
Qed.
Lemma g_positive a : 0 < kap * C * Rpower a n.
Proof. pos. Qed.

(** n > 1/2, d < d_c: the energy grows with the radius from 0 on. Every contact, of whatever radius, breaks. *)
Theorem energy_breaks d : 1/2 < n -> d < dn ac -> forall a b, 0 < a -> a < b -> Un a d < Un b d.
Proof.
  intros Hh Hd a b Ha Hab. apply Un_grows; auto. intros x Hx. apply (level dn ac d x (dn_valley Hh) ltac:(lra)); auto.
Qed.

(** n > 1/2, d_c < d < 0: there is a barrier at a1 and a minimum at a2, and the energy is monotone between and beyond. *)
Theorem energy_barrier d : 1/2 < n -> dn ac < d < 0 -> exists a1 a2, 0 < a1 < ac /\ ac < a2 /\ dn a1 = d /\ dn a2 = d /\
  (forall a b, 0 < a -> a < b -> b <= a1 -> Un a d < Un b d) /\
  (forall a b, a1 <= a -> a < b -> b <= a2 -> Un b d < Un a d) /\
  (forall a b, a2 <= a -> a < b -> Un a d < Un b d).
Proof.
  intros Hh Hd. pose proof (dn_valley Hh) as V. destruct (count dn ac d V) as [_ [_ H]].
  destruct (H Hd) as [a1 [a2 [A1 [A2 [D1 [D2 _]]]]]]. exists a1, a2. repeat split; auto; try lra.
  - intros a b Ha Hab Hb. apply Un_grows; auto. intros x Hx.
    destruct (level dn ac d x V ltac:(lra)) as [_ [L1 _]]. apply (L1 a1 ltac:(lra) D1 ltac:(lra)). lra.
  - intros a b Ha Hab Hb. apply Un_falls; auto. lra. intros x Hx.
    destruct (level dn ac d x V ltac:(lra)) as [_ [L1 L2]]. split.
    + destruct (Rle_dec x ac) as [L|L].
      apply (L1 a1 ltac:(lra) D1 ltac:(lra)); lra. apply (L2 a2 D2 ltac:(lra)); lra.
    + pose proof (g_positive x). pose proof (dl_positive x ltac:(lra)). lra.
  - intros a b Ha Hab. apply Un_grows; auto. lra. intros x Hx.
    destruct (level dn ac d x V ltac:(lra)) as [_ [_ L2]]. apply (L2 a2 D2 ltac:(lra)). lra.
Qed.

(** n < 1/2, d > d_c: from the contact without adhesion on, g(a) = d, the energy falls with the radius without end. Every contact
    becomes complete. *)
Theorem energy_complete d : n < 1/2 -> dn ac < d ->
  forall a b, 0 < a -> d <= kap * C * Rpower a n -> a < b -> Un b d < Un a d.
Proof.
  intros Hh Hd a b Ha Hg Hab. apply Un_falls; auto. intros x Hx. split.
  - pose proof (proj1 (level _ ac (- d) x (dn_hill Hh) ltac:(lra)) ltac:(lra)). simpl in H. lra.
  - pose proof (g_grows a x Ha ltac:(lra)). pose proof (dl_positive x ltac:(lra)). lra.
Qed.

(** n < 1/2, 0 < d < d_c: a minimum at a1 and a barrier at a2, beyond which the energy falls without end. *)
Theorem energy_partial d : n < 1/2 -> 0 < d < dn ac -> exists a1 a2, 0 < a1 < ac /\ ac < a2 /\ dn a1 = d /\ dn a2 = d /\
  (forall a b, 0 < a -> d <= kap * C * Rpower a n -> a < b -> b <= a1 -> Un b d < Un a d) /\
  (forall a b, a1 <= a -> a < b -> b <= a2 -> Un a d < Un b d) /\
  (forall a b, a2 <= a -> a < b -> Un b d < Un a d).
Proof.
  intros Hh Hd. pose proof (dn_hill Hh) as V. destruct (count _ ac (- d) V) as [_ [_ H]].
  destruct (H ltac:(lra)) as [a1 [a2 [A1 [A2 [D1 [D2 _]]]]]]. exists a1, a2. repeat split; auto; try lra.
  - intros a b Ha Hg Hab Hb. apply Un_falls; auto. intros x Hx. split.
    + destruct (level _ ac (- d) x V ltac:(lra)) as [_ [L _]]. specialize (L a1 ltac:(lra) D1 ltac:(lra)). simpl in L. lra.
    + pose proof (g_grows a x Ha ltac:(lra)). pose proof (dl_positive x ltac:(lra)). lra.
  - intros a b Ha Hab Hb. apply Un_grows; auto. lra. intros x Hx.
    destruct (level _ ac (- d) x V ltac:(lra)) as [_ [L1 L2]].
    specialize (L1 a1 ltac:(lra) D1 ltac:(lra)). specialize (L2 a2 D2 ltac:(lra)). simpl in L1, L2.
    destruct (Rle_dec x ac) as [L|L]; lra.
  - intros a b Ha Hab. apply Un_falls; auto. lra. intros x Hx.
    destruct (level _ ac (- d) x V ltac:(lra)) as [_ [_ L2]]. specialize (L2 a2 D2 ltac:(lra)). simpl in L2. split. lra.
    pose proof (g_grows a2 x ltac:(lra) ltac:(lra)). pose proof (dl_positive x ltac:(lra)). pose proof (dl_positive a2 ltac:(lra)).
    unfold Definitions.dn in D2. lra.
Qed.

(** n < 1/2, d <= 0: one equilibrium, unstable: a smaller contact shrinks to nothing, a larger one becomes complete (figure 3). *)
Theorem energy_sharp d : n < 1/2 -> d <= 0 -> exists a1, 0 < a1 /\ dn a1 = d /\
  (forall a b, 0 < a -> a < b -> b <= a1 -> Un a d < Un b d) /\
  (forall a b, a1 <= a -> a < b -> Un b d < Un a d).
Proof.
  intros Hh Hd. pose proof (dn_hill Hh) as V. destruct (count _ ac (- d) V) as [_ [H _]].
  destruct (H ltac:(lra)) as [a1 [[A1 D1] _]]. exists a1.
  destruct V as [Hm [K [q [p [v [HK [Hq [Hp [Hmu Hf]]]]]]]]].
  pose proof (valley_negative K q p v (ln ac) HK Hq Hp Hmu) as Ng. pose proof (valley_grows K q p v (ln ac) HK Hq Hp Hmu) as Gr.
  assert (L : ln ac < ln a1). { apply Rnot_le_lt. intro L. specialize (Ng _ L). rewrite <- Hf in Ng by auto. lra. }
  assert (Sg : forall x, 0 < x -> (x < a1 -> d < dn x) /\ (a1 < x -> dn x < d)).
  { intros x Hx. pose proof (Hf x Hx) as H1. pose proof (Hf a1 A1) as H2. split; intros Hxa.
    - destruct (Rle_dec (ln x) (ln ac)) as [L1|L1]. specialize (Ng _ L1). lra.
      pose proof (Gr (ln x) (ln a1) ltac:(lra) ltac:(apply ln_increasing; auto)). lra.
    - pose proof (Gr (ln a1) (ln x) ltac:(lra) ltac:(apply ln_increasing; auto)). lra. }
  repeat split; auto; try lra.
  - intros a b Ha Hab Hb. apply Un_grows; auto. intros x Hx. apply Sg; lra.
  - intros a b Ha Hab. apply Un_falls; auto. lra. intros x Hx. split. apply Sg; lra.
    pose proof (g_positive x). pose proof (dl_positive x ltac:(lra)). lra.
Qed.
End Equilibria.

(** The paraboloid under controlled force: Johnson, Kendall and Roberts. *)
Theorem critical_force_paraboloid E w R : 0 < E -> 0 < w -> 0 < R ->
  Fn E w (1/(2*R)) 2 (aF E w (1/(2*R)) 2) = - (3/2) * PI * w * R.
Proof.
  intros HE Hw HR. pose proof PI_RGT_0. assert (HC : 0 < 1/(2*R)) by pos.
  destruct (critical_force E w (1/(2*R)) 2 HE Hw HC ltac:(lra) ltac:(lra)) as [_ H1]. rewrite H1.
  assert (H2 : Rpower (aF E w (1/(2*R)) 2) (3/2) = 3 * sqrt (B E w) * R / 2).
  { unfold aF. rewrite Rpower_mult. replace (1/(2*2-1)*(3/2)) with (/2) by field. unfold N. rewrite kappa_2.
    pose proof (B_pos E w HE Hw). rewrite Rpower_sqrt by pos.
    replace (9 * B E w / (2*2*(1/(2*R)))^2) with ((3*R/2)*(3*R/2) * B E w) by (field; lra).
    rewrite sqrt_mult, sqrt_square by (try apply Rlt_le; pos). field. }
  rewrite H2. pose proof (B_pos E w HE Hw). replace (2*(1-2*2)/(2+1)*E*sqrt (B E w)*(3*sqrt (B E w)*R/2))
    with (- 3*E*R*(sqrt (B E w)*sqrt (B E w))) by field.
  rewrite sqrt_sqrt by lra. unfold B. field. lra.
Qed.
