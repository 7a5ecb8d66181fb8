#include "numeric/riemann_hilbert/signed_fundamental_solution.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric {
namespace {

template <Real R>
const typename RoundedProblem<R>::Singularity& singularity_at(const RoundedProblem<R>& problem,
                                                              const ContactSet<R>& set, std::size_t j) {
  const auto& point = set.point(j);
  if (!point.is_end()) return problem.jump(*point.anchor);
  return problem.end(opposite(set.contact_side(j)), !point.vanishes, problem.friction_of(set.interval(set.inside(j))));
}

template <Real R>
Power<R> power_at(const RoundedProblem<R>& problem, const ContactSet<R>& set, std::size_t j) {
  const auto& point = set.point(j);
  const bool is_jump = point.anchor && j > 0 && j < set.segments() && set.in_contact(j);
  if (!point.is_end() && !is_jump) return {};
  return singularity_at(problem, set, j).power;
}

template <Real R>
std::vector<Power<R>> powers_of(const RoundedProblem<R>& problem, const ContactSet<R>& set) {
  std::vector<Power<R>> powers;
  powers.reserve(set.points().size());
  for (std::size_t j = 0; j < set.points().size(); ++j) powers.push_back(power_at(problem, set, j));
  return powers;
}

template <Real R>
using PivotOf = typename SignedFundamentalSolution<R>::Pivot;

template <Real R>
FundamentalSolution<R> solution_of(const ContactSet<R>& set, std::vector<Power<R>> powers,
                                   const std::vector<PivotOf<R>>& pivots) {
  for (const PivotOf<R>& pivot : pivots) {
    Power<R>& p = powers[pivot.point];
    if (pivot.order > 0) p = {p.value - 1, p.value};
    if (pivot.order < 0) p = {p.plus_one, p.plus_one + 1};
  }
  return FundamentalSolution<R>(set.panels(), std::move(powers));
}

/// Returns the pivot of each component: the end whose power is nearest to zero after a change by one. A free end that
/// cannot move is used only if both ends cannot move.
template <Real R>
std::vector<PivotOf<R>> pivots_of(const RoundedProblem<R>& problem, const ContactSet<R>& set,
                                  const std::vector<Power<R>>& powers) {
  using Kind = typename ContactSet<R>::Kind;
  const std::vector<std::size_t> begins = set.all(Kind::begins);
  const std::vector<std::size_t> ends = set.all(Kind::ends);
  std::vector<PivotOf<R>> result;
  if (begins.size() <= problem.most_coupled()) return result;
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t begin = begins[i], end = ends[i];
    const int order = (set.point(begin).vanishes ? 1 : 0) + (set.point(end).vanishes ? 1 : 0) - 1;
    const bool one_moves = set.point(begin).is_movable() != set.point(end).is_movable();
    const bool takes_begin = order > 0 && one_moves ? set.point(begin).is_movable()
                                                    : order * powers[begin].value > order * powers[end].value;
    result.push_back({takes_begin ? begin : end, order});
  }
  return result;
}

/// Returns the sum of the powers of the component that begins at point `first`: the number of its free ends minus one.
template <Real R>
int degree_of_component(const ContactSet<R>& set, std::size_t first) {
  std::size_t last = first + 1;
  while (!set.point(last).is_end()) ++last;
  return (set.point(first).vanishes ? 1 : 0) + (set.point(last).vanishes ? 1 : 0) - 1;
}

}  // namespace

template <Real R>
SignedFundamentalSolution<R>::SignedFundamentalSolution(const RoundedProblem<R>& problem, ContactSet<R> set)
    : problem_(&problem),
      set_(std::move(set)),
      powers_(powers_of(problem, set_)),
      pivots_(pivots_of(problem, set_, powers_)),
      solution_(solution_of(set_, powers_, pivots_)),
      signs_(set_.segments() + 2, 1) {
  assign_components();
  int sum = 0;  // sum of the powers on the right of the current point: an integer between components
  const auto even = [](int i) { return i % 2 == 0; };
  for (std::size_t k = set_.segments(); k-- > 0;) {
    const auto& right = set_.point(k + 1);
    if (!set_.in_contact(k)) {
      if (right.kind == ContactSet<R>::Kind::begins && pivots_.empty()) sum += degree_of_component(set_, k + 1);
      signs_[k + 1] = even(sum) ? 1 : -1;
    } else if (right.kind == ContactSet<R>::Kind::ends) {
      signs_[k + 1] = even(sum) != right.vanishes ? 1 : -1;
    } else {
      signs_[k + 1] = signs_[k + 2];
    }
  }
  if (set_.point(0).kind == ContactSet<R>::Kind::begins && pivots_.empty()) sum += degree_of_component(set_, 0);
  degree_ = sum;
  signs_[0] = even(sum) ? 1 : -1;
}

template <Real R>
void SignedFundamentalSolution<R>::assign_components() {
  left_component_.assign(set_.segments(), 0);
  right_component_.assign(set_.segments(), 0);
  if (pivots_.empty()) return;
  std::size_t next = 0;  // the first component on the right
  for (const auto& [first, end] : set_.runs()) {
    const bool contact = set_.in_contact(first);
    const std::size_t left = contact || next == 0 ? next : next - 1;
    const std::size_t right = contact || next < pivots_.size() ? next : next - 1;
    R width = 0;
    for (std::size_t k = first; k < end; ++k) width += set_.length(k);
    R before = 0;
    for (std::size_t k = first; k < end; ++k) {
      const bool nearer_left = before + set_.length(k) / 2 <= width / 2;
      const bool is_first = k == first;
      const bool is_last = k + 1 == end;
      left_component_[k] = is_first || (!is_last && nearer_left) ? left : right;
      right_component_[k] = is_last || (!is_first && !nearer_left) ? right : left;
      before += set_.length(k);
    }
    if (contact) ++next;
  }
}

template <Real R>
std::size_t SignedFundamentalSolution<R>::component_at(const SurfacePoint<R>& at) const {
  if (pivots_.empty() || at.segment < 0) return 0;
  if (at.segment >= static_cast<std::ptrdiff_t>(set_.segments())) return pivots_.size() - 1;
  const auto segment = static_cast<std::size_t>(at.segment);
  return at.node.from_left <= at.node.from_right ? left_component_[segment] : right_component_[segment];
}

template <Real R>
std::size_t SignedFundamentalSolution<R>::component_of(std::size_t j) const {
  return left_component_[j < set_.segments() && set_.in_contact(j) ? j : j - 1];
}

template <Real R>
R SignedFundamentalSolution<R>::to_pivot(const SurfacePoint<R>& at) const {
  if (pivots_.empty()) return R(1);
  const Pivot& pivot = pivots_[component_at(at)];
  if (pivot.order == 0) return R(1);
  const R d = distance(at, pivot.point);
  return pivot.order > 0 ? d : 1 / d;
}

template <Real R>
int SignedFundamentalSolution<R>::sign(const SurfacePoint<R>& at) const {
  const int sign = this->sign(at.segment);
  if (pivots_.empty() || in_contact(set_, at)) return sign;
  const Pivot& pivot = pivots_[component_at(at)];
  return pivot.order != 0 && at.segment < static_cast<std::ptrdiff_t>(pivot.point) ? -sign : sign;
}

template <Real R>
R SignedFundamentalSolution<R>::amplitude(std::size_t j) const {
  const R common = solution_.amplitude(j);
  if (pivots_.empty()) return common;
  const Pivot& pivot = pivots_[component_of(j)];
  if (pivot.order == 0 || pivot.point == j) return common;
  R d = 0;
  for (std::size_t k = std::min(j, pivot.point); k < std::max(j, pivot.point); ++k) d += set_.length(k);
  return pivot.order > 0 ? R(common * d) : R(common / d);
}

template <Real R>
R SignedFundamentalSolution<R>::smooth_modulus(std::size_t segment, const Node<R>& node) const {
  const R common = solution_.smooth_modulus(segment, node);
  if (pivots_.empty()) return common;
  const std::size_t pivot = pivots_[left_component_[segment]].point;
  if (pivot == segment || pivot == segment + 1) return common;
  return common * abs(to_pivot({static_cast<std::ptrdiff_t>(segment), node}));
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
  const R common = common_modulus(at);
  return pivots_.empty() ? common : R(common * abs(to_pivot(at)));
}

template <Real R>
R SignedFundamentalSolution<R>::common_modulus(const SurfacePoint<R>& at) const {
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
R SignedFundamentalSolution<R>::traction_factor(std::size_t segment, std::size_t component) const {
  const R own = traction_factor(segment);
  if (pivots_.empty() || left_component_[segment] == component) return own;
  const auto changes = [&](std::size_t i) { return pivots_[i].order != 0 && is_left_of_pivot(segment, i); };
  return changes(left_component_[segment]) == changes(component) ? own : R(-own);
}

template <Real R>
R SignedFundamentalSolution<R>::distance(const SurfacePoint<R>& at, std::size_t j) const {
  const auto point = static_cast<std::ptrdiff_t>(j);
  if (point <= at.segment) {
    return set_.sum_of_lengths(j, static_cast<std::size_t>(at.segment), at.node.from_left);
  }
  return -set_.sum_of_lengths(static_cast<std::size_t>(at.segment + 1), j, at.node.from_right);
}

template <Real R>
std::vector<R> SignedFundamentalSolution<R>::distances(const SurfacePoint<R>& at) const {
  std::vector<R> result(set_.points().size());
  R d = at.node.from_left;
  for (std::ptrdiff_t j = at.segment; j >= 0; --j) {
    if (j < static_cast<std::ptrdiff_t>(set_.segments()) && j < at.segment)
      d += set_.length(static_cast<std::size_t>(j));
    result[static_cast<std::size_t>(j)] = d;
  }
  d = at.node.from_right;
  for (auto j = static_cast<std::size_t>(at.segment + 1); j < result.size(); ++j) {
    if (static_cast<std::ptrdiff_t>(j) > at.segment + 1) d += set_.length(j - 1);
    result[j] = -d;
  }
  return result;
}

template <Real R>
std::vector<R> SignedFundamentalSolution<R>::distances_of_ends(const SurfacePoint<R>& at) const {
  std::vector<R> result(set_.points().size());
  const std::vector<std::size_t>& ends = set_.ends();
  const auto middle = std::partition_point(
      ends.begin(), ends.end(), [&at](std::size_t j) { return static_cast<std::ptrdiff_t>(j) <= at.segment; });
  R d = at.node.from_left;
  auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(at.segment, 0));
  for (auto end = middle; end != ends.begin();) {
    --end;
    d = set_.sum_of_lengths(*end, from, d);
    from = *end;
    result[from] = d;
  }
  d = at.node.from_right;
  from = static_cast<std::size_t>(at.segment + 1);
  for (auto end = middle; end != ends.end(); ++end) {
    d = set_.sum_of_lengths(from, *end, d);
    from = *end;
    result[from] = -d;
  }
  return result;
}

STEADYSLIDE_INSTANTIATE_CLASS(SignedFundamentalSolution)

}  // namespace steadyslide::numeric
