(** The exchange of integrals behind (1.1). An integral over the eighth of a sphere of a function of one coordinate u alone is π/2
    times its integral over u from 0 to 1, as equal heights have equal areas (Archimedes). For powers of u these are Wallis'
    integrals; by the polynomials of Bernstein it holds for every continuous function. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Kappa MDR.Punch.
Open Scope R_scope.

(** Bernstein's polynomial: the mean of phi(k), where k counts how many of N steps are made and each is made with probability u. *)
Fixpoint bernstein (N : nat) (phi : R -> R) (u : R) : R :=
  match N with O => phi 0 | S N => u * bernstein N (fun k => phi (k + 1)) u + (1 - u) * bernstein N phi u end.

Lemma bernstein_linear N u c : forall phi psi,
  bernstein N (fun k => c * phi k + psi k) u = c * bernstein N phi u + bernstein N psi u.
Proof.
  induction N; intros phi psi; simpl. auto.
  rewrite (IHN (fun k => phi (k+1)) (fun k => psi (k+1))), (IHN phi psi). ring.
Qed.

Lemma bernstein_const N u c : bernstein N (fun _ => c) u = c.
Proof. induction N; simpl; auto. rewrite IHN. ring. Qed.

Lemma bernstein_le N u : 0 <= u <= 1 -> forall phi psi, (forall k, 0 <= k <= INR N -> phi k <= psi k) ->
  bernstein N phi u <= bernstein N psi u.
Proof.
  intros Hu. induction N; intros phi psi H. simpl. apply H. simpl. lra.
  assert (HS : INR (S N) = INR N + 1) by apply S_INR. simpl bernstein.
  assert (H1 : bernstein N (fun k => phi (k+1)) u <= bernstein N (fun k => psi (k+1)) u) by (apply IHN; intros; apply H; lra).
  assert (H2 : bernstein N phi u <= bernstein N psi u) by (apply IHN; intros; apply H; lra). nra.
Qed.

Lemma bernstein_ext N u phi psi : 0 <= u <= 1 -> (forall k, phi k = psi k) -> bernstein N phi u = bernstein N psi u.
Proof. intros Hu H. apply Rle_antisym; apply bernstein_le; auto; intros k _; rewrite H; lra. Qed.

(* mean and variance *)
Lemma bernstein_square N u : 0 <= u <= 1 -> forall c,
  bernstein N (fun k => (k + c)^2) u = (INR N * u + c)^2 + INR N * (u * (1 - u)).
Proof.
  intros Hu. induction N; intros c. simpl. ring. rewrite S_INR. simpl bernstein.
  rewrite (bernstein_ext N u (fun k => (k + 1 + c)*((k + 1 + c)*1)) (fun k => (k + (1 + c))^2)) by (auto; intros; ring).
  rewrite (bernstein_ext N u (fun k => (k + c)*((k + c)*1)) (fun k => (k + c)^2)) by (auto; intros; ring).
  rewrite !IHN. ring.
Qed.

(* a continuous function is as near to one of its Bernstein polynomials as desired, from 0 to 1 *)
Lemma weierstrass (h : R -> R) (eps : posreal) : (forall u, continuous h u) ->
  exists N, forall u, 0 <= u <= 1 -> Rabs (h u - bernstein (S N) (fun k => h (k / INR (S N))) u) <= eps.
Proof.
  intros Hc. assert (Hp : forall u, continuity_pt h u) by (intros; apply continuity_pt_filterlim, Hc).
  assert (He : 0 < eps / 2) by (pose proof (cond_pos eps); lra).
  destruct (Heine_cor2 (f := h) (a := 0) (b := 1) (fun u _ => Hp u) (mkposreal _ He)) as [d Hd]. simpl in Hd.
  destruct (continuity_ab_maj (fun u => Rabs (h u)) 0 1 ltac:(lra)) as [m [Hm _]].
  { intros u _. apply (continuity_pt_comp h Rabs). apply Hp. apply Rcontinuity_abs. }
  set (M := Rabs (h m)) in *. assert (HM : 0 <= M) by apply Rabs_pos. pose proof (cond_pos d) as Hd0.
  set (q := 2 * M / d^2). assert (Hq : 0 <= q). { apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat, pow_lt; auto. }
  assert (Hgap : forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> Rabs (h x - h y) <= eps/2 + q * (x - y)^2).
  { intros x y Hx Hy. pose proof (pow2_ge_0 (x - y)) as H2. destruct (Rlt_dec (Rabs (x - y)) d) as [L|L].
    - specialize (Hd x y Hx Hy L). nra.
    - assert (d^2 <= (x - y)^2). { rewrite <- (pow2_abs (x - y)). apply pow_incr. lra. }
      assert (H3 : 2 * M <= q * (x - y)^2).
      { unfold q. apply Rle_trans with (2 * M / d^2 * d^2). right. field. lra. apply Rmult_le_compat_l; auto. }
      apply Rle_trans with (2 * M). 2: lra. pose proof (Hm x Hx) as M1. pose proof (Hm y Hy) as M2. simpl in M1, M2. fold M in M1, M2.
      apply Rle_trans with (Rabs (h x) + Rabs (h y)); [|lra].
      unfold Rminus. rewrite <- (Rabs_Ropp (h y)). apply Rabs_triang. }
  destruct (nfloor_ex (2 * q / eps)) as [N [_ HN]].
  { apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat, cond_pos. }
  exists N. intros u Hu. set (n := INR (S N)). assert (Hn : n = INR N + 1) by apply S_INR.
  assert (Hn0 : 0 < n) by (pose proof (pos_INR N); lra).
  assert (Hqn : q / n <= eps / 2).
  { apply Rmult_le_reg_r with n; auto. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    pose proof (cond_pos eps) as E0. apply Rmult_lt_compat_r with (r := eps) in HN; auto.
    replace (2*q/eps*eps) with (2*q) in HN by (field; lra). nra. }
  set (phi := fun k => h (k / n)).
  assert (Hk : forall k, 0 <= k <= INR (S N) -> 0 <= k / n <= 1).
  { intros k Hk. fold n in Hk. split. apply Rmult_le_pos. lra. left. apply Rinv_0_lt_compat; auto.
    apply Rmult_le_reg_r with n; auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (Hsq : bernstein (S N) (fun k => q / n^2 * (k + - (n * u))^2 + eps/2) u <= eps).
  { rewrite (bernstein_linear (S N) u (q / n^2) (fun k => (k + - (n * u))^2) (fun _ => eps/2)), bernstein_const, bernstein_square by auto.
    fold n. replace (q / n^2 * ((n * u + - (n * u))^2 + n * (u * (1 - u))) + eps/2) with (q / n * (u * (1 - u)) + eps/2) by (field; lra).
    assert (0 <= u * (1 - u) <= 1) by nra. assert (0 <= q / n). { apply Rmult_le_pos; auto. left. apply Rinv_0_lt_compat; auto. } nra. }
  assert (Hb : forall k, 0 <= k <= INR (S N) -> Rabs (h u - phi k) <= q / n^2 * (k + - (n * u))^2 + eps/2).
  { intros k H. specialize (Hgap u (k / n) Hu (Hk k H)). replace (q / n^2 * (k + - (n * u))^2) with (q * (u - k/n)^2) by (field; lra).
    unfold phi. lra. }
  assert (Hdiff : forall c, bernstein (S N) (fun k => c * (h u - phi k)) u = c * (h u - bernstein (S N) phi u)).
  { intros c. rewrite (bernstein_ext _ _ _ (fun k => - c * phi k + c * h u)) by (auto; intros; ring).
    rewrite (bernstein_linear (S N) u (- c) phi (fun _ => c * h u)), bernstein_const. ring. }
  apply Rabs_le. pose proof (Hdiff 1) as D1. pose proof (Hdiff (-1)) as D2. split.
  - assert (bernstein (S N) (fun k => -1 * (h u - phi k)) u <= bernstein (S N) (fun k => q / n^2 * (k + - (n * u))^2 + eps/2) u).
    { apply bernstein_le; auto. intros k H. specialize (Hb k H). pose proof (Rle_abs (- (h u - phi k))). rewrite Rabs_Ropp in H0. lra. } lra.
  - assert (bernstein (S N) (fun k => 1 * (h u - phi k)) u <= bernstein (S N) (fun k => q / n^2 * (k + - (n * u))^2 + eps/2) u).
    { apply bernstein_le; auto. intros k H. specialize (Hb k H). pose proof (Rle_abs (h u - phi k)). lra. } lra.
Qed.

(** The two integrals: over the eighth of a sphere, and over the height. *)
Definition inner (h : R -> R) v : R := RInt (fun t => h (v * sin t)) 0 (PI/2).
Definition eighth (h : R -> R) : R := RInt (fun s => sin s * inner h (sin s)) 0 (PI/2).

Lemma sin_01 t : 0 <= t <= PI/2 -> 0 <= sin t <= 1.
Proof. intros Ht. split. apply sin_ge_0; lra. apply SIN_bound. Qed.

Lemma cont_at_sin (h : R -> R) v t : (forall u, continuous h u) -> continuous (fun t => h (v * sin t)) t.
Proof.
  intros H. apply (continuous_comp (fun t => v * sin t) h); auto. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma ex_inner (h : R -> R) v : (forall u, continuous h u) -> ex_RInt (fun t => h (v * sin t)) 0 (PI/2).
Proof. intros H. apply ex_cont. intros. apply cont_at_sin; auto. Qed.

Lemma inner_continuous (h : R -> R) v : (forall u, continuous h u) -> continuous (inner h) v.
Proof.
  intros Hc. pose proof PI_RGT_0. apply filterlim_locally. intros eps.
  assert (He : 0 < eps / PI) by (apply Rdiv_lt_0_compat; auto; apply cond_pos). set (b := Rabs v + 1).
  destruct (Heine_cor2 (f := h) (a := - b) (b := b) (fun u _ => proj2 (continuity_pt_filterlim h u) (Hc u)) (mkposreal _ He)) as [d Hd]. simpl in Hd.
  assert (Hm : 0 < Rmin d 1) by (apply Rmin_glb_lt; [apply cond_pos|lra]).
  exists (mkposreal _ Hm). intros y Hy. change (Rabs (y - v) < Rmin d 1) in Hy. change (Rabs (inner h y - inner h v) < eps).
  pose proof (Rmin_l d 1). pose proof (Rmin_r d 1). unfold inner.
  rewrite <- (RInt_minus (V := R_CompleteNormedModule) (fun t => h (y * sin t)) (fun t => h (v * sin t))) by (apply ex_inner; auto).
  apply Rle_lt_trans with ((PI/2 - 0) * (eps / PI)).
  2:{ replace ((PI/2 - 0) * (eps / PI)) with (eps / 2) by (field; lra). pose proof (cond_pos eps). lra. }
  apply abs_RInt_le_const. lra. apply (ex_RInt_minus (V := R_NormedModule)); apply ex_inner; auto.
  intros t Ht. pose proof (sin_01 t Ht) as Hs. change (Rabs (h (y * sin t) - h (v * sin t)) <= eps / PI). left.
  assert (Hv : Rabs (v * sin t) <= Rabs v). { rewrite Rabs_mult, (Rabs_pos_eq (sin t)) by lra. pose proof (Rabs_pos v). nra. }
  assert (Hyv : Rabs (y * sin t - v * sin t) <= Rabs (y - v)).
  { replace (y * sin t - v * sin t) with ((y - v) * sin t) by ring. rewrite Rabs_mult, (Rabs_pos_eq (sin t)) by lra.
    pose proof (Rabs_pos (y - v)). nra. }
  apply Rabs_le_between in Hv. pose proof (proj1 (Rabs_le_between _ _) Hyv). apply Hd; unfold b; lra.
Qed.

Lemma ex_eighth (h : R -> R) : (forall u, continuous h u) -> ex_RInt (fun s => sin s * inner h (sin s)) 0 (PI/2).
Proof.
  intros H. apply ex_cont. intros s. apply (continuous_mult (K := R_AbsRing) sin (fun s => inner h (sin s))).
  - apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
  - apply (continuous_comp sin (inner h)). apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. apply inner_continuous; auto.
Qed.

Lemma eighth_ext (h k : R -> R) : (forall u, 0 <= u <= 1 -> h u = k u) -> eighth h = eighth k.
Proof.
  intros H. pose proof PI_RGT_0. apply RInt_ext. intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra. f_equal.
  apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra.
  apply H. pose proof (sin_01 s ltac:(lra)). pose proof (sin_01 t ltac:(lra)). nra.
Qed.

Lemma cont_linear c (h k : R -> R) u : continuous h u -> continuous k u -> continuous (fun u => c * h u + k u) u.
Proof.
  intros. apply (continuous_plus (V := R_NormedModule) (fun u => c * h u)); auto.
  apply (continuous_scal_r (K := R_AbsRing) (V := R_NormedModule) c h); auto.
Qed.

Lemma RInt_linear c (h k : R -> R) a b : ex_RInt h a b -> ex_RInt k a b ->
  RInt (fun u => c * h u + k u) a b = c * RInt h a b + RInt k a b.
Proof.
  intros Hh Hk. apply is_RInt_unique. apply (is_RInt_plus (V := R_NormedModule) (fun u => c * h u)).
  apply (is_RInt_scal (V := R_NormedModule) h). all: apply (RInt_correct (V := R_CompleteNormedModule)); auto.
Qed.

Lemma eighth_linear c (h k : R -> R) : (forall u, continuous h u) -> (forall u, continuous k u) ->
  eighth (fun u => c * h u + k u) = c * eighth h + eighth k.
Proof.
  intros Hh Hk. unfold eighth. rewrite <- RInt_linear by (apply ex_eighth; auto). apply RInt_ext. intros s _.
  unfold inner at 1. rewrite (RInt_linear c (fun t => h (sin s * sin t)) (fun t => k (sin s * sin t))) by (apply ex_inner; auto).
  fold (inner h (sin s)) (inner k (sin s)). match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
Qed.

Lemma eighth_bound (h : R -> R) eps : (forall u, continuous h u) -> (forall u, 0 <= u <= 1 -> Rabs (h u) <= eps) ->
  Rabs (eighth h) <= PI/2 * (PI/2 * eps).
Proof.
  intros Hc H. pose proof PI_RGT_0. replace (PI/2 * (PI/2 * eps)) with ((PI/2 - 0) * (PI/2 * eps)) by ring.
  apply abs_RInt_le_const. lra. apply ex_eighth; auto. intros s Hs. pose proof (sin_01 s Hs) as S1.
  assert (HI : Rabs (inner h (sin s)) <= PI/2 * eps).
  { replace (PI/2 * eps) with ((PI/2 - 0) * eps) by ring. apply abs_RInt_le_const. lra. apply ex_inner; auto.
    intros t Ht. apply H. pose proof (sin_01 t Ht). nra. }
  rewrite Rabs_mult, (Rabs_pos_eq (sin s)) by lra. pose proof (Rabs_pos (inner h (sin s))). nra.
Qed.

(* Wallis *)
Definition wallis k : R := RInt (fun t => sin t ^ k) 0 (PI/2).

Lemma wallis_W k : wallis (S k) = W (INR (S k)).
Proof.
  pose proof PI_RGT_0. apply RInt_ext. intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. destruct (sin_range t Ht).
  rewrite pw_pos, Rpower_pow by auto. auto.
Qed.

Lemma wallis_product k : (INR k + 1) * (wallis k * wallis (S k)) = PI/2.
Proof.
  destruct k.
  - rewrite wallis_W. change (INR 1) with 1. rewrite W_1. unfold wallis. simpl. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring.
  - rewrite !wallis_W, (S_INR (S k)). apply V_constant. apply lt_0_INR. lia.
Qed.

Lemma cont_pow k u : continuous (fun u => u ^ k) u.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. Qed.

Lemma inner_pow k v : inner (fun u => u ^ k) v = v ^ k * wallis k.
Proof.
  unfold wallis. rewrite <- (RInt_scal (V := R_CompleteNormedModule) (fun t => sin t ^ k)).
  apply RInt_ext. intros t _. apply Rpow_mult_distr.
  apply ex_cont. intros t. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
Qed.

Lemma eighth_pow k : eighth (fun u => u ^ k) = PI/2 * RInt (fun u => u ^ k) 0 1.
Proof.
  assert (H1 : RInt (fun u => u ^ k) 0 1 = / (INR k + 1)).
  { assert (Hk : INR k + 1 <> 0) by (pose proof (pos_INR k); lra). apply is_RInt_unique.
    replace (/ (INR k + 1)) with (minus (/ (INR k + 1) * 1 ^ S k) (/ (INR k + 1) * 0 ^ S k))
      by (rewrite pow1, pow_i by lia; unfold minus, plus, opp; simpl; ring).
    apply (is_RInt_derive (fun u => / (INR k + 1) * u ^ S k)).
    - intros u _. auto_derive. auto. change (match k with O => 1 | S _ => INR k + 1 end) with (INR (S k)). rewrite S_INR. simpl. field. auto.
    - intros u _. apply cont_pow. }
  rewrite H1. assert (INR k + 1 <> 0) by (pose proof (pos_INR k); lra).
  transitivity (wallis k * wallis (S k)). 2: rewrite <- (wallis_product k); field; auto.
  unfold eighth. unfold wallis at 2. rewrite <- (RInt_scal (V := R_CompleteNormedModule) (fun t => sin t ^ S k)).
  2:{ apply ex_cont. intros t. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto. }
  apply RInt_ext. intros s _. rewrite inner_pow. unfold scal; simpl; unfold mult; simpl. ring.
Qed.

(* the statement for u^k p, for every k: it passes from p and q to u p + (1 - u) q *)
Definition fits (p : R -> R) := (forall u, continuous p u) /\
  forall k, eighth (fun u => u ^ k * p u) = PI/2 * RInt (fun u => u ^ k * p u) 0 1.

Lemma cont_pow_mult k p u : (forall u : R, continuous p u) -> continuous (fun u => u ^ k * p u) u.
Proof. intros. apply (continuous_mult (K := R_AbsRing) (fun u => u ^ k) p); auto. apply cont_pow. Qed.

Lemma fits_bernstein N : forall phi, fits (bernstein N phi).
Proof.
  induction N; intros phi.
  - split. intros u. apply (continuous_const (V := R_UniformSpace)). intros k. simpl.
    assert (E : forall u : R, u ^ k * phi 0 = phi 0 * u ^ k + 0) by (intros; ring).
    rewrite (eighth_ext _ (fun u => phi 0 * u ^ k + (fun _ => 0) u)) by (intros; apply E).
    rewrite (RInt_ext _ (fun u => phi 0 * u ^ k + (fun _ => 0) u)) by (intros; apply E).
    assert (C0 : forall u : R, continuous (fun _ : R => 0) u) by (intros; apply (continuous_const (V := R_UniformSpace))).
    rewrite eighth_linear, RInt_linear, eighth_pow; try apply ex_cont; auto; try (intros; apply cont_pow).
    assert (Z : eighth (fun _ => 0) = 0). { pose proof (eighth_linear 1 (fun _ => 0) (fun _ => 0) C0 C0) as H.
      rewrite (eighth_ext _ (fun _ => 0)) in H by (intros; ring). lra. }
    rewrite Z, RInt_const. unfold scal; simpl; unfold mult; simpl. ring.
  - destruct (IHN (fun k => phi (k + 1))) as [Cp Ip]. destruct (IHN phi) as [Cq Iq]. simpl.
    set (p := bernstein N (fun k => phi (k + 1))) in *. set (q := bernstein N phi) in *. clearbody p q. split.
    + intros u. apply (continuous_plus (V := R_NormedModule) (fun u => u * p u)).
      apply (continuous_mult (K := R_AbsRing) (fun u => u) p); auto. apply continuous_id.
      apply (continuous_mult (K := R_AbsRing) (fun u => 1 - u) q); auto.
      apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. auto.
    + intros k. assert (E : forall u, u ^ k * (u * p u + (1 - u) * q u) =
        1 * (fun u => u ^ S k * p u) u + (fun u => -1 * (fun u => u ^ S k * q u) u + (fun u => u ^ k * q u) u) u) by (intros; simpl; ring).
      rewrite (eighth_ext _ _ (fun u _ => E u)), (RInt_ext _ _ _ _ (fun u _ => E u)).
      assert (A : forall j (u : R), continuous (fun u : R => u ^ j * p u) u) by (intros; apply cont_pow_mult; auto).
      assert (B : forall j (u : R), continuous (fun u : R => u ^ j * q u) u) by (intros; apply cont_pow_mult; auto).
      assert (BB : forall u : R, continuous (fun u : R => -1 * (u ^ S k * q u) + u ^ k * q u) u) by (intros; apply cont_linear; auto).
      rewrite (eighth_linear 1 (fun u : R => u ^ S k * p u) _ (A (S k)) BB), (RInt_linear 1 _ _ 0 1 (ex_cont _ 0 1 (A (S k))) (ex_cont _ 0 1 BB)).
      rewrite (RInt_linear (-1) _ _ 0 1 (ex_cont _ 0 1 (B (S k))) (ex_cont _ 0 1 (B k))).
      change (1 * eighth (fun u : R => u ^ S k * p u) + eighth (fun u : R => -1 * (u ^ S k * q u) + u ^ k * q u) =
        PI/2 * (1 * RInt (fun u : R => u ^ S k * p u) 0 1 + (-1 * RInt (fun u : R => u ^ S k * q u) 0 1 + RInt (fun u : R => u ^ k * q u) 0 1))).
      rewrite (eighth_linear (-1) (fun u : R => u ^ S k * q u) (fun u : R => u ^ k * q u) (B (S k)) (B k)).
      rewrite Ip, !Iq. ring.
Qed.

(** Archimedes: over the eighth of a sphere the integral of a continuous function of one coordinate u is π/2 times its integral
    from 0 to 1. *)
Theorem eq_1_1_archimedes (h : R -> R) : (forall u, continuous h u) ->
  RInt (fun s => sin s * RInt (fun t => h (sin s * sin t)) 0 (PI/2)) 0 (PI/2) = PI/2 * RInt h 0 1.
Proof.
  intros Hc. change (eighth h = PI/2 * RInt h 0 1). pose proof PI_RGT_0.
  set (z := eighth h - PI/2 * RInt h 0 1). set (K := PI/2 * (PI/2) + PI/2). assert (HK : 0 < K) by (unfold K; nra).
  assert (Hz : forall eps : posreal, Rabs z <= K * eps).
  { intros eps. destruct (weierstrass h eps Hc) as [N HN]. set (p := bernstein (S N) (fun k => h (k / INR (S N)))) in *.
    destruct (fits_bernstein (S N) (fun k => h (k / INR (S N)))) as [Cp Ip]. fold p in Cp, Ip. specialize (Ip 0%nat).
    set (e := fun u => -1 * p u + h u). assert (Ce : forall u, continuous e u) by (intros; apply cont_linear; auto).
    assert (He : forall u, 0 <= u <= 1 -> Rabs (e u) <= eps).
    { intros u Hu. replace (e u) with (h u - p u) by (unfold e; ring). auto. }
    assert (E1 : eighth e = - eighth p + eighth h) by (unfold e; rewrite eighth_linear by auto; ring).
    assert (E2 : @eq R (RInt e 0 1) (- RInt p 0 1 + RInt h 0 1)) by (unfold e; rewrite RInt_linear by (apply ex_cont; auto); ring).
    assert (E3 : eighth p = PI/2 * RInt p 0 1).
    { rewrite (eighth_ext p (fun u => u ^ 0 * p u)) by (intros; simpl; ring). rewrite Ip. f_equal. apply RInt_ext. intros. simpl.
      match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
    replace z with (eighth e - PI/2 * RInt e 0 1) by (unfold z; rewrite E1, E2, E3; ring).
    pose proof (eighth_bound e eps Ce He) as B1.
    assert (B2 : Rabs (RInt e 0 1) <= (1 - 0) * eps) by (apply abs_RInt_le_const; auto; [lra | apply ex_cont; auto]).
    unfold Rminus at 1. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq (PI/2)) by lra. unfold K. nra. }
  assert (Z : z = 0).
  { destruct (Req_dec z 0) as [|N]; auto. exfalso. pose proof (Rabs_pos_lt z N) as Hp.
    assert (He : 0 < Rabs z / (2 * K)) by (apply Rdiv_lt_0_compat; lra). specialize (Hz (mkposreal _ He)). simpl in Hz.
    replace (K * (Rabs z / (2 * K))) with (Rabs z / 2) in Hz by (field; lra). lra. }
  unfold z in Z. lra.
Qed.
