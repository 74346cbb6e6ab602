(** Section 4 of the paper: power laws under controlled indentation, (1.13) to (1.17), and the erratum of (1.15). *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Stability.
Open Scope R_scope.

Section PowerLaw.
Variables E w C n : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hn : 0 < n).
Notation kap := (kappa n).
Let Hk : 0 < kap := kappa_pos n Hn.
Notation B := (B E w).
Notation N := (N C n).
Notation dl := (dl E w).
Notation dn := (dn E w C n).
Notation slope := (slope E w C n).
Notation Fn := (Fn E w C n).
Notation Un := (Un E w C n).
Notation ac := (ac E w C n).
Notation ac_printed := (ac_printed E w C n).
Notation a0 := (a0 E w C n).
Let B_pos := B_pos E w HE Hw.
Let dl_B := dl_B E w HE Hw.
Let dl_pow := dl_pow E w HE Hw.
Let dl_sq := dl_sq E w HE Hw.
Let dl_derive := dl_derive E w HE Hw.


Lemma N_pos : 0 < N.
Proof. unfold Definitions.N. pos. Qed.

(** (1.14): its left side less its right side is the slope of the indentation (1.13) along the equilibria. *)
Theorem eq_1_14 a : 0 < a -> is_derive dn a (slope a).
Proof.
  intros Ha. unfold Definitions.dn, Definitions.slope. apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
  - replace (n * kap * C * Rpower a (n-1)) with (kap * C * (n * Rpower a (n-1))) by ring.
    apply (is_derive_scal (fun x => Rpower x n)). apply is_derive_Rpower; auto.
  - apply dl_derive; auto.
Qed.


Lemma BN_pos : 0 < B / N^2.
Proof. pose proof B_pos. pose proof N_pos. apply Rdiv_lt_0_compat; auto. apply pow_lt; auto. Qed.

Lemma lnBN : ln (B / N^2) = ln B - 2 * ln N.
Proof.
  pose proof B_pos. pose proof N_pos. unfold Rdiv.
  rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; try apply pow_lt; auto).
  replace (N^2) with (N*N) by ring. rewrite ln_mult by auto. ring.
Qed.

Lemma exp_half_ln x : 0 < x -> sqrt x = exp (/2 * ln x).
Proof. intros. rewrite <- Rpower_sqrt by auto. reflexivity. Qed.

(* the slope, factored: a positive number times a monotone bracket *)
Lemma slope_factored a : n <> 1/2 -> 0 < a ->
  slope a = sqrt (B / a) * (exp ((n - /2) * (ln a - ln ac)) - 1).
Proof.
  intros Hh Ha. pose proof B_pos. pose proof N_pos. unfold Definitions.slope.
  replace (PI * w / (2 * E * a)) with (B / a) by (unfold Definitions.B; field; lra).
  rewrite Rmult_minus_distr_l, Rmult_1_r. f_equal.
  unfold Definitions.ac. rewrite ln_Rpower, lnBN.
  rewrite exp_half_ln by (apply Rdiv_lt_0_compat; auto).
  rewrite <- exp_plus. fold N. unfold Rpower.
  replace N with (exp (ln N)) at 1 by (apply exp_ln; auto).
  rewrite <- exp_plus. f_equal. unfold Rdiv at 1. rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; auto).
  field. lra.
Qed.

Lemma ac_pos : 0 < ac. Proof. apply Rp_pos. Qed.

Lemma exp_minus1_0 x : exp x - 1 = 0 <-> x = 0.
Proof.
  split; intros H. apply exp_inv. rewrite exp_0. lra. subst. rewrite exp_0. lra.
Qed.

(** (1.14) has exactly one solution, the corrected (1.15). *)
Theorem eq_1_15 a : n <> 1/2 -> 0 < a -> (slope a = 0 <-> a = ac).
Proof.
  intros Hh Ha. pose proof B_pos. rewrite slope_factored by auto.
  assert (0 < sqrt (B / a)) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; auto).
  split; intros H1.
  - apply Rmult_integral in H1. destruct H1 as [H1|H1]. lra. apply (proj1 (exp_minus1_0 _)) in H1.
    apply Rmult_integral in H1. destruct H1 as [H1|H1]. lra.
    apply ln_inv; auto. apply ac_pos. lra.
  - subst. replace (_ * (ln ac - ln ac)) with 0 by ring. rewrite exp_0. ring.
Qed.

(** The printed (1.15) solves (1.14) only where B = N², that is where a_c is the unit of length. *)
Theorem eq_1_15_printed : n <> 1/2 -> (slope ac_printed = 0 <-> B = N^2).
Proof.
  intros Hh. pose proof B_pos as HB. pose proof N_pos as HN.
  rewrite eq_1_15 by (auto; apply Rp_pos).
  assert (HN2 : 0 < N^2) by (apply pow_lt; auto).
  transitivity (ln (B / N^2) = 0).
  - unfold Definitions.ac_printed, Definitions.ac. split; intros K.
    + apply (f_equal ln) in K. rewrite !ln_Rpower in K.
      apply (f_equal (fun x => x * (2*n - 1))) in K.
      replace (1 / (1 - 2*n) * ln (B / N^2) * (2*n - 1)) with (- ln (B / N^2)) in K by (field; lra).
      replace (1 / (2*n - 1) * ln (B / N^2) * (2*n - 1)) with (ln (B / N^2)) in K by (field; lra). lra.
    + unfold Rpower. rewrite K, !Rmult_0_r. auto.
  - split; intros K.
    + rewrite <- ln_1 in K. apply ln_inv in K; [|apply BN_pos|lra].
      replace B with (B / N^2 * N^2) by (field; lra). rewrite K. ring.
    + rewrite K. replace (N^2/N^2) with 1 by (field; lra). apply ln_1.
Qed.

(* strict monotonicity on both sides of a_c; the extremum is global *)
Lemma slope_sign_above a : 1/2 < n -> 0 < a -> (ac < a -> 0 < slope a) /\ (a < ac -> slope a < 0).
Proof.
  intros Hh Ha. pose proof B_pos. pose proof ac_pos. rewrite slope_factored by (auto; lra).
  assert (0 < sqrt (B / a)) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; auto).
  split; intros H2.
  - assert (ln ac < ln a) by (apply ln_increasing; auto).
    assert (1 < exp ((n - /2) * (ln a - ln ac))). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
  - assert (ln a < ln ac) by (apply ln_increasing; auto).
    assert (exp ((n - /2) * (ln a - ln ac)) < 1). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
Qed.

Lemma slope_sign_below a : n < 1/2 -> 0 < a -> (ac < a -> slope a < 0) /\ (a < ac -> 0 < slope a).
Proof.
  intros Hh Ha. pose proof B_pos. pose proof ac_pos. rewrite slope_factored by (auto; lra).
  assert (0 < sqrt (B / a)) by (apply sqrt_lt_R0, Rdiv_lt_0_compat; auto).
  split; intros H2.
  - assert (ln ac < ln a) by (apply ln_increasing; auto).
    assert (exp ((n - /2) * (ln a - ln ac)) < 1). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
  - assert (ln a < ln ac) by (apply ln_increasing; auto).
    assert (1 < exp ((n - /2) * (ln a - ln ac))). { rewrite <- exp_0. apply exp_increasing. nra. } nra.
Qed.

Lemma mvt a b : 0 < a -> a < b -> exists c, dn b - dn a = slope c * (b - a) /\ a < c < b.
Proof.
  intros Ha Hab. apply MVT_cor2; auto.
  intros c Hc. apply is_derive_Reals. apply eq_1_14. lra.
Qed.

(** For n > 1/2 the critical indentation is the smallest of all equilibria: below it there is none. *)
Theorem eq_1_15_minimum a : 1/2 < n -> 0 < a -> a <> ac -> dn ac < dn a.
Proof.
  intros Hh Ha Hne. pose proof ac_pos. destruct (Rtotal_order a ac) as [H1|[H1|H1]]; try lra.
  - destruct (mvt a ac) as [c [Hc Hc']]; auto. destruct (slope_sign_above c) as [_ Hs]; try lra.
    assert (slope c < 0) by (apply Hs; lra). nra.
  - destruct (mvt ac a) as [c [Hc Hc']]; auto. destruct (slope_sign_above c) as [Hs _]; try lra.
    assert (0 < slope c) by (apply Hs; lra). nra.
Qed.

(** For n < 1/2 it is the largest of all equilibria: above it there is none. *)
Theorem eq_1_15_maximum a : n < 1/2 -> 0 < a -> a <> ac -> dn a < dn ac.
Proof.
  intros Hh Ha Hne. pose proof ac_pos. destruct (Rtotal_order a ac) as [H1|[H1|H1]]; try lra.
  - destruct (mvt a ac) as [c [Hc Hc']]; auto. destruct (slope_sign_below c) as [_ Hs]; try lra.
    assert (0 < slope c) by (apply Hs; lra). nra.
  - destruct (mvt ac a) as [c [Hc Hc']]; auto. destruct (slope_sign_below c) as [Hs _]; try lra.
    assert (slope c < 0) by (apply Hs; lra). nra.
Qed.

(* the condition (1.14) at a_c, in the form that simplifies everything: N a_c^n = sqrt(B) a_c^(1/2) *)
Lemma at_critical : n <> 1/2 -> N * Rpower ac n = sqrt B * Rpower ac (/2).
Proof.
  intros Hh. pose proof B_pos. pose proof N_pos.
  rewrite exp_half_ln by auto. unfold Rpower, Definitions.ac. rewrite ln_Rpower, lnBN, <- exp_plus.
  replace N with (exp (ln N)) at 1 by (apply exp_ln; auto). rewrite <- exp_plus. f_equal. field. lra.
Qed.

(** The critical indentation, factored: negative for n > 1/2, positive for n < 1/2. *)
Theorem critical_indentation : n <> 1/2 -> dn ac = (1 - 2*n) / n * sqrt (B * ac).
Proof.
  intros Hh. pose proof B_pos. pose proof ac_pos. pose proof (at_critical Hh) as Hc. unfold Definitions.dn.
  rewrite dl_pow by auto. rewrite sqrt_mult, <- (Rpower_sqrt ac) by lra.
  replace (kap * C * Rpower ac n) with (N * Rpower ac n / n) by (unfold Definitions.N; field; lra).
  rewrite Hc. field. lra.
Qed.

(* (1.16) *)

Lemma sqrt8 a : 0 < a -> sqrt (8 * PI * a^3 * E * w) = 2 * E * a * dl a.
Proof.
  intros Ha. pose proof PI_RGT_0. unfold Definitions.dl.
  replace (8 * PI * a^3 * E * w) with ((2*E*a) * (2*E*a) * (2 * PI * a * w / E)) by (field; lra).
  assert (0 < 2*PI*a*w/E) by (pos).
  rewrite sqrt_mult, sqrt_square by nra. auto.
Qed.

Lemma gap_integral d a : 0 < a ->
  is_RInt (fun x => d - kap * C * Rpower x n) 0 a (d * a - kap * C * (Rpower a (n+1) / (n+1))).
Proof.
  intros Ha.
  replace (d * a) with (scal (a - 0) d) by (unfold scal; simpl; unfold mult; simpl; ring).
  apply (is_RInt_minus (V := R_NormedModule) (fun _ => d)).
  apply (is_RInt_const (V := R_NormedModule)).
  apply (is_RInt_scal (V := R_NormedModule) (fun x => Rpower x n)). apply is_RInt_Rpower; auto.
Qed.

(** (1.16): the force, by its integral (1.6), as it is printed. *)
Theorem eq_1_16 a : 0 < a ->
  2 * E * RInt (fun x => dn a - kap * C * Rpower x n) 0 a
  = 2 * E * (n / (n+1)) * kap * C * Rpower a (n+1) - sqrt (8 * PI * a^3 * E * w).
Proof.
  intros Ha. rewrite (is_RInt_unique _ _ _ _ (gap_integral (dn a) a Ha)). rewrite sqrt8 by auto.
  unfold Definitions.dn. rewrite Rpower_plus, Rpower_1 by auto. field. lra.
Qed.

Lemma force_Fn a : 0 < a -> 2 * E * RInt (fun x => dn a - kap * C * Rpower x n) 0 a = Fn a.
Proof.
  intros Ha. rewrite (is_RInt_unique _ _ _ _ (gap_integral (dn a) a Ha)).
  unfold Definitions.Fn, Definitions.dn. rewrite Rpower_plus, Rpower_1 by auto. field. lra.
Qed.

(** The force at the instability, factored. *)
Theorem eq_1_17_factored : n <> 1/2 -> Fn ac = - (2 * (2*n+1) / (n+1)) * E * sqrt B * Rpower ac (3/2).
Proof.
  intros Hh. pose proof ac_pos. pose proof (at_critical Hh) as Hc. unfold Definitions.Fn. rewrite dl_pow by auto.
  replace (3/2) with (1 + /2) by field. rewrite Rpower_plus, Rpower_1 by auto.
  replace (n / (n+1) * kap * C * Rpower ac n) with (N * Rpower ac n / (n+1)) by (unfold Definitions.N; field; lra).
  rewrite Hc. field. lra.
Qed.

(** It is tensile for every n. *)
Theorem eq_1_17_tensile : n <> 1/2 -> Fn ac < 0.
Proof.
  intros Hh. rewrite eq_1_17_factored by auto.
  pose proof B_pos. assert (0 < 2 * (2*n+1) / (n+1) * E * sqrt B * Rpower ac (3/2)) by (pos). lra.
Qed.

(** (1.17): the force at the corrected critical radius is what is printed, with C for its c (erratum 2). *)
Theorem eq_1_17 : n <> 1/2 ->
  Fn ac = - (2 * (2*n+1) / (n+1)) * Rpower E (- ((n-2)/(1-2*n)))
          * Rpower (PI*w/2) (- ((n+1)/(1-2*n))) * Rpower (1/(n*C*kap)) (- (3/(1-2*n))).
Proof.
  intros Hh. rewrite eq_1_17_factored by auto. rewrite !Rmult_assoc. f_equal.
  pose proof PI_RGT_0. pose proof N_pos. assert (0 < PI * w / 2) by nra.
  assert (HB : ln B = ln (PI*w/2) - ln E).
  { unfold Definitions.B. replace (PI*w/(2*E)) with (PI*w/2 * / E) by (field; lra).
    rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; auto). ring. }
  assert (HN : ln (1/(n*(C*kap))) = - ln N).
  { replace (1/(n*(C*kap))) with (/ N) by (unfold Definitions.N; field; lra). apply ln_Rinv; auto. }
  rewrite exp_half_ln by apply B_pos. unfold Rpower at 1. unfold Definitions.ac. rewrite ln_Rpower, lnBN.
  unfold Rpower. rewrite HN. replace E with (exp (ln E)) at 1 by (apply exp_ln; auto).
  rewrite <- !exp_plus. f_equal. rewrite HB. field. lra.
Qed.

(* the energy at fixed indentation, of the power law *)

Lemma square_integral d a : 0 < a ->
  is_RInt (fun x => (d - kap * C * Rpower x n)^2) 0 a
    (d^2 * a - 2 * d * kap * C * (Rpower a (n+1) / (n+1)) + (kap*C)^2 * (Rpower a (2*n+1) / (2*n+1))).
Proof.
  intros Ha.
  apply (is_RInt_ext (fun x => (d^2 - 2 * d * kap * C * Rpower x n) + (kap*C)^2 * Rpower x (2*n))).
  { intros x _. replace (2*n) with (n+n) by ring. rewrite Rpower_plus.
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  apply (is_RInt_plus (V := R_NormedModule) (fun x => d^2 - 2 * d * kap * C * Rpower x n)).
  - replace (d^2 * a) with (scal (a - 0) (d^2)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_minus (V := R_NormedModule) (fun _ => d^2)).
    apply (is_RInt_const (V := R_NormedModule)).
    apply (is_RInt_scal (V := R_NormedModule) (fun x => Rpower x n)). apply is_RInt_Rpower; auto.
  - apply (is_RInt_scal (V := R_NormedModule) (fun x => Rpower x (2*n))). apply is_RInt_Rpower; lra.
Qed.

(** The energy of the critical state. The broken contact has none, so for n > 1/2 this is what is lost at pull-off. *)
Theorem work_pull_off : n <> 1/2 ->
  Un ac (dn ac) = n * (2*n-1) / ((n+1) * (2*n+1)) * (PI * ac^2 * w).
Proof.
  intros Hh. pose proof ac_pos as Ha. pose proof (at_critical Hh) as Hc. pose proof B_pos.
  unfold Definitions.Un. rewrite (is_RInt_unique _ _ _ _ (square_integral (dn ac) ac Ha)).
  replace (2*n+1) with (n+n+1) at 1 by ring. rewrite !Rpower_plus, !Rpower_1 by auto.
  set (p := Rpower ac n) in *.
  assert (Hs : (N * p)^2 = B * ac).
  { rewrite Hc.
    replace ((sqrt B * Rpower ac (/2))^2) with ((sqrt B * sqrt B) * (Rpower ac (/2) * Rpower ac (/2))) by ring.
    rewrite sqrt_sqrt, <- Rpower_plus by lra. replace (/2+/2) with 1 by field. rewrite Rpower_1 by auto. auto. }
  assert (Hd : dn ac = (1 - 2*n) / n * (N * p)).
  { rewrite critical_indentation by auto. rewrite Hc, sqrt_mult, <- (Rpower_sqrt ac) by lra. auto. }
  rewrite Hd.
  replace (PI * ac^2 * w) with (2 * E * (B * ac) * ac) by (unfold Definitions.B; field; lra).
  rewrite <- Hs. unfold Definitions.N. field. lra.
Qed.

(* Equilibrium at d = 0, and the energy lost at jump-in. *)

Lemma at_zero : n <> 1/2 -> N * Rpower a0 n = 2 * n * (sqrt B * Rpower a0 (/2)).
Proof.
  intros Hh. pose proof B_pos. pose proof N_pos.
  replace (2 * n) with (exp (ln (2*n))) by (apply exp_ln; lra).
  assert (H1 : ln (4 * n^2 * B / N^2) = 2 * ln (2*n) + ln (B / N^2)).
  { replace (4*n^2*B/N^2) with ((2*n)*(2*n)*(B/N^2)) by (field; lra).
    pose proof BN_pos. rewrite !ln_mult by nra. ring. }
  rewrite exp_half_ln by auto. unfold Rpower, Definitions.a0. rewrite ln_Rpower, H1, lnBN.
  replace N with (exp (ln N)) at 1 by (apply exp_ln; auto). rewrite <- !exp_plus. f_equal. field. lra.
Qed.

Lemma equilibrium_at_zero : n <> 1/2 -> dn a0 = 0.
Proof.
  intros Hh. unfold Definitions.dn. rewrite dl_pow by apply Rp_pos.
  replace (kap * C * Rpower a0 n) with (N * Rpower a0 n / n) by (unfold Definitions.N; field; lra).
  rewrite at_zero by auto. field. lra.
Qed.

(** The energy of the equilibrium at d = 0, from the energy 0 of no contact: for n > 1/2 it is lost at jump-in. *)
Theorem work_jump_in : n <> 1/2 -> Un a0 0 = - ((2*n-1) / (2*n+1)) * (PI * a0^2 * w).
Proof.
  intros Hh. assert (Ha : 0 < a0) by apply Rp_pos. pose proof (at_zero Hh) as Hc. pose proof B_pos.
  unfold Definitions.Un. rewrite (is_RInt_unique _ _ _ _ (square_integral 0 a0 Ha)).
  replace (2*n+1) with (n+n+1) at 1 by ring. rewrite !Rpower_plus, !Rpower_1 by auto.
  set (p := Rpower a0 n) in *.
  assert (Hs : (N * p)^2 = 4 * n^2 * (B * a0)).
  { rewrite Hc.
    replace ((2 * n * (sqrt B * Rpower a0 (/2)))^2)
      with (4 * n^2 * ((sqrt B * sqrt B) * (Rpower a0 (/2) * Rpower a0 (/2)))) by ring.
    rewrite sqrt_sqrt, <- Rpower_plus by lra. replace (/2+/2) with 1 by field. rewrite Rpower_1 by auto. auto. }
  replace (PI * a0^2 * w) with (2 * E * a0 * (B * a0)) by (unfold Definitions.B; field; lra).
  replace (B * a0) with ((N*p)^2 / (4*n^2)) by (rewrite Hs; field; lra). unfold Definitions.N. field. lra.
Qed.

(** What is lost is positive, at pull-off and at jump-in. *)
Theorem work_positive : 1/2 < n -> 0 < Un ac (dn ac) /\ Un a0 0 < 0.
Proof.
  intros Hh. pose proof PI_RGT_0. rewrite work_pull_off, work_jump_in by lra.
  assert (0 < ac) by apply ac_pos. assert (0 < a0) by apply Rp_pos.
  assert (0 < PI * ac^2 * w) by pos. assert (0 < PI * a0^2 * w) by pos.
  assert (0 < n * (2*n-1) / ((n+1) * (2*n+1))) by pos. assert (0 < (2*n-1) / (2*n+1)) by pos.
  split; nra.
Qed.

(** The whole family of power laws in two curves: with t = a/a_c, d/d_c and F/F_c depend on n and t alone. *)
Theorem universal_curves t : n <> 1/2 -> 0 < t ->
  dn (t * ac) = dn ac * (Rpower t n - 2 * n * sqrt t) / (1 - 2*n) /\
  Fn (t * ac) = - Fn ac * (Rpower t (n+1) - 2 * (n+1) * (t * sqrt t)) / (2*n + 1).
Proof.
  intros Hh Ht. pose proof ac_pos as Ha. pose proof (at_critical Hh) as Hc. pose proof B_pos as HB.
  assert (Hta : 0 < t * ac) by pos.
  assert (H1 : kap * C * Rpower (t * ac) n = Rpower t n * (sqrt B * Rpower ac (/2)) / n).
  { rewrite <- Rpower_mult_distr, <- Hc by auto. unfold Definitions.N. field. lra. }
  assert (H2 : dl (t * ac) = 2 * sqrt B * (sqrt t * Rpower ac (/2))).
  { rewrite dl_pow, <- Rpower_mult_distr, (Rpower_sqrt t) by auto. ring. }
  split.
  - rewrite critical_indentation by auto. rewrite sqrt_mult, <- (Rpower_sqrt ac) by lra.
    unfold Definitions.dn. rewrite H1, H2. field. lra.
  - rewrite eq_1_17_factored by auto. unfold Definitions.Fn.
    replace (n/(n+1)*kap*C*Rpower (t*ac) n) with (n/(n+1)*(kap*C*Rpower (t*ac) n)) by ring. rewrite H1, H2.
    replace (3/2) with (1 + /2) by field. rewrite !Rpower_plus, !Rpower_1 by auto. field. lra.
Qed.

(** The slope of the force along the equilibria of a power law. *)
Lemma Fn_derive a : 0 < a -> is_derive Fn a (2 * E * (a * slope a - dl a)).
Proof.
  intros Ha. pose proof (eq_1_14 a Ha) as H.
  apply (is_derive_ext_loc (fun a => 2 * E * (a * dn a) - 2 * E * (kap * C) * (Rpower a (n+1) / (n+1)))).
  { exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy.
    unfold Definitions.Fn, Definitions.dn. rewrite Rpower_plus, Rpower_1 by lra.
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. lra. }
  replace (2 * E * (a * slope a - dl a))
    with (minus (2 * E * (1 * dn a + a * slope a)) (2 * E * (kap * C) * (/ (n+1) * ((n+1) * Rpower a (n+1-1))))).
  2:{ replace (n+1-1) with n by ring. unfold Definitions.dn, minus, plus, opp; simpl. field. lra. }
  apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
  - apply (is_derive_scal (fun a => a * dn a)). apply (is_derive_mult (fun a => a) dn); auto.
    apply (is_derive_id (K := R_AbsRing)). intros; apply Rmult_comm.
  - apply (is_derive_scal (fun a => Rpower a (n+1) / (n+1))).
    apply (is_derive_ext (fun a => / (n+1) * Rpower a (n+1))). intros; apply Rmult_comm.
    apply (is_derive_scal (fun a => Rpower a (n+1))). apply is_derive_Rpower; auto.
Qed.

Lemma Un_local a d : 0 < a -> locally a (fun a => U E w (fun x => kap * C * pw n x) a d = Un a d).
Proof.
  intros Ha. exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy.
  unfold U, Definitions.Un. do 2 f_equal. apply RInt_ext. intros x Hx. rewrite Rmin_left in Hx by lra.
  rewrite pw_pos by lra. auto.
Qed.

Lemma g_continuous x : continuous (fun x => kap * C * pw n x) x.
Proof. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule)). apply continuous_pw; auto. Qed.

Lemma Un_slope a d : 0 < a -> is_derive (fun a => Un a d) a (E * ((d - kap * C * Rpower a n)^2 - dl a ^ 2)).
Proof.
  intros Ha. apply (is_derive_ext_loc (fun a => U E w (fun x => kap * C * pw n x) a d)). apply Un_local; auto.
  rewrite <- (pw_pos n a) by auto. apply (eq_1_4 E w HE Hw (fun x => kap * C * pw n x) g_continuous a d Ha).
Qed.

(** (1.13): for a power law, the rule of Heß is d = κ_n C a^n - Δl(a). *)
Theorem eq_1_13 a d : 0 < a -> d < kap * C * Rpower a n -> (is_derive (fun a => Un a d) a 0 <-> d = dn a).
Proof.
  intros Ha Hd. pose proof (eq_1_5 E w HE Hw (fun x => kap * C * pw n x) g_continuous a d Ha) as R. simpl in R.
  rewrite (pw_pos n a) in R by auto. specialize (R Hd). pose proof (Un_local a d Ha) as Hloc. split; intros K.
  - apply R. revert K. apply is_derive_ext_loc. revert Hloc. apply filter_imp. auto.
  - apply R in K. revert K. apply is_derive_ext_loc. auto.
Qed.

End PowerLaw.

(** Erratum 1: (1.15) as printed does not solve (1.14), for no exponent n. *)
Theorem erratum_1_15 n : 0 < n -> n <> 1/2 ->
  ~ (forall E w C, 0 < E -> 0 < w -> 0 < C -> slope E w C n (ac_printed E w C n) = 0).
Proof.
  intros Hn Hh H. pose proof PI_RGT_0. pose proof (kappa_pos n Hn) as Hk.
  assert (0 < n * kappa n) by (apply Rmult_lt_0_compat; auto). assert (0 < (n * kappa n)^2) by (apply pow_lt; auto).
  assert (Hw : 0 < 4 * (n * kappa n)^2 / PI) by (apply Rdiv_lt_0_compat; lra).
  specialize (H 1 _ 1 ltac:(lra) Hw ltac:(lra)).
  apply eq_1_15_printed in H; try lra. unfold B, N in H.
  replace (PI * (4 * (n * kappa n)^2 / PI) / (2*1)) with (2 * (n * kappa n)^2) in H by (field; lra). lra.
Qed.
