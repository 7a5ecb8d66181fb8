#include "symbolic/statements/polynomial_families.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;

ex antiderivative(const ex& polynomial, const GiNaC::symbol& x) {
  const ex expanded = polynomial.expand();
  ex sum = 0;
  for (int n = 0; n <= expanded.degree(x); ++n) sum += expanded.coeff(x, n) * GiNaC::pow(x, n + 1) / (n + 1);
  return sum;
}

ex integral(const ex& polynomial, const GiNaC::symbol& x, const ex& from, const ex& to) {
  const ex primitive = antiderivative(polynomial, x);
  return primitive.subs(x == to) - primitive.subs(x == from);
}

namespace {

/// Returns the n-th member of first, second, 2x second - first, ...
ex recurrence(ex first, ex second, int n, const ex& x) {
  for (int k = 0; k < n; ++k) {
    const ex next = (2 * x * second - first).expand();
    first = second;
    second = next;
  }
  return first;
}

}  // namespace

ex chebyshev_t(int n, const ex& x) { return recurrence(1, x, n, x); }
ex chebyshev_u(int n, const ex& x) { return recurrence(0, 1, n + 1, x); }

}  // namespace steadyslide::symbolic
