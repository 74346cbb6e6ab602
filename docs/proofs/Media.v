(** Media other than the half-space, a graded half-space on a machine, the wave of Johnson (1995), and statements that the paper
    makes in words. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers MDR.Stability.
Open Scope R_scope.

Section Media.
(** A contact of the size a: S is the stiffness of a flat punch with the slope S1, g the depth without adhesion, F0 the force without
    adhesion, F0' = S g', and el the elongation at detachment. *)
Variables S S1 g el F0 : R -> R.
Variables a g1 el1 : R.
Hypotheses (HS : is_derive S a (S1 a)) (Hg : is_derive g a g1) (Hl : is_derive el a el1) (HF : is_derive F0 a (S a * g1)).

(** The force along the equilibria d = g - Δl has the slope S d' - S'Δl. *)
Theorem media_force : is_derive (fun x => F0 x - S x * el x) a (S a * (g1 - el1) - S1 a * el a).
Proof.
  auto_derive. repeat split; eexists; eassumption.
  replace (Derive (fun x => F0 x) a) with (S a * g1) by (symmetry; apply is_derive_unique; exact HF).
  replace (Derive (fun x => S x) a) with (S1 a) by (symmetry; apply is_derive_unique; exact HS).
  replace (Derive (fun x => el x) a) with el1 by (symmetry; apply is_derive_unique; exact Hl). ring.
Qed.

(** On a machine of the stiffness k the controlled position d + F/k, times k, is stationary exactly where g' = Δl' + S'Δl/(k + S), and
    grows where g' is larger. *)
Theorem media_machine k : 0 < k + S a ->
  is_derive (fun x => k * (g x - el x) + (F0 x - S x * el x)) a ((k + S a) * (g1 - (el1 + S1 a * el a / (k + S a)))) /\
  ((k + S a) * (g1 - (el1 + S1 a * el a / (k + S a))) = 0 <-> g1 = el1 + S1 a * el a / (k + S a)) /\
  (0 < (k + S a) * (g1 - (el1 + S1 a * el a / (k + S a))) <-> el1 + S1 a * el a / (k + S a) < g1).
Proof.
  intros Hk. split; [|split].
  - replace ((k + S a) * (g1 - (el1 + S1 a * el a / (k + S a)))) with (k * (g1 - el1) + (S a * (g1 - el1) - S1 a * el a))
      by (field; lra).
    auto_derive. repeat split; eexists; eassumption.
    replace (Derive (fun x => F0 x) a) with (S a * g1) by (symmetry; apply is_derive_unique; exact HF).
    replace (Derive (fun x => S x) a) with (S1 a) by (symmetry; apply is_derive_unique; exact HS).
    replace (Derive (fun x => g x) a) with g1 by (symmetry; apply is_derive_unique; exact Hg).
    replace (Derive (fun x => el x) a) with el1 by (symmetry; apply is_derive_unique; exact Hl). ring.
  - set (e := el1 + _). split; intros H. apply Rmult_integral in H. destruct H; lra. rewrite H. ring.
  - set (e := el1 + _). split; intros H. nra. apply Rmult_lt_0_compat; lra.
Qed.
End Media.

(** The energy of any medium, ½∫ S'(d - g)² - wA, has at a fixed depth the slope ½S'((g - d)² - 2wA'/S'): it is stationary where the
    outer springs are stretched by √(2wA'/S'). *)
Theorem media_energy (S1 g A : R -> R) w d a A1 : (forall x, continuous S1 x) -> (forall x, continuous g x) ->
  is_derive A a A1 -> 0 < S1 a ->
  is_derive (fun x => RInt (fun t => S1 t * (d - g t)^2 / 2) 0 x - w * A x) a (S1 a / 2 * ((g a - d)^2 - 2 * w * A1 / S1 a)) /\
  (0 <= 2 * w * A1 / S1 a -> d < g a ->
    (S1 a / 2 * ((g a - d)^2 - 2 * w * A1 / S1 a) = 0 <-> g a - d = sqrt (2 * w * A1 / S1 a))).
Proof.
  intros HS Hg HA Hp. split.
  - replace (S1 a / 2 * ((g a - d)^2 - 2 * w * A1 / S1 a)) with (minus (S1 a * (d - g a)^2 / 2) (w * A1))
      by (unfold minus, plus, opp; simpl; field; lra).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)).
    + apply (RInt_derive (fun t => S1 t * (d - g t)^2 / 2)). intros x.
      apply (continuous_ext (fun t => S1 t * ((d - g t) * (d - g t)) * / 2)).
      { intros t. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. field. }
      apply (continuous_mult (K := R_AbsRing)); [|apply continuous_const].
      apply (continuous_mult (K := R_AbsRing)); [apply HS|].
      assert (continuous (fun t => d - g t) x).
      { apply (continuous_minus (V := R_NormedModule) (fun _ => d)); [apply continuous_const | apply Hg]. }
      apply (continuous_mult (K := R_AbsRing)); assumption.
    + apply (is_derive_scal A); assumption.
  - intros H0 Hd. set (q := 2 * w * A1 / S1 a) in *. split; intros H.
    + assert (Hq : (g a - d)^2 = q) by nra. rewrite <- Hq. symmetry. rewrite <- Rsqr_pow2. apply sqrt_Rsqr. lra.
    + rewrite H. rewrite pow2_sqrt by assumption. ring.
Qed.

(** A graded half-space on a machine. With t² = (3 + χ)/(1 - χ) and s the stiffness of the contact over that of the machine, the
    logarithmic derivative of λ is nowhere above (t - 1)/(t + 1), and reaches it at s = 1/t alone. *)
Theorem graded_machine t s : 1 < t -> 0 < s ->
  (t^2 - 1) * s / ((1 + s) * (1 + t^2 * s)) <= (t - 1) / (t + 1) /\
  ((t^2 - 1) * s / ((1 + s) * (1 + t^2 * s)) = (t - 1) / (t + 1) <-> s = 1 / t).
Proof.
  intros Ht Hs. assert (Hp : 0 < (1 + s) * (1 + t^2 * s)) by (apply Rmult_lt_0_compat; nra).
  assert (He : (t - 1)/(t + 1) - (t^2 - 1) * s / ((1 + s) * (1 + t^2 * s))
    = (t - 1)/(t + 1) * (1 - t * s)^2 / ((1 + s) * (1 + t^2 * s))) by (field; split; nra).
  assert (Hc : 0 < (t - 1)/(t + 1)) by (apply Rdiv_lt_0_compat; lra).
  split.
  - assert (0 <= (t - 1)/(t + 1) * (1 - t * s)^2 / ((1 + s) * (1 + t^2 * s))); [|lra].
    apply Rmult_le_pos. apply Rmult_le_pos. lra. apply pow2_ge_0. left. apply Rinv_0_lt_compat; assumption.
  - split; intros H.
    + assert (H0 : (t - 1)/(t + 1) * (1 - t * s)^2 / ((1 + s) * (1 + t^2 * s)) = 0) by lra.
      unfold Rdiv in H0 at 1. apply Rmult_integral in H0. destruct H0 as [H0|H0].
      * apply Rmult_integral in H0. destruct H0 as [H0|H0]. lra.
        assert (1 - t * s = 0) by (apply Rsqr_0_uniq; rewrite Rsqr_pow2; assumption).
        apply (Rmult_eq_reg_l t); [|lra]. field_simplify; lra.
      * exfalso. apply (Rinv_neq_0_compat ((1 + s) * (1 + t^2 * s))); [lra | assumption].
    + assert (Ht0 : t * s = 1) by (rewrite H; field; lra). rewrite Ht0 in He.
      replace ((1 - 1)^2) with 0 in He by ring. unfold Rdiv in He at 3. rewrite Rmult_0_r, Rmult_0_l in He. lra.
Qed.

(** In n: (1 - χ)/2 and 1 + χ times that bound add up to the printed bound for three folds. *)
Theorem graded_bound chi : -1 < chi < 1 -> let t := sqrt ((3 + chi) / (1 - chi)) in
  1 < t /\ (1 - chi)/2 + (1 + chi) * ((t - 1)/(t + 1)) = (5 - chi)/2 - sqrt ((1 - chi) * (3 + chi)).
Proof.
  intros H t. unfold t. rewrite sqrt_div by lra. rewrite sqrt_mult by lra.
  assert (Hu : 0 < sqrt (3 + chi)) by (apply sqrt_lt_R0; lra). assert (Hv : 0 < sqrt (1 - chi)) by (apply sqrt_lt_R0; lra).
  assert (Hu2 : sqrt (3 + chi) * sqrt (3 + chi) = 3 + chi) by (apply sqrt_sqrt; lra).
  assert (Hv2 : sqrt (1 - chi) * sqrt (1 - chi) = 1 - chi) by (apply sqrt_sqrt; lra).
  set (u := sqrt (3 + chi)) in *. set (v := sqrt (1 - chi)) in *. clearbody u v. split.
  - assert (v < u) by nra. apply (Rmult_lt_reg_r v); [assumption|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - replace ((u/v - 1)/(u/v + 1)) with ((u - v)/(u + v)) by (field; repeat split; lra).
    assert (Hc : chi = 1 - v * v) by lra. assert (Hd : u * u = 4 - v * v) by lra.
    apply (Rmult_eq_reg_r (u + v)); [|lra].
    replace (((1 - chi)/2 + (1 + chi) * ((u - v)/(u + v))) * (u + v)) with ((1 - chi)/2 * (u + v) + (1 + chi) * (u - v))
      by (field; lra).
    rewrite Hc. clear Hc Hu2 Hv2 H. nra.
Qed.

(** The wave of Johnson under a mean pressure, as a function of s = sin²ψ: P = s - α√(tan ψ). *)
Section Wave.
Variable alpha : R.
Hypothesis Ha : 0 < alpha.
Definition wave_pressure s := s - alpha * sqrt (sqrt (s / (1 - s))).

Lemma wave_root s : 0 < s < 1 -> 0 < sqrt (sqrt (s / (1 - s))) /\ (sqrt (sqrt (s / (1 - s))))^4 = s / (1 - s).
Proof.
  intros Hs. assert (Hq : 0 < s / (1 - s)) by (apply Rdiv_lt_0_compat; lra). split.
  - apply sqrt_lt_R0, sqrt_lt_R0; assumption.
  - replace (sqrt (sqrt (s/(1-s))) ^ 4) with ((sqrt (sqrt (s/(1-s))) ^ 2) ^ 2) by ring.
    rewrite !pow2_sqrt; auto. lra. left. apply sqrt_lt_R0; assumption.
Qed.

(** The folds are where α⁴ = 256 s³(1 - s)⁵, and the equilibria are stable where it is less. *)
Theorem wave_fold s : 0 < s < 1 ->
  is_derive wave_pressure s (1 - alpha * sqrt (sqrt (s / (1 - s))) / (4 * s * (1 - s))) /\
  (1 - alpha * sqrt (sqrt (s / (1 - s))) / (4 * s * (1 - s)) = 0 <-> alpha^4 = 256 * s^3 * (1 - s)^5) /\
  (0 < 1 - alpha * sqrt (sqrt (s / (1 - s))) / (4 * s * (1 - s)) <-> alpha^4 < 256 * s^3 * (1 - s)^5).
Proof.
  intros Hs. destruct (wave_root s Hs) as [Hr Hr4]. assert (Hq : 0 < s / (1 - s)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hp : 0 < 4 * s * (1 - s)) by nra.
  split; [|].
  - unfold wave_pressure. assert (Hr2 : 0 < sqrt (s/(1-s))) by (apply sqrt_lt_R0; assumption).
    auto_derive. repeat split; try lra; assumption.
    assert (E2 : sqrt (s/(1-s)) * sqrt (s/(1-s)) = s/(1-s)) by (apply sqrt_sqrt; lra).
    assert (E1 : sqrt (sqrt (s/(1-s))) * sqrt (sqrt (s/(1-s))) = sqrt (s/(1-s))) by (apply sqrt_sqrt; lra).
    unfold Rdiv in E1, E2, Hr, Hr2, Hr4. unfold Rminus, Rdiv in *. set (r := sqrt (sqrt (s * / (1 + - s)))) in *.
    rewrite <- E1 in E2 |- *. clear E1. assert (Hs' : s = (1 + - s) * (r * r * (r * r))) by (rewrite E2; field; lra).
    clearbody r. assert (Hs2 : s = r^4 / (1 + r^4)) by (apply (Rmult_eq_reg_r (1 + r^4)); [field_simplify; nra | nra]).
    rewrite Hs2. field. repeat split; nra.
  - set (r := sqrt (sqrt (s / (1 - s)))) in *.
    assert (E : (alpha * r)^4 * (1 - s) = alpha^4 * s) by (rewrite Rpow_mult_distr, Hr4; field; lra).
    assert (Hm : forall x y, 0 < x -> 0 < y -> (x^4 < y^4 <-> x < y)).
    { intros x y Hx Hy. split; intros H.
      - destruct (Rlt_or_le x y); auto. assert (y^4 <= x^4) by (apply pow_incr; lra). lra.
      - assert (x^2 < y^2) by nra. assert (0 < x^2) by nra. nra. }
    assert (Hx : 0 < alpha * r) by (apply Rmult_lt_0_compat; assumption).
    assert (K : (alpha * r)^4 < (4 * s * (1 - s))^4 <-> alpha^4 < 256 * s^3 * (1 - s)^5).
    { assert (E' : (4 * s * (1 - s))^4 * (1 - s) = (256 * s^3 * (1 - s)^5) * s) by ring. split; intros H.
      - apply (Rmult_lt_reg_r s); [lra|]. rewrite <- E, <- E'. apply Rmult_lt_compat_r; lra.
      - apply (Rmult_lt_reg_r (1 - s)); [lra|]. rewrite E, E'. apply Rmult_lt_compat_r; lra. }
    assert (K' : (4 * s * (1 - s))^4 < (alpha * r)^4 <-> 256 * s^3 * (1 - s)^5 < alpha^4).
    { assert (E' : (4 * s * (1 - s))^4 * (1 - s) = (256 * s^3 * (1 - s)^5) * s) by ring. split; intros H.
      - apply (Rmult_lt_reg_r s); [lra|]. rewrite <- E, <- E'. apply Rmult_lt_compat_r; lra.
      - apply (Rmult_lt_reg_r (1 - s)); [lra|]. rewrite E, E'. apply Rmult_lt_compat_r; lra. }
    assert (G : forall x y, 0 < y -> (0 < 1 - x / y <-> x < y)).
    { intros x y Hy. replace (1 - x / y) with ((y - x) * / y) by (field; lra). assert (0 < / y) by (apply Rinv_0_lt_compat; lra).
      split; intros H0. nra. apply Rmult_lt_0_compat; lra. }
    assert (G' : forall x y, 0 < y -> (1 - x / y = 0 <-> x = y)).
    { intros x y Hy. replace (1 - x / y) with ((y - x) * / y) by (field; lra). assert (0 < / y) by (apply Rinv_0_lt_compat; lra).
      split; intros H0. apply Rmult_integral in H0. destruct H0; lra. rewrite H0. ring. }
    pose proof (Hm _ _ Hx Hp) as M. pose proof (Hm _ _ Hp Hx) as M'.
    assert (T : alpha * r < 4 * s * (1 - s) <-> alpha^4 < 256 * s^3 * (1 - s)^5) by tauto.
    assert (T' : 4 * s * (1 - s) < alpha * r <-> 256 * s^3 * (1 - s)^5 < alpha^4) by tauto.
    rewrite (G _ _ Hp), (G' _ _ Hp). split; [|exact T]. split; intros H.
    + destruct (Rtotal_order (alpha^4) (256 * s^3 * (1 - s)^5)) as [L|[L|L]]; auto.
      apply T in L. lra. apply T' in L. lra.
    + destruct (Rtotal_order (alpha * r) (4 * s * (1 - s))) as [L|[L|L]]; auto.
      apply T in L. lra. apply T' in L. lra.
Qed.
End Wave.

(** s³(1 - s)⁵ grows up to s = 3/8 and then falls, so there are at most two folds, one on either side; its largest value gives α₁⁴ =
    84375/65536, above which there is none. *)
Lemma wave_slope s : is_derive (fun s => s^3 * (1 - s)^5) s (s^2 * (1 - s)^4 * (3 - 8 * s)).
Proof. auto_derive; auto. ring. Qed.

Lemma by_slope (f f1 : R -> R) x y : (forall z, is_derive f z (f1 z)) -> x < y -> (forall z, x < z < y -> 0 < f1 z) -> f x < f y.
Proof.
  intros Hf Hxy Hp. destruct (MVT_cor2 f f1 x y Hxy) as [z [H1 H2]]. intros z _. apply is_derive_Reals, Hf.
  specialize (Hp z H2). nra.
Qed.

Theorem wave_two_folds x y : 0 < x -> x < y ->
  (y <= 3/8 -> x^3 * (1 - x)^5 < y^3 * (1 - y)^5) /\ (3/8 <= x -> y < 1 -> y^3 * (1 - y)^5 < x^3 * (1 - x)^5).
Proof.
  intros Hx Hxy. split; intros.
  - apply (by_slope (fun s => s^3 * (1 - s)^5) (fun s => s^2 * (1 - s)^4 * (3 - 8 * s))); auto. apply wave_slope.
    intros z Hz. repeat apply Rmult_lt_0_compat; try lra; apply pow_lt; lra.
  - assert (- (x^3 * (1 - x)^5) < - (y^3 * (1 - y)^5)); [|lra].
    apply (by_slope (fun s => - (s^3 * (1 - s)^5)) (fun s => - (s^2 * (1 - s)^4 * (3 - 8 * s)))); auto.
    intros z. apply (is_derive_opp (V := R_NormedModule)), wave_slope.
    intros z Hz. replace (- (z^2 * (1 - z)^4 * (3 - 8 * z))) with (z^2 * (1 - z)^4 * (8 * z - 3)) by ring.
    repeat apply Rmult_lt_0_compat; try lra; apply pow_lt; lra.
Qed.

Theorem wave_load_threshold s : 0 < s < 1 ->
  256 * s^3 * (1 - s)^5 <= 84375/65536 /\ (256 * s^3 * (1 - s)^5 = 84375/65536 <-> s = 3/8).
Proof.
  intros Hs. set (t := 1 - s).
  set (q := 9375/262144 * t^6 + 53125/131072 * (s * t^5) + 590625/262144 * (s^2 * t^4) + 83619/65536 * (s^3 * t^3)
    + 130545/262144 * (s^4 * t^2) + 15525/131072 * (s^5 * t) + 3375/262144 * s^6).
  assert (E : 84375/65536 - 256 * s^3 * (1 - s)^5 = 256 * (s - 3/8)^2 * q) by (unfold q, t; field).
  assert (Hq : 0 < q).
  { assert (Ht : 0 < t) by (unfold t; lra). assert (P : forall x k, 0 < x -> 0 < x^k) by (intros; apply pow_lt; assumption).
    unfold q. repeat apply Rplus_lt_0_compat; repeat apply Rmult_lt_0_compat; try apply P; lra. }
  clearbody q. subst t. set (z := (s - 3/8)^2) in *. assert (Hz0 : 0 <= z) by apply pow2_ge_0. split.
  { assert (0 <= 256 * z * q) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra. }
  split; intros H0.
  - assert (Hz : z = 0) by (assert (Hm : z * q = 0) by lra; apply Rmult_integral in Hm; destruct Hm; lra).
    unfold z in Hz. assert (s - 3/8 = 0) by (apply Rsqr_0_uniq; rewrite Rsqr_pow2; assumption). lra.
  - rewrite H0. lra.
Qed.

(** Equilibria without a load have α⁴ = s³(1 - s): none above α₀, α₀⁴ = 27/256, so that surfaces that touch jump to complete contact. *)
Theorem wave_touch_threshold s : 0 < s < 1 -> s^3 * (1 - s) <= 27/256 /\ (s^3 * (1 - s) = 27/256 <-> s = 3/4).
Proof.
  intros Hs. assert (E : 27/256 - s^3 * (1 - s) = (s - 3/4)^2 * (3/16 + s/2 + s^2)) by field.
  assert (Hq : 0 < 3/16 + s/2 + s^2) by nra. set (q := 3/16 + _ + _) in *. clearbody q.
  set (z := (s - 3/4)^2) in *. assert (Hz0 : 0 <= z) by apply pow2_ge_0. split.
  { assert (0 <= z * q) by (apply Rmult_le_pos; lra). lra. }
  split; intros H1.
  - assert (Hz : z = 0) by (assert (Hm : z * q = 0) by lra; apply Rmult_integral in Hm; destruct Hm; lra).
    unfold z in Hz. assert (s - 3/4 = 0) by (apply Rsqr_0_uniq; rewrite Rsqr_pow2; assumption). lra.
  - rewrite H1. lra.
Qed.

(** Complete contact has less energy than separation exactly for α > 1/√(2π). *)
Theorem wave_energy_threshold alpha : 0 < alpha -> (1/4 - PI * alpha^2 / 2 < 0 <-> 1 / sqrt (2 * PI) < alpha).
Proof.
  intros Ha. pose proof PI_RGT_0. assert (Hr : 0 < sqrt (2 * PI)) by (apply sqrt_lt_R0; lra).
  assert (E : sqrt (2 * PI) * sqrt (2 * PI) = 2 * PI) by (apply sqrt_sqrt; lra).
  set (r := sqrt (2 * PI)) in *. clearbody r.
  assert (E1 : 1/4 - PI * alpha^2 / 2 = (1 - r * alpha) * (1 + r * alpha) / 4).
  { replace ((1 - r * alpha) * (1 + r * alpha) / 4) with ((1 - r * r * alpha^2) / 4) by field. rewrite E. field. }
  rewrite E1. assert (Hp : 0 < r * alpha) by nra. set (x := r * alpha) in *. split; intros Hx.
  - apply (Rmult_lt_reg_l r); auto. replace (r * (1 / r)) with 1 by (field; lra). fold x. nra.
  - apply (Rmult_lt_compat_l r) in Hx; auto. replace (r * (1 / r)) with 1 in Hx by (field; lra). fold x in Hx. nra.
Qed.

(** By the approach the α of a fold grows or falls with s as this quadratic in y = 4(1 - s)/L, 0 < y < 1, is positive or negative: it
    grows for s <= 1/4, falls for s >= 3/8, and between them there is one y in (0, 1) at which that changes. *)
Theorem wave_approach s y : 0 < s < 1 -> 0 < y < 1 ->
  (s <= 1/4 -> 0 < y^2 - (3 - 4*s) * y + (3 - 8*s)) /\ (3/8 <= s -> y^2 - (3 - 4*s) * y + (3 - 8*s) < 0) /\
  (1/4 < s < 3/8 -> let z := ((3 - 4*s) - sqrt ((4*s + 3) * (4*s - 1)))/2 in
    0 < z < 1 /\ (0 < y^2 - (3 - 4*s) * y + (3 - 8*s) <-> y < z) /\ (y^2 - (3 - 4*s) * y + (3 - 8*s) < 0 <-> z < y)).
Proof.
  intros Hs Hy. split; [|split]; [intros; nra | intros; nra |].
  intros H z. assert (Hd : 0 < (4*s + 3) * (4*s - 1)) by nra.
  assert (Hr : 0 < sqrt ((4*s + 3) * (4*s - 1))) by (apply sqrt_lt_R0; assumption).
  assert (E : sqrt ((4*s + 3) * (4*s - 1)) * sqrt ((4*s + 3) * (4*s - 1)) = (4*s + 3) * (4*s - 1)) by (apply sqrt_sqrt; lra).
  unfold z. set (r := sqrt _) in *. clearbody r.
  assert (Hr1 : r < 3 - 4*s) by nra. assert (Hr2 : 1 - 4*s < r) by nra. assert (Hr3 : 4*s - 1 < r) by nra.
  assert (Hf : y^2 - (3 - 4*s) * y + (3 - 8*s) = (y - ((3 - 4*s) - r)/2) * (y - ((3 - 4*s) + r)/2)).
  { replace ((y - ((3 - 4*s) - r)/2) * (y - ((3 - 4*s) + r)/2)) with (y^2 - (3 - 4*s) * y + ((3 - 4*s)^2 - r * r)/4) by field.
    rewrite E. field. }
  assert (Hl : y - ((3 - 4*s) + r)/2 < 0) by nra.
  rewrite Hf. split. split; nra. split; split; intros; nra.
Qed.

(** Section 3, "a finite contact radius which is different from that of the non-adhesion problem": it is larger. *)
Theorem paper_radius (g : R -> R) a a0 d l : (forall x y, 0 <= x -> x <= y -> g x <= g y) -> 0 < l -> 0 <= a ->
  g a0 = d -> g a - l = d -> a0 < a.
Proof. intros Hg Hl Ha H0 H1. destruct (Rlt_or_le a0 a); auto. pose proof (Hg a a0 Ha H). lra. Qed.

(** At the instability of n < 1/2, d_c = (1 - 2n)κCa_cⁿ, the two radii have the ratio (1 - 2n)^(-1/n). *)
Theorem paper_ratio n K a a0 : 0 < n < 1/2 -> 0 < K -> 0 < a -> 0 < a0 -> K * Rpower a0 n = (1 - 2*n) * (K * Rpower a n) ->
  a / a0 = Rpower (1 - 2*n) (- (1/n)).
Proof.
  intros Hn HK Ha H0 H. assert (E : Rpower a0 n = (1 - 2*n) * Rpower a n) by nra.
  assert (L : n * ln a0 = ln (1 - 2*n) + n * ln a).
  { apply (f_equal ln) in E. rewrite ln_Rpower, ln_mult, ln_Rpower in E; auto. lra. apply Rp_pos. }
  apply ln_inv. apply Rdiv_lt_0_compat; assumption. apply Rp_pos.
  rewrite ln_div, ln_Rpower by assumption. apply (Rmult_eq_reg_l n); [|lra]. field_simplify; lra.
Qed.

(** Section 3, "convex or concave": q(a) = √a g'(a) decides for any profile. A fold is where q is √(πw/2E), the equilibrium is stable
    where q is larger, and where q is strictly monotone there is no more than one fold. *)
Section Line.
Variables E w : R.
Hypotheses (HE : 0 < E) (Hw : 0 < w).
Variable g1 : R -> R.
Let level := sqrt (PI * w / (2 * E)).
Let slope a := g1 a - sqrt (PI * w / (2 * E * a)).

Lemma line_slope a : 0 < a -> slope a = (sqrt a * g1 a - level) / sqrt a.
Proof.
  intros Ha. pose proof PI_RGT_0. unfold slope, level. assert (0 < sqrt a) by (apply sqrt_lt_R0; assumption).
  replace (PI * w / (2 * E * a)) with (PI * w / (2 * E) / a) by (field; lra).
  assert (0 < PI * w / (2 * E)) by (apply Rdiv_lt_0_compat; nra). rewrite (sqrt_div (PI * w / (2 * E)) a) by lra.
  field. lra.
Qed.

Theorem paper_line a : 0 < a -> (slope a = 0 <-> sqrt a * g1 a = level) /\ (0 < slope a <-> level < sqrt a * g1 a).
Proof.
  intros Ha. rewrite (line_slope a Ha). assert (Hr : 0 < sqrt a) by (apply sqrt_lt_R0; assumption).
  assert (Hi : 0 < / sqrt a) by (apply Rinv_0_lt_compat; assumption). unfold Rdiv. split; split; intros H.
  - apply Rmult_integral in H. destruct H; lra.
  - rewrite H. ring.
  - nra.
  - apply Rmult_lt_0_compat; lra.
Qed.

Theorem paper_one_fold : (forall x y, 0 < x -> x < y -> sqrt x * g1 x < sqrt y * g1 y) \/
  (forall x y, 0 < x -> x < y -> sqrt y * g1 y < sqrt x * g1 x) ->
  forall x y, 0 < x -> 0 < y -> slope x = 0 -> slope y = 0 -> x = y.
Proof.
  intros H x y Hx Hy H1 H2. apply (proj1 (paper_line x Hx)) in H1. apply (proj1 (paper_line y Hy)) in H2.
  destruct (Rtotal_order x y) as [L|[L|L]]; auto; destruct H as [H|H].
  - specialize (H x y Hx L). lra.
  - specialize (H x y Hx L). lra.
  - specialize (H y x Hy L). lra.
  - specialize (H y x Hy L). lra.
Qed.

(** Section 5, touching from the inner or from the outer side: at a fold the slope of d grows exactly where q does. *)
Theorem paper_side a q1 : 0 < a -> is_derive (fun x => sqrt x * g1 x) a q1 -> slope a = 0 ->
  is_derive (fun x => (sqrt x * g1 x - level) / sqrt x) a (q1 / sqrt a).
Proof.
  intros Ha Hq H. assert (Hr : 0 < sqrt a) by (apply sqrt_lt_R0; assumption). apply (proj1 (paper_line a Ha)) in H.
  set (q := fun x => sqrt x * g1 x) in *.
  assert (Hn : is_derive (fun x => q x - level) a q1).
  { replace q1 with (minus q1 0) by (unfold minus, plus, opp; simpl; ring).
    apply (is_derive_minus (K := R_AbsRing) (V := R_NormedModule)); auto. apply (is_derive_const (V := R_NormedModule)). }
  assert (Hs : is_derive sqrt a (/ (2 * sqrt a))) by (auto_derive; auto; field; lra).
  replace (q1 / sqrt a) with ((q1 * sqrt a - (q a - level) * (/ (2 * sqrt a))) / (sqrt a)^2).
  - apply (is_derive_div (fun x => q x - level) sqrt); auto. lra.
  - unfold q at 1. rewrite H. field. lra.
Qed.
End Line.
