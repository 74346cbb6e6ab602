(** The statement of every step of `mdr derive`, as the program reads it. This file is written by `mdr derive --format coq`;
    a test compares the two. `Steps.v` proves the statements that normal forms decide.

    Every symbol is a positive real number, kap any of them: it is κ_n where the step is about numbers. A step holds where no
    divisor is 0. A refuted step is false as it stands here. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
Require MDR.Definitions MDR.Agm MDR.Profiles MDR.KappaSeries.
Open Scope R_scope.

(** g with its slope g1, its integral G, and the integral Q of its square, up to constants. *)
Definition profile (g g1 G Q : R -> R) : Prop :=
  forall x, 0 < x -> is_derive g x (g1 x) /\ is_derive G x (g x) /\ is_derive Q x (g x ^ 2).

(** Euler's function, by the theorem of Bohr and Mollerup. *)
Definition is_Gamma (Gamma : R -> R) : Prop :=
  Gamma 1 = 1 /\ (forall z, 0 < z -> 0 < Gamma z) /\ (forall z, 0 < z -> Gamma (z + 1) = z * Gamma z) /\
  (forall x y t, 0 < x -> 0 < y -> 0 <= t <= 1 ->
    ln (Gamma (t * x + (1 - t) * y)) <= t * ln (Gamma x) + (1 - t) * ln (Gamma y)).
