#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;
using GiNaC::lst;

ex Cosines::without_squares(const ex& f) const {
  return f.expand().subs(lst{sj * sj == 1 - cj * cj, sk * sk == 1 - ck * ck}, GiNaC::subs_options::algebraic).expand();
}

ex Cosines::derivative(const ex& f) const {
  return without_squares(f.diff(theta) - j * sj * f.diff(cj) + j * cj * f.diff(sj) - k * sk * f.diff(ck) +
                         k * ck * f.diff(sk));
}

ex Cosines::at_zero(const ex& f) const { return f.subs(lst{theta == 0, cj == 1, sj == 0, ck == 1, sk == 0}); }

ex Cosines::at_pi(const ex& f, int sign_j, int sign_k) const {
  return f.subs(lst{theta == pi, cj == sign_j, sj == 0, ck == sign_k, sk == 0});
}

void Cosines::equal(Comparison& comparison, const std::string& what, const ex& lhs, const ex& rhs) const {
  const auto cleared = [&](const ex& f) { return (f * j * j * k * k * (j * j - k * k)).normal().expand(); };
  comparison.equal(what, cleared(lhs), cleared(rhs));
}

std::vector<DecidedStatement> hilbert_statements() {
  std::vector<DecidedStatement> all;
  add_chebyshev_forms(all);
  add_chebyshev_norms(all);
  add_skew_operators(all);
  add_inequalities(all);
  return all;
}

}  // namespace steadyslide::symbolic
