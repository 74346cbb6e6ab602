(** What lies beside the edge of the contact: the second stationary indentation of the energy, d = g + Δl, is excluded, since the surfaces
    would overlap there; and from which side the two curves of (1.7) touch at a fold. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Stability.
Open Scope R_scope.

Section Gap.
Variables E w : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w).
Variable g : R -> R.
Hypothesis Hg : forall x, continuous g x.
Notation dl := (dl E w).

(** The profile by its transform (theorems [eq_1_1_abel_smooth] and [eq_1_1_abel]): f(r) = 2/π ∫ g(r sin t) dt over a quarter turn. *)
Definition profile r := 2/PI * RInt (fun t => g (r * sin t)) 0 (PI/2).
(** How far flat punches of the radii x < a with the depths d - g(x) lift the surface beside the contact, at r > a:
    2/π ∫ (d - g(x))/sqrt (r² - x²) dx from 0 to a, with x = r sin t. *)
Definition lifted a d r := 2/PI * RInt (fun t => d - g (r * sin t)) 0 (asin (a/r)).
(** The gap beside the contact. *)
Definition gap a d r := profile r - d + lifted a d r.

Lemma turned_continuous d r t : continuous (fun t => d - g (r * sin t)) t.
Proof.
  apply (continuous_minus (V := R_NormedModule) (fun _ => d)). apply continuous_const.
  apply (continuous_comp (fun t => r * sin t) g); auto.
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

(** The gap is the integral of what g exceeds d by, between the edge and r: the part inside the contact has gone. *)
Theorem gap_beside a d r : gap a d r = 2/PI * RInt (fun t => g (r * sin t) - d) (asin (a/r)) (PI/2).
Proof.
  pose proof PI_RGT_0 as Hpi. set (u := asin (a/r)). set (h := fun t => d - g (r * sin t)).
  assert (Hi : forall x y, ex_RInt h x y).
  { intros x y. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros; apply turned_continuous. }
  assert (H1 : RInt h 0 (PI/2) = RInt h 0 u + RInt h u (PI/2)).
  { symmetry. apply (RInt_Chasles (V := R_CompleteNormedModule) h 0 u (PI/2)); auto. }
  assert (H2 : RInt (fun t => g (r * sin t)) 0 (PI/2) = PI/2 * d - RInt h 0 (PI/2)).
  { apply is_RInt_unique. replace (PI/2 * d - RInt h 0 (PI/2)) with (minus (scal (PI/2 - 0) d) (RInt h 0 (PI/2)))
      by (unfold minus, plus, opp, scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_ext (fun t => minus d (h t))).
    { intros t _. unfold h, minus, plus, opp; simpl. ring. }
    apply (is_RInt_minus (V := R_NormedModule) (fun _ => d)). apply (is_RInt_const (V := R_NormedModule)).
    apply (RInt_correct (V := R_CompleteNormedModule)). auto. }
  assert (H3 : RInt (fun t => g (r * sin t) - d) u (PI/2) = - RInt h u (PI/2)).
  { apply is_RInt_unique. change (- RInt h u (PI/2)) with (opp (RInt h u (PI/2))).
    apply (is_RInt_ext (fun t => opp (h t))). { intros t _. unfold h, opp; simpl. ring. }
    apply (is_RInt_opp (V := R_NormedModule)). apply (RInt_correct (V := R_CompleteNormedModule)). auto. }
  unfold gap, profile, lifted. fold u h. rewrite H2, H3, H1. field. lra.
Qed.

Lemma gap_sign a d r s : 0 < a -> a < r -> (forall x, a < x < r -> 0 < s * (g x - d)) -> 0 < s * gap a d r.
Proof.
  intros Ha Hr H. pose proof PI_RGT_0 as Hpi. rewrite gap_beside. set (u := asin (a/r)).
  assert (Hq : 0 < a/r < 1). { split. apply Rdiv_lt_0_compat; lra. apply (Rmult_lt_reg_r r). lra. field_simplify; lra. }
  assert (Hs : sin u = a/r) by (apply sin_asin; lra).
  assert (Hu : - (PI/2) <= u <= PI/2) by apply asin_bound.
  assert (U : u < PI/2).
  { destruct (proj2 Hu) as [L|L]; auto. rewrite L, sin_PI2 in Hs. lra. }
  assert (I : 0 < RInt (fun t => s * (g (r * sin t) - d)) u (PI/2)).
  { apply RInt_gt_0; auto.
    - intros t Ht. apply H. assert (S1 : sin u < sin t) by (apply sin_increasing_1; lra).
      assert (S2 : sin t < sin (PI/2)) by (apply sin_increasing_1; lra). rewrite sin_PI2 in S2. rewrite Hs in S1. split.
      + apply (Rmult_lt_compat_l r) in S1; [|lra]. replace (r * (a/r)) with a in S1 by (field; lra). auto.
      + nra.
    - intros t Ht. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) s (fun t => g (r * sin t) - d)).
      apply (continuous_ext (fun t => opp (d - g (r * sin t)))). { intros y. unfold opp; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
      apply (continuous_opp (V := R_NormedModule)). apply turned_continuous. }
  assert (L : RInt (fun t => s * (g (r * sin t) - d)) u (PI/2) = s * RInt (fun t => g (r * sin t) - d) u (PI/2)).
  { apply is_RInt_unique. apply (is_RInt_scal (V := R_NormedModule) (fun t => g (r * sin t) - d) u (PI/2) s).
    apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros t _. apply (continuous_ext (fun t => opp (d - g (r * sin t)))). { intros y. unfold opp; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
    apply (continuous_opp (V := R_NormedModule)). apply turned_continuous. }
  rewrite L in I. assert (0 < 2/PI) by (apply Rdiv_lt_0_compat; lra).
  replace (s * (2/PI * RInt (fun t => g (r * sin t) - d) u (PI/2))) with (2/PI * (s * RInt (fun t => g (r * sin t) - d) u (PI/2))) by ring.
  apply Rmult_lt_0_compat; auto.
Qed.

(** At d = g(a) + Δl(a) the energy is stationary, too, but beside the contact the surfaces overlap: it is no contact. At the equilibrium
    d = g(a) - Δl(a) they are apart. Both hold from the edge up to some distance. *)
Theorem stationary_excluded a : 0 < a ->
  is_derive (fun a' => U E w g a' (g a + dl a)) a 0 /\
  exists e, 0 < e /\ forall r, a < r < a + e -> gap a (g a + dl a) r < 0 /\ 0 < gap a (g a - dl a) r.
Proof.
  intros Ha. pose proof (dl_pos E w HE Hw a Ha) as Hl. split.
  - replace 0 with (E * ((g a + dl a - g a)^2 - dl a ^ 2)) by ring. apply (eq_1_4 E w HE Hw g Hg); auto.
  - destruct (proj1 (filterlim_locally g (g a)) (Hg a) (mkposreal _ Hl)) as [e He]. exists e. split. apply cond_pos.
    intros r Hr. assert (B : forall x, a < x < r -> Rabs (g x - g a) < dl a).
    { intros x Hx. apply (He x). change (Rabs (x - a) < e). apply Rabs_def1; lra. }
    split.
    + assert (0 < -1 * gap a (g a + dl a) r); [|lra]. apply gap_sign; try lra. intros x Hx. specialize (B x Hx). apply Rabs_def2 in B. lra.
    + assert (0 < 1 * gap a (g a - dl a) r); [|lra]. apply gap_sign; try lra. intros x Hx. specialize (B x Hx). apply Rabs_def2 in B. lra.
Qed.
End Gap.

(** Section 5, touching from the inner or from the outer side, for any profile whose g has a derivative: q(a) = sqrt a g'(a) decides. *)
Section Touching.
Variables E w : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w).
Variables g g1 : R -> R.
Notation dl := (dl E w).
Notation q := (fun x => sqrt x * g1 x).
(** All between b and c, where the statements hold; 0 and infinity for the whole profile. *)
Variables b c : R.
Hypotheses (Hb : 0 <= b) (Hg : forall x, b < x < c -> is_derive g x (g1 x)).

Lemma touching a s : b < a < c -> g1 a = sqrt (PI * w / (2 * E * a)) ->
  (forall x y, b < x -> x < y -> y < c -> 0 < s * (q y - q x)) ->
  forall x, b < x < c -> x <> a -> 0 < s * ((g x - (g a - dl a)) - dl x).
Proof.
  intros Ha Hf Hq x Hx Hn. pose proof PI_RGT_0 as Hpi.
  assert (Hs : forall y, 0 < y -> sqrt (PI * w / (2 * E * y)) = sqrt (PI * w / (2 * E)) / sqrt y).
  { intros y Hy. replace (PI * w / (2 * E * y)) with (PI * w / (2 * E) / y) by (field; lra).
    assert (0 < PI * w / (2 * E)) by (apply Rdiv_lt_0_compat; nra). apply sqrt_div; lra. }
  assert (Hd : forall y, b < y < c -> is_derive (fun y => g y - dl y) y ((q y - q a) / sqrt y)).
  { intros y Hy. assert (R1 : 0 < sqrt y) by (apply sqrt_lt_R0; lra). assert (R2 : 0 < sqrt a) by (apply sqrt_lt_R0; lra).
    replace ((sqrt y * g1 y - sqrt a * g1 a) / sqrt y) with (minus (g1 y) (sqrt (PI * w / (2 * E * y)))).
    - apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)); auto. apply dl_derive; lra.
    - unfold minus, plus, opp; simpl. rewrite Hf, !Hs by lra. field. lra. }
  set (h := fun y => g y - dl y). assert (Hx' : h x - h a = g x - (g a - dl a) - dl x) by (unfold h; ring). rewrite <- Hx'.
  destruct (Rtotal_order x a) as [L|[L|L]]. 2: contradiction.
  - destruct (MVT_cor2 h (fun y => (q y - q a) / sqrt y) x a L) as [z [H1 H2]].
    { intros y Hy. apply is_derive_Reals, Hd. lra. }
    specialize (Hq z a ltac:(lra) ltac:(lra) ltac:(lra)). assert (R1 : 0 < / sqrt z) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra).
    replace (s * (h x - h a)) with (s * (q a - q z) * / sqrt z * (a - x)).
    + apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto.
    + replace (h x - h a) with (- (h a - h x)) by ring. rewrite H1. unfold Rdiv. ring.
  - destruct (MVT_cor2 h (fun y => (q y - q a) / sqrt y) a x L) as [z [H1 H2]].
    { intros y Hy. apply is_derive_Reals, Hd. lra. }
    specialize (Hq a z ltac:(lra) ltac:(lra) ltac:(lra)). assert (R1 : 0 < / sqrt z) by (apply Rinv_0_lt_compat, sqrt_lt_R0; lra).
    rewrite H1. replace (s * ((q z - q a) / sqrt z * (x - a))) with (s * (q z - q a) * / sqrt z * (x - a)) by (unfold Rdiv; ring).
    apply Rmult_lt_0_compat; [|lra]. apply Rmult_lt_0_compat; auto.
Qed.

(** Where q grows, the curve g(x) - d of (1.7) touches Δl(x) at the fold from above: there is no equilibrium beside it. *)
Theorem touch_outer a : b < a < c -> g1 a = sqrt (PI * w / (2 * E * a)) ->
  (forall x y, b < x -> x < y -> y < c -> sqrt x * g1 x < sqrt y * g1 y) ->
  let d := g a - dl a in forall x, b < x < c -> x <> a -> dl x < g x - d.
Proof.
  intros Ha Hf Hq d x Hx Hn. assert (0 < 1 * ((g x - (g a - dl a)) - dl x)).
  { apply touching; auto. intros y z Hy Hz Hc. specialize (Hq y z Hy Hz Hc). lra. } unfold d. lra.
Qed.

(** Where q falls, it touches from below. *)
Theorem touch_inner a : b < a < c -> g1 a = sqrt (PI * w / (2 * E * a)) ->
  (forall x y, b < x -> x < y -> y < c -> sqrt y * g1 y < sqrt x * g1 x) ->
  let d := g a - dl a in forall x, b < x < c -> x <> a -> g x - d < dl x.
Proof.
  intros Ha Hf Hq d x Hx Hn. assert (0 < -1 * ((g x - (g a - dl a)) - dl x)).
  { apply touching; auto. intros y z Hy Hz Hc. specialize (Hq y z Hy Hz Hc). lra. } unfold d. lra.
Qed.
End Touching.
