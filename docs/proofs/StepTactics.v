(** The tactic `step`, which proves a statement of `Statements.v` as normal forms do: names are written out, integrals and derivatives
    taken by their rules, real powers and roots split into those of single symbols; what is left is an identity of a field. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Powers.
Require Import MDR.Statements.
Open Scope R_scope.
Lemma square_of x : 0 < x -> exists s, 0 < s /\ x = s * s.
Proof. intros H. exists (sqrt x). split. apply sqrt_lt_R0; auto. symmetry; apply sqrt_sqrt; lra. Qed.
Lemma Rpower_half x : 0 < x -> Rpower x (1 / 2) = sqrt x.
Proof. intros. replace (1/2) with (/2) by field. apply Rpower_sqrt; auto. Qed.
Lemma Rpower_3_half x : 0 < x -> Rpower x (3 / 2) = x * sqrt x.
Proof. intros. replace (3/2) with (1 + /2) by field. rewrite Rpower_plus, Rpower_1, Rpower_sqrt; auto. Qed.
Lemma Rpower_two x : 0 < x -> Rpower x 2 = x * x.
Proof. intros. replace 2 with (1 + 1) by ring. rewrite Rpower_plus, Rpower_1; auto. Qed.
Lemma Rpower_three x : 0 < x -> Rpower x 3 = x * x * x.
Proof. intros. replace 3 with (1 + 1 + 1) by ring. rewrite !Rpower_plus, Rpower_1; auto. Qed.
Lemma Rpower_2 x n : Rpower x (2 * n) = Rpower x n * Rpower x n.
Proof. rewrite <- Rpower_plus. f_equal. ring. Qed.

(* Divisors that are not 0. *)
Ltac nonzero := repeat split; first [lra | assumption | apply Rgt_not_eq, Rlt_gt; pos | apply Rlt_not_eq; nra | nra | (intro; nra)].
(* Real powers of one base into those of the plain exponent. *)
Ltac exponents := unfold Rminus; repeat first
  [ rewrite Rpower_half by pos | rewrite Rpower_two by pos | rewrite Rpower_three by pos | rewrite Rpower_3_half by pos | rewrite Rpower_2 | rewrite <- Rpower_mult_distr by pos | rewrite Rpower_plus | rewrite Rpower_Ropp
  | rewrite Rpower_1 by pos ]; fold Rminus.
Ltac atoms := repeat match goal with |- context [Rpower ?x ?e] =>
  let p := fresh "p" in let H := fresh in pose proof (Rp_pos x e) as H; set (p := Rpower x e) in *; clearbody p end.
Lemma sqrt_4 : sqrt 4 = 2. Proof. replace 4 with (2 * 2) by ring. apply sqrt_square. lra. Qed.
Lemma sqrt_9 : sqrt 9 = 3. Proof. replace 9 with (3 * 3) by ring. apply sqrt_square. lra. Qed.
Lemma sqrt_8 : sqrt 8 = 2 * sqrt 2.
Proof. replace 8 with (2 * 2 * 2) by ring. rewrite sqrt_mult, sqrt_square by lra. ring. Qed.
Lemma sqrt_inv_pos x : 0 < x -> sqrt (/ x) = / sqrt x.
Proof. intros. replace (/ x) with (1 / x) by (field; lra). rewrite sqrt_div, sqrt_1 by lra. field. apply Rgt_not_eq, sqrt_lt_R0; auto. Qed.
Ltac split_roots := cbn [pow]; repeat first
  [ rewrite sqrt_4 | rewrite sqrt_8 | rewrite sqrt_9 | rewrite sqrt_mult by (left; pos) | rewrite sqrt_inv_pos by pos | rewrite sqrt_div by (try (left; pos); pos) | rewrite sqrt_square by (left; pos) | rewrite sqrt_1 ].
Ltac roots := split_roots;
  try (generalize PI PI_RGT_0; let pi := fresh "pi" in let H := fresh in intros pi H);
  repeat match goal with |- context [sqrt ?x] => is_var x; 
    let s := fresh "s" in let H := fresh in
    destruct (square_of x) as [s [H ->]]; [assumption | rewrite (sqrt_square s) in * by (left; assumption)] end.
Lemma Q2 : sqrt 2 * sqrt 2 = 2. Proof. apply sqrt_sqrt. lra. Qed.
Lemma Q3 : sqrt 3 * sqrt 3 = 3. Proof. apply sqrt_sqrt. lra. Qed.
Lemma P2 : 0 < sqrt 2. Proof. apply sqrt_lt_R0. lra. Qed.
Lemma P3 : 0 < sqrt 3. Proof. apply sqrt_lt_R0. lra. Qed.
Ltac fields := pose proof Q2; pose proof Q3; pose proof P2; pose proof P3;
  generalize dependent (sqrt 2); generalize dependent (sqrt 3);
  let r3 := fresh in let i3 := fresh in let p3 := fresh in let r2 := fresh in let i2 := fresh in let p2 := fresh in
  intros r3 i3 p3 r2 i2 p2;
  first [ring [i2 i3] | (field; nonzero) | (field_simplify_eq [i2 i3]; [ring [i2 i3] | nonzero])].

(* A derivative by the rules, at a positive point, the innermost first; of a profile by its hypothesis. *)
Ltac in_profile := match goal with H : profile ?g ?g1 ?G ?Q |- ex_derive _ ?x =>
  let Hx := fresh in assert (Hx : 0 < x) by assumption; 
  first [ exact (ex_intro _ _ (proj1 (H x Hx))) | exact (ex_intro _ _ (proj1 (proj2 (H x Hx))))
        | exact (ex_intro _ _ (proj2 (proj2 (H x Hx)))) ] end.
Ltac slope_conditions := repeat split; try assumption; try in_profile; try lra; try (pos; fail); try (apply Rgt_not_eq, Rlt_gt; pos; fail); nonzero.
Ltac known := repeat match goal with H : profile ?g ?g1 ?G ?Q |- context [Derive ?f ?y] =>
  let Hy := fresh in assert (Hy : 0 < y) by assumption;
  first [ replace (Derive f y) with (g1 y) by (symmetry; apply is_derive_unique; exact (proj1 (H y Hy)))
        | replace (Derive f y) with (g y) by (symmetry; apply is_derive_unique; exact (proj1 (proj2 (H y Hy))))
        | replace (Derive f y) with (g y ^ 2) by (symmetry; apply is_derive_unique; exact (proj2 (proj2 (H y Hy)))) ];
  clear Hy end.
Ltac derive_by_rules := apply is_derive_unique; unfold Rpower; auto_derive; [slope_conditions | known; reflexivity].
Ltac refold := repeat match goal with |- context [exp (?e * ln ?x)] => change (exp (e * ln x)) with (Rpower x e) end.
Ltac slopes := repeat
  match goal with
  | |- context [Derive (fun a => Derive ?f a) ?x] =>
    let d := fresh "d" in evar (d : R -> R);
    replace (Derive (fun a => Derive f a) x) with (Derive d x);
    [ subst d | symmetry; apply (Derive_ext_loc (fun a => Derive f a) d x); exists (mkposreal x ltac:(assumption)); 
      let y := fresh "y" in let Hy := fresh in intros y Hy; change (Rabs (y - x) < x) in Hy; apply Rabs_def2 in Hy;
      assert (0 < y) by lra; clear Hy; subst d; cbv beta; derive_by_rules ]
  | |- context [Derive ?f ?x] =>
    let d := fresh "d" in evar (d : R);
    replace (Derive f x) with d; [subst d | subst d; symmetry; derive_by_rules]
  end; refold.
Ltac algebra := exponents; atoms; roots; fields.



(** Integrals from 0. *)
Lemma int_const c a : RInt (fun _ : R => c) 0 a = c * a.
Proof. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. ring. Qed.
Lemma is_int_power c n a : 0 < n -> 0 < a -> is_RInt (fun x => c * Rpower x n) 0 a (c * (Rpower a (n+1) / (n+1))).
Proof. intros. apply (is_RInt_scal (V := R_NormedModule) (fun x => Rpower x n)). apply is_RInt_Rpower; auto. Qed.
Lemma int_power c n a : 0 < n -> 0 < a -> RInt (fun x => c * Rpower x n) 0 a = c * (Rpower a (n+1) / (n+1)).
Proof. intros. apply is_RInt_unique, is_int_power; auto. Qed.
Lemma is_int_gap d c n a : 0 < n -> 0 < a -> is_RInt (fun x => d - c * Rpower x n) 0 a (d * a - c * (Rpower a (n+1) / (n+1))).
Proof.
  intros. replace (d * a) with (scal (a - 0) d) by (unfold scal; simpl; unfold mult; simpl; ring).
  apply (is_RInt_minus (V := R_NormedModule) (fun _ => d)). apply (is_RInt_const (V := R_NormedModule)). apply is_int_power; auto.
Qed.
Lemma int_gap d c n a : 0 < n -> 0 < a -> RInt (fun x => d - c * Rpower x n) 0 a = d * a - c * (Rpower a (n+1) / (n+1)).
Proof. intros. apply is_RInt_unique, is_int_gap; auto. Qed.
Lemma is_int_power_square c n a : 0 < n -> 0 < a ->
  is_RInt (fun x => (c * Rpower x n) ^ 2) 0 a (c ^ 2 * (Rpower a (2*n+1) / (2*n+1))).
Proof.
  intros. apply (is_RInt_ext (fun x => c ^ 2 * Rpower x (2*n))). 2: apply is_int_power; lra.
  intros x _. rewrite Rpower_2. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring.
Qed.
Lemma int_power_square c n a : 0 < n -> 0 < a -> RInt (fun x => (c * Rpower x n) ^ 2) 0 a = c ^ 2 * (Rpower a (2*n+1) / (2*n+1)).
Proof. intros. apply is_RInt_unique, is_int_power_square; auto. Qed.
Lemma int_gap_square d c n a : 0 < n -> 0 < a -> RInt (fun x => (d - c * Rpower x n) ^ 2) 0 a
  = d ^ 2 * a - 2 * d * c * (Rpower a (n+1) / (n+1)) + c ^ 2 * (Rpower a (2*n+1) / (2*n+1)).
Proof.
  intros. apply is_RInt_unique.
  apply (is_RInt_ext (fun x => (d ^ 2 - 2 * d * c * Rpower x n) + (c * Rpower x n) ^ 2)).
  { intros x _. match goal with |- @eq _ ?l ?r => change (@eq R l r) end. ring. }
  apply (is_RInt_plus (V := R_NormedModule) (fun x => d ^ 2 - 2 * d * c * Rpower x n)).
  apply is_int_gap; auto. apply is_int_power_square; auto.
Qed.
Ltac integrals := repeat first [ rewrite int_gap_square by (assumption || lra) | rewrite int_gap by (assumption || lra)
  | rewrite int_power_square by (assumption || lra) | rewrite int_power by (assumption || lra) | rewrite int_const ].

(** The critical radii, as radii at which the power of the profile is known. *)
Section Radii.
Variables n E w C kap : R.
Hypotheses (Hn : 0 < n) (Hh : n <> 1 / 2) (HE : 0 < E) (Hw : 0 < w) (HC : 0 < C) (Hk : 0 < kap).
Let value q a := Rpower a n = q * sqrt (PI * w / (2 * E)) * sqrt a / (n * kap * C).
Lemma of_a_c : 0 < a_c n E w C kap /\ value 1 (a_c n E w C kap).
Proof. unfold value, a_c, B, N. split. apply Rp_pos. rewrite Rmult_1_l. mono. Qed.
Lemma of_a_F : 0 < a_F n E w C kap /\ value 3 (a_F n E w C kap).
Proof. unfold value, a_F, B, N. split. apply Rp_pos. mono. Qed.
Lemma of_a_0 : 0 < a_0 n E w C kap /\ value (2 * n) (a_0 n E w C kap).
Proof. unfold value, a_0, B, N. split. apply Rp_pos. mono. Qed.
Lemma of_a_z : 0 < a_z n E w C kap /\ value (2 * (n + 1)) (a_z n E w C kap).
Proof. unfold value, a_z, B, N. split. apply Rp_pos. mono. Qed.
End Radii.
Ltac at_radius := 
  let use r L n E w C kap :=
    let a := fresh "a" in let Ha := fresh in let Hp := fresh "at_radius" in
    destruct (L n E w C kap) as [Ha Hp]; [lra | lra | assumption | assumption | first [assumption | pos] | assumption |];
    set (a := r n E w C kap) in *; clearbody a in
  match goal with
  | |- context [a_c ?n ?E ?w ?C ?kap] => use a_c of_a_c n E w C kap
  | |- context [a_F ?n ?E ?w ?C ?kap] => use a_F of_a_F n E w C kap
  | |- context [a_0 ?n ?E ?w ?C ?kap] => use a_0 of_a_0 n E w C kap
  | |- context [a_z ?n ?E ?w ?C ?kap] => use a_z of_a_z n E w C kap
  end.
Ltac begin := intros;
  try match goal with H : 0 < ?t < PI / 2 |- _ =>
    assert (0 < sin t) by (apply sin_gt_0; lra); assert (0 < cos t) by (apply cos_gt_0; lra) end;
  unfold d_c, F_c, d_F, F_F in *; cbv zeta in *; try at_radius; 
  try match goal with H : ?n = 1 / 2 |- _ => is_var n; subst n end;
  unfold d_n, F_n, U_n, U, F_g, d_g, lam, C_rho, a_k, h, q_j, dl, B, N in *.
Ltac finish := integrals; slopes; exponents; try match goal with H : Rpower _ _ = _ |- _ => rewrite ?H; clear H end; algebra.
Ltac step := begin; finish.
(** A sign: the side of the inequality is written as what has it. *)
Ltac positive x := match goal with |- ?l > 0 => replace l with x; [apply Rlt_gt; pos | finish] end.
Ltac negative x := match goal with |- ?l < 0 =>
  replace l with (- (x)); [apply Ropp_lt_cancel; rewrite Ropp_0, Ropp_involutive; pos | finish] end.
(** A dimension: both sides are positive. *)
Ltac scaling := intros; cbv zeta; unfold a_c, dl, B, N; mono.
