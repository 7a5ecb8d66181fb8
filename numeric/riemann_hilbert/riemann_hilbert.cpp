#include "numeric/riemann_hilbert/riemann_hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/variational/coarse_contact.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric {
namespace {

/// The start of a search: zones measured from `origin`, in the problem's unit of length.
struct Start {
  Rational origin;
  std::vector<ContactInterval> zones;
  double tilt = 0;

  /// Returns a frame with its origin in the middle of the contact, in which the half-width is near 1.
  Frame frame() const {
    const double left = zones.front().left, right = zones.back().right;
    int exponent = 0;
    std::frexp((right > left ? right - left : 1) / 2, &exponent);
    const Integer power = Integer(1) << std::abs(exponent);
    return {origin + Rational((left + right) / 2), exponent >= 0 ? Rational(power) : Rational(1, power)};
  }

  std::vector<ContactInterval> in(const Frame& frame) const {
    const double shift = to_real<double>((origin - frame.origin) / frame.unit);
    const double unit = to_real<double>(frame.unit);
    return mapped(zones, [&](const ContactInterval& zone) {
      return ContactInterval{shift + zone.left / unit, shift + zone.right / unit, zone.left_at_edge,
                             zone.right_at_edge};
    });
  }
};

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

Start coarse_start(const ContactProblem& problem, int cells) {
  const CoarseContact coarse = coarse_contact(with_fewer_jumps(problem, static_cast<std::size_t>(cells) / 2), cells);
  return {coarse.origin, coarse.zones, coarse.tilt};
}

template <Real R>
Start start_from(const ContactProblem& problem, const ContactSolution<R>& solution) {
  Start start{(problem.indenter().left() + problem.indenter().right()) / 2, {}, 0};
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

/// Returns the zones of a solution, from the lengths of its set; measured from an anchor if one is near.
template <Real R>
Start start_again(const RiemannHilbertSolution<R>& solution) {
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
  Start start{
      anchor ? solution.problem().place(*anchor) : Rational(frame.origin + frame.unit * Rational(set.x(reference))),
      {},
      static_cast<double>(solution.state().tilt)};
  for (std::size_t i = 0; i < begins.size(); ++i) {
    start.zones.push_back(
        {offset(begins[i]), offset(ends[i]), !set.point(begins[i]).vanishes, !set.point(ends[i]).vanishes});
  }
  return start;
}

template <Real R>
std::shared_ptr<RiemannHilbertSolution<R>> search_once(const ContactProblem& problem, const Start& start) {
  const auto search = [&](const RoundedProblem<R>& reduced, JacobiRules<R>& rules) {
    const std::vector<ContactInterval> zones = start.in(reduced.frame());
    ContactSet<R> set(reduced, zones);
    // Zones that overlap because of rounding become one zone.
    if (!set.is_consistent()) {
      set = ContactSet<R>(reduced, {{zones.front().left, zones.back().right, false, false}});
    }
    return search_contact(reduced, ContactState<R>::initial(reduced, std::move(set), R(start.tilt)), rules);
  };
  return std::make_shared<RiemannHilbertSolution<R>>(problem, start.frame(), search);
}

/// A contact far smaller than its frame needs its own frame, because its places are not accurate enough.
template <Real R>
std::shared_ptr<RiemannHilbertSolution<R>> search(const ContactProblem& problem, const Start& start) {
  constexpr int max_frames = 12;
  auto solution = search_once<R>(problem, start);
  for (int i = 0; i < max_frames && solution->state().set.span_length() < R(0.01); ++i) {
    solution = search_once<R>(problem, start_again(*solution));
  }
  return solution;
}

/// Continues the solution in double in R.
template <Real R>
std::shared_ptr<RiemannHilbertSolution<R>> refined(const ContactProblem& problem,
                                                   const RiemannHilbertSolution<double>& rough) {
  const auto search = [&](const RoundedProblem<R>& reduced, JacobiRules<R>& rules) {
    const ContactState<double>& state = rough.state();
    ContactSet<R> set = ContactSet<R>::converted(reduced, state.set);
    // A free end that lies on a jump in double becomes free again.
    const R distance = epsilon<double>() * set.span_length();
    for (std::size_t j = set.points().size(); j-- > 0;) {
      if (!set.point(j).is_free() || !set.point(j).anchor) continue;
      const std::size_t inside = set.inside(j);
      const R d = std::min(distance, set.length(inside) / 2);
      set.move_end(j, inside, set.contact_side(j) == Side::right ? d : set.length(inside) - d);
    }
    std::vector<R> q(state.q.begin(), state.q.end());
    if (!q.empty() && set.components() <= reduced.most_coupled()) q.back() = reduced.load();
    return search_contact(reduced, {std::move(set), std::move(q), R(state.tilt)}, rules);
  };
  return std::make_shared<RiemannHilbertSolution<R>>(problem, rough.problem().frame(), search);
}

/// Searches from a solution on equal cells with fast products, for problems that are too large for dense coarse
/// solutions: many pieces may mean many zones.
std::shared_ptr<RiemannHilbertSolution<double>> search_from_cells(const ContactProblem& problem,
                                                                  std::size_t cells_per_piece) {
  VariationalOptions options;
  const std::size_t wanted = cells_per_piece * problem.indenter().pieces().size();
  while (options.cells < std::min(wanted, std::size_t{1} << 20)) options.cells *= 2;
  const Attempt<double> cells = variational_inequality(problem, options);
  return cells.solution ? search<double>(problem, start_from(problem, *cells.solution)) : nullptr;
}

/// Returns the first solution of several searches, each from a finer start; if none finds a solution, the state of the
/// first.
std::shared_ptr<RiemannHilbertSolution<double>> search_from_nothing(const ContactProblem& problem) {
  const std::size_t pieces = problem.indenter().pieces().size();
  std::vector<std::size_t> cells_per_piece;
  if (pieces > 24) cells_per_piece.push_back(32);
  if (pieces > 64) cells_per_piece.push_back(256);
  std::shared_ptr<RiemannHilbertSolution<double>> best;
  const auto solves = [&best](std::shared_ptr<RiemannHilbertSolution<double>> found) {
    const bool solved = found && found->failed_condition().empty();
    if (solved || !best) best = std::move(found);
    return solved;
  };
  for (const std::size_t cells : cells_per_piece) {
    if (solves(search_from_cells(problem, cells))) return best;
  }
  if (pieces > 64) return best;
  for (const int cells : {48, 120, 300}) {
    if (solves(search<double>(problem, coarse_start(problem, cells)))) break;
  }
  return best;
}

}  // namespace

std::string too_many_profile_breaks(const ContactProblem& problem, Digits digits) {
  const std::size_t breaks = problem.indenter().pieces().size() - 1;
  const bool in_double = digits == Digits::sixteen;
  const std::size_t most = in_double ? max_profile_breaks : max_profile_breaks_in_digits;
  if (breaks <= most) return {};
  return "the profile has too many breaks for the Riemann-Hilbert method" +
         std::string(in_double ? ", take --method variational" : " with more than 16 digits") + "; it has at most " +
         std::to_string(most) + "; " + std::to_string(breaks) + " breaks";
}

bool may_have_many_gaps(const ContactProblem& problem) {
  constexpr std::ptrdiff_t many = 100;
  const std::vector<Indenter::Break> breaks = problem.indenter().breaks();
  return std::count_if(breaks.begin(), breaks.end(), [](const Indenter::Break& b) { return b.wedge < 0; }) > many;
}

template <Real R>
Attempt<R> riemann_hilbert(const ContactProblem& problem, const ContactSolution<R>* start) {
  if (std::string reason = too_many_friction_pieces(problem, digits_of<R>); !reason.empty())
    return {nullptr, std::move(reason)};
  if (std::string reason = too_many_profile_breaks(problem, digits_of<R>); !reason.empty()) return {nullptr, reason};
  // For every precision, the contact is first found in double.
  std::shared_ptr<RiemannHilbertSolution<double>> rough;
  if (start) rough = search<double>(problem, start_from(problem, *start));
  if (!rough || !rough->failed_condition().empty()) rough = search_from_nothing(problem);
  std::shared_ptr<RiemannHilbertSolution<R>> solution;
  if constexpr (std::same_as<R, double>) {
    solution = std::move(rough);
  } else {
    solution = refined<R>(problem, *rough);
  }
  if (problem.elasticity().indenter() && solution->has_edge()) {
    return {nullptr, "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails"};
  }
  return {solution, {}};
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template Attempt<R> riemann_hilbert(const ContactProblem&, const ContactSolution<R>*);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
