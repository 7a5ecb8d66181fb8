#pragma once
// The action of H t = (1/pi) PV int t(x')/(x'-x) dx' on a density near one point, here x = 0:
//
//   |x|^lambda on x > 0:   -cot(pi lambda) |x|^lambda for x > 0,   -|x|^lambda/sin(pi lambda) for x < 0,
//
// for -1 < lambda < 0 on the half-line. If the density is cut off at |x| = 1, the same holds for every lambda > -1 that
// is not an integer, up to the power series `far_part`, which is analytic at 0. Derivatives with respect to lambda give
// the logarithms; finite parts at lambda = n give the integer powers. H anticommutes with x -> -x and commutes with
// multiplication by x up to a constant, so nothing here depends on the order n of x^n.
//
// Trigonometric values are algebraic: C = cot(pi lambda) and S = 1/sin(pi lambda), S^2 = 1 + C^2. For sources of this
// layer, proofs_checks and tests only. Not thread-safe, because GiNaC is not.

#include <ginac/ginac.h>

#include <compare>
#include <map>

#include "model/direction.hpp"

namespace steadyslide::symbolic {

/// x^order |x|^lambda log(|x|)^logs on one side of 0 and zero on the other; without |x|^lambda unless `fractional`.
struct LocalMonomial {
  Side side;
  bool fractional;
  int order;
  int logs;
  friend auto operator<=>(const LocalMonomial&, const LocalMonomial&) = default;
};

/// A sum of monomials with their coefficients.
using LocalDensity = std::map<LocalMonomial, GiNaC::ex>;

LocalDensity& operator+=(LocalDensity& a, const LocalDensity& b);

/// cot(pi lambda), 1/sin(pi lambda) and pi as elements of the field of the computation.
struct LocalConstants {
  GiNaC::ex cot;
  GiNaC::ex cosecant;
  GiNaC::ex pi;
};

/// Returns H of the density, without the far parts of its monomials. Throws std::domain_error unless 0 <= logs <= 8.
LocalDensity act(const LocalDensity& density, const LocalConstants& constants);

/// Returns the part that `act` leaves out if the monomial is cut off at |x| = 1, as the first `terms` terms of its
/// power series. For a density on the right, with mu = lambda + order (mu = order without |x|^lambda), it is
///   -(logs!/pi) sum_{k >= 0} x^k/(k - mu)^{logs+1},  without the k = mu that would divide by zero.
/// For a density on the left it is the mirror image times -1. The series converges for |x| < 1.
GiNaC::ex far_part(const LocalMonomial& monomial, const GiNaC::ex& lambda, const GiNaC::ex& x, int terms);

}  // namespace steadyslide::symbolic
