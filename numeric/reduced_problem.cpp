#include "numeric/reduced_problem.hpp"

#include <algorithm>
#include "model/singular_point.hpp"

namespace steadyslide::numeric {
namespace {

/// p(origin + unit xi), by Horner's rule.
Polynomial in_frame(const Polynomial& p, const Frame& frame) {
  const Polynomial x({frame.origin, frame.unit});
  Polynomial result;
  for (int k = p.degree(); k >= 0; --k) {
    result = result * x + Polynomial::constant(p.coefficient(static_cast<std::size_t>(k)));
  }
  return result;
}

template <Real R>
std::vector<R> rounded(const Polynomial& p) {
  std::vector<R> result;
  result.reserve(p.coefficients().size());
  for (const Rational& c : p.coefficients()) result.push_back(to_real<R>(c));
  return result;
}

}  // namespace

template <Real R>
ReducedProblem<R>::ReducedProblem(const ContactProblem& problem, const Frame& frame)
    : problem_(&problem), frame_(frame) {
  const Indenter& indenter = problem.indenter();
  const FrictionProfile& friction = problem.friction();
  const Rational c = problem.elasticity().compliance();

  const std::vector<Indenter::Break> all_breaks = indenter.breaks();
  places_.push_back(indenter.left());
  places_.insert(places_.end(), friction.jumps().begin(), friction.jumps().end());
  for (const Indenter::Break& b : all_breaks) places_.push_back(b.x);
  places_.push_back(indenter.right());
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());

  // Pieces that continue one polynomial are one slope: the Riemann-Hilbert form then has no integral.
  std::vector<Polynomial> different;
  std::vector<std::size_t> slope_of_piece;
  for (const Indenter::Piece& piece : indenter.pieces()) {
    const Polynomial slope = piece.profile.derivative();
    const auto found = std::find(different.begin(), different.end(), slope);
    slope_of_piece.push_back(static_cast<std::size_t>(found - different.begin()));
    if (found == different.end()) different.push_back(slope);
  }
  for (const Polynomial& slope : different) {
    const Polynomial local = in_frame(slope, frame) * Polynomial::constant(1 / c);
    highest_degree_ = std::max(highest_degree_, local.degree());
    slopes_.push_back(rounded<R>(local));
  }

  std::size_t piece = 0;
  std::size_t next_break = 0;
  std::size_t friction_piece = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    Anchor anchor{to_real<R>((places_[k] - frame.origin) / frame.unit), R(0), 0, false, 0};
    if (next_break < all_breaks.size() && all_breaks[next_break].x == places_[k]) {
      const Indenter::Break& b = all_breaks[next_break++];
      anchor.step = to_real<R>(b.step / (c * frame.unit));
      anchor.step_sign = sign(b.step);
      ++piece;
      anchor.is_break = slope_of_piece[piece] != slope_of_piece[piece - 1] || anchor.step_sign != 0;
      anchor.wedge = b.wedge / c;
    }
    anchors_.push_back(anchor);
    if (k + 1 == places_.size()) break;
    spacing_.push_back(to_real<R>((places_[k + 1] - places_[k]) / frame.unit));
    if (friction_piece < friction.jumps().size() && friction.jumps()[friction_piece] == places_[k]) ++friction_piece;
    slope_of_.push_back(slope_of_piece[piece]);
    friction_of_.push_back(friction_piece);
  }

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
R ReducedProblem<R>::slope(std::size_t index, const R& x) const {
  const std::vector<R>& g = slopes_[index];
  R value = 0;
  for (std::size_t j = g.size(); j-- > 0;) value = value * x + g[j];
  return value;
}

template <Real R>
R ReducedProblem<R>::rise(std::size_t index, const R& from, const R& to) const {
  // x^{j+1} - y^{j+1} = (x - y) (x^j + ... + y^j): nothing cancels over a short interval.
  const std::vector<R>& g = slopes_[index];
  R sum = 0;
  R quotient = 0;  // x^j + x^{j-1} y + ... + y^j
  R power = 1;     // y^j
  for (std::size_t j = 0; j < g.size(); ++j) {
    quotient = quotient * to + power;
    power *= from;
    sum += g[j] * quotient / static_cast<double>(j + 1);
  }
  return sum * (to - from);
}

template <Real R>
bool ReducedProblem<R>::edge_possible(End end, std::size_t anchor) const {
  if (end == End::left) return anchor == 0 || anchors_[anchor].step_sign < 0;
  return anchor + 1 == anchors_.size() || anchors_[anchor].step_sign > 0;
}

template <Real R>
template <class Make>
const typename ReducedProblem<R>::Singularity& ReducedProblem<R>::cached(Slot& slot, const Make& make) const {
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
    return edge ? steadyslide::edge_exponent(end, s) : steadyslide::free_exponent(end, s);
  });
}

template <Real R>
const typename ReducedProblem<R>::Singularity& ReducedProblem<R>::jump(std::size_t anchor) const {
  return cached(jumps_[anchor], [&] {
    const std::size_t left = friction_of_[anchor - 1];
    const std::size_t right = friction_of_[anchor];
    if (left == right) return Exponent(0);
    return steadyslide::jump_exponent(problem_->coupled_friction(left), problem_->coupled_friction(right));
  });
}

template <Real R>
const Exponent& ReducedProblem<R>::edge_exponent(End e, std::size_t friction) const {
  return end(e, true, friction).exponent;
}
template <Real R>
const Exponent& ReducedProblem<R>::free_exponent(End e, std::size_t friction) const {
  return end(e, false, friction).exponent;
}
template <Real R>
const Exponent& ReducedProblem<R>::jump_exponent(std::size_t anchor) const {
  return jump(anchor).exponent;
}
template <Real R>
const Power<R>& ReducedProblem<R>::edge_power(End e, std::size_t friction) const {
  return end(e, true, friction).power;
}
template <Real R>
const Power<R>& ReducedProblem<R>::free_power(End e, std::size_t friction) const {
  return end(e, false, friction).power;
}
template <Real R>
const Power<R>& ReducedProblem<R>::jump_power(std::size_t anchor) const {
  return jump(anchor).power;
}

template class ReducedProblem<double>;
template class ReducedProblem<Real50>;
template class ReducedProblem<Real100>;

}  // namespace steadyslide::numeric
