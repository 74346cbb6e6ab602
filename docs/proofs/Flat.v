(** Tips with a flat: (1.1) solves Abel's equation although f' jumps at the rim of the flat, and flat punches press the surface into
    the shape of the tip. The step is squeezed between continuous slopes. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform MDR.Stability MDR.Profiles MDR.Punch MDR.Archimedes MDR.Abel MDR.Improper.
Open Scope R_scope.

Lemma continuous_on_of (u : R -> R) : (forall x, continuous u x) -> continuous_on (fun r => 0 <= r) u.
Proof. intros Hu x _ P HP. destruct (Hu x P HP) as [e He]. exists e. intros y Hy _. auto. Qed.

Lemma continuous_Rabs (u : R -> R) x : continuous u x -> continuous (fun y => Rabs (u y)) x.
Proof. intros Hu. apply (continuous_comp u Rabs); auto. apply continuity_pt_filterlim, Rcontinuity_abs. Qed.

(** Abel's equation for a continuous slope, with f as its integral. *)
Lemma abel_continuous (k : R -> R) r : (forall x, continuous k x) -> 0 < r ->
  is_RInt (fun s => transform k (r * sin s)) 0 (PI/2) (PI/2 * RInt k 0 r).
Proof.
  intros Hk Hr. pose proof PI_RGT_0.
  assert (D : forall x, is_derive (fun x => RInt k 0 x) x (k x)) by (intros; apply RInt_derive; auto).
  assert (E : 2/PI * RInt (fun s => transform k (r * sin s)) 0 (PI/2) = RInt k 0 r).
  { apply (eq_1_1_abel_smooth (fun x => RInt k 0 x) k); auto.
    - rewrite RInt_point. reflexivity.
    - apply continuous_on_of. intros x. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply D.
    - apply continuous_on_of. auto. }
  rewrite <- E. set (J := RInt (fun s => transform k (r * sin s)) 0 (PI/2) : R).
  replace (PI/2 * (2/PI * J)) with J by (field; lra). apply (RInt_correct (V := R_CompleteNormedModule)).
  apply ex_cont. intros s. apply (continuous_comp (fun s => r * sin s) (transform k)).
  - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
  - apply (continuous_mult (K := R_AbsRing) (fun x => x) (inner k)). apply continuous_id. apply inner_continuous; auto.
Qed.

Section Flat.
Variables h g : R -> R.
Variables b r Fr : R.
Notation k := (flat_to b h).
(** The slope of the tip is h beyond the flat of radius b; g is (1.1), f(r) is the integral of the slope. *)
Hypotheses (Hb : 0 < b) (Hr : 0 < r) (Ch : forall x, continuous h x) (Cg : forall x, continuous g x) (G0 : g 0 = 0)
  (Hg : forall x, 0 < x -> is_RInt (fun t => k (x * sin t)) 0 (PI/2) (g x / x)) (HF : is_RInt k 0 r Fr).

(* a continuous slope that differs from k between b and b + e only, and a bound of the difference *)
Let ramp e x := (Rabs ((x - b) / e) - Rabs ((x - b) / e - 1) + 1) / 2.
Let he e x := h x * ramp e x.
Let peak e x := 2 / (1 + ((x - b) / e)^2).

Lemma ramp_continuous e x : continuous (ramp e) x.
Proof.
  unfold ramp. apply (continuous_mult (K := R_AbsRing) (fun x => Rabs ((x - b) / e) - Rabs ((x - b) / e - 1) + 1)).
  2: apply continuous_const. apply (continuous_plus (V := R_NormedModule)). 2: apply continuous_const.
  apply (continuous_minus (V := R_NormedModule) (fun x => Rabs ((x - b) / e))); apply continuous_Rabs;
  apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; auto.
Qed.

Lemma he_continuous e x : continuous (he e) x.
Proof. apply (continuous_mult (K := R_AbsRing) h); auto. apply ramp_continuous. Qed.

Lemma peak_continuous e x : 0 < e -> continuous (peak e) x.
Proof.
  intros. apply (ex_derive_continuous (V := R_NormedModule)). unfold peak. auto_derive.
  apply Rgt_not_eq. pose proof (pow2_ge_0 ((x - b) / e)) as Q. unfold Rdiv in *. nra.
Qed.

Lemma peak_area e : 0 < e -> RInt (peak e) 0 r <= 2 * e * PI.
Proof.
  intros He. rewrite (is_RInt_unique (peak e) 0 r (minus (2 * e * atan ((r - b) / e)) (2 * e * atan ((0 - b) / e)))).
  - pose proof (atan_bound ((r - b) / e)) as A1. pose proof (atan_bound ((0 - b) / e)) as A2.
    change (2 * e * atan ((r - b) / e) - 2 * e * atan ((0 - b) / e) <= 2 * e * PI).
    set (A := atan ((r - b) / e)) in *. set (A' := atan ((0 - b) / e)) in *. clearbody A A'.
    replace (2 * e * A - 2 * e * A') with (2 * e * (A - A')) by ring. apply Rmult_le_compat_l; lra.
  - apply (is_RInt_derive (fun x => 2 * e * atan ((x - b) / e))); intros x _. 2: apply peak_continuous; auto.
    unfold peak. auto_derive; auto. set (y := (x - b) / e). replace ((x + - b) * / e) with y by (unfold y; field; lra).
    assert (Y : 0 < 1 + y^2) by nra. field.  split; lra.
Qed.

Lemma close M e x : 0 < e -> 0 <= x <= r -> (forall x, 0 <= x <= r -> Rabs (h x) <= M) -> Rabs (k x - he e x) <= M * peak e x.
Proof.
  intros He Hx HM. specialize (HM x Hx). pose proof (Rabs_pos (h x)) as Hp.
  assert (Pos : 0 <= peak e x). { apply Rlt_le. unfold peak. apply Rdiv_lt_0_compat. lra. pose proof (pow2_ge_0 ((x - b) / e)). lra. }
  set (y := (x - b) / e). assert (Ey : x = b + e * y) by (unfold y; field; lra).
  unfold flat_to, he, ramp. fold y. destruct Rle_dec.
  - rewrite (Rabs_left1 y), (Rabs_left1 (y - 1)) by nra. replace (0 - h x * ((- y - - (y - 1) + 1) / 2)) with 0 by field.
    rewrite Rabs_R0. nra.
  - assert (0 < y) by nra. rewrite (Rabs_right y) by lra. destruct (Rle_dec y 1).
    + rewrite (Rabs_left1 (y - 1)) by lra. replace (h x - h x * ((y - - (y - 1) + 1) / 2)) with (h x * (1 - y)) by field.
      rewrite Rabs_mult, (Rabs_right (1 - y)) by lra.
      assert (1 <= peak e x). { unfold peak. fold y. apply Rmult_le_reg_r with (1 + y^2). nra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by nra. nra. }
      nra.
    + rewrite (Rabs_right (y - 1)) by lra. replace (h x - h x * ((y - (y - 1) + 1) / 2)) with 0 by field. rewrite Rabs_R0. nra.
Qed.

Lemma inner_ex (u : R -> R) x : (forall x, continuous u x) -> is_RInt (fun t => u (x * sin t)) 0 (PI/2) (inner u x).
Proof. intros. apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_inner; auto. Qed.

Lemma transforms_close M e x : 0 < e -> 0 <= x <= r -> (forall x, 0 <= x <= r -> Rabs (h x) <= M) ->
  Rabs (g x - transform (he e) x) <= M * transform (peak e) x.
Proof.
  intros He Hx HM. pose proof PI_RGT_0. destruct (proj1 Hx) as [Hx0|<-].
  2:{ rewrite G0. unfold transform. rewrite !Rmult_0_l, Rminus_0_r, Rabs_R0. lra. }
  assert (N : norm (minus (g x / x) (inner (he e) x)) <= scal M (inner (peak e) x)).
  { apply (norm_RInt_le (fun t => minus (k (x * sin t)) (he e (x * sin t))) (fun t => scal M (peak e (x * sin t))) 0 (PI/2)). lra.
    - intros t Ht. assert (0 <= sin t) by (apply sin_ge_0; lra). pose proof (SIN_bound t). apply (close M e); auto. nra.
    - apply (is_RInt_minus (V := R_NormedModule)). apply Hg; auto. apply inner_ex, he_continuous.
    - apply (is_RInt_scal (V := R_NormedModule) (fun t => peak e (x * sin t))). apply inner_ex. intros; apply peak_continuous; auto. }
  change (Rabs (g x / x - inner (he e) x) <= M * inner (peak e) x) in N.
  change (transform (he e) x) with (x * inner (he e) x). change (transform (peak e) x) with (x * inner (peak e) x).
  replace (g x - x * inner (he e) x) with (x * (g x / x - inner (he e) x)) by (field; lra).
  rewrite Rabs_mult, Rabs_right by lra. nra.
Qed.

(** Abel's equation for a tip with a flat. *)
Theorem eq_1_1_abel_flat : 2/PI * RInt (fun s => g (r * sin s)) 0 (PI/2) = Fr.
Proof.
  pose proof PI_RGT_0.
  destruct (continuity_ab_maj (fun x => Rabs (h x)) 0 r ltac:(lra)) as [m [Hm _]].
  { intros x _. apply continuity_pt_filterlim. apply continuous_Rabs. apply Ch. }
  set (M := Rabs (h m)). assert (HM : forall x, 0 <= x <= r -> Rabs (h x) <= M) by auto. pose proof (Rabs_pos (h m)) as M0. fold M in M0.
  assert (IG : is_RInt (fun s => g (r * sin s)) 0 (PI/2) (RInt (fun s => g (r * sin s)) 0 (PI/2))).
  { apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_cont. intros s. apply (continuous_comp (fun s => r * sin s) g); auto.
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  set (J := RInt (fun s => g (r * sin s)) 0 (PI/2) : R) in *.
  assert (B : forall e, 0 < e -> Rabs (J - PI/2 * Fr) <= PI * M * (2 * e * PI)).
  { intros e He. pose proof (peak_area e He) as A.
    assert (A0 : forall x, continuous (peak e) x) by (intros; apply peak_continuous; auto).
    assert (N1 : norm (minus J (PI/2 * RInt (he e) 0 r)) <= scal M (PI/2 * RInt (peak e) 0 r)).
    { apply (norm_RInt_le (fun s => minus (g (r * sin s)) (transform (he e) (r * sin s))) (fun s => scal M (transform (peak e) (r * sin s))) 0 (PI/2)). lra.
      - intros s Hs. assert (0 <= sin s) by (apply sin_ge_0; lra). pose proof (SIN_bound s). apply (transforms_close M e); auto. nra.
      - apply (is_RInt_minus (V := R_NormedModule)). auto. apply abel_continuous; auto. apply he_continuous.
      - apply (is_RInt_scal (V := R_NormedModule) (fun s => transform (peak e) (r * sin s))). apply abel_continuous; auto. }
    assert (N2 : norm (minus Fr (RInt (he e) 0 r)) <= scal M (RInt (peak e) 0 r)).
    { apply (norm_RInt_le (fun x => minus (k x) (he e x)) (fun x => scal M (peak e x)) 0 r). lra.
      - intros x Hx. apply (close M e); auto.
      - apply (is_RInt_minus (V := R_NormedModule)). auto. apply (RInt_correct (V := R_CompleteNormedModule)), ex_cont, he_continuous.
      - apply (is_RInt_scal (V := R_NormedModule) (peak e)). apply (RInt_correct (V := R_CompleteNormedModule)), ex_cont. auto. }
    set (H1 := RInt (he e) 0 r : R) in *. set (P1 := RInt (peak e) 0 r : R) in *.
    change (Rabs (J - PI/2 * H1) <= M * (PI/2 * P1)) in N1. change (Rabs (Fr - H1) <= M * P1) in N2.
    replace (J - PI/2 * Fr) with ((J - PI/2 * H1) - PI/2 * (Fr - H1)) by ring.
    eapply Rle_trans. apply Rabs_triang. rewrite Rabs_Ropp, Rabs_mult, (Rabs_right (PI/2)) by lra.
    assert (M * P1 <= M * (2 * e * PI)) by (apply Rmult_le_compat_l; auto). nra. }
  assert (Z : J - PI/2 * Fr = 0).
  { apply Rabs_eq_0. destruct (Rle_lt_or_eq_dec 0 _ (Rabs_pos (J - PI/2 * Fr))) as [L|L]; auto. exfalso.
    set (A := Rabs (J - PI/2 * Fr)) in *. assert (Q : 0 < PI * (M + 1) * (4 * PI)) by nra.
    specialize (B (A / (PI * (M + 1) * (4 * PI)))). assert (0 < A / (PI * (M + 1) * (4 * PI))) as Pe by (apply Rdiv_lt_0_compat; auto).
    specialize (B Pe). replace (PI * M * (2 * (A / (PI * (M + 1) * (4 * PI))) * PI)) with (A / 2 * (M / (M + 1))) in B by (field; lra).
    assert (M / (M + 1) <= 1). { apply Rmult_le_reg_r with (M + 1). lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    nra. }
  replace J with (PI/2 * Fr) by lra. field. lra.
Qed.
End Flat.

(** Together: punches of all radii with g of (1.1) press the surface into the shape of a tip with a flat. *)
Theorem eq_1_1_contact_flat (h g g1 : R -> R) b a d r Fr : 0 < b < a -> 0 < r < a ->
  (forall x, continuous h x) -> (forall x, continuous g x) -> (forall x, 0 <= x <= b -> g x = 0) ->
  (forall x, b < x -> is_derive g x (g1 x)) -> (forall x, b < x -> continuous g1 x) ->
  (forall x, b < x -> is_RInt (fun t => flat_to b h (x * sin t)) 0 (PI/2) (g x / x)) -> is_RInt (flat_to b h) 0 r Fr ->
  exists s, is_RInt_gen (fun x => g1 x * lowered x r) (at_right b) (at_point a) s /\ s + (d - g a) * lowered a r = d - Fr.
Proof.
  intros Hb Hr Ch Cg Hz D1 C1 Hg HF. pose proof PI_RGT_0.
  assert (Hg' : forall x, 0 < x -> is_RInt (fun t => flat_to b h (x * sin t)) 0 (PI/2) (g x / x)).
  { intros x Hx. destruct (Rlt_le_dec b x) as [L|L]; auto. rewrite (Hz x) by lra.
    apply (is_RInt_ext (fun _ => 0)).
    - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (sin_range t Ht). unfold flat_to. destruct Rle_dec as [_|N]; auto.
      exfalso. apply N. nra.
    - replace (0 / x) with (scal (PI/2 - 0) 0) by (unfold scal; simpl; unfold mult; simpl; field; lra).
      apply (is_RInt_const (V := R_NormedModule)). }
  exists (g a - 2/PI * RInt (fun t => g (r * sin t)) 0 (PI/2)). split.
  - apply (eq_1_1_punch_improper g g1 b); auto; lra.
  - rewrite (eq_1_1_abel_flat h g b r Fr) by (auto; try lra; apply Hz; lra). unfold lowered. destruct Rle_dec; [|lra]. ring.
Qed.

Lemma flat_integral (h : R -> R) b r (H : R -> R) : 0 < b -> 0 < r -> (forall x, is_derive H x (h x)) -> (forall x, continuous h x) ->
  is_RInt (flat_to b h) 0 r (H (Rmax b r) - H b).
Proof.
  intros Hb Hr D C. assert (Z : forall u, 0 < u <= b -> is_RInt (flat_to b h) 0 u 0).
  { intros u Hu. apply (is_RInt_ext (fun _ => 0)).
    - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold flat_to. destruct Rle_dec as [_|N]; auto. lra.
    - replace 0 with (scal (u - 0) 0) at 2 by (unfold scal; simpl; unfold mult; simpl; ring). apply (is_RInt_const (V := R_NormedModule)). }
  destruct (Rlt_le_dec b r) as [L|L].
  - rewrite Rmax_right by lra. replace (H r - H b) with (plus 0 (minus (H r) (H b))) by (unfold minus, plus, opp; simpl; ring).
    apply (is_RInt_Chasles (V := R_NormedModule) _ 0 b r). apply Z; lra. apply (is_RInt_ext h).
    + intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold flat_to. destruct Rle_dec as [N|_]; auto. lra.
    + apply (is_RInt_derive H h); auto.
  - rewrite Rmax_left by lra. rewrite Rminus_diag_eq by auto. apply Z. lra.
Qed.

(* sqrt (x² - b²), which is 0 up to b *)
Lemma rim b x : 0 <= x <= b -> sqrt (x^2 - b^2) = 0.
Proof. intros. apply sqrt_neg_0. nra. Qed.

Lemma rim_continuous b x : continuous (fun x => sqrt (x^2 - b^2)) x.
Proof.
  apply (continuous_comp (fun x => x^2 - b^2) sqrt). 2: apply continuous_sqrt.
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

(** The cone with a flat: slope s beyond b, g(x) = s x arccos (b/x). *)
Theorem eq_1_1_contact_cone_with_flat s b a d r : 0 < b < a -> 0 < r < a -> exists S,
  is_RInt_gen (fun x => s * (acos (b/x) + b / sqrt (x^2 - b^2)) * lowered x r) (at_right b) (at_point a) S /\
  S + (d - s * a * acos (b/a)) * lowered a r = d - s * Rmax 0 (r - b).
Proof.
  intros Hb Hr. pose proof PI_RGT_0.
  assert (Q : forall x, b < x -> 0 < sqrt (x^2 - b^2)) by (intros; apply sqrt_lt_R0; nra).
  assert (A : forall x, b < x -> acos (b/x) = atan (sqrt (x^2 - b^2) / b)).
  { intros x Hx. rewrite acos_atan by (apply Rdiv_lt_0_compat; lra). f_equal.
    replace (1 - (b/x)²) with ((x^2 - b^2) / (x*x)) by (unfold Rsqr; field; lra). rewrite sqrt_div, sqrt_square by nra. field. lra. }
  set (g := fun x => s * x * atan (sqrt (x^2 - b^2) / b)).
  assert (Ga : g a = s * a * acos (b/a)) by (unfold g; rewrite A by lra; auto). rewrite <- Ga.
  replace (s * Rmax 0 (r - b)) with (s * Rmax b r - s * b).
  2:{ rewrite <- Rmult_minus_distr_l. f_equal. unfold Rmax. destruct (Rle_dec b r), (Rle_dec 0 (r - b)); lra. }
  apply (eq_1_1_contact_flat (fun _ => s) g _ b a d r); auto.
  - intros x. apply continuous_const.
  - intros x. apply (continuous_mult (K := R_AbsRing) (fun x => s * x)).
    + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
    + apply (continuous_comp (fun x => sqrt (x^2 - b^2) / b) atan).
      * apply (continuous_mult (K := R_AbsRing) (fun x => sqrt (x^2 - b^2)) (fun _ => / b)). apply rim_continuous. apply continuous_const.
      * apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
  - intros x Hx. unfold g. rewrite rim by auto. unfold Rdiv. rewrite Rmult_0_l, atan_0. ring.
  - intros x Hx. specialize (Q x Hx). rewrite A by auto. unfold g. auto_derive.
    + replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. repeat split; auto. nra.
    + replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. pose proof (sqrt_sqrt (x^2 - b^2) ltac:(nra)) as E.
      set (q := sqrt (x^2 - b^2)) in *. assert (N : 1 + q * / b * (q * / b * 1) = x^2 / b^2).
      { replace (1 + q * / b * (q * / b * 1)) with ((b^2 + q * q) / b^2) by (field; lra). rewrite E. f_equal. ring. }
      rewrite N. change (q * / b) with (q / b). field. repeat split; lra.
  - intros x Hx. specialize (Q x Hx). apply (continuous_ext_loc _ (fun x => s * (atan (sqrt (x^2 - b^2) / b) + b / sqrt (x^2 - b^2)))).
    + exists (mkposreal (x - b) ltac:(lra)). intros y Hy. change (Rabs (y - x) < x - b) in Hy. apply Rabs_def2 in Hy. rewrite A by lra. auto.
    + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive.
      replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. repeat split; try nra; lra.
  - intros x Hx. replace (g x / x) with (s * (PI/2) - s * asin (b/x)).
    + apply (flat_inner b (fun _ => s) x (fun t => s * t)). lra. intros t. auto_derive; auto. ring. intros t. apply continuous_const.
    + assert (0 < b/x < 1). { split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with x. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
      unfold g. rewrite <- A, acos_asin by lra. field. lra.
  - apply (flat_integral (fun _ => s) b r (fun x => s * x)); try lra. intros x. auto_derive; auto. ring. intros x. apply continuous_const.
Qed.

(** The paraboloid with a flat: (r² - b²)/2R beyond b, g(x) = (x/R) sqrt (x² - b²). *)
Theorem eq_1_1_contact_paraboloid_with_flat R0 b a d r : 0 < R0 -> 0 < b < a -> 0 < r < a -> exists S,
  is_RInt_gen (fun x => (sqrt (x^2 - b^2) + x^2 / sqrt (x^2 - b^2)) / R0 * lowered x r) (at_right b) (at_point a) S /\
  S + (d - a / R0 * sqrt (a^2 - b^2)) * lowered a r = d - (Rmax b r ^ 2 - b^2) / (2 * R0).
Proof.
  intros HR Hb Hr. pose proof PI_RGT_0.
  assert (Q : forall x, b < x -> 0 < sqrt (x^2 - b^2)) by (intros; apply sqrt_lt_R0; nra).
  set (g := fun x => x / R0 * sqrt (x^2 - b^2)). change (a / R0 * sqrt (a^2 - b^2)) with (g a).
  replace ((Rmax b r ^ 2 - b^2) / (2 * R0)) with (Rmax b r ^ 2 / (2 * R0) - b^2 / (2 * R0)) by (field; lra).
  apply (eq_1_1_contact_flat (fun x => x / R0) g _ b a d r); auto.
  - intros x. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
  - intros x. apply (continuous_mult (K := R_AbsRing) (fun x => x / R0)). 2: apply rim_continuous.
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
  - intros x Hx. unfold g. rewrite rim by auto. ring.
  - intros x Hx. specialize (Q x Hx). unfold g. auto_derive.
    + replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. repeat split; try lra. nra.
    + replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. field. lra.
  - intros x Hx. specialize (Q x Hx). apply (ex_derive_continuous (V := R_NormedModule)). auto_derive.
    replace (x*(x*1) + - (b*(b*1))) with (x^2 - b^2) by ring. repeat split; try nra; lra.
  - intros x Hx. assert (0 < b/x < 1). { split. apply Rdiv_lt_0_compat; lra. apply Rmult_lt_reg_r with x. lra. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    replace (g x / x) with (- (x/R0) * cos (PI/2) - - (x/R0) * cos (asin (b/x))).
    + apply (flat_inner b (fun r => r/R0) x (fun t => - (x/R0) * cos t)). lra. intros t. auto_derive; auto. field. lra.
      intros t. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
    + rewrite cos_PI2, cos_asin by lra. replace (1 - (b/x)²) with ((x^2 - b^2)/(x*x)) by (unfold Rsqr; field; lra).
      rewrite sqrt_div, sqrt_square by nra. unfold g. field. lra.
  - apply (flat_integral (fun x => x / R0) b r (fun x => x^2 / (2 * R0))); try lra.
    + intros x. auto_derive; auto. field. lra.
    + intros x. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
Qed.

(** A tip with a cap: its slope is continuous, and that of g is so beyond the axis. *)
Theorem eq_1_1_contact_capped (f f1 g1 : R -> R) a d r : f 0 = 0 -> (forall x, continuous f x) -> (forall x, continuous f1 x) ->
  (forall x, 0 < x -> is_derive f x (f1 x)) -> (forall x, 0 < x -> is_derive (transform f1) x (g1 x)) ->
  (forall x, 0 < x -> continuous g1 x) -> 0 < r < a ->
  exists s, is_RInt_gen (fun x => g1 x * lowered x r) (at_right 0) (at_point a) s /\ s + (d - transform f1 a) * lowered a r = d - f r.
Proof.
  intros F0 Cf Cf1 Df Dg Cg1 Hr. exists (transform f1 a - 2/PI * RInt (fun t => transform f1 (r * sin t)) 0 (PI/2)). split.
  - apply (eq_1_1_punch_improper (transform f1) g1 0); auto; try lra.
    + intros x. apply (continuous_mult (K := R_AbsRing) (fun x => x) (inner f1)). apply continuous_id. apply inner_continuous; auto.
    + intros x Hx. replace x with 0 by lra. unfold transform. ring.
  - rewrite (eq_1_1_abel_smooth f f1) by (auto; try lra; apply continuous_on_of; auto). unfold lowered. destruct Rle_dec; [|lra]. ring.
Qed.
