(** Abel's equation is solved by (1.1), for every smooth profile: the two integrals, one after the other, are an integral over the
    eighth of a sphere. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Stability MDR.Profiles MDR.Punch MDR.Archimedes.
Open Scope R_scope.

Lemma continuous_clamped (g : R -> R) x : continuous_on (fun r => 0 <= r) g -> continuous (fun x => g (Rmax 0 x)) x.
Proof.
  intros Hg P HP. destruct (Hg (Rmax 0 x) (Rmax_l 0 x) P HP) as [e He]. exists e. intros y Hy. apply He. 2: apply Rmax_l.
  change (Rabs (Rmax 0 y - Rmax 0 x) < e). change (Rabs (y - x) < e) in Hy. apply Rabs_def2 in Hy. apply Rabs_def1;
  unfold Rmax; destruct (Rle_dec 0 y), (Rle_dec 0 x); lra.
Qed.

(** A profile with f(0) = 0 and a continuous slope f', on the radii from 0 on. *)
Section Profile.
Variables f f1 : R -> R.
Hypotheses (H0 : f 0 = 0) (Hf : continuous_on (fun r => 0 <= r) f) (Hf1 : continuous_on (fun r => 0 <= r) f1)
  (Hd : forall r, 0 < r -> is_derive f r (f1 r)).

(* f' with its value at 0 on the other side, which no integral sees *)
Let k x := f1 (Rmax 0 x).
Let Hk x : continuous k x := continuous_clamped f1 x Hf1.
Let k_pos x : 0 <= x -> k x = f1 x.
Proof. intros. unfold k. rewrite Rmax_right; auto. Qed.

Lemma profile_integral r : 0 < r -> f r = RInt k 0 r.
Proof.
  intros Hr. destruct (MVT_gen (fun x => f (Rmax 0 x) - RInt k 0 x) 0 r (fun _ => 0)) as [c [_ Hc]].
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra.
    evar_last. 2: transitivity (minus (f1 x) (k x)); [reflexivity | rewrite k_pos by lra; unfold minus, plus, opp; simpl; ring].
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule) (fun x => f (Rmax 0 x)) (fun x => RInt k 0 x)).
    2:{ apply RInt_derive. exact Hk. }
    apply (is_derive_ext_loc f). 2: apply Hd; lra. exists (mkposreal x (proj1 Hx)). intros y Hy.
    change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. rewrite Rmax_right; auto; lra.
  - intros x _. apply continuity_pt_filterlim. apply (continuous_minus (V := R_NormedModule) (fun x => f (Rmax 0 x)) (fun x => RInt k 0 x)).
    apply continuous_clamped; auto. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply RInt_derive. exact Hk.
  - rewrite (Rmax_right 0 r), (Rmax_left 0 0), RInt_point, H0 in Hc by lra. unfold zero in Hc; simpl in Hc. lra.
Qed.

Lemma transform_k x : 0 <= x -> transform f1 x = transform k x.
Proof.
  intros Hx. pose proof PI_RGT_0. unfold transform. f_equal. apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra.
  symmetry. apply k_pos. pose proof (sin_01 t ltac:(lra)). nra.
Qed.

(** (1.1) solves Abel's equation for every smooth profile: with r = x sin t in (1.1), and x = r sin s, the integral of (2/π) g gives
    back f. *)
Theorem eq_1_1_abel_smooth r : 0 < r -> 2/PI * RInt (fun s => transform f1 (r * sin s)) 0 (PI/2) = f r.
Proof.
  intros Hr. pose proof PI_RGT_0. set (h := fun u => k (r * u)).
  assert (Ch : forall u : R, continuous h u).
  { intros u. apply (continuous_comp (fun u => r * u) k); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  assert (E1 : RInt (fun s => transform f1 (r * sin s)) 0 (PI/2) = r * eighth h).
  { unfold eighth. rewrite <- (RInt_scal (V := R_CompleteNormedModule) (fun s => sin s * inner h (sin s))) by (apply ex_eighth; auto).
    apply RInt_ext. intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra. pose proof (sin_01 s ltac:(lra)).
    rewrite transform_k by nra. unfold transform, inner, h. rewrite (RInt_ext _ (fun t => k (r * (sin s * sin t)))).
    unfold scal; simpl; unfold mult; simpl. ring. intros t _. f_equal. ring. }
  assert (E2 : @eq R (r * RInt h 0 1) (RInt k 0 r)).
  { pose proof (RInt_comp_lin (V := R_CompleteNormedModule) k r 0 0 1 (ex_cont k _ _ Hk)) as K.
    replace (r * 0 + 0) with 0 in K by ring. replace (r * 1 + 0) with r in K by ring. rewrite <- K.
    rewrite <- (RInt_scal (V := R_CompleteNormedModule) h) by (apply ex_cont; auto). apply RInt_ext. intros u _. unfold h.
    rewrite Rplus_0_r. auto. }
  rewrite E1, profile_integral by auto. rewrite <- E2. change (2/PI * (r * eighth h) = r * RInt h 0 1). rewrite (eq_1_1_archimedes h Ch : eighth h = _). field. lra.
Qed.

(** The same with the improper integrals as they are printed: g(x)/x is the integral of f'(r)/sqrt (x² - r²) over r from 0 to x,
    and (π/2) f(r) that of g(x)/sqrt (r² - x²) over x from 0 to r. *)
Theorem eq_1_1_abel_improper : let g := transform f1 in
  (forall x, 0 < x -> is_RInt_gen (fun r => f1 r / sqrt (x^2 - r^2)) (at_point 0) (at_left x) (g x / x)) /\
  (forall r, 0 < r -> is_RInt_gen (fun x => g x / sqrt (r^2 - x^2)) (at_point 0) (at_left r) (PI/2 * f r)).
Proof.
  intros g. pose proof PI_RGT_0.
  assert (Hext : forall (p q : R -> R) x l, 0 < x -> (forall r, 0 <= r -> p r = q r) ->
    is_RInt_gen p (at_point 0) (at_left x) l -> is_RInt_gen q (at_point 0) (at_left x) l).
  { intros p q x l Hx Hpq. apply is_RInt_gen_ext; try typeclasses eauto. apply (Filter_prod _ _ _ (fun a => a = 0) (fun b => 0 < b)).
    - unfold at_point. auto.
    - exists (mkposreal x Hx). intros y Hy _. change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. lra.
    - intros a b Ha Hb r Hr. simpl in Hr. rewrite Ha, Rmin_left, Rmax_right in Hr by lra. apply Hpq. lra. }
  split; intros x Hx.
  - replace (g x / x) with (inner k x).
    2:{ unfold g. rewrite transform_k by lra. change (inner k x = x * inner k x / x). field. lra. }
    apply (Hext (fun r => k r / sqrt (x^2 - r^2))); auto. intros r Hr. rewrite k_pos; auto. apply eq_1_1; auto.
  - rewrite <- (eq_1_1_abel_smooth x Hx). set (G := fun x => x * inner k x).
    assert (EG : RInt (fun s => transform f1 (x * sin s)) 0 (PI/2) = RInt (fun s => G (x * sin s)) 0 (PI/2)).
    { apply RInt_ext. intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra. pose proof (sin_01 s ltac:(lra)). apply transform_k. nra. }
    rewrite EG. set (J := RInt (fun s => G (x * sin s)) 0 (PI/2) : R). replace (PI/2 * (2/PI * J)) with J by (field; lra).
    apply (Hext (fun r => G r / sqrt (x^2 - r^2))); auto. intros r Hr. unfold g. rewrite transform_k; auto.
    apply eq_1_1; auto. intros r. apply (continuous_mult (K := R_AbsRing) (fun x => x) (inner k)). apply continuous_id.
    apply inner_continuous; auto.
Qed.
End Profile.

(** Together: punches of all radii with g of (1.1) press the surface into the shape f inside the contact, for every profile with
    f(0) = 0 and a continuous second derivative. *)
Theorem eq_1_1_contact_smooth (f f1 f2 : R -> R) a d r :
  f 0 = 0 -> (forall x, is_derive f x (f1 x)) -> (forall x, is_derive f1 x (f2 x)) -> (forall x, continuous f2 x) -> 0 < r < a ->
  surface (fun x => Derive (transform f1) x) (transform f1 a) a d r = d - f r.
Proof.
  intros H0 Hf Hf1 Hf2 Hr. pose proof PI_RGT_0.
  assert (C : forall u v : R -> R, (forall x, is_derive u x (v x)) -> forall x, continuous u x).
  { intros u v Hu x. apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply Hu. }
  pose proof (C f f1 Hf) as Cf. pose proof (C f1 f2 Hf1) as Cf1.
  set (g1 := fun x => inner f1 x + x * RInt (fun t => sin t * f2 (x * sin t)) 0 (PI/2)).
  assert (D1 : forall t x, is_derive (fun x => f1 (x * sin t)) x (sin t * f2 (x * sin t))).
  { intros t x. apply (is_derive_comp f1 (fun x => x * sin t)); auto. auto_derive; auto; ring. }
  assert (Hi : forall x, is_derive (inner f1) x (RInt (fun t => sin t * f2 (x * sin t)) 0 (PI/2))).
  { intros x. evar_last. apply (is_derive_RInt_param (fun x t => f1 (x * sin t)) 0 (PI/2) x).
    - exists (mkposreal 1 Rlt_0_1). intros y _ t _. eexists. apply D1.
    - intros t _. apply (continuity_2d_pt_ext (fun x t => sin t * f2 (x * sin t))). intros y s. symmetry. apply is_derive_unique, D1.
      assert (Cs : continuity_2d_pt (fun _ t => sin t) x t).
      { apply (continuity_1d_2d_pt_comp sin (fun _ t => t)). apply continuity_sin. apply continuity_2d_pt_id2. }
      apply continuity_2d_pt_mult; auto. apply (continuity_1d_2d_pt_comp f2 (fun x t => x * sin t)). apply continuity_pt_filterlim, Hf2.
      apply continuity_2d_pt_mult; auto. apply continuity_2d_pt_id1.
    - exists (mkposreal 1 Rlt_0_1). intros y _. apply ex_inner; auto.
    - apply RInt_ext. intros t _. apply is_derive_unique, D1. }
  assert (Hg : forall x, is_derive (transform f1) x (g1 x)).
  { intros x. unfold g1. replace (inner f1 x) with (1 * inner f1 x) by ring. apply (is_derive_mult (fun x => x) (inner f1)); auto.
    apply (is_derive_id (K := R_AbsRing)). intros; apply Rmult_comm. }
  assert (Cg1 : forall x, continuous g1 x).
  { intros x. set (u := fun x => f1 x + x * f2 x). assert (Cu : forall x, continuous (fun x => x * f2 x) x).
    { intros y. apply (continuous_mult (K := R_AbsRing) (fun x => x) f2); auto. apply continuous_id. }
    apply (continuous_ext (fun x => inner f1 x + inner (fun x => x * f2 x) x)).
    - intros y. unfold g1. f_equal. unfold inner. rewrite <- (RInt_scal (V := R_CompleteNormedModule) (fun t => sin t * f2 (y * sin t))).
      + apply RInt_ext. intros t _. unfold scal; simpl; unfold mult; simpl. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
      + apply ex_cont. intros t. apply (continuous_mult (K := R_AbsRing) sin (fun t => f2 (y * sin t))).
        apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. apply cont_at_sin; auto.
    - apply (continuous_plus (V := R_NormedModule) (inner f1)); apply inner_continuous; auto. }
  assert (Eg : forall x, Derive (transform f1) x = g1 x) by (intros; apply is_derive_unique; auto).
  rewrite (eq_1_1_punch (transform f1)); auto.
  - assert (On : forall u : R -> R, (forall x, continuous u x) -> continuous_on (fun r => 0 <= r) u).
    { intros u Hu x _ P HP. destruct (Hu x P HP) as [e He]. exists e. intros y Hy _. auto. }
    rewrite (eq_1_1_abel_smooth f f1); auto. lra.
  - intros x. rewrite Eg. auto.
  - intros x. apply (continuous_ext g1); auto.
Qed.
