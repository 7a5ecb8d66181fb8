#include "numeric/riemann_hilbert/rounded_problem.hpp"

#include <algorithm>

#include "model/singular_point.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {

template <Real R>
RoundedProblem<R>::RoundedProblem(const ContactProblem& problem, const Frame& frame, std::size_t most_coupled)
    : problem_(&problem), exact_(problem, frame), most_coupled_(most_coupled), load_(to_real<R>(exact_.load)) {
  for (const Polynomial& slope : exact_.slopes) {
    highest_degree_ = std::max(highest_degree_, slope.degree());
    slopes_.push_back(coefficients_of<R>(slope));
  }
  for (std::size_t k = 0; k < exact_.anchors.size(); ++k) {
    const ReducedProblem::Anchor& at = exact_.anchors[k];
    Anchor anchor{to_real<R>(at.x), to_real<R>(at.step), sign(at.step), false, R(0), at};
    if (k > 0) spacing_.push_back(to_real<R>(Rational(at.x - exact_.anchors[k - 1].x)));
    if (k > 0 && k < exact_.intervals.size()) {
      const ReducedProblem::Interval &left = exact_.intervals[k - 1], &right = exact_.intervals[k];
      anchor.is_break = left.slope != right.slope || at.step != 0;
      anchor.s_jump = to_real<R>(Rational(right.s - left.s));
    }
    anchors_.push_back(std::move(anchor));
  }
  const auto count = static_cast<std::size_t>(
      std::count_if(anchors_.begin(), anchors_.end(), [](const Anchor& anchor) { return anchor.is_break; }));
  shortest_gap_ = count < most_coupled ? R(1e-280) : R(1e-150);

  const std::size_t frictions = problem.friction().values().size();
  for (std::size_t k = 0; k < frictions; ++k) {
    const Rational s = problem.coupled_friction(k);
    s_.push_back(to_real<R>(s));
    cos_alpha_.push_back(cos_pi_alpha<R>(s));
  }
  if (exact_.load_at) load_at_ = to_real<R>(*exact_.load_at);
  ends_.resize(frictions);
  jumps_.resize(exact_.anchors.size());
}

template <Real R>
R RoundedProblem<R>::profile_increment(std::size_t index, const R& from, const R& length) const {
  // x^{j+1} - y^{j+1} = (x - y) (x^j + ... + y^j), so nothing cancels for a short interval.
  const std::vector<R>& g = slopes_[index];
  const R to = from + length;
  R sum = 0;
  R quotient = 0;  // x^j + x^{j-1} y + ... + y^j
  R power = 1;     // y^j
  for (std::size_t j = 0; j < g.size(); ++j) {
    quotient = quotient * to + power;
    power *= from;
    sum += g[j] * quotient / static_cast<double>(j + 1);
  }
  return sum * length;
}

template <Real R>
bool RoundedProblem<R>::edge_possible(End end, std::size_t anchor) const {
  if (end == End::left) return anchor == 0 || anchors_[anchor].step_sign < 0;
  return anchor + 1 == anchors_.size() || anchors_[anchor].step_sign > 0;
}

template <Real R>
template <class Make>
const typename RoundedProblem<R>::Singularity& RoundedProblem<R>::cached(Slot& slot, const Make& make) const {
  const std::lock_guard lock(*making_);
  if (!slot) {
    Exponent exponent = make();
    slot = Singularity{exponent, Power<R>::of(exponent)};
  }
  return *slot;
}

template <Real R>
const typename RoundedProblem<R>::Singularity& RoundedProblem<R>::end(End end, bool edge, std::size_t friction) const {
  Slot& slot = ends_[friction][(end == End::left ? 0 : 1) + (edge ? 0 : 2)];
  return cached(slot, [&] {
    const Rational s = problem_->coupled_friction(friction);
    return edge ? edge_exponent(end, s) : free_exponent(end, s);
  });
}

template <Real R>
const typename RoundedProblem<R>::Singularity& RoundedProblem<R>::jump(std::size_t anchor) const {
  return cached(jumps_[anchor], [&] {
    const Rational &left = exact_.intervals[anchor - 1].s, &right = exact_.intervals[anchor].s;
    return left == right ? Exponent(0) : jump_exponent(left, right);
  });
}

STEADYSLIDE_INSTANTIATE_CLASS(RoundedProblem)

}  // namespace steadyslide::numeric
