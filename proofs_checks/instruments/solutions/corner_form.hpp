#pragma once
// The traction of a solved problem next to a wedge, with and without a friction jump there, as a formula says it:
//
//   t = D(x) (log_factor log d + step) + cosine d^power B(x),   D = psi'_+ - psi'_- over c, d = |x-c|,
//
// with B analytic across c. Measured: what is left of t when the stated singularity is taken out is one analytic
// function, so that its values on one side give those on the other. [Bal16, theorems 2, 9]

#include <array>

#include "model/contact_problem.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {

/// A profile of two pieces that meet at c = 1/8.
struct SolvedCorner {
  std::string name;
  ContactProblem problem;
  int theta;  ///< its sign, where t <= 0 leaves it open

  /// Does the friction jump at c?
  bool has_jump() const { return problem.friction().values().size() > 1; }
};
/// The friction from `rear` to `front`, the flanks as polynomials in x - c.
SolvedCorner solved_corner(std::string name, const Rational& rear, const Rational& front, const Polynomial& left,
                           const Polynomial& right, const Rational& load, int theta = 1);
std::string text_of(const SolvedCorner& c);

struct CornerForm {
  Number power = 0;
  Number log_factor = 0;
  std::array<Number, 2> step{};        ///< left, right
  std::array<Number, 2> cosine{1, 1};  ///< left, right
  /// B(c) over -theta where the friction jumps, elsewhere over the constant that the solver gives.
  Number limit = 1;
  bool continued = true;  ///< D(x), not D(c)
};

/// What such a formula says of these problems (a quick run has the first `quick` of them), put beside solutions of 50
/// digits or more. Its text describes "across" and "at c".
FormulaClaim<SolvedCorner, CornerForm> corner_claim(std::string id, std::vector<SolvedCorner> corners,
                                                    std::size_t quick, CornerForm (*formula)(const SolvedCorner&));

}  // namespace steadyslide::proofs_checks
