(** The theorem of Bohr and Mollerup, the half of it that is needed: there is no more than one function on the positive numbers that is
    positive, has Γ(z+1) = zΓ(z), a convex logarithm and Γ(1) = 1. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import MDR.Definitions MDR.Powers.
Open Scope R_scope.

Section Convex.
Variable G : R -> R.
Hypotheses (Gpos : forall z, 0 < z -> 0 < G z) (Gstep : forall z, 0 < z -> G (z+1) = z * G z).
Hypothesis Gconv : forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (G (t*x + (1-t)*y)) <= t * ln (G x) + (1-t) * ln (G y).

Lemma ln_step z : 0 < z -> ln (G (z+1)) = ln z + ln (G z).
Proof. intros. rewrite Gstep, ln_mult; auto. Qed.

(* A chord of the convex logarithm, between those of its two neighbours. *)
Lemma chord z t : 1 < z -> 0 <= t <= 1 -> t * ln (z-1) <= ln (G (z+t)) - ln (G z) <= t * ln z.
Proof.
  intros Hz Ht. split.
  - pose proof (Gconv (z+t) (z-1) (/ (1+t)) ltac:(lra) ltac:(lra)) as H.
    assert (H1 : 0 <= / (1+t) <= 1).
    { split. left; apply Rinv_0_lt_compat; lra. rewrite <- Rinv_1 at 2. apply Rinv_le_contravar; lra. }
    specialize (H H1). replace (/ (1+t) * (z+t) + (1 - / (1+t)) * (z-1)) with z in H by (field; lra).
    pose proof (ln_step (z-1) ltac:(lra)) as H2. replace (z-1+1) with z in H2 by ring.
    apply (Rmult_le_compat_l (1+t)) in H; [|lra].
    replace ((1+t) * (/ (1+t) * ln (G (z+t)) + (1 - / (1+t)) * ln (G (z-1)))) with (ln (G (z+t)) + t * ln (G (z-1))) in H
      by (field; lra).
    nra.
  - pose proof (Gconv (z+1) z t ltac:(lra) ltac:(lra) Ht) as H. replace (t*(z+1) + (1-t)*z) with (z+t) in H by ring.
    rewrite ln_step in H by lra. nra.
Qed.
End Convex.

(** Γ is determined by these properties. *)
Theorem gamma_unique (G H : R -> R) :
  (forall z, 0 < z -> 0 < G z) -> (forall z, 0 < z -> G (z+1) = z * G z) ->
  (forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (G (t*x + (1-t)*y)) <= t * ln (G x) + (1-t) * ln (G y)) -> G 1 = 1 ->
  (forall z, 0 < z -> 0 < H z) -> (forall z, 0 < z -> H (z+1) = z * H z) ->
  (forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 -> ln (H (t*x + (1-t)*y)) <= t * ln (H x) + (1-t) * ln (H y)) -> H 1 = 1 ->
  forall z, 0 < z -> G z = H z.
Proof.
  intros Gpos Gstep Gconv G1 Hpos Hstep Hconv H1.
  set (D z := ln (G z) - ln (H z)).
  assert (Hper : forall z, 0 < z -> D (z+1) = D z) by (intros z Hz; unfold D; rewrite (ln_step G), (ln_step H) by auto; ring).
  assert (Hfar : forall k z, 0 < z -> D (z + INR k) = D z).
  { induction k as [|k IH]; intros z Hz. simpl. f_equal. ring.
    rewrite S_INR, <- Rplus_assoc, Hper by (pose proof (pos_INR k); lra). auto. }
  assert (Hchord : forall z t, 1 < z -> 0 <= t <= 1 -> Rabs (D (z+t) - D z) <= / (z-1)).
  { intros z t Hz Ht. pose proof (chord G Gpos Gstep Gconv z t Hz Ht). pose proof (chord H Hpos Hstep Hconv z t Hz Ht).
    assert (Hl : ln z - ln (z-1) <= / (z-1)).
    { rewrite <- ln_div by lra. replace (z/(z-1)) with (1 + / (z-1)) by (field; lra).
      assert (0 < / (z-1)) by (apply Rinv_0_lt_compat; lra).
      pose proof (exp_ineq1 (/ (z-1)) ltac:(lra)). apply Rle_trans with (ln (exp (/ (z-1)))).
      left; apply ln_increasing; lra. rewrite ln_exp. lra. }
    assert (ln (z-1) < ln z) by (apply ln_increasing; lra). unfold D. apply Rabs_le. nra. }
  assert (Hconst : forall z t, 0 < z -> 0 <= t <= 1 -> D (z+t) = D z).
  { intros z t Hz Ht. destruct (Req_dec (D (z+t)) (D z)) as [e|ne]; auto. exfalso.
    assert (Hd : 0 < Rabs (D (z+t) - D z)) by (apply Rabs_pos_lt; lra). set (e := Rabs _) in *.
    destruct (archimed (/ e + 1)) as [Hk _]. assert (He : 0 < / e) by (apply Rinv_0_lt_compat; auto).
    assert (Hk2 : (0 <= up (/ e + 1))%Z) by (apply le_IZR; lra).
    pose proof (INR_IZR_INZ (Z.to_nat (up (/ e + 1)))) as Hk3. rewrite Z2Nat.id in Hk3 by auto.
    set (k := Z.to_nat _) in *. pose proof (Hchord (z + INR k) t ltac:(lra) Ht) as Hc.
    replace (z + INR k + t) with (z + t + INR k) in Hc by ring. rewrite !Hfar in Hc by lra. fold e in Hc.
    assert (/ e < z + INR k - 1) by lra. apply Rinv_lt_contravar in H0. rewrite Rinv_involutive in H0; lra.
    apply Rmult_lt_0_compat; lra. }
  assert (Hone : D 1 = 0) by (unfold D; rewrite G1, H1; ring).
  assert (Hall : forall k z, 1 <= z <= 1 + INR k -> D z = 0).
  { induction k as [|k IH]; intros z Hz. simpl in Hz. replace z with 1 by lra. auto.
    rewrite S_INR in Hz. destruct (Rle_dec z 2).
    - replace z with (1 + (z-1)) by ring. rewrite Hconst; lra.
    - replace z with (z - 1 + 1) by ring. rewrite Hper by lra. apply IH. lra. }
  intros z Hz. assert (HD : D z = 0).
  { rewrite <- Hper by auto. destruct (archimed z) as [Hk _]. assert (Hk2 : (0 <= up z)%Z) by (apply le_IZR; lra).
    apply (Hall (Z.to_nat (up z))). rewrite INR_IZR_INZ, Z2Nat.id by auto. lra. }
  apply ln_inv; auto. unfold D in HD. lra.
Qed.
