#include "numeric/riemann_hilbert/signed_fundamental_solution.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
const typename ReducedProblem<R>::Singularity& singularity_at(const ReducedProblem<R>& problem,
                                                              const ContactSet<R>& set, std::size_t j) {
  const auto& point = set.point(j);
  if (!point.is_end()) return problem.jump(*point.anchor);
  return problem.end(opposite(set.contact_side(j)), !point.vanishes, problem.friction_of(set.interval(set.inside(j))));
}

template <Real R>
Power<R> power_at(const ReducedProblem<R>& problem, const ContactSet<R>& set, std::size_t j) {
  const auto& point = set.point(j);
  const bool is_jump = point.anchor && j > 0 && j < set.segments() && set.in_contact(j);
  if (!point.is_end() && !is_jump) return {R(0), R(1)};
  return singularity_at(problem, set, j).power;
}

template <Real R>
FundamentalSolution<R> solution_of(const ReducedProblem<R>& problem, const ContactSet<R>& set) {
  std::vector<Power<R>> powers;
  powers.reserve(set.points().size());
  for (std::size_t j = 0; j < set.points().size(); ++j) powers.push_back(power_at(problem, set, j));
  return FundamentalSolution<R>(set.panels(), std::move(powers));
}

/// The powers of the component that begins at point `first` sum to the number of its free ends less one.
template <Real R>
int degree_of_component(const ContactSet<R>& set, std::size_t first) {
  std::size_t last = first + 1;
  while (!set.point(last).is_end()) ++last;
  return (set.point(first).vanishes ? 1 : 0) + (set.point(last).vanishes ? 1 : 0) - 1;
}

}  // namespace

template <Real R>
SignedFundamentalSolution<R>::SignedFundamentalSolution(const ReducedProblem<R>& problem, ContactSet<R> set)
    : problem_(&problem),
      set_(std::move(set)),
      solution_(solution_of(problem, set_)),
      signs_(set_.segments() + 2, 1),
      degree_(0) {
  int sum = 0;  // of the powers on the right of what is looked at: an integer between components
  const auto even = [](int i) { return i % 2 == 0; };
  for (std::size_t k = set_.segments(); k-- > 0;) {
    const auto& right = set_.point(k + 1);
    if (!set_.in_contact(k)) {
      if (right.kind == ContactSet<R>::Kind::begins) sum += degree_of_component(set_, k + 1);
      signs_[k + 1] = even(sum) ? 1 : -1;
    } else if (right.kind == ContactSet<R>::Kind::ends) {
      signs_[k + 1] = even(sum) != right.vanishes ? 1 : -1;
    } else {
      signs_[k + 1] = signs_[k + 2];
    }
  }
  if (set_.point(0).kind == ContactSet<R>::Kind::begins) sum += degree_of_component(set_, 0);
  degree_ = sum;
  signs_[0] = even(sum) ? 1 : -1;
}

template <Real R>
const Exponent& SignedFundamentalSolution<R>::exponent(std::size_t j) const {
  return singularity_at(*problem_, set_, j).exponent;
}

template <Real R>
bool SignedFundamentalSolution<R>::changes_polynomial(std::size_t j) const {
  return j > 0 && j < set_.segments() && set_.in_contact(j - 1) && set_.in_contact(j) && slope_at(j - 1) != slope_at(j);
}

template <Real R>
R SignedFundamentalSolution<R>::modulus(const SurfacePoint<R>& at) const {
  if (at.segment < 0) return solution_.modulus_beyond(Side::left, at.node.from_right);
  if (at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) {
    return solution_.modulus_beyond(Side::right, at.node.from_left);
  }
  return solution_.modulus(static_cast<std::size_t>(at.segment), at.node);
}

template <Real R>
R SignedFundamentalSolution<R>::traction_factor(std::size_t segment) const {
  return sign(static_cast<std::ptrdiff_t>(segment)) * problem_->cos_alpha(friction_at(segment));
}

template <Real R>
R SignedFundamentalSolution<R>::distance(const SurfacePoint<R>& at, std::size_t j) const {
  const auto point = static_cast<std::ptrdiff_t>(j);
  if (point <= at.segment) {
    return set_.sum_of_lengths(j, static_cast<std::size_t>(at.segment), at.node.from_left);
  }
  return -set_.sum_of_lengths(static_cast<std::size_t>(at.segment + 1), j, at.node.from_right);
}

template class SignedFundamentalSolution<double>;
template class SignedFundamentalSolution<Real50>;
template class SignedFundamentalSolution<Real100>;

}  // namespace steadyslide::numeric
