#include "numeric/riemann_hilbert.hpp"

namespace steadyslide::numeric {

template <Real R>
Attempt<R> riemann_hilbert(const ContactProblem&, const ContactSolution<R>*) {
  return {nullptr, "not available in this version"};
}

template Attempt<double> riemann_hilbert(const ContactProblem&, const ContactSolution<double>*);
template Attempt<Real50> riemann_hilbert(const ContactProblem&, const ContactSolution<Real50>*);
template Attempt<Real100> riemann_hilbert(const ContactProblem&, const ContactSolution<Real100>*);

}  // namespace steadyslide::numeric
