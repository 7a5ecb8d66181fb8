#pragma once
// A formula for the traction of a solved problem close to a wedge, with and without a friction jump there:
//
//   t = D(x) (log_factor log d + step) + cosine d^power B(x),   D = psi'_+ - psi'_- over c, d = |x-c|,
//
// with B analytic across c. The measurement removes the stated singularity from t. The rest must be one analytic
// function, so that its values on one side give those on the other. [Bal16, theorems 2, 9]

#include <array>

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

/// A profile of two pieces that meet at c = 1/8.
struct SolvedCorner {
  std::string name;
  ContactProblem problem;
  int theta;  ///< the sign of theta, if t <= 0 does not determine it

  /// True if the friction jumps at c.
  bool has_jump() const { return problem.friction().values().size() > 1; }
};
/// Returns the problem with friction from `rear` to `front`; the flanks are polynomials in x - c.
SolvedCorner solved_corner(std::string name, const Rational& rear, const Rational& front, const Polynomial& left,
                           const Polynomial& right, const Rational& load, int theta = 1);
std::string text_of(const SolvedCorner& c);

struct CornerForm {
  Number power = 0;
  Number log_factor = 0;
  std::array<Number, 2> step{};        ///< left, right
  std::array<Number, 2> cosine{1, 1};  ///< left, right
  /// B(c) divided by -theta if the friction jumps at c, otherwise by the constant that the solver gives.
  Number limit = 1;
  bool continued = true;  ///< use D(x); if false, D(c)
};

/// Returns the claim that compares a formula with the solutions of these problems at 50 digits or more. A quick run has
/// the first `quick` problems. The claim's text describes the quantities "across" and "at c".
FormulaClaim<SolvedCorner, CornerForm> corner_claim(std::string id, std::vector<SolvedCorner> corners,
                                                    std::size_t quick, CornerForm (*formula)(const SolvedCorner&));

}  // namespace steadyslide::proofs_checks
