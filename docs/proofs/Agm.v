(** κ_½ by the arithmetic-geometric mean: Gauss's theorem, κ_½ = π/(2 agm(1, sqrt 2)), and the numbers of (1.18) and (1.19). *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Transform.
Open Scope R_scope.

(** The pair after k steps, each to the arithmetic and the geometric mean; agm is the limit of the first, and theorem [agm_limit]
    says that it is that of both. *)
Fixpoint means (k : nat) (a b : R) : R * R :=
  match k with O => (a, b) | S k => means k ((a + b)/2) (sqrt (a*b)) end.
Definition agm a b : R := real (Lim_seq (fun k => fst (means k a b))).

Lemma mean_bounds a b : 0 < a -> 0 < b -> 0 < sqrt (a*b) <= (a+b)/2 /\ Rmin a b <= sqrt (a*b) /\ (a+b)/2 <= Rmax a b.
Proof.
  intros Ha Hb. assert (Hs : 0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra). pose proof (sqrt_sqrt (a*b) ltac:(nra)) as Hq.
  set (s := sqrt (a*b)) in *. repeat split; auto.
  - apply Rsqr_incr_0; try lra. unfold Rsqr. rewrite Hq. pose proof (pow2_ge_0 (a-b)). nra.
  - apply Rsqr_incr_0; try lra. 2: unfold Rmin; destruct Rle_dec; lra. unfold Rsqr. rewrite Hq. unfold Rmin; destruct Rle_dec; nra.
  - unfold Rmax; destruct Rle_dec; lra.
Qed.

Lemma means_step k : forall a b, means (S k) a b = ((fst (means k a b) + snd (means k a b))/2, sqrt (fst (means k a b) * snd (means k a b))).
Proof. induction k; intros a b. auto. change (means (S (S k)) a b) with (means (S k) ((a+b)/2) (sqrt (a*b))). rewrite IHk. auto. Qed.

Lemma means_pos k : forall a b, 0 < a -> 0 < b -> 0 < fst (means k a b) /\ 0 < snd (means k a b).
Proof.
  induction k; intros a b Ha Hb. auto. simpl. apply IHk. lra. apply sqrt_lt_R0; nra.
Qed.

(** from the first step on the geometric mean is the smaller one, and the distance is halved *)
Lemma means_squeeze k : forall a b, 0 < a -> 0 < b -> b <= a ->
  snd (means k a b) <= fst (means k a b) /\ b <= snd (means k a b) /\ fst (means k a b) <= a /\
  fst (means k a b) - snd (means k a b) <= (a - b) * (/2)^k.
Proof.
  induction k; intros a b Ha Hb H. simpl. lra.
  destruct (mean_bounds a b Ha Hb) as [[H1 H2] [H3 H4]]. rewrite Rmin_right in H3 by auto. rewrite Rmax_left in H4 by auto.
  simpl. destruct (IHk ((a+b)/2) (sqrt (a*b)) ltac:(lra) H1 H2) as [K1 [K2 [K3 K4]]]. repeat split; try lra.
  apply Rle_trans with (1 := K4). assert (0 < (/2)^k) by (apply pow_lt; lra).
  replace ((a-b)*(/2*(/2)^k)) with ((a-b)/2*(/2)^k) by field. apply Rmult_le_compat_r; lra.
Qed.

(** The two means have a common limit. *)
Theorem agm_limit a b : 0 < a -> 0 < b ->
  is_lim_seq (fun k => fst (means k a b)) (agm a b) /\ is_lim_seq (fun k => snd (means k a b)) (agm a b).
Proof.
  intros Ha Hb. destruct (mean_bounds a b Ha Hb) as [[H1 H2] _].
  set (u := fun k => fst (means k ((a+b)/2) (sqrt (a*b)))). set (l := fun k => snd (means k ((a+b)/2) (sqrt (a*b)))).
  assert (Hsq : forall k, l k <= u k /\ sqrt (a*b) <= l k /\ u k - l k <= ((a+b)/2 - sqrt (a*b)) * (/2)^k).
  { intros k. destruct (means_squeeze k ((a+b)/2) (sqrt (a*b)) ltac:(lra) H1 H2) as [K1 [K2 [K3 K4]]]. auto. }
  assert (Hdec : forall k, u (S k) <= u k).
  { intros k. unfold u. rewrite means_step. simpl. destruct (Hsq k) as [K _]. unfold u, l in K. lra. }
  assert (Hu : ex_finite_lim_seq u).
  { apply ex_finite_lim_seq_decr with (sqrt (a*b)). auto. intros k. destruct (Hsq k) as [K1 [K2 _]]. lra. }
  destruct Hu as [m Hu].
  assert (Hgeom : is_lim_seq (fun k => ((a+b)/2 - sqrt (a*b)) * (/2)^k) 0).
  { replace (Finite 0) with (Rbar_mult ((a+b)/2 - sqrt (a*b)) 0). 2: simpl; f_equal; ring.
    apply is_lim_seq_scal_l. apply is_lim_seq_geom. rewrite Rabs_pos_eq; lra. }
  assert (Hdiff : is_lim_seq (fun k => u k - l k) 0).
  { apply is_lim_seq_le_le with (fun _ => 0) (fun k => ((a+b)/2 - sqrt (a*b)) * (/2)^k); auto.
    intros k. destruct (Hsq k) as [K1 [K2 K3]]. lra. apply is_lim_seq_const. }
  assert (Hl : is_lim_seq l m).
  { apply (is_lim_seq_ext (fun k => u k - (u k - l k))). intros; ring.
    replace (Finite m) with (Finite (m - 0)) by (f_equal; ring). apply is_lim_seq_minus'; auto. }
  assert (Hm : agm a b = m).
  { unfold agm. rewrite <- Lim_seq_incr_1. simpl. change (real (Lim_seq u) = m). rewrite (is_lim_seq_unique u m Hu). auto. }
  rewrite Hm. split; apply is_lim_seq_incr_1; auto.
Qed.

Lemma agm_bounds k a b : 0 < a -> 0 < b -> snd (means (S k) a b) <= agm a b <= fst (means (S k) a b).
Proof.
  intros Ha Hb. destruct (agm_limit a b Ha Hb) as [L1 L2].
  apply (is_lim_seq_incr_n _ (S k)) in L1. apply (is_lim_seq_incr_n _ (S k)) in L2.
  destruct (means_pos k a b Ha Hb) as [P1 P2]. destruct (mean_bounds _ _ P1 P2) as [[H1 H2] _].
  assert (Hs : means (S k) a b = ((fst (means k a b) + snd (means k a b))/2, sqrt (fst (means k a b) * snd (means k a b)))) by apply means_step.
  assert (Hadd : forall j, forall a b, means (j + S k) a b = means j (fst (means (S k) a b)) (snd (means (S k) a b))).
  { induction j; intros x y. simpl. destruct (means k ((x+y)/2) (sqrt (x*y))); auto.
    change (S j + S k)%nat with (S (j + S k)). rewrite means_step, IHj, <- means_step. auto. }
  set (p := fst (means (S k) a b)) in *. set (q := snd (means (S k) a b)) in *.
  assert (Hpq : q <= p /\ 0 < q) by (unfold p, q; rewrite Hs; simpl; lra).
  assert (Hj : forall j, q <= snd (means (j + S k) a b) /\ fst (means (j + S k) a b) <= p).
  { intros j. rewrite Hadd. destruct (means_squeeze j p q ltac:(lra) ltac:(lra) ltac:(lra)) as [K1 [K2 [K3 K4]]]. auto. }
  split.
  - apply (is_lim_seq_le (fun _ => q) (fun j => snd (means (j + S k) a b)) q (agm a b)); auto. intros j; apply Hj. apply is_lim_seq_const.
  - apply (is_lim_seq_le (fun j => fst (means (j + S k) a b)) (fun _ => p) (agm a b) p); auto. intros j; apply Hj. apply is_lim_seq_const.
Qed.

Lemma agm_pos a b : 0 < a -> 0 < b -> 0 < agm a b.
Proof.
  intros Ha Hb. destruct (agm_bounds 0 a b Ha Hb) as [H _]. simpl in H. assert (0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra). lra.
Qed.

(** The complete elliptic integral. *)
Section Gauss.
Variables a b : R.
Hypotheses (Ha : 0 < a) (Hb : 0 < b).

Definition D t := sqrt ((a * cos t)^2 + (b * sin t)^2).

Lemma D_arg t : 0 < (a * cos t)^2 + (b * sin t)^2.
Proof.
  pose proof (sin2_cos2 t) as H. unfold Rsqr in H. 
  destruct (Req_dec (sin t) 0) as [K|K].
  - rewrite K in *. assert (cos t <> 0) by nra. pose proof (pow2_gt_0 (a * cos t)). assert (a * cos t <> 0) by (apply Rmult_integral_contrapositive; lra). nra.
  - assert (b * sin t <> 0) by (apply Rmult_integral_contrapositive; lra). pose proof (pow2_gt_0 (b * sin t) H0). pose proof (pow2_ge_0 (a * cos t)). lra.
Qed.
Lemma D_pos t : 0 < D t.
Proof. apply sqrt_lt_R0, D_arg. Qed.
Lemma D_sq t : D t * D t = (a * cos t)^2 + (b * sin t)^2.
Proof. apply sqrt_sqrt. left. apply D_arg. Qed.

Lemma D_continuous t : continuous (fun t => 1 / D t) t.
Proof.
  apply (ex_derive_continuous (V := R_NormedModule)). unfold D. auto_derive.
  pose proof (D_arg t) as H. replace (a * cos t * (a * cos t * 1) + b * sin t * (b * sin t * 1)) with ((a * cos t)^2 + (b * sin t)^2) by ring.
  split; auto. split; auto. apply Rgt_not_eq, sqrt_lt_R0; auto.
Qed.

Lemma ex_elliptic x y : ex_RInt (fun t => 1 / D t) x y.
Proof. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros; apply D_continuous. Qed.
End Gauss.

Definition elliptic a b := RInt (fun t => 1 / D a b t) 0 (PI/2).

(** Gauss's step: t + psi with tan psi = (b/a) tan t, written without poles *)
Section Step.
Variables a b : R.
Hypotheses (Ha : 0 < a) (Hb : 0 < b).
Let q t := a * (cos t)^2 + b * (sin t)^2.
Definition gauss t := 2*t + atan ((b - a) * sin t * cos t / q t).

Lemma q_pos t : 0 < q t.
Proof.
  unfold q. pose proof (sin2_cos2 t) as H. unfold Rsqr in H. simpl. rewrite !Rmult_1_r.
  pose proof (pow2_ge_0 (sin t)). pose proof (pow2_ge_0 (cos t)).
  destruct (Rle_dec a b); nra.
Qed.

Lemma q_identity t : (q t)^2 + ((b - a) * sin t * cos t)^2 = D a b t * D a b t.
Proof.
  rewrite (D_sq a b Ha Hb). unfold q. pose proof (sin2_cos2 t) as H. unfold Rsqr in H.
  set (s := sin t) in *. set (c := cos t) in *. replace (s^2) with (1 - c^2) by lra. 
  replace (((b-a)*s*c)^2) with ((b-a)^2*(s*s)*c^2) by ring. replace ((b*s)^2) with (b^2*(s*s)) by ring.
  replace (s*s) with (1 - c*c) by lra. ring.
Qed.

Lemma gauss_trig t : cos (gauss t) = (a*(cos t)^2 - b*(sin t)^2)/D a b t /\ sin (gauss t) = (a+b)*sin t*cos t/D a b t.
Proof.
  pose proof (q_pos t) as Hq. pose proof (D_pos a b Ha Hb t) as HD. pose proof (q_identity t) as H1.
  pose proof (sin2_cos2 t) as H. unfold Rsqr in H.
  set (z := (b - a) * sin t * cos t) in *.
  assert (H2 : sqrt (1 + (z / q t)²) = D a b t / q t).
  { replace (1 + (z / q t)²) with ((D a b t / q t) * (D a b t / q t)).
    apply sqrt_square. left. apply Rdiv_lt_0_compat; auto.
    unfold Rsqr. replace (D a b t / q t * (D a b t / q t)) with ((D a b t * D a b t) / (q t * q t)) by (field; lra).
    rewrite <- H1. field. lra. }
  unfold gauss. fold z. rewrite cos_plus, sin_plus, cos_atan, sin_atan, H2, cos_2a, sin_2a.
  split; (apply Rmult_eq_reg_r with (D a b t); [|lra]).
  - transitivity ((cos t * cos t - sin t * sin t) * q t - 2 * sin t * cos t * z). field; lra.
    transitivity (a*(cos t)^2 - b*(sin t)^2). 2: field; lra. unfold z, q. set (s := sin t) in *. set (c := cos t) in *.
    replace ((c*c - s*s)*(a*c^2 + b*s^2) - 2*s*c*((b-a)*s*c)) with ((s*s + c*c)*(a*c^2 - b*s^2)) by ring. rewrite H. ring.
  - transitivity (2 * sin t * cos t * q t + (cos t * cos t - sin t * sin t) * z). field; lra.
    transitivity ((a+b)*sin t*cos t). 2: field; lra. unfold z, q. set (s := sin t) in *. set (c := cos t) in *.
    replace (2*s*c*(a*c^2 + b*s^2) + (c*c - s*s)*((b-a)*s*c)) with ((s*s + c*c)*((a+b)*s*c)) by ring. rewrite H. ring.
Qed.

Lemma gauss_D t : D ((a+b)/2) (sqrt (a*b)) (gauss t) = (a+b)*q t/(2 * D a b t).
Proof.
  pose proof (q_pos t) as Hq. pose proof (D_pos a b Ha Hb t) as HD. destruct (gauss_trig t) as [C1 S1].
  pose proof (sqrt_sqrt (a*b) ltac:(nra)) as Hs. unfold D at 1. rewrite C1, S1. set (d := D a b t) in *.
  replace (((a+b)/2*((a*(cos t)^2 - b*(sin t)^2)/d))^2 + (sqrt (a*b)*((a+b)*sin t*cos t/d))^2)
    with (((a+b)*q t/(2*d))*((a+b)*q t/(2*d))).
  - apply sqrt_square. apply Rmult_le_pos. nra. left. apply Rinv_0_lt_compat. lra.
  - replace ((sqrt (a*b)*((a+b)*sin t*cos t/d))^2) with ((sqrt (a*b)*sqrt (a*b))*((a+b)*sin t*cos t/d)^2) by (field; lra).
    rewrite Hs. unfold q. field. lra.
Qed.

Lemma gauss_derive t : is_derive gauss t ((a+b)*q t/(D a b t * D a b t)).
Proof.
  pose proof (q_pos t) as Hq. pose proof (D_pos a b Ha Hb t) as HD. pose proof (q_identity t) as H1. pose proof (D_sq a b Ha Hb t) as H2.
  pose proof (sin2_cos2 t) as H. unfold Rsqr in H.
  unfold gauss, q. auto_derive.
  - change (a * (cos t)^2 + b * (sin t)^2 <> 0). fold (q t). lra.
  - replace (a * (cos t * (cos t * 1)) + b * (sin t * (sin t * 1))) with (q t) by (unfold q; ring).
    change (a * (cos t)^2 + b * (sin t)^2) with (q t).
    set (s := sin t) in *. set (c := cos t) in *. set (d := D a b t) in *. set (Q := q t) in *.
    assert (HQ : Q = a*c^2 + b*s^2) by reflexivity.
    assert (H3 : 1 + ((b-a)*s*c*/Q)^2 = d*d/Q^2) by (rewrite <- H1; field; lra).
    assert (H4 : 0 < d*d/Q^2) by (apply Rdiv_lt_0_compat; nra).
    match goal with |- ?L = _ => match L with context [1 + ?X] => replace (1 + X) with (d*d/Q^2) by (rewrite <- H3; unfold Rdiv; ring) end end.
    apply Rmult_eq_reg_r with (d*d); [|nra]. replace ((a+b)*Q/(d*d)*(d*d)) with ((a+b)*Q) by (field; lra).
    transitivity (2*(d*d) + ((b-a)*(c*c - s*s)*Q - (b-a)*s*c*(2*(b-a)*s*c))). field. split; lra.
    rewrite H2, HQ. replace ((a*c)^2) with (a^2*c^2*(s*s+c*c)) by (rewrite H; ring). replace ((b*s)^2) with (b^2*s^2*(s*s+c*c)) by (rewrite H; ring).
    transitivity ((a+b)*(a*c^2+b*s^2)*(s*s+c*c)). ring. rewrite H. ring.
Qed.

Lemma gauss_0 : gauss 0 = 0.
Proof. unfold gauss. rewrite sin_0. replace ((b-a)*0*cos 0/q 0) with 0 by (unfold Rdiv; ring). rewrite atan_0. ring. Qed.
Lemma gauss_end : gauss (PI/2) = PI.
Proof. unfold gauss. rewrite cos_PI2. replace ((b-a)*sin (PI/2)*0/q (PI/2)) with 0 by (unfold Rdiv; ring). rewrite atan_0. field. Qed.

Lemma gauss_full : RInt (fun t => 1 / D ((a+b)/2) (sqrt (a*b)) t) 0 PI = 2 * elliptic a b.
Proof.
  pose proof PI_RGT_0. assert (Hs : 0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra). assert (Hm : 0 < (a+b)/2) by lra.
  symmetry. unfold elliptic.
  assert (Hc : is_RInt (fun t => scal ((a+b)*q t/(D a b t * D a b t)) (1 / D ((a+b)/2) (sqrt (a*b)) (gauss t))) 0 (PI/2)
    (RInt (fun t => 1 / D ((a+b)/2) (sqrt (a*b)) t) (gauss 0) (gauss (PI/2)))).
  { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun t => 1 / D ((a+b)/2) (sqrt (a*b)) t) gauss).
    - intros t _. apply D_continuous; auto.
    - intros t _. split. apply gauss_derive.
      apply (ex_derive_continuous (V := R_NormedModule)). unfold q, D. auto_derive.
      pose proof (D_arg a b Ha Hb t) as H0.
      replace (a * cos t * (a * cos t * 1) + b * sin t * (b * sin t * 1)) with ((a * cos t)^2 + (b * sin t)^2) by ring.
      assert (0 < sqrt ((a * cos t)^2 + (b * sin t)^2)) by (apply sqrt_lt_R0; auto). repeat split; auto. nra. }
  apply (is_RInt_unique (V := R_CompleteNormedModule)) in Hc. rewrite gauss_0, gauss_end in Hc. rewrite <- Hc.
  rewrite <- (RInt_scal (V := R_CompleteNormedModule) (fun t => 1 / D a b t)) by (apply ex_elliptic; auto).
  apply RInt_ext. intros t _. rewrite gauss_D. pose proof (q_pos t). pose proof (D_pos a b Ha Hb t).
  unfold scal; simpl; unfold mult; simpl. field. repeat split; lra.
Qed.

Lemma half_turn x y : 0 < x -> 0 < y -> RInt (fun t => 1 / D x y t) 0 PI = 2 * elliptic x y.
Proof.
  intros Hx Hy. pose proof PI_RGT_0.
  rewrite <- (RInt_Chasles (V := R_CompleteNormedModule) _ 0 (PI/2) PI) by (apply ex_elliptic; auto).
  assert (H1 : RInt (fun t => 1 / D x y t) (PI/2) PI = elliptic x y).
  { pose proof (RInt_comp_lin (V := R_CompleteNormedModule) (fun t => 1 / D x y t) (-1) PI 0 (PI/2) ltac:(apply ex_elliptic; auto)) as K.
    replace (-1*0 + PI) with PI in K by ring. replace (-1*(PI/2) + PI) with (PI/2) in K by field.
    rewrite <- (opp_RInt_swap (V := R_CompleteNormedModule) _ PI (PI/2)), <- K by (apply ex_elliptic; auto).
    rewrite (RInt_ext _ (fun t => scal (-1) (1 / D x y t))).
    2:{ intros t _. f_equal. f_equal. unfold D. replace (-1*t + PI) with (PI - t) by ring.
        f_equal. rewrite sin_PI_x, cos_minus, cos_PI, sin_PI. ring. }
    rewrite (RInt_scal (V := R_CompleteNormedModule)) by (apply ex_elliptic; auto).
    unfold elliptic, opp, scal; simpl. unfold mult; simpl. ring. }
  rewrite H1. unfold elliptic, plus; simpl. ring.
Qed.

Lemma elliptic_step : elliptic ((a+b)/2) (sqrt (a*b)) = elliptic a b.
Proof.
  assert (0 < sqrt (a*b)) by (apply sqrt_lt_R0; nra). pose proof (half_turn ((a+b)/2) (sqrt (a*b)) ltac:(lra) ltac:(lra)) as H1.
  rewrite gauss_full in H1. lra.
Qed.
End Step.

Lemma elliptic_means k : forall a b, 0 < a -> 0 < b -> elliptic (fst (means k a b)) (snd (means k a b)) = elliptic a b.
Proof.
  induction k; intros a b Ha Hb. auto. simpl. rewrite IHk. apply elliptic_step; auto. lra. apply sqrt_lt_R0; nra.
Qed.

Lemma elliptic_bounds a b : 0 < b -> b <= a -> PI/(2*a) <= elliptic a b <= PI/(2*b).
Proof.
  intros Hb Hab. pose proof PI_RGT_0. assert (Ha : 0 < a) by lra.
  assert (Hd : forall t, b <= D a b t <= a).
  { intros t. pose proof (D_sq a b Ha Hb t) as H1. pose proof (D_pos a b Ha Hb t). pose proof (sin2_cos2 t) as H2. unfold Rsqr in H2.
    replace ((a * cos t)^2 + (b * sin t)^2) with (a^2*(cos t*cos t) + b^2*(sin t*sin t)) in H1 by ring.
    assert (0 <= cos t*cos t) by nra. assert (0 <= sin t*sin t) by nra. assert (b^2 <= a^2) by nra.
    replace (sin t*sin t) with (1 - cos t*cos t) in * by lra.
    split; apply Rsqr_incr_0; try lra; unfold Rsqr; rewrite H1; nra. }
  assert (Hc : forall c, 0 < c -> RInt (fun _ => 1/c) 0 (PI/2) = PI/(2*c)).
  { intros c Hc. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. field. lra. }
  rewrite <- !Hc by auto. unfold elliptic. split.
  - apply (RInt_le (fun _ => 1/a) (fun t => 1 / D a b t) 0 (PI/2)). lra. apply (ex_RInt_const (V := R_NormedModule)).
    apply ex_elliptic; auto. intros t _. destruct (Hd t) as [D1 D2]. pose proof (D_pos a b Ha Hb t) as D3.
    apply Rmult_le_compat_l. lra. apply Rinv_le_contravar; lra.
  - apply (RInt_le (fun t => 1 / D a b t) (fun _ => 1/b) 0 (PI/2)). lra. apply ex_elliptic; auto.
    apply (ex_RInt_const (V := R_NormedModule)). intros t _. destruct (Hd t) as [D1 D2].
    apply Rmult_le_compat_l. lra. apply Rinv_le_contravar; lra.
Qed.

(** Gauss's theorem: the integral of 1/sqrt (a²cos² + b²sin²) over a quarter turn is π/(2 agm(a, b)). *)
Theorem gauss_agm a b : 0 < a -> 0 < b -> RInt (fun t => 1 / sqrt ((a * cos t)^2 + (b * sin t)^2)) 0 (PI/2) = PI / (2 * agm a b).
Proof.
  intros Ha Hb. change (elliptic a b = PI / (2 * agm a b)). pose proof PI_RGT_0. pose proof (agm_pos a b Ha Hb) as Hm.
  destruct (agm_limit a b Ha Hb) as [L1 L2]. apply is_lim_seq_incr_1 in L1. apply is_lim_seq_incr_1 in L2.
  assert (Hlim : forall u, is_lim_seq u (agm a b) -> is_lim_seq (fun k => PI / (2 * u k)) (PI / (2 * agm a b))).
  { intros u Hu. apply is_lim_seq_div'. apply is_lim_seq_const. 2: lra.
    apply (is_lim_seq_scal_l u 2 (agm a b)) in Hu. exact Hu. }
  assert (Hb' : forall k, PI/(2*fst (means (S k) a b)) <= elliptic a b <= PI/(2*snd (means (S k) a b))).
  { intros k. rewrite <- (elliptic_means (S k) a b Ha Hb). destruct (means_pos k a b Ha Hb) as [P1 P2].
    destruct (mean_bounds _ _ P1 P2) as [[H1 H2] _]. rewrite means_step. simpl. apply elliptic_bounds; lra. }
  apply Rle_antisym.
  - apply (is_lim_seq_le (fun _ => elliptic a b) (fun k => PI/(2*snd (means (S k) a b))) (elliptic a b) (PI / (2 * agm a b))).
    intros k; apply Hb'. apply is_lim_seq_const. apply Hlim; auto.
  - apply (is_lim_seq_le (fun k => PI/(2*fst (means (S k) a b))) (fun _ => elliptic a b) (PI / (2 * agm a b)) (elliptic a b)).
    intros k; apply Hb'. apply Hlim; auto. apply is_lim_seq_const.
Qed.

(** sin u = cos² t, in the half angle, which has no pole *)
Definition lemniscate t := 2 * atan ((cos t)^2 / (1 + sin t * sqrt (1 + (cos t)^2))).

Lemma lemniscate_parts t : 0 <= t <= PI/2 ->
  let r := sqrt (1 + (cos t)^2) in 0 <= sin t /\ 0 <= cos t /\ 1 <= r /\ r*r = 1 + (cos t)^2 /\
  sin (lemniscate t) = (cos t)^2 /\ cos (lemniscate t) = sin t * r.
Proof.
  intros Ht r. pose proof PI_RGT_0. assert (Hs : 0 <= sin t) by (apply sin_ge_0; lra). assert (Hc : 0 <= cos t) by (apply cos_ge_0; lra).
  pose proof (sin2_cos2 t) as H1. unfold Rsqr in H1. assert (Hr : r*r = 1 + (cos t)^2) by (apply sqrt_sqrt; nra).
  assert (Hr1 : 1 <= r). { unfold r. rewrite <- sqrt_1 at 1. apply sqrt_le_1; nra. }
  assert (Hp : 0 < 1 + sin t * r) by nra.
  repeat split; auto; unfold lemniscate; fold r; destruct (half_angle ((cos t)^2 / (1 + sin t * r))) as [K1 K2]; rewrite ?K1, ?K2;
    set (s := sin t) in *; set (c := cos t) in *; clearbody r;
    assert (Hx : (1 + s*r)^2 + (c^2)^2 = 2*(1 + s*r)) by
      (replace ((1+s*r)^2) with (1 + 2*(s*r) + (s*s)*(r*r)) by ring; rewrite Hr; replace (s*s) with (1 - c*c) by lra; ring).
  - replace (1 + (c^2/(1+s*r))^2) with (2*(1+s*r)/(1+s*r)^2) by (rewrite <- Hx; field; lra). field. lra.
  - replace (1 + (c^2/(1+s*r))^2) with (2*(1+s*r)/(1+s*r)^2) by (rewrite <- Hx; field; lra).
    replace (1 - (c^2/(1+s*r))^2) with (((1+s*r)^2 - (c^2)^2)/(1+s*r)^2) by (field; lra).
    replace ((c^2)^2) with (2*(1+s*r) - (1+s*r)^2) by lra. field. lra.
Qed.

Lemma lemniscate_derive t : 0 <= t <= PI/2 -> is_derive lemniscate t (- (2 * cos t / sqrt (1 + (cos t)^2))).
Proof.
  intros Ht. destruct (lemniscate_parts t Ht) as [Hs [Hc [Hr1 [Hr _]]]]. pose proof (sin2_cos2 t) as H1. unfold Rsqr in H1.
  assert (Hp : 0 < 1 + sin t * sqrt (1 + (cos t)^2)) by nra.
  unfold lemniscate. auto_derive.
  - replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. repeat split; auto. nra. lra.
  - replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring.
    set (r := sqrt (1 + (cos t)^2)) in *. set (s := sin t) in *. set (c := cos t) in *. clearbody r.
    assert (Hx : (1 + s*r)^2 + (c^2)^2 = 2*(1 + s*r)) by
      (replace ((1+s*r)^2) with (1 + 2*(s*r) + (s*s)*(r*r)) by ring; rewrite Hr; replace (s*s) with (1 - c*c) by lra; ring).
    assert (Hy : 1 + (c*(c*1) * / (1 + s*r))^2 = 2/(1+s*r)).
    { replace (2/(1+s*r)) with (2*(1+s*r)/(1+s*r)^2) by (field; lra). rewrite <- Hx. field. lra. }
    match goal with |- ?L = _ => match L with context [1 + ?X] => 
      match X with context [/ (1 + s * r)] => replace (1 + X) with (2/(1+s*r)) by (rewrite <- Hy; unfold Rdiv; ring) end end end.
    transitivity ((-2*c*s*(1+s*r) - c^2*(c*r - c*(s*s)/r))/(1+s*r)). field. split; lra.
    apply Rmult_eq_reg_r with (r*(1+s*r)); [|apply Rmult_integral_contrapositive; lra].
    transitivity (-2*c*(s*r + (s*s)*(r*r)) - c^3*(r*r - s*s)). field. split; lra.
    transitivity (-2*c*(1+s*r)). 2: field; lra. rewrite Hr. replace (s*s) with (1 - c*c) by lra. ring.
Qed.

(** κ_½ as the integral of Gauss: with sin u = cos² t, and one integration by parts. *)
Lemma kappa_half_elliptic : kappa (/2) = elliptic (sqrt 2) 1.
Proof.
  pose proof PI_RGT_0. unfold kappa. replace (/2 + 1) with (3/2) by field.
  set (h := fun t => 3 * (cos t)^4 / sqrt (1 + (cos t)^2)). set (k := fun t => 1 / sqrt (1 + (cos t)^2)).
  assert (Hr : forall t, 0 < 1 + (cos t)^2) by (intros t; pose proof (pow2_ge_0 (cos t)); lra).
  assert (Hck : forall t, continuous k t).
  { intros t. apply (ex_derive_continuous (V := R_NormedModule)). unfold k. auto_derive. specialize (Hr t).
    replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. repeat split; auto. apply Rgt_not_eq, sqrt_lt_R0; auto. }
  assert (Hch : forall t, continuous h t).
  { intros t. apply (ex_derive_continuous (V := R_NormedModule)). unfold h. auto_derive. specialize (Hr t).
    replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. repeat split; auto. apply Rgt_not_eq, sqrt_lt_R0; auto. }
  (* parts *)
  assert (H1 : RInt h 0 (PI/2) = RInt k 0 (PI/2)).
  { assert (P : is_RInt (fun t => minus (h t) (k t)) 0 (PI/2) (minus (sin (PI/2) * cos (PI/2) * sqrt (1 + (cos (PI/2))^2)) (sin 0 * cos 0 * sqrt (1 + (cos 0)^2)))).
    { apply (is_RInt_derive (fun t => sin t * cos t * sqrt (1 + (cos t)^2))).
      - intros t _. specialize (Hr t). pose proof (sqrt_lt_R0 _ Hr) as Hq. pose proof (sqrt_sqrt _ (Rlt_le _ _ Hr)) as Hqq.
        pose proof (sin2_cos2 t) as Hsc. unfold Rsqr in Hsc. unfold h, k. auto_derive.
        + replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. auto.
        + replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. set (r := sqrt (1 + (cos t)^2)) in *.
          set (s := sin t) in *. set (c := cos t) in *. unfold minus, plus, opp; simpl.
          apply Rmult_eq_reg_r with r; [|lra].
          transitivity ((c*c - s*s)*(r*r) - (s*s)*(c*c)). field; lra. rewrite Hqq. replace (s*s) with (1 - c*c) by lra. field. lra.
      - intros t _. apply (continuous_minus (V := R_NormedModule)); auto. }
    rewrite cos_PI2, sin_0 in P. replace (minus _ _) with 0 in P by (unfold minus, plus, opp; simpl; ring).
    assert (Q : is_RInt (fun t => minus (h t) (k t)) 0 (PI/2) (minus (RInt h 0 (PI/2)) (RInt k 0 (PI/2)))).
    { apply (is_RInt_minus (V := R_NormedModule)); apply (RInt_correct (V := R_CompleteNormedModule));
      apply (ex_RInt_continuous (V := R_CompleteNormedModule)); auto. }
    apply (is_RInt_unique (V := R_CompleteNormedModule)) in P. apply (is_RInt_unique (V := R_CompleteNormedModule)) in Q.
    rewrite P in Q. unfold minus, plus, opp in Q; simpl in Q. lra. }
  (* substitution *)
  assert (H2 : 3/2 * W (3/2) = RInt h 0 (PI/2)).
  { assert (S : is_RInt (fun t => scal (- (2 * cos t / sqrt (1 + (cos t)^2))) (pw (3/2) (sin (lemniscate t)))) 0 (PI/2)
      (RInt (fun u => pw (3/2) (sin u)) (lemniscate 0) (lemniscate (PI/2)))).
    { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun u => pw (3/2) (sin u)) lemniscate).
      - intros t _. apply cont_pw_sin. lra.
      - intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. split. apply lemniscate_derive; auto.
        apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Hr t).
        replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. repeat split; auto. apply Rgt_not_eq, sqrt_lt_R0; auto. }
    replace (lemniscate 0) with (PI/2) in S.
    2:{ unfold lemniscate. rewrite cos_0, sin_0. replace (1^2/(1 + 0 * sqrt (1 + 1^2))) with 1 by (field; lra). rewrite atan_1. field. }
    replace (lemniscate (PI/2)) with 0 in S.
    2:{ unfold lemniscate. rewrite cos_PI2, sin_PI2. replace (0^2/(1 + 1 * sqrt (1 + 0^2))) with 0. rewrite atan_0; ring.
        replace (1 + 0^2) with 1 by ring. rewrite sqrt_1. field. }
    rewrite <- (opp_RInt_swap (V := R_CompleteNormedModule)) in S by (apply ex_W; lra).
    apply (is_RInt_unique (V := R_CompleteNormedModule)) in S.
    assert (S2 : RInt (fun t => scal (- (3/2)) (scal (- (2 * cos t / sqrt (1 + (cos t)^2))) (pw (3/2) (sin (lemniscate t))))) 0 (PI/2) = RInt h 0 (PI/2)).
    { apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra.
      destruct (lemniscate_parts t ltac:(lra)) as [_ [_ [Hr1 [_ [E _]]]]]. rewrite E. assert (0 < cos t) by (apply cos_gt_0; lra).
      rewrite pw_pos by (apply pow_lt; auto). replace (Rpower ((cos t)^2) (3/2)) with ((cos t)^3).
      2:{ rewrite <- !Rpower_pow by auto. rewrite Rpower_mult. f_equal. simpl. field. }
      unfold h, scal; simpl. unfold mult; simpl. field. simpl in Hr1. lra. }
    rewrite <- S2, (RInt_scal (V := R_CompleteNormedModule)), S.
    2:{ apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra.
        apply (continuous_mult (K := R_AbsRing)).
        - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. specialize (Hr t).
          replace (1 + cos t * (cos t * 1)) with (1 + (cos t)^2) by ring. repeat split; auto. apply Rgt_not_eq, sqrt_lt_R0; auto.
        - apply (continuous_comp lemniscate (fun u => pw (3/2) (sin u))).
          apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply lemniscate_derive; auto. apply cont_pw_sin. lra. }
    unfold W, opp, scal; simpl. unfold mult; simpl. field. }
  rewrite H2, H1. unfold elliptic. apply RInt_ext. intros t _. unfold k, D. do 2 f_equal.
  pose proof (sin2_cos2 t) as Hsc. unfold Rsqr in Hsc. replace ((sqrt 2 * cos t)^2) with (sqrt 2 * sqrt 2 * (cos t)^2) by ring.
  rewrite sqrt_sqrt by lra. simpl. lra.
Qed.

Lemma agm_swap a b : 0 < a -> 0 < b -> agm a b = agm b a.
Proof.
  intros Ha Hb. unfold agm. f_equal. rewrite <- (Lim_seq_incr_1 (fun k => fst (means k a b))), <- (Lim_seq_incr_1 (fun k => fst (means k b a))).
  apply Lim_seq_ext. intros k. simpl. rewrite (Rplus_comm a b), (Rmult_comm a b). auto.
Qed.

(** (1.18): κ_½ = π/(2 agm(1, sqrt 2)), half of the lemniscate constant. *)
Theorem kappa_elliptic : kappa (/2) = PI / (2 * agm 1 (sqrt 2)).
Proof.
  pose proof (sqrt_lt_R0 2 ltac:(lra)). rewrite kappa_half_elliptic. rewrite agm_swap by lra. apply gauss_agm; lra.
Qed.

(** (1.19): the number that is printed as 0.7628 is 2 agm(1, sqrt 2)/π, *)
Theorem eq_1_19_threshold : 1 / kappa (/2) = 2 * agm 1 (sqrt 2) / PI.
Proof.
  pose proof PI_RGT_0. pose proof (agm_pos 1 (sqrt 2) ltac:(lra) (sqrt_lt_R0 2 ltac:(lra))). rewrite kappa_elliptic. field. lra.
Qed.

(** its first digits, and those of κ_½, printed as 1.311. *)
Theorem eq_1_19_digits : 0.762759763501 < 1 / kappa (/2) < 0.762759763502 /\ 1.3110287771460 < kappa (/2) < 1.3110287771462.
Proof.
  pose proof PI_RGT_0 as Hpi. pose proof (sqrt_lt_R0 2 ltac:(lra)) as H2. pose proof (agm_pos 1 (sqrt 2) ltac:(lra) H2) as Hm.
  pose proof (agm_bounds 3 1 (sqrt 2) ltac:(lra) H2) as [L U]. simpl in L, U.
  assert (B : 1.19814023473559 <= agm 1 (sqrt 2) <= 1.19814023473560).
  { split; [apply Rle_trans with (2 := L) | apply Rle_trans with (1 := U)]; interval with (i_prec 90). }
  rewrite eq_1_19_threshold, kappa_elliptic. set (m := agm 1 (sqrt 2)) in *. clearbody m. clear L U.
  repeat split; interval with (i_prec 90).
Qed.
