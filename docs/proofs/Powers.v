(** Real powers: derivative, integral from 0; tactics for positive monomials. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions.
Open Scope R_scope.

Lemma Rp_pos x y : 0 < Rpower x y. Proof. unfold Rpower; apply exp_pos. Qed.

Lemma ln_Rpower x y : ln (Rpower x y) = y * ln x.
Proof. unfold Rpower; apply ln_exp. Qed.

Lemma is_derive_Rpower a n : 0 < a -> is_derive (fun x => Rpower x n) a (n * Rpower a (n-1)).
Proof.
  intros Ha. unfold Rpower. auto_derive. auto.
  replace ((n-1) * ln a) with (n * ln a + - ln a) by ring.
  rewrite exp_plus, exp_Ropp, exp_ln by auto. field. lra.
Qed.

Lemma pw_pos s x : 0 < x -> pw s x = Rpower x s.
Proof. intros; unfold pw; destruct Rle_dec; lra. Qed.
Lemma pw_neg s x : x <= 0 -> pw s x = 0.
Proof. intros; unfold pw; destruct Rle_dec; lra. Qed.
Lemma pw_ge0 s x : 0 <= pw s x.
Proof. unfold pw; destruct Rle_dec. lra. left; apply Rp_pos. Qed.

Lemma pw_small s eps h : 0 < s -> 0 < eps -> Rabs h < Rpower eps (/ s) -> Rabs (pw s h) < eps.
Proof.
  intros Hs He Hh. destruct (Rle_dec h 0) as [H|H].
  - rewrite pw_neg, Rabs_R0 by auto. auto.
  - rewrite pw_pos by lra. rewrite Rabs_pos_eq by (left; apply Rp_pos).
    rewrite Rabs_pos_eq in Hh by lra.
    replace eps with (Rpower (Rpower eps (/ s)) s).
    2:{ rewrite Rpower_mult, Rinv_l, Rpower_1; lra. }
    apply exp_increasing. apply Rmult_lt_compat_l; auto.
    apply ln_increasing; lra.
Qed.

Lemma is_derive_pw s x : 0 < s -> is_derive (pw (s+1)) x ((s+1) * pw s x).
Proof.
  intros Hs. destruct (Rtotal_order x 0) as [H|[H|H]].
  - rewrite (pw_neg s x) by lra. rewrite Rmult_0_r.
    apply (is_derive_ext_loc (fun _ => 0)).
    + exists (mkposreal (-x) ltac:(lra)). intros y Hy. symmetry. apply pw_neg.
      change (Rabs (y - x) < - x) in Hy. apply Rabs_def2 in Hy. lra.
    + apply (is_derive_const (K := R_AbsRing) (V := R_NormedModule)).
  - subst x. rewrite (pw_neg s 0) by lra. rewrite Rmult_0_r.
    apply is_derive_Reals. intros eps He.
    exists (mkposreal _ (Rp_pos eps (/ s))). simpl. intros h Hh Hd.
    rewrite Rplus_0_l, (pw_neg (s+1) 0) by lra.
    replace ((pw (s+1) h - 0) / h - 0) with (pw s h). apply pw_small; auto.
    destruct (Rle_dec h 0). rewrite !pw_neg by lra. field. auto.
    rewrite !pw_pos by lra. rewrite Rpower_plus, Rpower_1 by lra. field. auto.
  - rewrite pw_pos by auto.
    apply (is_derive_ext_loc (fun x => Rpower x (s+1))).
    + exists (mkposreal x H). intros y Hy. symmetry. apply pw_pos.
      change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. lra.
    + replace s with (s + 1 - 1) at 2 by ring. apply is_derive_Rpower; auto.
Qed.

Lemma continuous_pw s x : 0 < s -> continuous (pw s) x.
Proof.
  intros Hs. destruct (Rtotal_order x 0) as [H|[H|H]].
  - apply (continuous_ext_loc _ (fun _ => 0)). 2: apply continuous_const.
    exists (mkposreal (-x) ltac:(lra)). intros y Hy. symmetry. apply pw_neg.
    change (Rabs (y - x) < - x) in Hy. apply Rabs_def2 in Hy. lra.
  - subst x. apply continuity_pt_filterlim. intros eps He.
    exists (Rpower eps (/ s)). split. apply Rp_pos.
    intros y [_ Hy]. simpl in *. unfold R_dist in *. rewrite (pw_neg s 0) by lra.
    rewrite Rminus_0_r in *. apply pw_small; auto.
  - apply (continuous_ext_loc _ (fun x => Rpower x s)).
    exists (mkposreal x H). intros y Hy. symmetry. apply pw_pos.
    change (Rabs (y - x) < x) in Hy. apply Rabs_def2 in Hy. lra.
    apply (ex_derive_continuous (V := R_NormedModule)). eexists. apply is_derive_Rpower; auto.
Qed.

Lemma is_RInt_pw s a : 0 < s -> is_RInt (pw s) 0 a (pw (s+1) a / (s+1)).
Proof.
  intros Hs.
  replace (pw (s+1) a / (s+1)) with (minus (/ (s+1) * pw (s+1) a) (/ (s+1) * pw (s+1) 0)).
  2:{ rewrite (pw_neg _ 0) by lra. unfold minus, plus, opp; simpl. field; lra. }
  apply (is_RInt_derive (fun x => / (s+1) * pw (s+1) x)).
  - intros x _. replace (pw s x) with (/ (s+1) * ((s+1) * pw s x)) by (field; lra).
    apply (is_derive_scal (pw (s+1))). apply is_derive_pw; auto.
  - intros x _. apply continuous_pw; auto.
Qed.

(* Rpower 0 s is not 0 in Coq, but one point does not matter to an integral. *)
Lemma is_RInt_Rpower s a : 0 < s -> 0 < a -> is_RInt (fun x => Rpower x s) 0 a (Rpower a (s+1) / (s+1)).
Proof.
  intros Hs Ha. rewrite <- pw_pos by auto.
  apply (is_RInt_ext (pw s)). 2: apply is_RInt_pw; auto.
  intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply pw_pos; lra.
Qed.

(** A product, quotient, root or power of positive numbers is positive. *)
Ltac pos := repeat (match goal with
  | |- 0 < _ * _ => apply Rmult_lt_0_compat
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat
  | |- 0 < / _ => apply Rinv_0_lt_compat
  | |- 0 < sqrt _ => apply sqrt_lt_R0
  | |- 0 < _ ^ _ => apply pow_lt
  | |- 0 < Rpower _ _ => apply Rp_pos
  | |- 0 < PI => exact PI_RGT_0
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < _ + _ => first [lra | apply Rplus_lt_0_compat]
  | |- 0 < _ => first [assumption | lra | nra]
  end).

Lemma ln_div x y : 0 < x -> 0 < y -> ln (x / y) = ln x - ln y.
Proof. intros. unfold Rdiv. rewrite ln_mult, ln_Rinv by (try apply Rinv_0_lt_compat; auto). ring. Qed.
Lemma ln_sqrt x : 0 < x -> ln (sqrt x) = / 2 * ln x.
Proof. intros. rewrite <- Rpower_sqrt by auto. apply ln_Rpower. Qed.
Lemma ln_pow' x k : 0 < x -> ln (x ^ k) = INR k * ln x.
Proof. intros. rewrite <- Rpower_pow by auto. apply ln_Rpower. Qed.

Ltac ln_push := repeat (first [ rewrite ln_Rpower | rewrite ln_exp
  | rewrite ln_mult by pos | rewrite ln_div by pos | rewrite ln_Rinv by pos
  | rewrite ln_sqrt by pos | rewrite ln_pow' by pos ]); simpl INR.
(** composite rational numbers: into their primes *)
Ltac primes := rewrite ?ln_1; try replace (ln 4) with (2 * ln 2) by (replace 4 with (2*2) by ring; rewrite ln_mult; lra);
  try replace (ln 8) with (3 * ln 2) by (replace 8 with (2*2*2) by ring; rewrite !ln_mult; lra);
  try replace (ln 9) with (2 * ln 3) by (replace 9 with (3*3) by ring; rewrite ln_mult; lra).
(** equality of two monomials: take logarithms *)
Ltac mono := apply ln_inv; [pos | pos | ln_push; primes; field; repeat split; lra].
Ltac nz := repeat split; try lra; try (apply Rgt_not_eq, Rlt_gt; pos).
