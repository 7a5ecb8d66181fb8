#pragma once
// What H t = (1/pi) PV int t(x')/(x'-x) dx' does to a density near one point, x = 0 here:
//
//   |x|^lambda on x > 0:   -cot(pi lambda) |x|^lambda for x > 0,   -|x|^lambda/sin(pi lambda) for x < 0,
//
// for -1 < lambda < 0 on the half-line; with the density cut off at |x| = 1, and then continued to every lambda > -1
// that is no integer, up to the power series `far_part`, which is one function on both sides of 0: analytic across it.
// Derivatives in lambda give the logarithms, finite parts at lambda = n the integers. H anticommutes with x -> -x, and
// commutes with multiplication by x up to a constant: so nothing here depends on the order n of x^n.
//
// Trigonometric values are algebraic: C = cot(pi lambda) and S = 1/sin(pi lambda), S^2 = 1 + C^2. For sources of this
// layer, proofs_checks and tests only. Not thread-safe, as GiNaC is not.

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

/// cot(pi lambda), 1/sin(pi lambda) and pi as elements of the field in which one computes.
struct LocalConstants {
  GiNaC::ex cot;
  GiNaC::ex cosecant;
  GiNaC::ex pi;
};

/// H of the density, up to the far parts of its monomials. Throws std::domain_error unless 0 <= logs <= 8.
LocalDensity act(const LocalDensity& density, const LocalConstants& constants);

/// What `act` leaves out if the monomial is cut off at |x| = 1, as the first `terms` terms of its power series: for a
/// density on the right, mu = lambda + order (order alone without |x|^lambda),
///   -(logs!/pi) sum_{k >= 0} x^k/(k - mu)^{logs+1},  without the k = mu that would divide by zero.
/// On the left it is the mirror image of that, times -1. It converges for |x| < 1.
GiNaC::ex far_part(const LocalMonomial& monomial, const GiNaC::ex& lambda, const GiNaC::ex& x, int terms);

}  // namespace steadyslide::symbolic
