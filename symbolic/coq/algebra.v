(* Algebra is any commutative algebra over the rational numbers. The divisors that occur have inverses in it; a root is an
   element with the square that is given. [p#q] is the number p/q. *)
Require Import QArith Qreduction NArith Ring Ring_theory.

Section Identities.

Variable Algebra : Type.
Variables zero one : Algebra.
Variables add mul sub : Algebra -> Algebra -> Algebra.
Variable opp : Algebra -> Algebra.
Variable of_Q : Q -> Algebra.
Hypothesis is_ring : ring_theory zero one add mul sub opp (@eq Algebra).
Hypothesis over_Q : ring_morph zero one add mul sub opp (@eq Algebra) 0%Q 1%Q Qplus Qmult Qminus Qopp Qeq_bool of_Q.

Notation "[ q ]" := (of_Q q%Q) (format "[ q ]").
Notation "x + y" := (add x y).
Notation "x - y" := (sub x y).
Notation "x * y" := (mul x y).
Notation "x ^ n" := (pow_N one mul x n%N).

(* The tactic ring for this algebra: it computes with fractions in lowest terms. *)
Lemma over_reduced_Q :
  ring_morph zero one add mul sub opp (@eq Algebra) 0%Q 1%Q
    (fun x y => Qred (x + y)) (fun x y => Qred (x * y)) (fun x y => Qred (x - y)) Qopp Qeq_bool of_Q.
Proof.
  assert (E : forall x, of_Q (Qred x) = of_Q x)
    by (intro x; apply (morph_eq over_Q), Qeq_bool_iff, Qred_correct).
  destruct over_Q; constructor; intros; rewrite ?E; auto.
Qed.

Lemma powers : power_theory one mul (@eq Algebra) (fun n : N => n) (pow_N one mul).
Proof. constructor; reflexivity. Qed.

Ltac number t :=
  match t with
  | of_Q (Qmake ?p ?q) => match isZcst p with true => match isPcst q with true => constr:(Qmake p q) end end
  | _ => constr:(NotConstant)
  end.

Add Ring algebra : is_ring (morphism over_reduced_Q, constants [number], power_tac powers [Ncst]).

(* a = b, because a - b is a sum of multiples of differences that are zero. *)
Lemma by_cofactors : forall a b sum, a - b = sum -> sum = zero -> a = b.
Proof. intros a b sum E Z. assert (a = (a - b) + b) as -> by ring. rewrite E, Z. ring. Qed.

Lemma multiple_of : forall cofactor x y sum, x = y -> sum = zero -> cofactor * (x - y) + sum = zero.
Proof. intros cofactor x y sum -> ->. ring. Qed.

Ltac zero_by_hypotheses := repeat (apply multiple_of; [assumption |]); reflexivity.
