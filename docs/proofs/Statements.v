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

(** ** The formulas that have a name *)
Definition B (E w : R) : R := PI * w / (2 * E).
Definition N (n C kap : R) : R := n * kap * C.
Definition dl (E w a : R) : R := sqrt (2 * PI * a * w / E).
Definition U (E w a d : R) (G Q : R -> R) : R := E * (a * d ^ 2 - 2 * d * (G a) + (Q a)) - PI * a ^ 2 * w.
Definition d_g (E w a : R) (g : R -> R) : R := (g a) - (dl E w a).
Definition F_g (E w a : R) (g G : R -> R) : R := 2 * E * (a * (d_g E w a g) - (G a)).
Definition lam (E a k : R) : R := (k + 6 * E * a) / (k + 2 * E * a).
Definition d_n (n E w C kap a : R) : R := kap * C * Rpower a n - sqrt (2 * PI * a * w / E).
Definition F_n (n E w C kap a : R) : R := 2 * E * a * (n / (n + 1) * kap * C * Rpower a n - sqrt (2 * PI * a * w / E)).
Definition U_n (n E w C kap a d : R) : R := E * RInt (fun x => (d - kap * C * Rpower x n) ^ 2) 0 a - PI * a ^ 2 * w.
Definition a_c (n E w C kap : R) : R := Rpower ((B E w) / (N n C kap) ^ 2) (1 / (2 * n - 1)).
Definition d_c (n E w C kap : R) : R := let a := (a_c n E w C kap) in (d_n n E w C kap a).
Definition F_c (n E w C kap : R) : R := let a := (a_c n E w C kap) in (F_n n E w C kap a).
Definition a_F (n E w C kap : R) : R := Rpower (9 * (B E w) / (N n C kap) ^ 2) (1 / (2 * n - 1)).
Definition d_F (n E w C kap : R) : R := let a := (a_F n E w C kap) in (d_n n E w C kap a).
Definition F_F (n E w C kap : R) : R := let a := (a_F n E w C kap) in (F_n n E w C kap a).
Definition a_0 (n E w C kap : R) : R := Rpower (4 * n ^ 2 * (B E w) / (N n C kap) ^ 2) (1 / (2 * n - 1)).
Definition a_z (n E w C kap : R) : R := Rpower (4 * (n + 1) ^ 2 * (B E w) / (N n C kap) ^ 2) (1 / (2 * n - 1)).
Definition C_rho (E w kap rho : R) : R := rho / kap * sqrt (2 * PI * w / E).
Definition a_k (E k rho : R) : R := k * (rho - 1) / (2 * E * (3 - rho)).
Definition kappa_gamma (n : R) (Gamma : R -> R) : R := sqrt PI / 2 * n * Gamma (n / 2) / Gamma ((n + 1) / 2).
Definition h (s : R) : R := 2 * s / ((1 + s) * (1 + 3 * s)).
Definition q_j (b c j : R) : R := (b + j) / (2 * (c + j)).
Definition P_w (theta alpha : R) : R := (sin theta) ^ 2 - alpha * sqrt ((sin theta) / (cos theta)).
Definition alpha_f (theta : R) : R := 4 * Rpower (sin theta) (3 / 2) * Rpower (cos theta) (5 / 2).
Definition d_p (n E w a Rad : R) : R := a ^ 2 / ((1 + n) * Rad) - sqrt (2 * PI * w * Rpower a (1 - n) / E).
Definition F_p (n E a d Rad : R) : R := 2 * E * RInt (fun x => Rpower x n * (d - x ^ 2 / ((1 + n) * Rad))) 0 a.
Definition a_p (n E w Rad : R) : R := Rpower ((3 + n) ^ 2 * (1 + n) ^ 2 * Rad ^ 2 * (B E w) / 4) (1 / (3 + n)).

(** ** 1.1: The MDR transform *)
(* step_1_1_1: cited *)
(* proved *)
Definition step_1_1_2 : Prop :=
  forall (n C x theta : R), 0 < n -> 0 < C -> 0 < x -> 0 < theta < PI / 2 -> x * (let r := x * (sin theta) in Derive (fun r => C * Rpower r n) r) = n * C * Rpower x n * Rpower (sin theta) (n - 1).
(* proved *)
Definition step_1_1_3 : Prop :=
  forall (n theta : R), 0 < n -> 0 < theta < PI / 2 -> Derive (fun theta => (cos theta) * Rpower (sin theta) n) theta = n * Rpower (sin theta) (n - 1) * (cos theta) ^ 2 - Rpower (sin theta) (n + 1).
(* proved *)
Definition step_1_1_4 : Prop :=
  forall (n theta : R), 0 < n -> 0 < theta < PI / 2 -> n * Rpower (sin theta) (n - 1) * (cos theta) ^ 2 - Rpower (sin theta) (n + 1) = n * Rpower (sin theta) (n - 1) - (n + 1) * Rpower (sin theta) (n + 1).

(** ** 1.2: The stiffness of the springs *)
(* step_1_2_1: cited *)
(* proved *)
Definition step_1_2_2 : Prop :=
  forall (E a : R), 0 < E -> 0 < a -> 2 * RInt (fun x => E) 0 a = 2 * E * a.
(* proved *)
Definition step_1_2_3 : Prop :=
  forall (E k x : R), 0 < E -> 0 < k -> 0 < x -> forall l f : R, 0 < l -> 0 < f -> (let E := Rpower l (- 2) * Rpower f (1) * E in let k := Rpower l (- 1) * Rpower f (1) * k in let x := Rpower l (1) * Rpower f (0) * x in (E * x)) * (k) = (E * x) * (let E := Rpower l (- 2) * Rpower f (1) * E in let k := Rpower l (- 1) * Rpower f (1) * k in let x := Rpower l (1) * Rpower f (0) * x in (k)).

(** ** 1.3: The effective modulus *)
(* step_1_3_1: cited *)
(* proved *)
Definition step_1_3_2 : Prop :=
  forall (E1 E2 nu1 nu2 : R), 0 < E1 -> 0 < E2 -> 0 < nu1 -> 0 < nu2 -> ((1 - nu1 ^ 2) / E1 + (1 - nu2 ^ 2) / E2) <> 0 -> (E2 * (1 - nu1 ^ 2) + E1 * (1 - nu2 ^ 2)) <> 0 -> 1 / ((1 - nu1 ^ 2) / E1 + (1 - nu2 ^ 2) / E2) = E1 * E2 / (E2 * (1 - nu1 ^ 2) + E1 * (1 - nu2 ^ 2)).
(* proved *)
Definition step_1_3_3 : Prop :=
  forall (E1 nu1 : R), 0 < E1 -> 0 < nu1 -> (let nu2 := nu1 in let E2 := E1 in E2 * (1 - nu1 ^ 2) + E1 * (1 - nu2 ^ 2)) <> 0 -> (2 * (1 - nu1 ^ 2)) <> 0 -> (let nu2 := nu1 in let E2 := E1 in E1 * E2 / (E2 * (1 - nu1 ^ 2) + E1 * (1 - nu2 ^ 2))) = E1 / (2 * (1 - nu1 ^ 2)).

(** ** 1.4: The rule of Heß, from the balance of energy *)
(* step_1_4_1: cited *)
(* proved *)
Definition step_1_4_2 : Prop :=
  forall (E w a d : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < d -> Derive (fun a => (U E w a d G Q)) a = E * ((d - (g a)) ^ 2 - 2 * PI * a * w / E).
(* proved *)
Definition step_1_4_3 : Prop :=
  forall (E w a d : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < d -> Derive (fun a => (U E w a d G Q)) a = E * ((g a) - d - (dl E w a)) * ((g a) - d + (dl E w a)).
(* proved *)
Definition step_1_4_4 : Prop :=
  forall (E w a : R), 0 < E -> 0 < w -> 0 < a -> (dl E w a) = 2 * sqrt ((B E w) * a).
(* proved *)
Definition step_1_4_5 : Prop :=
  forall (E w a : R), 0 < E -> 0 < w -> 0 < a -> forall l f : R, 0 < l -> 0 < f -> (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let a := Rpower l (1) * Rpower f (0) * a in ((dl E w a))) * (a) = ((dl E w a)) * (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let a := Rpower l (1) * Rpower f (0) * a in (a)).

(** ** 1.5: The indentation in equilibrium *)
(* proved *)
Definition step_1_5_1 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> (let d := (d_g E w a g) in Derive (fun a => (U E w a d G Q)) a) = 0.
(* proved *)
Definition step_1_5_2 : Prop :=
  forall (E w a d : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < d -> Derive (fun a => (U E w a d G Q)) a = E * (d - (g a) - (dl E w a)) * (d - (g a) + (dl E w a)).

(** ** 1.6: The normal force *)
(* proved *)
Definition step_1_6_1 : Prop :=
  forall (E w a d : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < d -> Derive (fun d => (U E w a d G Q)) d = 2 * E * (a * d - (G a)).
(* proved *)
Definition step_1_6_2 : Prop :=
  forall (n E C kap a d : R), 0 < n -> 0 < E -> 0 < C -> 0 < kap -> 0 < a -> 0 < d -> 2 * E * RInt (fun x => d - kap * C * Rpower x n) 0 a = 2 * E * (a * d - kap * C * Rpower a (n + 1) / (n + 1)).
(* proved *)
Definition step_1_6_3 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> Derive (fun a => (F_g E w a g G)) a = 2 * E * (a * Derive (fun a => (d_g E w a g)) a - (dl E w a)).

(** ** 1.7: Equilibrium as an intersection of two curves *)
(* proved *)
Definition step_1_7_1 : Prop :=
  forall (E w a d : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < d -> (E * ((g a) - d + (dl E w a))) <> 0 -> Derive (fun a => (U E w a d G Q)) a / (E * ((g a) - d + (dl E w a))) = (g a) - d - (dl E w a).

(** ** 1.8: Where the contact shrinks *)
(* proved *)
Definition step_1_8_1 : Prop :=
  forall (E w a delta : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < delta -> (let d := (g a) - ((dl E w a) + delta) in Derive (fun a => (U E w a d G Q)) a) > 0.

(** ** 1.9: Where the contact grows *)
(* proved *)
Definition step_1_9_1 : Prop :=
  forall (E a y delta : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < a -> 0 < y -> 0 < delta -> (let w := E * (y + delta) ^ 2 / (2 * PI * a) in let d := (g a) - y in Derive (fun a => (U E w a d G Q)) a) < 0.
(* proved *)
Definition step_1_9_2 : Prop :=
  forall (E a y delta : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < a -> 0 < y -> 0 < delta -> (let w := E * (y + delta) ^ 2 / (2 * PI * a) in let d := (g a) + y in Derive (fun a => (U E w a d G Q)) a) < 0.
(* proved *)
Definition step_1_9_3 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> (let d := (g a) in Derive (fun a => (U E w a d G Q)) a) < 0.

(** ** 1.10: The condition of instability *)
(* proved *)
Definition step_1_10_1 : Prop :=
  forall (E w a : R), 0 < E -> 0 < w -> 0 < a -> Derive (fun a => (dl E w a)) a = sqrt (PI * w / (2 * E * a)).
(* proved *)
Definition step_1_10_2 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> (let d := (d_g E w a g) in Derive (fun a => Derive (fun a => (U E w a d G Q)) a) a) = 2 * E * (dl E w a) * Derive (fun a => (d_g E w a g)) a.

(** ** 1.11: Power laws and their two regimes *)
(* proved *)
Definition step_1_11_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> kap * C * Rpower a n / (dl E w a) = kap * C / sqrt (2 * PI * w / E) * Rpower a (n - 1 / 2).
(* proved *)
Definition step_1_11_2 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in (d_n n E w C kap a)) = 0.
(* proved *)
Definition step_1_11_3 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in Derive (fun a => (d_n n E w C kap a)) a) > 0.
(* proved *)
Definition step_1_11_4 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in Derive (fun a => (d_n n E w C kap a)) a) < 0.

(** ** 1.12: The transform of a power law and its factor *)
(* theorem *)
Definition step_1_12_1 : Prop :=
  forall (n : R) (Gamma : R -> R), 0 < n -> is_Gamma Gamma -> (n + 1) * RInt (fun theta => Rpower (sin theta) (n + 1)) 0 (PI / 2) = sqrt PI / 2 * n * Gamma (n / 2) / Gamma ((n + 1) / 2).
(* proved *)
Definition step_1_12_2 : Prop :=
  forall (n : R) (Gamma : R -> R), 0 < n -> is_Gamma Gamma -> sqrt PI / 2 * n * Gamma (n / 2) / Gamma ((n + 1) / 2) = sqrt PI * Gamma (1 + n / 2) / Gamma ((n + 1) / 2).
(* proved *)
Definition step_1_12_3 : Prop :=
  Definitions.kappa 1 = PI / 2.
(* proved *)
Definition step_1_12_4 : Prop :=
  Definitions.kappa 2 = 2.

(** ** kappa-recurrences: Recurrences of κ *)
(* definition *)
Definition step_kappa_recurrences_1 : Prop :=
  forall (n : R) (Gamma : R -> R), 0 < n -> is_Gamma Gamma -> Definitions.kappa n = sqrt PI / 2 * n * Gamma (n / 2) / Gamma ((n + 1) / 2).
(* proved *)
Definition step_kappa_recurrences_2 : Prop :=
  forall (n : R), 0 < n -> Definitions.kappa n * Definitions.kappa (n + 1) = PI * (n + 1) / 2.
(* proved *)
Definition step_kappa_recurrences_3 : Prop :=
  forall (n : R), 0 < n -> Definitions.kappa (n + 2) = Definitions.kappa n * (n + 2) / (n + 1).
(* proved *)
Definition step_kappa_recurrences_4 : Prop :=
  Definitions.kappa 4 = 8 / 3.
(* proved *)
Definition step_kappa_recurrences_5 : Prop :=
  Definitions.kappa 3 = 3 * PI / 4.

(** ** kappa-growth: κ grows with n *)
(* proved *)
Definition step_kappa_growth_1 : Prop :=
  forall (n theta : R), 0 < n -> 0 < theta < PI / 2 -> Derive (fun theta => Rpower (sin theta) n) theta = n * Rpower (sin theta) (n - 1) * (cos theta).
(* proved *)
Definition step_kappa_growth_2 : Prop :=
  forall (n eps : R), 0 < n -> 0 < eps -> 2 / n - 2 / (n + eps) > 0.
(* theorem *)
Definition step_kappa_growth_3 : Prop :=
  forall (n : R), 0 < n -> Definitions.kappa (n + 1) > Definitions.kappa n.

(** ** kappa-series: Series for κ without the Gamma function *)
(* theorem *)
Definition step_kappa_series_1 : Prop :=
  forall (n : R) (Gamma : R -> R), 0 < n -> is_Gamma Gamma -> KappaSeries.f n (1 + n / 2) = (kappa_gamma n Gamma).
(* proved *)
Definition step_kappa_series_2 : Prop :=
  forall (b c : R), 0 < b -> 0 < c -> (let j := 0 in (q_j b c j)) = b / (2 * c).
(* proved *)
Definition step_kappa_series_3 : Prop :=
  forall (b c j : R), 0 < b -> 0 < c -> 0 < j -> (let j := j + 1 in (q_j b c j)) = (let c := c + 1 in let b := b + 1 in (q_j b c j)).
(* proved *)
Definition step_kappa_series_4 : Prop :=
  forall (b c j : R), 0 < b -> 0 < c -> 0 < j -> (let j := j + 1 in c / (c + j)) * (c + j) / c = (let c := c + 1 in (q_j b c j)) / (q_j b c j).
(* proved *)
Definition step_kappa_series_5 : Prop :=
  forall (b c j : R), 0 < b -> 0 < c -> 0 < j -> 1 + (c - b) / c * c / (c + j) = 2 * (1 - (q_j b c j)).
(* proved *)
Definition step_kappa_series_6 : Prop :=
  forall (b c z : R), 0 < b -> 0 < c -> 0 < z -> 1 + b / (2 * c) * (2 - (c - b) / (c + 1) * z) = (b + c) / c - b * (c - b) / (2 * c * (c + 1)) * z.
(* proved *)
Definition step_kappa_series_7 : Prop :=
  forall (n m : R), 0 < n -> 0 < m -> (let c := 1 + n / 2 + 2 * m in let b := n + m in (b + c) / c) = (3 * n / 2 + 1 + 3 * m) / (n / 2 + 1 + 2 * m).
(* proved *)
Definition step_kappa_series_8 : Prop :=
  forall (n m : R), 0 < n -> 0 < m -> (let c := 1 + n / 2 + 2 * m in let b := n + m in b * (c - b) / (2 * c * (c + 1))) = (n + m) * (1 - n / 2 + m) / (2 * (n / 2 + 1 + 2 * m) * (n / 2 + 2 + 2 * m)).
(* proved *)
Definition step_kappa_series_9 : Prop :=
  forall (n m : R), 0 < n -> 0 < m -> 1 / 8 - (n + m) * (1 - n / 2 + m) / (2 * (n / 2 + 1 + 2 * m) * (n / 2 + 2 + 2 * m)) = ((3 * n / 2 - 5 / 6) ^ 2 + 47 / 36 + 2 * m) / (8 * (n / 2 + 1 + 2 * m) * (n / 2 + 2 + 2 * m)).
(* proved *)
Definition step_kappa_series_10 : Prop :=
  forall (n m : R), 0 < n -> 0 < m -> 1 + (n + m) * (1 - n / 2 + m) / (2 * (n / 2 + 1 + 2 * m) * (n / 2 + 2 + 2 * m)) = (4 + 4 * n + 13 * m + 9 * n * m / 2 + 9 * m ^ 2) / (2 * (n / 2 + 1 + 2 * m) * (n / 2 + 2 + 2 * m)).
(* proved *)
Definition step_kappa_series_11 : Prop :=
  forall (b c j : R), 0 < b -> 0 < c -> 0 < j -> 1 / 2 - (q_j b c j) = (c - b) / (2 * (c + j)).
(* proved *)
Definition step_kappa_series_12 : Prop :=
  forall (n m : R), 0 < n -> 0 < m -> (let c := 1 + n / 2 + 2 * m in let b := n + m in c - b) = 1 - n / 2 + m.

(** ** kappa-elliptic: κ by an arithmetic-geometric mean *)
(* step_kappa_elliptic_1: cited *)
(* theorem *)
Definition step_kappa_elliptic_2 : Prop :=
  forall (n : R), 0 < n -> RInt (fun theta => 1 / sqrt ((cos theta) ^ 2 + n ^ 2 * (sin theta) ^ 2)) 0 (PI / 2) = PI / (2 * Agm.agm 1 n).
(* theorem *)
Definition step_kappa_elliptic_3 : Prop :=
  Definitions.kappa (1 / 2) = PI / (2 * Agm.agm 1 (sqrt 2)).
(* theorem *)
Definition step_kappa_elliptic_4 : Prop :=
  Definitions.kappa (1 / 3) = PI / (Rpower 3 (1 / 4) * Agm.agm 2 (sqrt (2 + sqrt 3))).
(* theorem *)
Definition step_kappa_elliptic_5 : Prop :=
  Definitions.kappa (1 / 4) = PI * (1 + sqrt 2) / (4 * Agm.agm 1 (1 + sqrt 2)).
(* sampled *)
Definition step_kappa_elliptic_6 : Prop :=
  forall (n : R), 0 < n < 1 / 2 -> Definitions.kappa (1 - n) = Definitions.kappa n * (1 - n) / n * sin (PI * n) / (2 - 2 * (sin (PI * n / 2)) ^ 2).
(* theorem *)
Definition step_kappa_elliptic_7 : Prop :=
  Definitions.kappa (2 / 3) = 2 * Definitions.kappa (1 / 3) / sqrt 3.
(* theorem *)
Definition step_kappa_elliptic_8 : Prop :=
  Definitions.kappa (3 / 4) = 3 * Definitions.kappa (1 / 4) / (1 + sqrt 2).
(* proved *)
Definition step_kappa_elliptic_9 : Prop :=
  forall (n : R), 0 < n -> Definitions.kappa (n + 1) = PI * (n + 1) / (2 * Definitions.kappa n).
(* theorem *)
Definition step_kappa_elliptic_10 : Prop :=
  forall (n : R), 0 < n < 1 / 2 -> Agm.agm (1 + n) (1 - n) < 1 - n ^ 2 / 4.
(* theorem *)
Definition step_kappa_elliptic_11 : Prop :=
  forall (n : R), 0 < n < 1 / 2 -> Agm.agm (1 + n) (1 - n) > 1 - n ^ 2 / 4 - n ^ 4 / 4.

(** ** 1.13: The indentation of a power law *)
(* definition *)
Definition step_1_13_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> (let g := fun a => kap * C * Rpower a n in (d_g E w a g)) = kap * C * Rpower a n - sqrt (2 * PI * a * w / E).
(* proved *)
Definition step_1_13_2 : Prop :=
  forall (n C kap a : R), 0 < n -> 0 < C -> 0 < kap -> 0 < a -> forall l f : R, 0 < l -> 0 < f -> (let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in (kap * C * Rpower a n)) * (a) = (kap * C * Rpower a n) * (let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in (a)).

(** ** 1.14: The condition of instability of a power law *)
(* proved *)
Definition step_1_14_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> Derive (fun a => (d_n n E w C kap a)) a = n * kap * C * Rpower a (n - 1) - sqrt (PI * w / (2 * E * a)).
(* proved *)
Definition step_1_14_2 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> Derive (fun a => (d_n n E w C kap a)) a = sqrt ((B E w) / a) * ((N n C kap) / sqrt (B E w) * Rpower a (n - 1 / 2) - 1).

(** ** 1.15: The critical contact radius *)
(* refuted *)
Definition step_1_15_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> forall l f : R, 0 < l -> 0 < f -> (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in (Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (1 - 2 * n)))) * (a) = (Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (1 - 2 * n))) * (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in (a)).
(* refuted *)
Definition step_1_15_2 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (1 - 2 * n)) in Derive (fun a => (d_n n E w C kap a)) a) = 0.
(* refuted *)
Definition step_1_15_3 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (1 - 2 * n))) ^ 3 = PI * w * Rad ^ 2 / (8 * E).
(* enclosed *)
Definition step_1_15_4 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> kap = Definitions.kappa n -> n = 2 -> C = 1 / 2 -> E = 1 -> w = 1 -> (let a := Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (1 - 2 * n)) in Derive (fun a => (d_n n E w C kap a)) a) > 8 / 5.
(* proved *)
Definition step_1_15_5 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := Rpower (PI * w / (2 * E * n ^ 2 * kap ^ 2 * C ^ 2)) (1 / (2 * n - 1)) in Derive (fun a => (d_n n E w C kap a)) a) = 0.
(* proved *)
Definition step_1_15_6 : Prop :=
  forall (n E w C kap a : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> forall l f : R, 0 < l -> 0 < f -> (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in ((a_c n E w C kap))) * (a) = ((a_c n E w C kap)) * (let E := Rpower l (- 2) * Rpower f (1) * E in let w := Rpower l (- 1) * Rpower f (1) * w in let C := Rpower l (- (n - 1)) * Rpower f (0) * C in let kap := Rpower l (0) * Rpower f (0) * kap in let a := Rpower l (1) * Rpower f (0) * a in (a)).
(* proved *)
Definition step_1_15_7 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in (a_c n E w C kap)) ^ 3 = PI * w * Rad ^ 2 / (8 * E).
(* proved *)
Definition step_1_15_8 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_c n E w C kap) in Derive (fun a => Derive (fun a => (d_n n E w C kap a)) a) a) > 0.
(* proved *)
Definition step_1_15_9 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_c n E w C kap) in Derive (fun a => Derive (fun a => (d_n n E w C kap a)) a) a) < 0.

(** ** 1.16: The force of a power law *)
(* proved *)
Definition step_1_16_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> (let d := (d_n n E w C kap a) in 2 * E * RInt (fun x => d - kap * C * Rpower x n) 0 a) = 2 * E * n / (n + 1) * kap * C * Rpower a (n + 1) - sqrt (8 * PI * a ^ 3 * E * w).
(* proved *)
Definition step_1_16_2 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> 2 * E * n / (n + 1) * kap * C * Rpower a (n + 1) - sqrt (8 * PI * a ^ 3 * E * w) = (F_n n E w C kap a).
(* proved *)
Definition step_1_16_3 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> 2 * E * (a * (d_n n E w C kap a) - RInt (fun x => kap * C * Rpower x n) 0 a) = (F_n n E w C kap a).
(* proved *)
Definition step_1_16_4 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> Derive (fun a => (F_n n E w C kap a)) a = 2 * E * a * ((N n C kap) * Rpower a (n - 1) - 3 * sqrt ((B E w) / a)).

(** ** 1.17: The force at the instability *)
(* proved *)
Definition step_1_17_1 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_c n E w C kap) = - (2 * (2 * n + 1) / (n + 1) * Rpower E (- ((n - 2) / (1 - 2 * n))) * Rpower (PI * w / 2) (- ((n + 1) / (1 - 2 * n))) * Rpower (1 / (n * C * kap)) (- (3 / (1 - 2 * n)))).
(* refuted *)
Definition step_1_17_2 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := Rpower ((B E w) / (N n C kap) ^ 2) (1 / (1 - 2 * n)) in (F_n n E w C kap a)) = - (2 * (2 * n + 1) / (n + 1) * Rpower E (- ((n - 2) / (1 - 2 * n))) * Rpower (PI * w / 2) (- ((n + 1) / (1 - 2 * n))) * Rpower (1 / (n * C * kap)) (- (3 / (1 - 2 * n)))).
(* proved *)
Definition step_1_17_3 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_c n E w C kap) = - (2 * (2 * n + 1) / (n + 1) * E * sqrt (B E w) * Rpower (a_c n E w C kap) (3 / 2)).
(* proved *)
Definition step_1_17_4 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_c n E w C kap) < 0.
(* proved *)
Definition step_1_17_5 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in (F_c n E w C kap)) = - (5 / 6 * PI * w * Rad).

(** ** critical-indentation: The critical indentation, and where the force turns tensile *)
(* proved *)
Definition step_critical_indentation_1 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (d_c n E w C kap) = (1 - 2 * n) / n * sqrt ((B E w) * (a_c n E w C kap)).
(* proved *)
Definition step_critical_indentation_2 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (d_c n E w C kap) < 0.
(* proved *)
Definition step_critical_indentation_3 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (d_c n E w C kap) > 0.
(* proved *)
Definition step_critical_indentation_4 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_z n E w C kap) in (F_n n E w C kap a)) = 0.
(* proved *)
Definition step_critical_indentation_5 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (a_z n E w C kap) / (a_c n E w C kap) = Rpower (4 * (n + 1) ^ 2) (1 / (2 * n - 1)).
(* theorem *)
Definition step_critical_indentation_6 : Prop :=
  forall (n : R), 0 < n < 1 / 2 -> Rpower (4 * (n + 1) ^ 2) (1 / (2 * n - 1)) < 1.
(* proved *)
Definition step_critical_indentation_7 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_c n E w C kap) < 0.

(** ** 1.18: The case n = 1/2 *)
(* proved *)
Definition step_1_18_1 : Prop :=
  forall (n : R) (Gamma : R -> R), n = 1 / 2 -> is_Gamma Gamma -> (kappa_gamma n Gamma) = Rpower PI (3 / 2) * sqrt 2 / (4 * (Gamma (3 / 4)) ^ 2).
(* proved *)
Definition step_1_18_2 : Prop :=
  forall (n E w C kap a : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> kap * C * Rpower a n / (dl E w a) = kap * C / sqrt (2 * PI * w / E).
(* theorem *)
Definition step_1_18_3 : Prop :=
  Definitions.kappa (1 / 2) = PI / (2 * Agm.agm 1 (sqrt 2)).
(* theorem *)
Definition step_1_18_4 : Prop :=
  Definitions.kappa (1 / 2) > 2621 / 2000.
(* theorem *)
Definition step_1_18_5 : Prop :=
  Definitions.kappa (1 / 2) < 2623 / 2000.

(** ** 1.19: The threshold of C at n = 1/2 *)
(* proved *)
Definition step_1_19_1 : Prop :=
  forall (n E w kap a rho : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < rho -> (let C := (C_rho E w kap rho) in (d_n n E w C kap a)) = (rho - 1) * sqrt (2 * PI * w * a / E).
(* definition *)
Definition step_1_19_2 : Prop :=
  forall (E w kap : R), 0 < E -> 0 < w -> 0 < kap -> (let rho := 1 in (C_rho E w kap rho)) = 1 / kap * sqrt (2 * PI * w / E).
(* proved *)
Definition step_1_19_3 : Prop :=
  forall (n E w kap a t : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < t -> (let rho := 1 + t in let C := (C_rho E w kap rho) in (d_n n E w C kap a)) > 0.
(* proved *)
Definition step_1_19_4 : Prop :=
  forall (n E w kap a t : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < t -> (let rho := 1 - t in let C := (C_rho E w kap rho) in (d_n n E w C kap a)) < 0.
(* theorem *)
Definition step_1_19_5 : Prop :=
  1 / Definitions.kappa (1 / 2) = 2 * Agm.agm 1 (sqrt 2) / PI.
(* theorem *)
Definition step_1_19_6 : Prop :=
  1 / Definitions.kappa (1 / 2) > 3051 / 4000.
(* theorem *)
Definition step_1_19_7 : Prop :=
  1 / Definitions.kappa (1 / 2) < 15257 / 20000.

(** ** threshold-force: The threshold of C at n = 1/2 under controlled force *)
(* proved *)
Definition step_threshold_force_1 : Prop :=
  forall (n E w kap a rho : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < rho -> (let C := (C_rho E w kap rho) in (F_n n E w C kap a)) = 2 * E * a * sqrt (2 * PI * w * a / E) * (rho / 3 - 1).
(* proved *)
Definition step_threshold_force_2 : Prop :=
  forall (n E w kap a : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> (let rho := 3 in let C := (C_rho E w kap rho) in (F_n n E w C kap a)) = 0.
(* proved *)
Definition step_threshold_force_3 : Prop :=
  forall (n E w kap a t : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < t -> (let rho := 3 - t in let C := (C_rho E w kap rho) in (F_n n E w C kap a)) < 0.
(* proved *)
Definition step_threshold_force_4 : Prop :=
  forall (n E w kap a t : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < t -> (let rho := 3 + t in let C := (C_rho E w kap rho) in Derive (fun a => (F_n n E w C kap a)) a) > 0.
(* theorem *)
Definition step_threshold_force_5 : Prop :=
  3 / Definitions.kappa (1 / 2) > 228827929 / 100000000.
(* theorem *)
Definition step_threshold_force_6 : Prop :=
  3 / Definitions.kappa (1 / 2) < 22882793 / 10000000.

(** ** critical-force: The instability under controlled force *)
(* proved *)
Definition step_critical_force_1 : Prop :=
  forall (E w a load : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < load -> Derive (fun a => let d := (load + 2 * E * (G a)) / (2 * E * a) in (U E w a d G Q) - load * d) a = E * (((load + 2 * E * (G a)) / (2 * E * a) - (g a)) ^ 2 - (dl E w a) ^ 2).
(* proved *)
Definition step_critical_force_2 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> (let load := ((g a) - (dl E w a)) * 2 * E * a - 2 * E * (G a) in Derive (fun a => E * (((load + 2 * E * (G a)) / (2 * E * a) - (g a)) ^ 2 - (dl E w a) ^ 2)) a) = (dl E w a) / a * Derive (fun a => (F_g E w a g G)) a.
(* proved *)
Definition step_critical_force_3 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> Derive (fun a => (F_g E w a g G)) a = 2 * E * a * ((g1 a) - 3 * sqrt ((B E w) / a)).
(* proved *)
Definition step_critical_force_4 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_F n E w C kap) in Derive (fun a => (F_n n E w C kap a)) a) = 0.
(* proved *)
Definition step_critical_force_5 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (a_F n E w C kap) / (a_c n E w C kap) = Rpower 9 (1 / (2 * n - 1)).
(* proved *)
Definition step_critical_force_6 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (d_F n E w C kap) = (3 - 2 * n) / n * sqrt ((B E w) * (a_F n E w C kap)).
(* proved *)
Definition step_critical_force_7 : Prop :=
  (let n := 3 / 2 in let kap := Definitions.kappa n in (3 - 2 * n) / n) = 0.
(* proved *)
Definition step_critical_force_8 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_F n E w C kap) = 2 * (1 - 2 * n) / (n + 1) * E * sqrt (B E w) * Rpower (a_F n E w C kap) (3 / 2).
(* proved *)
Definition step_critical_force_9 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_F n E w C kap) < 0.
(* proved *)
Definition step_critical_force_10 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_F n E w C kap) > 0.
(* proved *)
Definition step_critical_force_11 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in (F_F n E w C kap)) = - (3 / 2 * PI * w * Rad).
(* proved *)
Definition step_critical_force_12 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_F n E w C kap) in Derive (fun a => Derive (fun a => (F_n n E w C kap a)) a) a) > 0.
(* proved *)
Definition step_critical_force_13 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_F n E w C kap) in Derive (fun a => Derive (fun a => (F_n n E w C kap a)) a) a) < 0.

(** ** maugis-dugdale: Adhesion of finite range, and its limit *)
(* proved *)
Definition step_maugis_dugdale_1 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> Derive (fun theta => theta * (sin theta) + (cos theta)) theta = theta * (cos theta).
(* proved *)
Definition step_maugis_dugdale_2 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> Derive (fun theta => theta + (sin theta) * (cos theta)) theta = 2 * (cos theta) ^ 2.
(* proved *)
Definition step_maugis_dugdale_3 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> theta * (theta + (cos theta) / (sin theta)) - (cos theta) * (theta / (sin theta) + (cos theta) - 1) = theta ^ 2 + (cos theta) - (cos theta) ^ 2.
(* proved *)
Definition step_maugis_dugdale_4 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> (cos theta) ^ 2 * ((sin theta) / (cos theta) + (1 / (cos theta) ^ 2 - 2) * theta) = theta + (sin theta) * (cos theta) - 2 * theta * (cos theta) ^ 2.
(* proved *)
Definition step_maugis_dugdale_5 : Prop :=
  forall (E w a delta : R), 0 < E -> 0 < w -> 0 < a -> 0 < delta -> 2 * w / (E * delta) * a * sqrt (PI * delta / (2 * w / (E * delta) * a)) = (dl E w a).
(* proved *)
Definition step_maugis_dugdale_6 : Prop :=
  forall (E w a delta : R), 0 < E -> 0 < w -> 0 < a -> 0 < delta -> 3 / 2 * (2 * w / (E * delta)) * sqrt (PI * delta / (2 * w / (E * delta) * a)) = 3 * sqrt ((B E w) / a).
(* proved *)
Definition step_maugis_dugdale_7 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in let a := (a_F n E w C kap) in (dl E w a)) = sqrt (2 * PI * Rpower (9 * PI / 8) (1 / 3)) * Rpower (Rad * w ^ 2 / E ^ 2) (1 / 3).

(** ** critical-machine: The instability on a machine of finite stiffness *)
(* proved *)
Definition step_critical_machine_1 : Prop :=
  forall (E w a k delta : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < k -> 0 < delta -> (let d := (k * delta + 2 * E * (G a)) / (k + 2 * E * a) in Derive (fun d => (U E w a d G Q) + k * (delta - d) ^ 2 / 2) d) = 0.
(* proved *)
Definition step_critical_machine_2 : Prop :=
  forall (E w a k : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < k -> (let delta := (((g a) - (dl E w a)) * (k + 2 * E * a) - 2 * E * (G a)) * (/ k ^ 1) in Derive (fun a => E * (((k * delta + 2 * E * (G a)) / (k + 2 * E * a) - (g a)) ^ 2 - (dl E w a) ^ 2)) a) = 2 * E * (dl E w a) / (k + 2 * E * a) * k * Derive (fun a => (d_g E w a g) + (F_g E w a g G) / k) a.
(* proved *)
Definition step_critical_machine_3 : Prop :=
  forall (E w a k : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < k -> k * Derive (fun a => (d_g E w a g) + (F_g E w a g G) / k) a = (k + 2 * E * a) * Derive (fun a => (d_g E w a g)) a - 2 * E * (dl E w a).
(* proved *)
Definition step_critical_machine_4 : Prop :=
  forall (E w a k : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> 0 < k -> k * Derive (fun a => (d_g E w a g) + (F_g E w a g G) / k) a = (k + 2 * E * a) * ((g1 a) - (lam E a k) * sqrt ((B E w) / a)).
(* proved *)
Definition step_critical_machine_5 : Prop :=
  forall (E a : R), 0 < E -> 0 < a -> (let k := 0 in (lam E a k)) = 3.
(* proved *)
Definition step_critical_machine_6 : Prop :=
  forall (E a k : R), 0 < E -> 0 < a -> 0 < k -> (lam E a k) - 1 = 4 * E * a / (k + 2 * E * a).
(* proved *)
Definition step_critical_machine_7 : Prop :=
  forall (E a k : R), 0 < E -> 0 < a -> 0 < k -> 3 - (lam E a k) = 2 * k / (k + 2 * E * a).
(* proved *)
Definition step_critical_machine_8 : Prop :=
  forall (E a k : R), 0 < E -> 0 < a -> 0 < k -> Derive (fun a => (lam E a k)) a > 0.
(* proved *)
Definition step_critical_machine_9 : Prop :=
  forall (n E w C kap a k : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> 0 < k -> k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a = (k + 2 * E * a) * ((N n C kap) * Rpower a (n - 1) - (lam E a k) * sqrt ((B E w) / a)).
(* proved *)
Definition step_critical_machine_10 : Prop :=
  forall (n E w kap a Lambda : R), 0 < n -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < Lambda -> (let C := Lambda * sqrt (B E w) * Rpower a (1 / 2 - n) / (n * kap) in (d_n n E w C kap a)) = (Lambda - 2 * n) / n * sqrt ((B E w) * a).
(* proved *)
Definition step_critical_machine_11 : Prop :=
  forall (n E w kap a Lambda : R), 0 < n -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < Lambda -> (let C := Lambda * sqrt (B E w) * Rpower a (1 / 2 - n) / (n * kap) in (F_n n E w C kap a)) = 2 * (Lambda - 2 * (n + 1)) / (n + 1) * E * a * sqrt ((B E w) * a).

(** ** machine-folds: Up to three folds on a machine *)
(* proved *)
Definition step_machine_folds_1 : Prop :=
  forall (E k s : R), 0 < E -> 0 < k -> 0 < s -> (let a := s * k / (2 * E) in (lam E a k)) = (1 + 3 * s) / (1 + s).
(* proved *)
Definition step_machine_folds_2 : Prop :=
  forall (s : R), 0 < s -> s * Derive (fun s => (1 + 3 * s) / (1 + s)) s * (1 + s) / (1 + 3 * s) = (h s).
(* proved *)
Definition step_machine_folds_3 : Prop :=
  forall (s mu : R), 0 < s -> 0 < mu -> (1 + s) * (1 + 3 * s) * (mu - (h s)) = 3 * mu * s ^ 2 - 2 * (1 - 2 * mu) * s + mu.
(* proved *)
Definition step_machine_folds_4 : Prop :=
  forall (s : R), 0 < s -> 2 - sqrt 3 - (h s) = (2 - sqrt 3) * (1 - sqrt 3 * s) ^ 2 / ((1 + s) * (1 + 3 * s)).
(* proved *)
Definition step_machine_folds_5 : Prop :=
  forall (mu : R), 0 < mu -> (1 - 2 * mu) ^ 2 - 3 * mu ^ 2 = (1 - (2 + sqrt 3) * mu) * (1 - (2 - sqrt 3) * mu).
(* proved *)
Definition step_machine_folds_6 : Prop :=
  1 / 2 + (2 - sqrt 3) = 5 / 2 - sqrt 3.
(* enclosed *)
Definition step_machine_folds_7 : Prop :=
  forall (n E w C kap a k : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> kap = Definitions.kappa n -> 0 < a -> 0 < k -> n = 3 / 5 -> C = 24829 / 10000 -> E = 1 -> w = 1 -> k = 1 -> a = 1 / 100 -> k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a < 0.
(* enclosed *)
Definition step_machine_folds_8 : Prop :=
  forall (n E w C kap a k : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> kap = Definitions.kappa n -> 0 < a -> 0 < k -> n = 3 / 5 -> C = 24829 / 10000 -> E = 1 -> w = 1 -> k = 1 -> a = 3 / 100 -> k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a > 0.
(* enclosed *)
Definition step_machine_folds_9 : Prop :=
  forall (n E w C kap a k : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> kap = Definitions.kappa n -> 0 < a -> 0 < k -> n = 3 / 5 -> C = 24829 / 10000 -> E = 1 -> w = 1 -> k = 1 -> a = 1 -> k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a < 0.
(* enclosed *)
Definition step_machine_folds_10 : Prop :=
  forall (n E w C kap a k : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> kap = Definitions.kappa n -> 0 < a -> 0 < k -> n = 3 / 5 -> C = 24829 / 10000 -> E = 1 -> w = 1 -> k = 1 -> a = 1000 -> k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a > 0.

(** ** machine-half: The fold on a machine at n = 1/2 *)
(* proved *)
Definition step_machine_half_1 : Prop :=
  forall (n E w kap a k rho : R), n = 1 / 2 -> 0 < E -> 0 < w -> 0 < kap -> 0 < a -> 0 < k -> 0 < rho -> (let C := (C_rho E w kap rho) in k * Derive (fun a => (d_n n E w C kap a) + (F_n n E w C kap a) / k) a) = (k + 2 * E * a) * sqrt ((B E w) / a) * (rho - (lam E a k)).
(* proved *)
Definition step_machine_half_2 : Prop :=
  forall (E k rho : R), 0 < E -> 0 < k -> 0 < rho -> (2 * E * (3 - rho)) <> 0 -> (let a := (a_k E k rho) in k + 2 * E * a) <> 0 -> (let a := (a_k E k rho) in (lam E a k)) = rho.

(** ** universal-curves: Universal curves *)
(* proved *)
Definition step_universal_curves_1 : Prop :=
  forall (n E w C kap t : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> (let a := t * (a_c n E w C kap) in (d_n n E w C kap a)) = - ((d_c n E w C kap) * (Rpower t n - 2 * n * Rpower t (1 / 2)) / (2 * n - 1)).
(* proved *)
Definition step_universal_curves_2 : Prop :=
  forall (n E w C kap t : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> (let a := t * (a_c n E w C kap) in (d_n n E w C kap a)) = (d_c n E w C kap) * (Rpower t n - 2 * n * Rpower t (1 / 2)) / (1 - 2 * n).
(* proved *)
Definition step_universal_curves_3 : Prop :=
  forall (n E w C kap t : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> (let a := t * (a_c n E w C kap) in (F_n n E w C kap a)) = - ((F_c n E w C kap) * (Rpower t (n + 1) - 2 * (n + 1) * Rpower t (3 / 2)) / (2 * n + 1)).

(** ** work-pull-off: The energy lost when the contact breaks *)
(* proved *)
Definition step_work_pull_off_1 : Prop :=
  forall (n E w C kap a d : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> 0 < d -> E * (a * d ^ 2 - 2 * d * RInt (fun x => kap * C * Rpower x n) 0 a + RInt (fun x => (kap * C * Rpower x n) ^ 2) 0 a) - PI * a ^ 2 * w = (U_n n E w C kap a d).
(* proved *)
Definition step_work_pull_off_2 : Prop :=
  forall (n E w C kap a d : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> 0 < d -> Derive (fun a => (U_n n E w C kap a d)) a = E * ((d - kap * C * Rpower a n) ^ 2 - (dl E w a) ^ 2).
(* proved *)
Definition step_work_pull_off_3 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_c n E w C kap) in let d := (d_n n E w C kap a) in (U_n n E w C kap a d)) = n * (2 * n - 1) / ((n + 1) * (2 * n + 1)) * PI * (a_c n E w C kap) ^ 2 * w.
(* proved *)
Definition step_work_pull_off_4 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_c n E w C kap) in let d := (d_n n E w C kap a) in (U_n n E w C kap a d)) > 0.
(* proved *)
Definition step_work_pull_off_5 : Prop :=
  (let n := 2 in let kap := Definitions.kappa n in n * (2 * n - 1) / ((n + 1) * (2 * n + 1))) = 2 / 5.

(** ** work-jump-in: The energy lost when the surfaces jump into contact *)
(* proved *)
Definition step_work_jump_in_1 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in let d := 0 in (U_n n E w C kap a d)) = - ((2 * n - 1) / (2 * n + 1) * PI * (a_0 n E w C kap) ^ 2 * w).
(* proved *)
Definition step_work_jump_in_2 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in let d := 0 in (U_n n E w C kap a d)) < 0.
(* proved *)
Definition step_work_jump_in_3 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_0 n E w C kap) in let d := 0 in (U_n n E w C kap a d)) > 0.
(* proved *)
Definition step_work_jump_in_4 : Prop :=
  (let n := 2 in let kap := Definitions.kappa n in (2 * n - 1) / (2 * n + 1)) = 3 / 5.

(** ** hysteresis: Two works of adhesion: the preload, the pull-off and the loop *)
(* proved *)
Definition step_hysteresis_1 : Prop :=
  forall (n E w C kap t : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> (let a := (a_F n E w C kap) in let w := t ^ 2 * w in (F_n n E w C kap a)) = - ((F_F n E w C kap) * (3 - 2 * (n + 1) * t) / (2 * n - 1)).
(* proved *)
Definition step_hysteresis_2 : Prop :=
  forall (n : R), 1 / 2 < n -> (let t := 3 / (2 * (n + 1)) in 3 - 2 * (n + 1) * t) = 0.
(* proved *)
Definition step_hysteresis_3 : Prop :=
  forall (n : R), 1 / 2 < n -> (3 / (2 * (n + 1))) ^ 2 = 9 / (4 * (n + 1) ^ 2).
(* proved *)
Definition step_hysteresis_4 : Prop :=
  (let n := 2 in let kap := Definitions.kappa n in 9 / (4 * (n + 1) ^ 2)) = 1 / 4.
(* proved *)
Definition step_hysteresis_5 : Prop :=
  (let n := 1 in let kap := Definitions.kappa n in 9 / (4 * (n + 1) ^ 2)) = 9 / 16.
(* proved *)
Definition step_hysteresis_6 : Prop :=
  forall (n E w C kap t : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> (let a := (a_c n E w C kap) in let w := t ^ 2 * w in (d_n n E w C kap a)) = - ((d_c n E w C kap) * (1 - 2 * n * t) / (2 * n - 1)).
(* proved *)
Definition step_hysteresis_7 : Prop :=
  forall (n E w C kap a : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> (let d := (d_n n E w C kap a) in (U_n n E w C kap a d)) = E * a * ((n / (n + 1) * kap * C * Rpower a n - (dl E w a)) ^ 2 + (n * kap * C * Rpower a n / (n + 1)) ^ 2 / (2 * n + 1)) - PI * a ^ 2 * w.
(* proved *)
Definition step_hysteresis_8 : Prop :=
  forall (n E w C kap t : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < t -> - (let a := let w := t ^ 2 * w in (a_0 n E w C kap) in let d := 0 in let w := t ^ 2 * w in (U_n n E w C kap a d)) = (2 * n - 1) / (2 * n + 1) * PI * (let w := t ^ 2 * w in (a_0 n E w C kap)) ^ 2 * t ^ 2 * w.

(** ** kendall: Kendall's flat punch as the limit of large n *)
(* proved *)
Definition step_kendall_1 : Prop :=
  forall (n E w kap Rad delta : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < kap -> 0 < Rad -> 0 < delta -> (let C := delta * Rpower Rad (- n) in (a_c n E w C kap)) = Rad * Rpower ((B E w) * Rad / (n ^ 2 * kap ^ 2 * delta ^ 2)) (1 / (2 * n - 1)).
(* theorem *)
Definition step_kendall_2 : Prop :=
  forall (n : R), 0 < n -> (Definitions.kappa n) ^ 2 > PI * n / 2.
(* theorem *)
Definition step_kendall_3 : Prop :=
  forall (n : R), 0 < n -> (Definitions.kappa n) ^ 2 < PI * (n + 1) / 2.
(* proved *)
Definition step_kendall_4 : Prop :=
  forall (n : R), 0 < n -> 2 * (2 * n + 1) / (n + 1) = 4 - 2 / (n + 1).
(* proved *)
Definition step_kendall_5 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> 4 * E * sqrt (B E w) * Rpower Rad (3 / 2) = sqrt (8 * PI * Rad ^ 3 * E * w).
(* proved *)
Definition step_kendall_6 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> 2 * sqrt ((B E w) * Rad) = (let a := Rad in (dl E w a)).
(* enclosed *)
Definition step_kendall_7 : Prop :=
  forall (n E w kap Rad delta : R), 1 / 2 < n -> 0 < E -> 0 < w -> kap = Definitions.kappa n -> 0 < Rad -> 0 < delta -> n = 10000 -> E = 1 -> w = 1 -> Rad = 1 -> delta = 1 -> (let C := delta * Rpower Rad (- n) in (F_c n E w C kap)) < - (997 / 1000 * sqrt (8 * PI * Rad ^ 3 * E * w)).
(* enclosed *)
Definition step_kendall_8 : Prop :=
  forall (n E w kap Rad delta : R), 1 / 2 < n -> 0 < E -> 0 < w -> kap = Definitions.kappa n -> 0 < Rad -> 0 < delta -> n = 10000 -> E = 1 -> w = 1 -> Rad = 1 -> delta = 1 -> (let C := delta * Rpower Rad (- n) in (F_c n E w C kap)) > - (999 / 1000 * sqrt (8 * PI * Rad ^ 3 * E * w)).

(** ** wavy: A paraboloid with waves *)
(* theorem *)
Definition step_wavy_1 : Prop :=
  forall (z : R), 0 < z -> RInt (fun theta => sin (z * (sin theta))) 0 (PI / 2) = PI / 2 * Profiles.struve z.
(* proved *)
Definition step_wavy_2 : Prop :=
  forall (Rad x : R), 0 < Rad -> 0 < x -> (let n := 2 in let kap := Definitions.kappa n in kap) * x ^ 2 / (2 * Rad) = x ^ 2 / Rad.

(** ** media: Every elastic medium is a row of springs *)
(* proved *)
Definition step_media_1 : Prop :=
  forall (w y Stiff1 Area1 : R), 0 < w -> 0 < y -> 0 < Stiff1 -> 0 < Area1 -> Stiff1 * y ^ 2 / 2 - w * Area1 = Stiff1 / 2 * (y ^ 2 - 2 * w * Area1 / Stiff1).
(* proved *)
Definition step_media_2 : Prop :=
  forall (E w a : R), 0 < E -> 0 < w -> 0 < a -> (let Stiff1 := 2 * E in let Area1 := 2 * PI * a in sqrt (2 * w * Area1 / Stiff1)) = (dl E w a).
(* proved *)
Definition step_media_3 : Prop :=
  forall (E w a Rad : R), 0 < E -> 0 < w -> 0 < a -> 0 < Rad -> (let Stiff1 := 2 * E * a / Rad in let Area1 := 2 * PI * a in sqrt (2 * w * Area1 / Stiff1)) = sqrt (2 * PI * w * Rad / E).
(* proved *)
Definition step_media_4 : Prop :=
  forall (a Stiff Stiff1 el el1 : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < a -> 0 < Stiff -> 0 < Stiff1 -> 0 < el -> 0 < el1 -> Stiff * (g1 a) - (Stiff1 * el + Stiff * el1) = Stiff * ((g1 a) - el1) - Stiff1 * el.
(* proved *)
Definition step_media_5 : Prop :=
  forall (a k Stiff Stiff1 el el1 : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < a -> 0 < k -> 0 < Stiff -> 0 < Stiff1 -> 0 < el -> 0 < el1 -> k * ((g1 a) - el1) + Stiff * ((g1 a) - el1) - Stiff1 * el = (k + Stiff) * ((g1 a) - (el1 + Stiff1 * el / (k + Stiff))).
(* proved *)
Definition step_media_6 : Prop :=
  forall (a k Stiff el xi eta : R), 0 < a -> 0 < k -> 0 < Stiff -> 0 < el -> 0 < xi -> 0 < eta -> (let el1 := eta * el / a in let Stiff1 := xi * Stiff / a in (el1 + Stiff1 * el / (k + Stiff)) / el1) = 1 + xi / eta * Stiff / (k + Stiff).
(* proved *)
Definition step_media_7 : Prop :=
  forall (E a k : R), 0 < E -> 0 < a -> 0 < k -> (let Stiff := 2 * E * a in let eta := 1 / 2 in let xi := 1 in 1 + xi / eta * Stiff / (k + Stiff)) = (lam E a k).

(** ** graded: Half-spaces with a modulus that is a power of the depth *)
(* step_graded_1: cited *)
(* proved *)
Definition step_graded_2 : Prop :=
  forall (s chi : R), 0 < s -> 0 < chi -> (let eta := (1 - chi) / 2 in let xi := 1 + chi in eta) <> 0 -> (let eta := (1 - chi) / 2 in let xi := 1 + chi in 1 + xi / eta * s / (1 + s)) * (1 - chi) = (1 - chi) + 2 * (1 + chi) * s / (1 + s).
(* proved *)
Definition step_graded_3 : Prop :=
  forall (chi : R), 0 < chi -> (1 - chi) + 2 * (1 + chi) = 3 + chi.
(* proved *)
Definition step_graded_4 : Prop :=
  forall (n chi : R), 0 < n -> 0 < chi -> (let Lambda := 1 - chi in Lambda / n - 2) = (1 - chi - 2 * n) / n.
(* proved *)
Definition step_graded_5 : Prop :=
  forall (n Lambda chi : R), 0 < n -> 0 < Lambda -> 0 < chi -> Lambda - 2 * (n + 1 + chi) = (Lambda / n - 2) * (n + 1 + chi) - Lambda * (1 + chi) / n.
(* proved *)
Definition step_graded_6 : Prop :=
  forall (n chi : R), 0 < n -> 0 < chi -> (let Lambda := 1 - chi in Lambda - 2 * (n + 1 + chi)) = - (2 * n + 1 + 3 * chi).
(* proved *)
Definition step_graded_7 : Prop :=
  forall (n chi : R), 0 < n -> 0 < chi -> (let Lambda := 3 + chi in Lambda - 2 * (n + 1 + chi)) = 1 - chi - 2 * n.
(* proved *)
Definition step_graded_8 : Prop :=
  forall (t s : R), 0 < t -> 0 < s -> (t - 1) / (t + 1) - (t ^ 2 - 1) * s / ((1 + s) * (1 + t ^ 2 * s)) = (t - 1) / (t + 1) * (1 - t * s) ^ 2 / ((1 + s) * (1 + t ^ 2 * s)).
(* proved *)
Definition step_graded_9 : Prop :=
  forall (t : R), 0 < t -> (let chi := (t ^ 2 - 3) / (1 + t ^ 2) in (1 - chi) / 2 + (1 + chi) * (t - 1) / (t + 1)) = (let chi := (t ^ 2 - 3) / (1 + t ^ 2) in (5 - chi) / 2) - 4 * t / (1 + t ^ 2).
(* proved *)
Definition step_graded_10 : Prop :=
  forall (t : R), 0 < t -> (let chi := (t ^ 2 - 3) / (1 + t ^ 2) in (1 - chi) * (3 + chi)) = (4 * t / (1 + t ^ 2)) ^ 2.
(* proved *)
Definition step_graded_11 : Prop :=
  forall (n E w Rad : R), 0 < n -> 0 < E -> 0 < w -> 0 < Rad -> (let a := (a_p n E w Rad) in Derive (fun a => let d := (d_p n E w a Rad) in (F_p n E a d Rad)) a) = 0.
(* proved *)
Definition step_graded_12 : Prop :=
  forall (n E w Rad : R), 0 < n -> 0 < E -> 0 < w -> 0 < Rad -> (let a := (a_p n E w Rad) in let d := (d_p n E w a Rad) in (F_p n E a d Rad)) = - ((3 + n) / 2 * PI * w * Rad).

(** ** line-contact: Line contact of a half-plane *)
(* proved *)
Definition step_line_contact_1 : Prop :=
  forall (n : R), 0 < n -> n * Definitions.kappa (n + 1) / (n + 1) = PI * n / (2 * Definitions.kappa n).
(* proved *)
Definition step_line_contact_2 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> E * (d_c n E w C kap) = - ((2 * n - 1) / (2 * n) * sqrt (2 * PI * E * w * (a_c n E w C kap))).
(* proved *)
Definition step_line_contact_3 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in let kap := PI / 2 in (a_c n E w C kap)) ^ 3 = 2 * w * Rad ^ 2 / (PI * E).
(* proved *)
Definition step_line_contact_4 : Prop :=
  forall (E w Rad : R), 0 < E -> 0 < w -> 0 < Rad -> (let C := 1 / (2 * Rad) in let n := 2 in let kap := Definitions.kappa n in let kap := PI / 2 in E * (d_c n E w C kap)) ^ 3 = - (27 / 16 * PI * E * w ^ 2 * Rad).
(* theorem *)
Definition step_line_contact_5 : Prop :=
  4 * Definitions.kappa (1 / 2) / PI > 16692536833 / 10000000000.
(* theorem *)
Definition step_line_contact_6 : Prop :=
  4 * Definitions.kappa (1 / 2) / PI < 8346268417 / 5000000000.
(* proved *)
Definition step_line_contact_7 : Prop :=
  forall (n E w C kap : R), 1 / 2 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 2 * w * (a_0 n E w C kap) - RInt (fun x => 2 * w * Rpower (x / (a_0 n E w C kap)) (2 * n - 1)) 0 (a_0 n E w C kap) = (2 - 1 / n) * w * (a_0 n E w C kap).

(** ** wave: Slightly wavy surfaces *)
(* step_wave_1: cited *)
(* proved *)
Definition step_wave_2 : Prop :=
  forall (theta alpha Pm : R), 0 < theta < PI / 2 -> 0 < alpha -> 0 < Pm -> Derive (fun theta => (sin theta) ^ 4 / 4 - Pm * (sin theta) ^ 2 - alpha ^ 2 * theta) theta + Pm ^ 2 * (cos theta) / (sin theta) = alpha ^ 2 * ((cos theta) / (sin theta) * ((sin theta) ^ 2 - Pm) ^ 2 / alpha ^ 2 - 1).
(* proved *)
Definition step_wave_3 : Prop :=
  forall (theta alpha : R), 0 < theta < PI / 2 -> 0 < alpha -> (cos theta) * ((sin theta) ^ 2 - (P_w theta alpha)) ^ 2 = alpha ^ 2 * (sin theta).
(* proved *)
Definition step_wave_4 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> (let alpha := (alpha_f theta) in Derive (fun theta => (P_w theta alpha)) theta) = 0.
(* proved *)
Definition step_wave_5 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> (let alpha := (alpha_f theta) in (P_w theta alpha)) = (sin theta) ^ 2 * (4 * (sin theta) ^ 2 - 3).
(* proved *)
Definition step_wave_6 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> Derive (fun theta => (alpha_f theta)) theta = 2 * Rpower (sin theta) (1 / 2) * Rpower (cos theta) (3 / 2) * (3 - 8 * (sin theta) ^ 2).
(* proved *)
Definition step_wave_7 : Prop :=
  256 * (3 / 8) ^ 3 * (5 / 8) ^ 5 = 84375 / 65536.
(* proved *)
Definition step_wave_8 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> (let alpha := sqrt ((sin theta) ^ 3 * (cos theta)) in (P_w theta alpha)) = 0.
(* proved *)
Definition step_wave_9 : Prop :=
  forall (theta : R), 0 < theta < PI / 2 -> Derive (fun theta => (sin theta) ^ 3 * (cos theta)) theta = (sin theta) ^ 2 * (3 - 4 * (sin theta) ^ 2).
(* proved *)
Definition step_wave_10 : Prop :=
  (3 / 4) ^ 3 / 4 = 27 / 256.
(* proved *)
Definition step_wave_11 : Prop :=
  (let alpha := 1 / sqrt (2 * PI) in 1 / 4 - PI * alpha ^ 2 / 2) = 0.

(** ** wave-approach: Slightly wavy surfaces under a controlled approach *)
(* proved *)
Definition step_wave_approach_1 : Prop :=
  forall (theta Ls : R), 0 < theta < PI / 2 -> 0 < Ls -> (Ls - 4 * (cos theta) ^ 2) <> 0 -> 2 * (sin theta) * (cos theta) + (let alpha := (alpha_f theta) * Ls / (Ls - 4 * (cos theta) ^ 2) in Derive (fun theta => (P_w theta alpha)) theta * Ls - (P_w theta alpha) * 2 * (cos theta) / (sin theta)) = 0.
(* proved *)
Definition step_wave_approach_2 : Prop :=
  forall (s Ls : R), 0 < s -> 0 < Ls -> (3 - 8 * s) * Ls ^ 2 - 4 * (1 - s) * (3 - 4 * s) * Ls + 16 * (1 - s) ^ 2 = Ls ^ 2 * (let y := 4 * (1 - s) / Ls in y ^ 2 - (3 - 4 * s) * y + (3 - 8 * s)).
(* proved *)
Definition step_wave_approach_3 : Prop :=
  forall (s : R), 0 < s -> (3 - 4 * s) ^ 2 - 4 * (3 - 8 * s) = (4 * s + 3) * (4 * s - 1).
(* proved *)
Definition step_wave_approach_4 : Prop :=
  forall (s : R), 0 < s -> 1 - (3 - 4 * s) + (3 - 8 * s) = 1 - 4 * s.
(* proved *)
Definition step_wave_approach_5 : Prop :=
  (let s := 1 / 4 in 4 * (1 - s)) = 3.

(** ** paper-statements: Four statements of the paper in words *)
(* proved *)
Definition step_paper_statements_1 : Prop :=
  forall (n E w C kap a : R), 0 < n -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> 0 < a -> kap * C * Rpower a n - (d_n n E w C kap a) > 0.
(* proved *)
Definition step_paper_statements_2 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (d_c n E w C kap) = (1 - 2 * n) * kap * C * Rpower (a_c n E w C kap) n.
(* proved *)
Definition step_paper_statements_3 : Prop :=
  / (1 - 2 / 4) ^ 4 = 16.
(* proved *)
Definition step_paper_statements_4 : Prop :=
  forall (E w a : R) (g g1 G Q : R -> R), profile g g1 G Q -> 0 < E -> 0 < w -> 0 < a -> sqrt a * Derive (fun a => (d_g E w a g)) a = sqrt a * (g1 a) - sqrt (PI * w / (2 * E)).
(* proved *)
Definition step_paper_statements_5 : Prop :=
  forall (n C kap a : R), 1 / 2 < n -> 0 < C -> 0 < kap -> 0 < a -> Derive (fun a => sqrt a * Derive (fun a => kap * C * Rpower a n) a) a > 0.
(* proved *)
Definition step_paper_statements_6 : Prop :=
  forall (n C kap a : R), 0 < n < 1 / 2 -> 0 < C -> 0 < kap -> 0 < a -> Derive (fun a => sqrt a * Derive (fun a => kap * C * Rpower a n) a) a < 0.
(* enclosed *)
Definition step_paper_statements_7 : Prop :=
  forall (n C a : R), 1 / 2 < n -> 0 < C -> 0 < a -> n = 3 / 4 -> C = 1 -> a = 1 -> Derive (fun a => Derive (fun a => C * Rpower a n) a) a < 0.
(* proved *)
Definition step_paper_statements_8 : Prop :=
  forall (n E w C kap : R), 0 < n -> n <> 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (let a := (a_c n E w C kap) in sqrt a * Derive (fun a => Derive (fun a => (d_n n E w C kap a)) a) a) = (let a := (a_c n E w C kap) in Derive (fun a => sqrt a * Derive (fun a => kap * C * Rpower a n) a) a).
(* proved *)
Definition step_paper_statements_9 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_c n E w C kap) < 0.
(* proved *)
Definition step_paper_statements_10 : Prop :=
  forall (n E w C kap : R), 0 < n < 1 / 2 -> 0 < E -> 0 < w -> 0 < C -> 0 < kap -> (F_F n E w C kap) > 0.
