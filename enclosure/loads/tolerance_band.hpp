#pragma once
// How far load shares and friction move if profile and friction are known only within a tolerance.
//
// Let p be the solution for psi and s = +-gamma f, where s nowhere decreases towards +x, and p_2 the solution for other
// data with |psi_2 - psi| <= e and |f_2 - f| <= d on the whole support, under the same load P and in the same attitude
// (or, if the indenter may tilt, on the same line of action). With q = p_2 - p, Q(x) = int_left^x q, and the
// compliance c,
//
//   b_0(q, q)/P^2 + (1/2) sum_k [s_k] (Q(c_k)/P)^2 <= E = 2 e/(c P) + |gamma| d,
//
// because the left side is <<g_2 - g, q>> <= 0 plus the pairing of q with (psi - psi_2)/c and with int (s - s_2) p_2:
// int |q| <= 2 P, int q = 0, and the second function moves by at most |gamma| d P along the support. b_0 >= 0. So
//
//   |sum_k a_k Q(c_k)| <= P sqrt(2 E sum_k a_k^2/[s_k]),
//
// for a load share, a difference of two Q(c_k), and for int f q = -sum_k [f_k] Q(c_k). The part int (f_2 - f) p_2 of
// the friction is at most d P.

#include "enclosure/number/ball.hpp"
#include "model/contact_problem.hpp"

namespace steadyslide::enclosure {

class ToleranceBand {
 public:
  /// `profile` is e, in units of length, `friction` is d; both at least 0. Throws InvalidData if s decreases somewhere.
  ToleranceBand(const ContactProblem& problem, const Rational& profile, const Rational& friction);

  /// Returns E.
  const Ball& energy() const { return energy_; }
  /// Returns the possible load shares under the k-th friction value, as fractions of P, if `share` is that of the
  /// problem itself. They lie in [0, 1].
  Ball load_share(std::size_t k, const Ball& share) const;
  /// Returns the possible values of the effective friction, int f p/P, if `friction` is that of the problem itself.
  Ball effective_friction(const Ball& friction) const;

 private:
  Ball deviation(const Rational& sum) const;

  const ContactProblem& problem_;
  Rational friction_tolerance_;
  std::vector<Rational> rises_;  ///< [s_k]
  Ball energy_;
};

}  // namespace steadyslide::enclosure
