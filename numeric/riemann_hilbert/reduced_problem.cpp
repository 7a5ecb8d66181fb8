#include "numeric/riemann_hilbert/reduced_problem.hpp"

#include <algorithm>
#include <map>

#include "model/singular_point.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {

template <Real R>
ReducedProblem<R>::ReducedProblem(const ContactProblem& problem, const Frame& frame, std::size_t most_coupled)
    : problem_(&problem), frame_(frame), most_coupled_(most_coupled) {
  const Indenter& indenter = problem.indenter();
  const FrictionProfile& friction = problem.friction();
  const Rational c = problem.elasticity().compliance();

  // Pieces that continue one polynomial are one slope: the Riemann-Hilbert form then has no integral.
  std::vector<Polynomial> different;
  const auto is_before = [](const Polynomial& a, const Polynomial& b) { return a.coefficients() < b.coefficients(); };
  std::map<Polynomial, std::size_t, decltype(is_before)> known(is_before);
  std::vector<std::size_t> slope_of_piece;
  for (const Indenter::Piece& piece : indenter.pieces()) {
    const Polynomial slope = piece.profile.derivative();
    const auto [found, is_new] = known.emplace(slope, different.size());
    slope_of_piece.push_back(found->second);
    if (is_new) different.push_back(slope);
  }
  for (const Polynomial& slope : different) {
    highest_degree_ = std::max(highest_degree_, slope.degree());
    slopes_.push_back(coefficients_of<R>(slope.composed(frame.unit, frame.origin) * Polynomial::constant(1 / c)));
  }

  const std::vector<Indenter::Break> breaks = indenter.breaks();
  const auto add_anchor = [&](const Rational& x) -> Anchor& {
    places_.push_back(x);
    return anchors_.emplace_back(Anchor{to_real<R>((x - frame.origin) / frame.unit), R(0), 0, false, 0, R(0)});
  };
  std::size_t profile = 0;
  for (const ContactProblem::Piece& piece : problem.pieces()) {
    Anchor& anchor = add_anchor(piece.left);
    if (piece.profile != profile) {
      const Indenter::Break& b = breaks[profile];
      anchor.step = to_real<R>(b.step / (c * frame.unit));
      anchor.step_sign = sign(b.step);
      anchor.is_break = slope_of_piece[piece.profile] != slope_of_piece[profile] || anchor.step_sign != 0;
      anchor.wedge = b.wedge / c;
      profile = piece.profile;
    }
    if (!friction_of_.empty() && piece.friction != friction_of_.back()) {
      anchor.s_jump = to_real<R>(
          Rational(problem.coupled_friction(piece.friction) - problem.coupled_friction(friction_of_.back())));
    }
    spacing_.push_back(to_real<R>((piece.right - piece.left) / frame.unit));
    slope_of_.push_back(slope_of_piece[profile]);
    friction_of_.push_back(piece.friction);
  }
  add_anchor(indenter.right());
  const auto count = static_cast<std::size_t>(
      std::count_if(anchors_.begin(), anchors_.end(), [](const Anchor& anchor) { return anchor.is_break; }));
  shortest_gap_ = count < most_coupled ? R(1e-280) : R(1e-150);

  for (std::size_t k = 0; k < friction.values().size(); ++k) {
    const Rational s = problem.coupled_friction(k);
    s_.push_back(to_real<R>(s));
    cos_alpha_.push_back(cos_pi_alpha<R>(s));
  }
  load_ = to_real<R>(problem.load() / frame.unit);
  if (problem.load_at()) load_at_ = to_real<R>((*problem.load_at() - frame.origin) / frame.unit);
  ends_.resize(friction.values().size());
  jumps_.resize(places_.size());
}

template <Real R>
R ReducedProblem<R>::profile_increment(std::size_t index, const R& from, const R& length) const {
  // x^{j+1} - y^{j+1} = (x - y) (x^j + ... + y^j): nothing cancels over a short interval.
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
bool ReducedProblem<R>::edge_possible(End end, std::size_t anchor) const {
  if (end == End::left) return anchor == 0 || anchors_[anchor].step_sign < 0;
  return anchor + 1 == anchors_.size() || anchors_[anchor].step_sign > 0;
}

template <Real R>
template <class Make>
const typename ReducedProblem<R>::Singularity& ReducedProblem<R>::cached(Slot& slot, const Make& make) const {
  const std::lock_guard lock(*making_);
  if (!slot) {
    Exponent exponent = make();
    slot = Singularity{exponent, Power<R>::of(exponent)};
  }
  return *slot;
}

template <Real R>
const typename ReducedProblem<R>::Singularity& ReducedProblem<R>::end(End end, bool edge, std::size_t friction) const {
  Slot& slot = ends_[friction][(end == End::left ? 0 : 1) + (edge ? 0 : 2)];
  return cached(slot, [&] {
    const Rational s = problem_->coupled_friction(friction);
    return edge ? edge_exponent(end, s) : free_exponent(end, s);
  });
}

template <Real R>
const typename ReducedProblem<R>::Singularity& ReducedProblem<R>::jump(std::size_t anchor) const {
  return cached(jumps_[anchor], [&] {
    const std::size_t left = friction_of_[anchor - 1];
    const std::size_t right = friction_of_[anchor];
    if (left == right) return Exponent(0);
    return jump_exponent(problem_->coupled_friction(left), problem_->coupled_friction(right));
  });
}

STEADYSLIDE_INSTANTIATE_CLASS(ReducedProblem)

}  // namespace steadyslide::numeric
