(** What the theorems speak about. Read this file, then any statement; no proof is needed to understand one.
    Units are free: every statement holds in any consistent system. *)
From Coq Require Import Reals.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(** x^s for s > 0 with the value 0 at x = 0; [Rpower x s] is x^s for x > 0. *)
Definition pw s x := if Rle_dec x 0 then 0 else Rpower x s.

(** The integral of sin^s over a quarter turn. *)
Definition W s := RInt (fun t => pw s (sin t)) 0 (PI/2).

(** κ_n, the factor of (1.12), in the form of (1.1) that has no singularity. Theorem [eq_1_12] shows that it is the factor
    of the MDR transform, [eq_1_12_gamma] that it is the quotient of Gamma functions of the paper. *)
Definition kappa n := (n + 1) * W (n + 1).

(** (1.1) with r = x sin t: g(x) = x ∫ f'(x sin t) dt over a quarter turn; [f1] is f'. *)
Definition transform (f1 : R -> R) x := x * RInt (fun t => f1 (x * sin t)) 0 (PI/2).

Section Contact.
(** E: effective modulus E*; w: work of adhesion per area, the Δγ of the paper. *)
Variables E w : R.

(** (1.4): the critical elongation Δl(a) of the outer springs. *)
Definition dl a := sqrt (2 * PI * a * w / E).

(** B = πw/(2E): (1.10) says that the slope of Δl is sqrt (B/a). *)
Definition B := PI * w / (2 * E).

(** Any profile, by its MDR transform g: the energy U(a, d) of the foundation with the surface energy -πa²w, and the force. *)
Section Profile.
Variable g : R -> R.
Definition U a d := E * RInt (fun x => (d - g x)^2) 0 a - PI * a^2 * w.
Definition F a d := 2 * E * RInt (fun x => d - g x) 0 a.
End Profile.

(** A power law f = C r^n, (1.11). *)
Variables C n : R.

Definition N := n * kappa n * C.

(** (1.13): the indentation in equilibrium at the contact radius a; [slope] is its derivative (theorem [eq_1_14]). *)
Definition dn a := kappa n * C * Rpower a n - dl a.
Definition slope a := n * kappa n * C * Rpower a (n-1) - sqrt (PI * w / (2 * E * a)).

(** (1.16): the force in equilibrium. *)
Definition Fn a := 2 * E * a * (n / (n+1) * kappa n * C * Rpower a n - dl a).

(** The energy of a power law. *)
Definition Un a d := E * RInt (fun x => (d - kappa n * C * Rpower x n)^2) 0 a - PI * a^2 * w.

(** (1.15): corrected, and as it is printed. *)
Definition ac := Rpower (B / N^2) (1 / (2*n - 1)).
Definition ac_printed := Rpower (B / N^2) (1 / (1 - 2*n)).

(** The radius of the equilibrium at d = 0, of the equilibrium without force, and of the fold under controlled force. *)
Definition a0 := Rpower (4 * n^2 * B / N^2) (1 / (2*n - 1)).
Definition az := Rpower (4 * (n+1)^2 * B / N^2) (1 / (2*n - 1)).
Definition aF := Rpower (9 * B / N^2) (1 / (2*n - 1)).

(** The ratio of C to its threshold in (1.19); of use at n = 1/2. *)
Definition rho := kappa n * C / sqrt (2 * PI * w / E).
End Contact.

(** A fold: a radius at which the derivative of a control along the equilibria vanishes. *)
Definition fold (control : R -> R) a := 0 < a /\ is_derive control a 0.

(** How many. *)
Definition none (P : R -> Prop) := forall x, ~ P x.
Definition one (P : R -> Prop) := exists x, P x /\ forall y, P y -> y = x.
Definition two (P : R -> Prop) := exists x y, x < y /\ P x /\ P y /\ forall z, P z -> z = x \/ z = y.
