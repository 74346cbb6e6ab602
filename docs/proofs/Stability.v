(** Sections 1 and 2 of the paper for any profile with a continuous MDR transform g: from the energy of the foundation to the
    rule of Heß (1.4), (1.5), the force (1.6), equilibrium and its stability (1.7) to (1.10). *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers.
Open Scope R_scope.

Section Elongation.
Variables E w : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w).
Notation dl := (dl E w).
Notation B := (B E w).

Lemma B_pos : 0 < B.
Proof. pose proof PI_RGT_0. unfold Definitions.B. apply Rdiv_lt_0_compat; nra. Qed.

Lemma dl_B a : 0 < a -> dl a = 2 * sqrt (B * a).
Proof.
  intros Ha. unfold Definitions.dl. replace (2 * PI * a * w / E) with (2 * 2 * (B * a)) by (unfold Definitions.B; field; lra).
  pose proof B_pos. rewrite sqrt_mult, sqrt_square by nra. auto.
Qed.

Lemma dl_pow a : 0 < a -> dl a = 2 * sqrt B * Rpower a (/2).
Proof.
  intros Ha. pose proof B_pos. rewrite dl_B, sqrt_mult, Rpower_sqrt by (auto; lra). ring.
Qed.

Lemma dl_sq a : 0 < a -> dl a * dl a = 4 * B * a.
Proof.
  intros Ha. pose proof B_pos. rewrite dl_B by auto.
  replace (2 * sqrt (B*a) * (2 * sqrt (B*a))) with (4 * (sqrt (B*a) * sqrt (B*a))) by ring.
  rewrite sqrt_sqrt by nra. ring.
Qed.

(* (1.10), second half, and (1.14) *)
Lemma dl_derive a : 0 < a -> is_derive dl a (sqrt (PI * w / (2 * E * a))).
Proof.
  intros Ha. pose proof PI_RGT_0. unfold Definitions.dl. auto_derive.
  { pos. }
  replace (PI * w / (2 * E * a)) with (B / a) by (unfold Definitions.B; field; lra).
  change (2 * PI * 1 * w * / E * / (2 * dl a) = sqrt (B / a)).
  pose proof B_pos. rewrite dl_B, sqrt_mult, sqrt_div by (auto; lra).
  assert (0 < sqrt B) by (apply sqrt_lt_R0; auto).
  assert (0 < sqrt a) by (apply sqrt_lt_R0; auto).
  replace (2 * PI * 1 * w * / E) with (4 * B) by (unfold Definitions.B; field; lra).
  replace (4 * B) with (4 * (sqrt B * sqrt B)) by (rewrite sqrt_sqrt; lra).
  field; lra.
Qed.

End Elongation.

Section AnyProfile.
Variables E w : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w).
Variable g : R -> R.
Hypothesis Hg : forall x, continuous g x.

Notation dl := (dl E w).
Notation B := (B E w).
Notation U := (U E w g).
Notation F := (F E g).

Lemma cont_sq d x : continuous (fun x => (d - g x)^2) x.
Proof.
  apply (continuous_ext (fun x => (d - g x) * (d - g x))). intros; simpl; 
    match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring.
  assert (continuous (fun x => d - g x) x).
  { apply (continuous_minus (V := R_NormedModule)). apply continuous_const. apply Hg. }
  apply (continuous_mult (K := R_AbsRing)); auto.
Qed.

Lemma RInt_derive (f : R -> R) (a : R) : (forall x : R, continuous f x) -> is_derive (fun a => RInt f 0 a) a (f a).
Proof.
  intros Hf. apply (is_derive_RInt (V := R_NormedModule) f _ 0 a); auto.
  exists (mkposreal 1 Rlt_0_1). intros y _. apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros; apply Hf.
Qed.

(** (1.4): at fixed indentation the energy has this slope, for every radius and every indentation. *)
Theorem eq_1_4 a d : 0 < a -> is_derive (fun a => U a d) a (E * ((d - g a)^2 - dl a ^ 2)).
Proof.
  intros Ha. unfold Definitions.U.
  replace (E * ((d - g a)^2 - dl a ^ 2)) with (E * (d - g a)^2 - 2 * PI * a * w).
  - apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
    + apply (is_derive_scal (fun a => RInt (fun x => (d - g x)^2) 0 a)). apply RInt_derive. apply cont_sq.
    + auto_derive; auto; ring.
  - pose proof (dl_sq E w HE Hw a Ha) as H. replace (dl a ^ 2) with (dl a * dl a) by ring. rewrite H.
    unfold Definitions.B. field. lra.
Qed.

Lemma dl_pos a : 0 < a -> 0 < dl a.
Proof. intros Ha. unfold Definitions.dl. pos. Qed.

Lemma slope_unique (f : R -> R) x s t : is_derive f x s -> is_derive f x t -> s = t.
Proof. intros H1 H2. rewrite <- (is_derive_unique f x s H1). apply is_derive_unique; auto. Qed.

(** (1.5), the rule of Heß: where the outer spring is stretched, the energy is stationary at exactly one indentation. *)
Theorem eq_1_5 a d : 0 < a -> d < g a -> (is_derive (fun a => U a d) a 0 <-> d = g a - dl a).
Proof.
  intros Ha Hd. pose proof (dl_pos a Ha) as Hl. pose proof (eq_1_4 a d Ha) as Hs. split; intros H1.
  - apply (slope_unique _ _ _ _ Hs) in H1. assert ((g a - d - dl a) * (g a - d + dl a) = 0).
    { apply Rmult_eq_reg_l with E; [|lra]. rewrite Rmult_0_r, <- H1. ring. }
    apply Rmult_integral in H. destruct H; lra.
  - replace 0 with (E * ((d - g a)^2 - dl a ^ 2)); auto. rewrite H1. ring.
Qed.

(** (1.7): equilibrium is where the curves g(a) - d and Δl(a) intersect. *)
Theorem eq_1_7 a d : 0 < a -> d < g a -> (is_derive (fun a => U a d) a 0 <-> g a - d = dl a).
Proof. intros Ha Hd. rewrite eq_1_5 by auto. split; lra. Qed.

(** (1.8): where g(a) - d exceeds Δl(a) the energy grows with the radius: the contact shrinks. *)
Theorem eq_1_8 a d : 0 < a -> g a - d > dl a -> exists s, is_derive (fun a => U a d) a s /\ 0 < s.
Proof.
  intros Ha H. pose proof (dl_pos a Ha). exists (E * ((d - g a)^2 - dl a ^ 2)). split. apply eq_1_4; auto.
  apply Rmult_lt_0_compat; auto. nra.
Qed.

(** (1.9): where the elongation is less than Δl(a), in tension or compression, the energy falls with the radius: the contact
    grows. *)
Theorem eq_1_9 a d : 0 < a -> Rabs (g a - d) < dl a -> exists s, is_derive (fun a => U a d) a s /\ s < 0.
Proof.
  intros Ha H. apply Rabs_def2 in H. pose proof (dl_pos a Ha). exists (E * ((d - g a)^2 - dl a ^ 2)). split.
  apply eq_1_4; auto. assert (0 < dl a ^2 - (d - g a)^2) by nra. nra.
Qed.

(** The energy, expanded. *)
Lemma U_expanded a d : 
  U a d = E * (a * d^2 - 2 * d * RInt g 0 a + RInt (fun x => (g x)^2) 0 a) - PI * a^2 * w.
Proof.
  unfold Definitions.U. f_equal. f_equal. apply is_RInt_unique.
  apply (is_RInt_ext (fun x => (d^2 - 2 * d * g x) + (g x)^2)).
  { intros x _. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  apply (is_RInt_plus (V := R_NormedModule) (fun x => d^2 - 2 * d * g x)).
  - apply (is_RInt_minus (V := R_NormedModule) (fun _ => d^2)).
    + replace (a * d^2) with (scal (a - 0) (d^2)) by (unfold scal; simpl; unfold mult; simpl; ring).
      apply (is_RInt_const (V := R_NormedModule)).
    + apply (is_RInt_scal (V := R_NormedModule) g). apply (RInt_correct (V := R_CompleteNormedModule)).
      apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto.
  - apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
    intros x _. apply (continuous_ext (fun x => g x * g x)).
    intros; match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring.
    apply (continuous_mult (K := R_AbsRing)); auto.
Qed.

(** (1.6): the force is the slope of the energy over the indentation. *)
Theorem eq_1_6 a d : is_derive (fun d => U a d) d (F a d).
Proof.
  apply (is_derive_ext (fun d => E * (a * d^2 - 2 * d * RInt g 0 a + RInt (fun x => (g x)^2) 0 a) - PI * a^2 * w)).
  { intros; symmetry; apply U_expanded. }
  replace (F a d) with (E * (2 * a * d - 2 * RInt g 0 a)).
  { set (G := RInt g 0 a). set (Q := RInt _ 0 a). auto_derive. auto. ring. }
  unfold Definitions.F. replace (RInt (fun x => d - g x) 0 a) with (d * a - RInt g 0 a). ring.
  symmetry. apply is_RInt_unique. 
  replace (d * a) with (scal (a - 0) d) by (unfold scal; simpl; unfold mult; simpl; ring).
  apply (is_RInt_minus (V := R_NormedModule) (fun _ => d)).
  apply (is_RInt_const (V := R_NormedModule)).
  apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto.
Qed.

Lemma curvature a d g1 : 0 < a -> is_derive g a g1 -> d = g a - dl a ->
  is_derive (fun a => E * ((d - g a)^2 - dl a ^ 2)) a (2 * E * dl a * (g1 - sqrt (PI * w / (2 * E * a)))).
Proof.
  intros Ha H Hd. pose proof (dl_derive E w HE Hw a Ha) as H1.
  set (s := sqrt _) in *.
  assert (H2 : is_derive (fun a => d - g a) a (- g1)).
  { replace (- g1) with (minus 0 g1) by (unfold minus, plus, opp; simpl; ring).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)). apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule)). auto. }
  replace (2 * E * dl a * (g1 - s)) with (E * (minus (INR 2 * (- g1) * (d - g a) ^ pred 2) (INR 2 * s * dl a ^ pred 2))).
  - apply (is_derive_scal (fun a => (d - g a)^2 - dl a ^2)).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
    apply (is_derive_pow (fun a => d - g a)); auto.
    apply (is_derive_pow dl); auto.
  - subst d. unfold minus, plus, opp; simpl. ring.
Qed.

(** (1.10): the slope of Δl is sqrt (πw/2Ea), and the second derivative of the energy in an equilibrium is 2EΔl times the
    slope of g less that of Δl: positive, so stable, where g is the steeper curve; zero where the curves touch. *)
Theorem eq_1_10 a d g1 : 0 < a -> is_derive g a g1 -> d = g a - dl a ->
  is_derive dl a (sqrt (PI * w / (2 * E * a))) /\
  is_derive (fun a => Derive (fun a => U a d) a) a (2 * E * dl a * (g1 - sqrt (PI * w / (2 * E * a)))) /\
  0 < 2 * E * dl a.
Proof.
  intros Ha H Hd. split; [|split]. apply dl_derive; auto.
  2:{ pose proof (dl_pos a Ha). repeat apply Rmult_lt_0_compat; lra. }
  apply (is_derive_ext_loc (fun a => E * ((d - g a)^2 - dl a ^ 2))). 2: apply curvature; auto.
  exists (mkposreal a Ha). intros y Hy. change (Rabs (y - a) < a) in Hy. apply Rabs_def2 in Hy.
  symmetry. apply is_derive_unique, eq_1_4. lra.
Qed.

(** The slope of the force along the equilibria d = g(a) - Δl(a): 2E (a d'(a) - Δl(a)). *)
Theorem eq_1_6_slope a g1 : 0 < a -> is_derive g a g1 ->
  is_derive (fun a => F a (g a - dl a)) a (2 * E * (a * (g1 - sqrt (PI * w / (2 * E * a))) - dl a)).
Proof.
  intros Ha H. pose proof (dl_derive E w HE Hw a Ha) as Hl. set (s := sqrt _) in *.
  apply (is_derive_ext (fun a => 2 * E * (a * (g a - dl a) - RInt g 0 a))).
  { intros t. unfold Definitions.F. f_equal. symmetry. apply is_RInt_unique.
    replace (t * (g t - dl t)) with (scal (t - 0) (g t - dl t)) by (unfold scal; simpl; unfold mult; simpl; ring).
    apply (is_RInt_minus (V := R_NormedModule) (fun _ => g t - dl t)).
    apply (is_RInt_const (V := R_NormedModule)).
    apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto. }
  apply (is_derive_scal (fun a => a * (g a - dl a) - RInt g 0 a)).
  replace (a * (g1 - s) - dl a) with (minus (1 * (g a - dl a) + a * (g1 - s)) (g a))
    by (unfold minus, plus, opp; simpl; ring).
  apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)). 2: apply RInt_derive; auto.
  apply (is_derive_mult (fun a => a) (fun a => g a - dl a)). apply (is_derive_id (K := R_AbsRing)).
  apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)); auto. intros; apply Rmult_comm.
Qed.
End AnyProfile.

(** (1.4) once more by Irwin: a pressure that is -EΔ/(π sqrt (a² - r²)) and a bounded part has at the edge of the contact the
    stress intensity K = EΔ/sqrt (πa), and K²/(2E) is the work of adhesion exactly if Δ = Δl(a). The part needs to be bounded near the edge
    only, from some radius b on: sharp tips press without bound in the middle. *)
Theorem eq_1_4_irwin E w a b D (q : R -> R) M : 0 < E -> 0 < w -> 0 < a -> b < a -> 0 <= D -> (forall r, b < r < a -> Rabs (q r) <= M) ->
  let K := E * D / sqrt (PI * a) in
  filterlim (fun r => sqrt (2 * PI * (a - r)) * (E * D / (PI * sqrt (a^2 - r^2)) + q r)) (at_left a) (locally K) /\
  (K^2 / (2 * E) = w <-> D = dl E w a).
Proof.
  intros HE Hw Ha Hb HD Hq K. pose proof PI_RGT_0 as Hpi. split.
  - set (h := fun r => E * D / PI * sqrt (2 * PI / (a + r))).
    assert (HK : h a = K).
    { unfold h, K. replace (2 * PI / (a + a)) with (PI / a) by (field; lra).
      rewrite sqrt_div, sqrt_mult by lra. pose proof (sqrt_lt_R0 a Ha). pose proof (sqrt_lt_R0 PI Hpi).
      pose proof (sqrt_sqrt PI ltac:(lra)) as H1. rewrite <- H1 at 1. field. lra. }
    set (e := fun r => Rabs (h r - K) + M * sqrt (2 * PI * (a - r))).
    assert (He0 : e a = 0).
    { unfold e. rewrite HK. replace (K - K) with 0 by ring. replace (2 * PI * (a - a)) with 0 by ring.
      rewrite Rabs_R0, sqrt_0. ring. }
    assert (Hc : continuous e a).
    { unfold e. apply (continuous_plus (V := R_NormedModule) (fun r => Rabs (h r - K))).
      - apply (continuous_comp (fun r => h r - K) Rabs). 2: apply continuous_Rabs.
        apply (ex_derive_continuous (V := R_NormedModule)). unfold h. auto_derive. repeat split; try lra.
        apply Rdiv_lt_0_compat; lra.
      - apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) M (fun r => sqrt (2 * PI * (a - r)))).
        apply (continuous_comp (fun r => 2 * PI * (a - r)) sqrt). 2: apply continuous_sqrt.
        apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
    apply filterlim_locally. intros eps. pose proof (proj1 (filterlim_locally e (e a)) Hc eps) as [del Hd].
    assert (Hm : 0 < Rmin del (Rmin a (a - b))) by (repeat apply Rmin_glb_lt; [apply cond_pos | auto | lra]).
    exists (mkposreal _ Hm). intros r Hr Hra. change (Rabs (r - a) < Rmin del (Rmin a (a - b))) in Hr.
    pose proof (Rmin_l del (Rmin a (a - b))). pose proof (Rmin_r del (Rmin a (a - b))).
    pose proof (Rmin_l a (a - b)). pose proof (Rmin_r a (a - b)). apply Rabs_def2 in Hr.
    assert (Hr2 : Rabs (r - a) < del) by (apply Rabs_def1; lra).
    specialize (Hd r Hr2). rewrite He0 in Hd. change (Rabs (e r - 0) < eps) in Hd.
    change (Rabs (sqrt (2 * PI * (a - r)) * (E * D / (PI * sqrt (a^2 - r^2)) + q r) - K) < eps).
    apply Rle_lt_trans with (2 := Hd). apply Rle_trans with (2 := Rle_abs _). rewrite Rminus_0_r. unfold e.
    assert (Hh : sqrt (2 * PI * (a - r)) * (E * D / (PI * sqrt (a^2 - r^2))) = h r).
    { unfold h. replace (a^2 - r^2) with ((a - r) * (a + r)) by ring.
      rewrite sqrt_div by lra. rewrite (sqrt_mult (a-r)), (sqrt_mult (2*PI)) by lra.
      assert (0 < sqrt (a - r)) by (apply sqrt_lt_R0; lra). assert (0 < sqrt (a + r)) by (apply sqrt_lt_R0; lra).
      field. lra. }
    replace (_ * (_ + q r) - K) with ((h r - K) + sqrt (2 * PI * (a - r)) * q r) by (rewrite <- Hh; ring).
    apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat_l.
    rewrite Rabs_mult, (Rabs_pos_eq (sqrt _)), Rmult_comm by apply sqrt_pos.
    apply Rmult_le_compat_r. apply sqrt_pos. apply Hq; lra.
  - assert (HK : K^2 / (2 * E) = E * D^2 / (2 * PI * a)).
    { unfold K. replace ((E * D / sqrt (PI * a))^2) with ((E * D)^2 / (sqrt (PI * a) * sqrt (PI * a))).
      rewrite sqrt_sqrt by nra. field. lra. assert (0 < sqrt (PI * a)) by (apply sqrt_lt_R0; nra). field. lra. }
    rewrite HK. pose proof (dl_sq E w HE Hw a Ha) as Hs. assert (Hl : 0 <= dl E w a) by apply sqrt_pos.
    unfold Definitions.B in Hs. replace (4 * (PI * w / (2 * E)) * a) with (2 * PI * a * w / E) in Hs by (field; lra).
    split; intros H.
    + apply Rsqr_inj; auto. unfold Rsqr. rewrite Hs, <- H. field. lra.
    + rewrite H. replace (dl E w a ^ 2) with (dl E w a * dl E w a) by ring. rewrite Hs. field. lra.
Qed.
