#include "numeric/riemann_hilbert/contact_start.hpp"

#include <cmath>

#include "numeric/number/mapped.hpp"
#include "numeric/variational/coarse_contact.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns the problem with at most `most` friction jumps; each value is the mean over several pieces. A coarse
/// solution divides its cells at every jump, and its cost grows with the cube of their number.
ContactProblem with_fewer_jumps(const ContactProblem& problem, std::size_t most) {
  const FrictionProfile& friction = problem.friction();
  const std::size_t group = friction.jumps().size() / (most + 1) + 1;
  if (group == 1) return problem;
  std::vector<Rational> values;
  std::vector<Rational> jumps;
  Rational sum = 0;
  Rational from = problem.indenter().left();
  Rational left = from;
  for (std::size_t k = 0; k < friction.values().size(); ++k) {
    const bool last = k + 1 == friction.values().size();
    const Rational right = last ? problem.indenter().right() : friction.jumps()[k];
    sum += friction.values()[k] * (right - left);
    left = right;
    if (!last && (k + 1) % group != 0) continue;
    values.push_back(sum / (right - from));
    if (!last) jumps.push_back(right);
    sum = 0;
    from = right;
  }
  return problem.with_friction(FrictionProfile(std::move(values), std::move(jumps)));
}

}  // namespace

Frame ContactStart::frame() const {
  const double left = zones.front().left, right = zones.back().right;
  int exponent = 0;
  std::frexp((right > left ? right - left : 1) / 2, &exponent);
  const Integer power = Integer(1) << std::abs(exponent);
  return {origin + Rational((left + right) / 2), exponent >= 0 ? Rational(power) : Rational(1, power)};
}

std::vector<ContactInterval> ContactStart::in(const Frame& frame) const {
  const auto shift = to_real<double>((origin - frame.origin) / frame.unit);
  const auto unit = to_real<double>(frame.unit);
  return mapped(zones, [&](const ContactInterval& zone) {
    return ContactInterval{shift + zone.left / unit, shift + zone.right / unit, zone.left_at_edge, zone.right_at_edge};
  });
}

ContactStart coarse_start(const ContactProblem& problem, int cells) {
  const CoarseContact coarse = coarse_contact(with_fewer_jumps(problem, static_cast<std::size_t>(cells) / 2), cells);
  return {coarse.origin, coarse.zones, coarse.tilt};
}

template <Real R>
ContactStart start_from(const ContactProblem& problem, const ContactSolution<R>& solution) {
  ContactStart start{(problem.indenter().left() + problem.indenter().right()) / 2, {}, 0};
  const R origin = to_real<R>(start.origin);
  for (const ContactComponent<R>& component : solution.contact()) {
    start.zones.push_back({static_cast<double>(component.left.x.value - origin),
                           static_cast<double>(component.right.x.value - origin),
                           component.left.kind != SingularKind::free, component.right.kind != SingularKind::free});
  }
  if (const auto tilt = solution.tilt()) {
    start.tilt = static_cast<double>(tilt->value / to_real<R>(problem.elasticity().compliance()));
  }
  return start;
}

template <Real R>
ContactStart start_again(const RiemannHilbertSolution<R>& solution) {
  const ContactSet<R>& set = solution.state().set;
  const Frame& frame = solution.problem().frame();
  const std::vector<std::size_t> begins = set.all(ContactSet<R>::Kind::begins);
  const std::vector<std::size_t> ends = set.all(ContactSet<R>::Kind::ends);
  const R hull = set.span_length();
  std::size_t from = begins.front();
  if (from > 0 && set.length(from - 1) <= hull) --from;
  std::size_t to = ends.back();
  if (to < set.segments() && set.length(to) <= hull) ++to;
  std::size_t reference = from;
  while (reference < to && !set.point(reference).anchor) ++reference;
  const auto& anchor = set.point(reference).anchor;
  const R unit = to_real<R>(frame.unit);
  const auto offset = [&](std::size_t j) {
    R sum = 0;
    for (std::size_t k = j; k < reference; ++k) sum -= set.length(k);
    for (std::size_t k = reference; k < j; ++k) sum += set.length(k);
    return static_cast<double>(unit * sum);
  };
  ContactStart start{
      anchor ? solution.problem().place(*anchor) : Rational(frame.origin + frame.unit * Rational(set.x(reference))),
      {},
      static_cast<double>(solution.state().tilt)};
  for (std::size_t i = 0; i < begins.size(); ++i) {
    start.zones.push_back(
        {offset(begins[i]), offset(ends[i]), !set.point(begins[i]).vanishes, !set.point(ends[i]).vanishes});
  }
  return start;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                    \
  template ContactStart start_from(const ContactProblem&, const ContactSolution<R>&); \
  template ContactStart start_again(const RiemannHilbertSolution<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
