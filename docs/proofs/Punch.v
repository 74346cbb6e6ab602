(** (1.1) and (1.6) from the flat punch: of the theory of elasticity only the solution for the flat punch is taken (Boussinesq;
    Sneddon 1965): a punch of radius x that is pressed by 1 lowers the surface by 1 below it and by (2/π) arcsin (x/r) at r > x,
    with the force 2Ex. A contact of radius a is a sum of punches of all radii up to a. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform.
Open Scope R_scope.

Definition lowered x r := if Rle_dec r x then 1 else 2 / PI * asin (x/r).

(** The contact grows from 0 to a while the indentation grows by g1(x) dx at the radius x; then, at the radius a, the indentation
    is changed from g(a) to d, by -Δl(a) in the case of adhesion. *)
Definition surface (g1 : R -> R) (ga : R) a d r := RInt (fun x => g1 x * lowered x r) 0 a + (d - ga) * lowered a r.
Definition load E (g1 : R -> R) (ga : R) a d := RInt (fun x => g1 x * (2 * E * x)) 0 a + (d - ga) * (2 * E * a).

Section Smooth.
Variables g g1 : R -> R.
Hypotheses (Hg : forall x, is_derive g x (g1 x)) (Hc : forall x, continuous g1 x).

Lemma g_cont x : continuous g x.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply Hg. Qed.

Lemma RInt_g1 a b : is_RInt g1 a b (g b - g a).
Proof. apply (is_RInt_derive g g1); auto. Qed.

Lemma ex_cont (h : R -> R) a b : (forall x, continuous h x) -> ex_RInt h a b.
Proof. intros. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). auto. Qed.

(** (1.6) once more: the forces of the punches add up to 2E ∫ (d - g). *)
Theorem eq_1_6_punch E a d : load E g1 (g a) a d = F E g a d.
Proof.
  assert (H1 : is_RInt (fun x => g1 x * (2 * E * x)) 0 a (2*E*(a * g a - RInt g 0 a))).
  { apply (is_RInt_ext (fun x => 2*E*((g x + x * g1 x) - g x))).
    { intros x _. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
    apply (is_RInt_scal (V := R_NormedModule) (fun x => (g x + x * g1 x) - g x)).
    apply (is_RInt_minus (V := R_NormedModule) (fun x => g x + x * g1 x)).
    - replace (a * g a) with (minus (a * g a) (0 * g 0)) by (unfold minus, plus, opp; simpl; ring).
      apply (is_RInt_derive (fun x => x * g x)).
      + intros x _. replace (g x + x * g1 x) with (1 * g x + x * g1 x) by ring. apply (is_derive_mult (fun x => x) g); auto.
        apply (is_derive_id (K := R_AbsRing)). intros; apply Rmult_comm.
      + intros x _. apply (continuous_plus (V := R_NormedModule) g). apply g_cont.
        apply (continuous_mult (K := R_AbsRing) (fun x => x) g1); auto. apply continuous_id.
    - apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_cont, g_cont. }
  unfold load, F. rewrite (is_RInt_unique _ _ _ _ H1).
  replace (RInt (fun x => d - g x) 0 a) with (d * a - RInt g 0 a). ring.
  symmetry. apply is_RInt_unique. replace (d * a) with (scal (a - 0) d) by (unfold scal; simpl; unfold mult; simpl; ring).
  apply (is_RInt_minus (V := R_NormedModule) (fun _ => d)). apply (is_RInt_const (V := R_NormedModule)).
  apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_cont, g_cont.
Qed.

(** by parts, with x = r sin t *)
Lemma parts r : 0 < r -> is_RInt (fun x => g1 x * asin (x/r)) 0 r (PI/2 * g r - RInt (fun t => g (r * sin t)) 0 (PI/2)).
Proof.
  intros Hr. pose proof PI_RGT_0.
  apply (is_RInt_ext (fun x => g1 x * angle r x)).
  { intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. f_equal. destruct (angle_sin_cos r Hr x ltac:(lra)) as [Hs _].
    pose proof (angle_range r x Hx). rewrite <- Hs. symmetry. apply asin_sin. lra. }
  assert (Hgc : forall t, continuous (fun t => g (r * sin t)) t).
  { intros t. apply (continuous_comp (fun t => r * sin t) g). 2: apply g_cont. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  assert (Hg1c : forall t, continuous (fun t => g1 (r * sin t)) t).
  { intros t. apply (continuous_comp (fun t => r * sin t) g1); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  assert (S : is_RInt (fun t => scal (r * cos t) (g1 (r * sin t) * angle r (r * sin t))) 0 (PI/2)
    (RInt (fun x => g1 x * angle r x) (r * sin 0) (r * sin (PI/2)))).
  { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun x => g1 x * angle r x) (fun t => r * sin t)).
    - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply (continuous_mult (K := R_AbsRing) g1); auto.
      apply angle_continuous; auto. assert (0 <= sin t) by (apply sin_ge_0; lra). pose proof (SIN_bound t). nra.
    - intros t _. split. auto_derive; auto; ring. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  rewrite sin_0, sin_PI2, Rmult_0_r, Rmult_1_r in S.
  assert (P : is_RInt (fun t => r * cos t * g1 (r * sin t) * t) 0 (PI/2) (PI/2 * g r - RInt (fun t => g (r * sin t)) 0 (PI/2))).
  { apply (is_RInt_ext (fun t => (g (r * sin t) + t * (r * cos t * g1 (r * sin t))) - g (r * sin t))).
    { intros t _. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
    apply (is_RInt_minus (V := R_NormedModule) (fun t => g (r * sin t) + t * (r * cos t * g1 (r * sin t)))).
    - replace (PI/2 * g r) with (minus (PI/2 * g (r * sin (PI/2))) (0 * g (r * sin 0)))
        by (rewrite sin_PI2, Rmult_1_r; unfold minus, plus, opp; simpl; ring).
      apply (is_RInt_derive (fun t => t * g (r * sin t))).
      + intros t _. replace (g (r * sin t) + t * (r * cos t * g1 (r * sin t))) with (1 * g (r * sin t) + t * (r * cos t * g1 (r * sin t))) by ring.
        apply (is_derive_mult (fun t => t) (fun t => g (r * sin t))). apply (is_derive_id (K := R_AbsRing)). 2: intros; apply Rmult_comm.
        apply (is_derive_comp g (fun t => r * sin t)); auto. auto_derive; auto; ring.
      + intros t _. apply (continuous_plus (V := R_NormedModule)); auto. apply (continuous_mult (K := R_AbsRing) (fun t => t)). apply continuous_id.
        apply (continuous_mult (K := R_AbsRing) (fun t => r * cos t)); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
    - apply (RInt_correct (V := R_CompleteNormedModule)). apply ex_cont, Hgc. }
  assert (E1 : RInt (fun x => g1 x * angle r x) 0 r = PI/2 * g r - RInt (fun t => g (r * sin t)) 0 (PI/2)).
  { rewrite <- (is_RInt_unique _ _ _ _ P). apply (is_RInt_unique (V := R_CompleteNormedModule)) in S. rewrite <- S. apply RInt_ext. intros t Ht.
    rewrite Rmin_left, Rmax_right in Ht by lra. destruct (sin_range t Ht) as [T1 T2].
    assert (Ha : angle r (r * sin t) = t).
    { destruct (angle_sin_cos r Hr (r * sin t) ltac:(nra)) as [Hs _]. replace (r * sin t / r) with (sin t) in Hs by (field; lra).
      pose proof (angle_range r (r * sin t) ltac:(nra)). rewrite <- (asin_sin (angle r (r * sin t))) by lra. rewrite Hs. apply asin_sin. lra. }
    rewrite Ha. unfold scal; simpl; unfold mult; simpl. ring. }
  rewrite <- E1. apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros z Hz. rewrite Rmin_left, Rmax_right in Hz by lra. apply (continuous_mult (K := R_AbsRing) g1); auto. apply angle_continuous; auto.
Qed.

(** Inside the contact the surface lies where a profile f presses it, at d - f(r), exactly if f(r) = (2/π) ∫ g(r sin t) dt over a
    quarter turn: Abel's equation. *)
Theorem eq_1_1_punch a d r : 0 < r < a -> surface g1 (g a) a d r = d - 2/PI * RInt (fun t => g (r * sin t)) 0 (PI/2).
Proof.
  intros Hr. pose proof PI_RGT_0. unfold surface.
  assert (H1 : is_RInt (fun x => g1 x * lowered x r) 0 a (plus (2/PI * (PI/2 * g r - RInt (fun t => g (r * sin t)) 0 (PI/2))) (g a - g r))).
  { apply (is_RInt_Chasles (V := R_NormedModule) _ 0 r a).
    - apply (is_RInt_ext (fun x => 2/PI * (g1 x * asin (x/r)))).
      { intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold lowered. destruct Rle_dec. lra.
        match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
      apply (is_RInt_scal (V := R_NormedModule) (fun x => g1 x * asin (x/r))). apply parts. lra.
    - apply (is_RInt_ext g1). 2: apply RInt_g1.
      intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold lowered. destruct Rle_dec; [|lra].
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  rewrite (is_RInt_unique _ _ _ _ H1). unfold lowered. destruct Rle_dec; [|lra]. unfold plus; simpl. field. lra.
Qed.
End Smooth.

(** (1.1) solves Abel's equation for every power law, and so for every sum of power laws: the integral of (2/π) g(r sin t) gives
    back the profile. *)
Theorem eq_1_1_abel C n r : 0 < n -> 0 < r ->
  2/PI * RInt (fun t => kappa n * C * pw n (r * sin t)) 0 (PI/2) = C * Rpower r n.
Proof.
  intros Hn Hr. pose proof PI_RGT_0.
  replace (RInt (fun t => kappa n * C * pw n (r * sin t)) 0 (PI/2)) with (kappa n * C * Rpower r n * W n).
  { rewrite kappa_W by auto. pose proof (W_pos n Hn). field. split; lra. }
  symmetry. apply is_RInt_unique. apply (is_RInt_ext (fun t => kappa n * C * Rpower r n * pw n (sin t))).
  { intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (sin_range t Ht). rewrite !pw_pos by nra.
    rewrite <- Rpower_mult_distr by auto. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  apply (is_RInt_scal (V := R_NormedModule) (fun t => pw n (sin t))). apply (RInt_correct (V := R_CompleteNormedModule)), ex_W. auto.
Qed.

(** Together, for n > 1: punches of all radii with g of (1.12) press the surface into the shape C r^n. *)
Theorem eq_1_1_contact C n a d r : 1 < n -> 0 < r < a ->
  surface (fun x => kappa n * C * (n * pw (n-1) x)) (kappa n * C * Rpower a n) a d r = d - C * Rpower r n.
Proof.
  intros Hn Hr. pose proof (eq_1_1_punch (fun x => kappa n * C * pw n x) (fun x => kappa n * C * (n * pw (n-1) x))) as K.
  simpl in K. rewrite <- (eq_1_1_abel C n r) by lra. rewrite <- (pw_pos n a) by lra. apply K; auto.
  - intros x. apply (is_derive_scal (pw n)). pose proof (is_derive_pw (n-1) x ltac:(lra)) as D. replace (n-1+1) with n in D by ring. exact D.
  - intros x. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (kappa n * C) (fun x => n * pw (n-1) x)).
    apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) n (pw (n-1))). apply continuous_pw. lra.
Qed.
