(** (1.1) from the flat punch where g' is infinite or jumps: power laws with n <= 1, and tips with a flat. The integral over the
    punches is improper at the radius b from which on g' is continuous. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform MDR.Stability MDR.Punch.
Open Scope R_scope.

Ltac real_ring := match goal with |- @eq _ ?l ?r => change (@eq R l r) end; ring.

(** g vanishes up to b and has a continuous slope g1 beyond; b = 0 for a tip that is sharp. *)
Section Improper.
Variables g g1 : R -> R.
Variable b : R.
Hypotheses (Hb : 0 <= b) (Cg : forall x, continuous g x) (Hz : forall x, 0 <= x <= b -> g x = 0)
  (Hg : forall x, b < x -> is_derive g x (g1 x)) (Hc : forall x, b < x -> continuous g1 x).

Let turned r t := g (r * sin t).

Lemma turned_continuous r t : continuous (turned r) t.
Proof.
  apply (continuous_comp (fun t => r * sin t) g). 2: apply Cg.
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma ex_turned r s t : ex_RInt (turned r) s t.
Proof. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros. apply turned_continuous. Qed.

Lemma angle_turned r t : 0 < r -> 0 < t < PI/2 -> angle r (r * sin t) = t.
Proof.
  intros Hr Ht. destruct (sin_range t Ht) as [T1 T2].
  destruct (angle_sin_cos r Hr (r * sin t) ltac:(nra)) as [Hs _]. replace (r * sin t / r) with (sin t) in Hs by (field; lra).
  pose proof (angle_range r (r * sin t) ltac:(nra)). rewrite <- (asin_sin (angle r (r * sin t))) by lra. rewrite Hs. apply asin_sin. lra.
Qed.

(** by parts, with x = r sin t, from u on *)
Lemma parts_from u r : b < u < r ->
  is_RInt (fun x => g1 x * angle r x) u r (PI/2 * g r - angle r u * g u - RInt (turned r) (angle r u) (PI/2)).
Proof.
  intros Hu. assert (Hr : 0 < r) by lra. pose proof PI_RGT_0. set (s := angle r u).
  pose proof (angle_range r u ltac:(lra)) as Hs. fold s in Hs.
  assert (Es : r * sin s = u). { destruct (angle_sin_cos r Hr u ltac:(lra)) as [E _]. fold s in E. rewrite E. field. lra. }
  assert (Above : forall t, s <= t <= PI/2 -> u <= r * sin t).
  { intros t Ht. rewrite <- Es. apply Rmult_le_compat_l. lra. apply sin_incr_1; lra. }
  assert (Hg1c : forall t, s <= t <= PI/2 -> continuous (fun t => g1 (r * sin t)) t).
  { intros t Ht. apply (continuous_comp (fun t => r * sin t) g1). 2: apply Hc; specialize (Above t Ht); lra.
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  assert (S : is_RInt (fun t => scal (r * cos t) (g1 (r * sin t) * angle r (r * sin t))) s (PI/2)
    (RInt (fun x => g1 x * angle r x) (r * sin s) (r * sin (PI/2)))).
  { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun x => g1 x * angle r x) (fun t => r * sin t)).
    - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. specialize (Above t Ht).
      apply (continuous_mult (K := R_AbsRing) g1). apply Hc; lra. apply angle_continuous; auto. pose proof (SIN_bound t). nra.
    - intros t _. split. auto_derive; auto; ring. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  rewrite Es, sin_PI2, Rmult_1_r in S.
  assert (P : is_RInt (fun t => r * cos t * g1 (r * sin t) * t) s (PI/2) (PI/2 * g r - s * g u - RInt (turned r) s (PI/2))).
  { apply (is_RInt_ext (fun t => (turned r t + t * (r * cos t * g1 (r * sin t))) - turned r t)).
    { intros t _. real_ring. }
    apply (is_RInt_minus (V := R_NormedModule) (fun t => turned r t + t * (r * cos t * g1 (r * sin t)))).
    2: apply (RInt_correct (V := R_CompleteNormedModule)), ex_turned.
    replace (PI/2 * g r - s * g u) with (minus (PI/2 * turned r (PI/2)) (s * turned r s))
      by (unfold turned; rewrite Es, sin_PI2, Rmult_1_r; unfold minus, plus, opp; simpl; ring).
    apply (is_RInt_derive (fun t => t * turned r t)); intros t Ht; rewrite Rmin_left, Rmax_right in Ht by lra.
    - replace (turned r t + t * (r * cos t * g1 (r * sin t))) with (1 * turned r t + t * (r * cos t * g1 (r * sin t))) by ring.
      apply (is_derive_mult (fun t => t) (turned r)). apply (is_derive_id (K := R_AbsRing)). 2: intros; apply Rmult_comm.
      apply (is_derive_comp g (fun t => r * sin t)). apply Hg. specialize (Above t Ht). lra. auto_derive; auto; ring.
    - apply (continuous_plus (V := R_NormedModule)). apply turned_continuous.
      apply (continuous_mult (K := R_AbsRing) (fun t => t)). apply continuous_id.
      apply (continuous_mult (K := R_AbsRing) (fun t => r * cos t)); auto.
      apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  assert (E1 : RInt (fun x => g1 x * angle r x) u r = PI/2 * g r - s * g u - RInt (turned r) s (PI/2)).
  { rewrite <- (is_RInt_unique _ _ _ _ P). apply (is_RInt_unique (V := R_CompleteNormedModule)) in S. rewrite <- S.
    apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. rewrite angle_turned by lra.
    unfold scal; simpl; unfold mult; simpl. ring. }
  rewrite <- E1. apply (RInt_correct (V := R_CompleteNormedModule)). apply (ex_RInt_continuous (V := R_CompleteNormedModule)).
  intros z Hz'. rewrite Rmin_left, Rmax_right in Hz' by lra. apply (continuous_mult (K := R_AbsRing) g1). apply Hc; lra.
  apply angle_continuous; auto; lra.
Qed.

(** What the punches of radii from u to a lower at r. *)
Lemma lowered_from u a r : b < u < r -> r < a -> is_RInt (fun x => g1 x * lowered x r) u a
  (g a - 2/PI * (angle r u * g u + RInt (turned r) (angle r u) (PI/2))).
Proof.
  intros Hu Ha. pose proof PI_RGT_0. assert (Hr : 0 < r) by lra.
  replace (g a - 2/PI * (angle r u * g u + RInt (turned r) (angle r u) (PI/2)))
    with (plus (2/PI * (PI/2 * g r - angle r u * g u - RInt (turned r) (angle r u) (PI/2))) (g a - g r))
    by (unfold plus; simpl; field; lra).
  apply (is_RInt_Chasles (V := R_NormedModule) _ u r a).
  - apply (is_RInt_ext (fun x => 2/PI * (g1 x * angle r x))).
    { intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold lowered. destruct Rle_dec. lra.
      replace (asin (x/r)) with (angle r x).
      { real_ring. }
      destruct (angle_sin_cos r Hr x ltac:(lra)) as [E _]. pose proof (angle_range r x ltac:(lra)). rewrite <- E. symmetry.
      apply asin_sin. lra. }
    apply (is_RInt_scal (V := R_NormedModule) (fun x => g1 x * angle r x)). apply parts_from. auto.
  - apply (is_RInt_ext g1).
    + intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold lowered. destruct Rle_dec; [|lra].
      real_ring.
    + apply (is_RInt_derive g g1); intros x Hx; rewrite Rmin_left, Rmax_right in Hx by lra; auto; [apply Hg | apply Hc]; lra.
Qed.

Lemma at_right_continuous (V : R -> R) (c : R) (P : R -> Prop) :
  b < c -> continuous V b -> locally (V b) P -> at_right b (fun u => b < u < c /\ P (V u)).
Proof.
  intros Hbc CV HP. specialize (CV P HP). unfold filtermap in CV. unfold at_right, within.
  assert (L : locally b (fun u => u < c)).
  { exists (mkposreal (c - b) ltac:(lra)). intros y Hy. change (Rabs (y - b) < c - b) in Hy. apply Rabs_def2 in Hy. lra. }
  generalize (filter_and _ _ CV L). apply filter_imp. intros u [H1 H2] H3. auto.
Qed.

(** Inside the contact the surface lies at d less (2/π) ∫ g(r sin t) dt, whatever g' does at b. *)
Theorem eq_1_1_punch_improper a r : b < a -> 0 < r < a ->
  is_RInt_gen (fun x => g1 x * lowered x r) (at_right b) (at_point a) (g a - 2/PI * RInt (fun t => g (r * sin t)) 0 (PI/2)).
Proof.
  intros Ha Hr. pose proof PI_RGT_0. change (fun t => g (r * sin t)) with (turned r).
  destruct (Rlt_le_dec b r) as [Hbr|Hbr].
  - set (V := fun u => g a - 2/PI * (angle r u * g u + (RInt (turned r) 0 (PI/2) - RInt (turned r) 0 (angle r u)))).
    assert (Cut : forall s, RInt (turned r) s (PI/2) = RInt (turned r) 0 (PI/2) - RInt (turned r) 0 s).
    { intros s. pose proof (RInt_Chasles (V := R_CompleteNormedModule) (turned r) 0 s (PI/2) (ex_turned _ _ _) (ex_turned _ _ _)) as K.
      change (@eq R (RInt (turned r) 0 s + RInt (turned r) s (PI/2))%R (RInt (turned r) 0 (PI/2))) in K. rewrite <- K. lra. }
    assert (CV : continuous V b).
    { assert (Ca : continuous (angle r) b) by (apply angle_continuous; lra).
      apply (continuous_minus (V := R_NormedModule) (fun _ => g a)). apply continuous_const.
      apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (2/PI)).
      apply (continuous_plus (V := R_NormedModule) (fun u => angle r u * g u)). apply (continuous_mult (K := R_AbsRing) (angle r)); auto.
      apply (continuous_minus (V := R_NormedModule) (fun _ => RInt (turned r) 0 (PI/2))). apply continuous_const.
      apply (continuous_comp (angle r) (fun s => RInt (turned r) 0 s)); auto.
      apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply RInt_derive. apply turned_continuous. }
    assert (Vb : V b = g a - 2/PI * RInt (turned r) 0 (PI/2)).
    { unfold V. rewrite (Hz b) by lra. replace (RInt (turned r) 0 (angle r b)) with 0. ring. symmetry.
      assert (Hs : sin (angle r b) = b/r) by (apply angle_sin_cos; lra).
      assert (Ha0 : 0 <= angle r b <= PI/2).
      { destruct Hb as [Hb'|<-]. pose proof (angle_range r b ltac:(lra)); lra. rewrite angle_0; lra. }
      rewrite (RInt_ext _ (fun _ => 0)).
      { rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. }
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. apply Hz.
      assert (S0 : 0 <= sin t) by (apply sin_ge_0; lra). assert (S1 : sin t <= b/r). { rewrite <- Hs. apply sin_incr_1; lra. }
      split. nra. apply (Rmult_le_compat_l r) in S1; [|lra]. replace (r * (b/r)) with b in S1 by (field; lra). auto. }
    rewrite <- Vb. intros P HP. apply (Filter_prod _ _ _ (fun u => b < u < r /\ P (V u)) (fun v => v = a)).
    + apply at_right_continuous; auto.
    + reflexivity.
    + intros u v [Hu HV] ->. exists (V u). split; auto. simpl. unfold V. rewrite <- Cut. apply lowered_from; lra.
  - replace (RInt (turned r) 0 (PI/2)) with 0.
    2:{ symmetry. rewrite (RInt_ext _ (fun _ => 0)). rewrite RInt_const. unfold scal; simpl; unfold mult; simpl; ring.
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (sin_range t Ht). apply Hz. nra. }
    replace (g a - 2/PI * 0) with (g a - g b) by (rewrite (Hz b) by lra; ring).
    intros P HP. apply (Filter_prod _ _ _ (fun u => b < u < a /\ P (g a - g u)) (fun v => v = a)).
    + apply (at_right_continuous (fun u => g a - g u)); auto.
      apply (continuous_minus (V := R_NormedModule) (fun _ => g a)); auto. apply continuous_const.
    + reflexivity.
    + intros u v [Hu HV] ->. exists (g a - g u). split; auto. simpl. apply (is_RInt_ext g1).
      * intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. unfold lowered. destruct Rle_dec; [|lra].
        real_ring.
      * apply (is_RInt_derive g g1); intros x Hx; rewrite Rmin_left, Rmax_right in Hx by lra; [apply Hg | apply Hc]; lra.
Qed.
End Improper.

(** Together, for every n > 0, sharp tips with n <= 1 included: punches of all radii with g of (1.12) press the surface into the shape
    C r^n. *)
Theorem eq_1_1_contact_sharp C n a d r : 0 < n -> 0 < r < a -> exists s,
  is_RInt_gen (fun x => kappa n * C * (n * Rpower x (n-1)) * lowered x r) (at_right 0) (at_point a) s /\
  s + (d - kappa n * C * Rpower a n) * lowered a r = d - C * Rpower r n.
Proof.
  intros Hn Hr. set (g := fun x => kappa n * C * pw n x).
  assert (Ep : forall x, 0 < x -> locally x (fun y => kappa n * C * Rpower y n = g y)).
  { intros x Hx. exists (mkposreal x Hx). intros y Hy. change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. unfold g.
    rewrite pw_pos by lra. auto. }
  pose proof (eq_1_1_punch_improper g (fun x => kappa n * C * (n * Rpower x (n-1))) 0 (Rle_refl 0)) as K.
  exists (g a - 2/PI * RInt (fun t => g (r * sin t)) 0 (PI/2)). split.
  - apply K; try lra.
    + intros x. apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) (kappa n * C) (pw n)). apply continuous_pw. auto.
    + intros x Hx. unfold g. rewrite pw_neg by lra. ring.
    + intros x Hx. apply (is_derive_ext_loc (fun y => kappa n * C * Rpower y n)). auto.
      apply (is_derive_scal (fun y => Rpower y n)). apply is_derive_Rpower. auto.
    + intros x Hx. apply (ex_derive_continuous (V := R_NormedModule)). unfold Rpower. auto_derive. auto.
  - unfold g. rewrite (eq_1_1_abel C n r) by lra. rewrite pw_pos by lra. unfold lowered. destruct Rle_dec; [|lra]. ring.
Qed.
