#include "numeric/riemann_hilbert/riemann_hilbert.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/bracketed_tilt.hpp"
#include "numeric/riemann_hilbert/contact_start.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::numeric {
namespace {

constexpr std::size_t most_pieces_of_coarse_start = 64;

template <Real R>
std::shared_ptr<RiemannHilbertSolution<R>> search_once(const ContactProblem& problem, const ContactStart& start) {
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
std::shared_ptr<RiemannHilbertSolution<R>> search(const ContactProblem& problem, const ContactStart& start) {
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
  // Gaps and zones of a profile with no corner are not much shorter than its pieces.
  if (pieces > 1000 && problem.indenter().is_smooth()) cells_per_piece.push_back(4);
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
  if (pieces > most_pieces_of_coarse_start) return best;
  for (const int cells : {48, 120, 300}) {
    if (solves(search<double>(problem, coarse_start(problem, cells)))) break;
  }
  return best;
}

/// Returns the problem with an indenter that keeps its attitude, turned by `tilt` about the place where the load acts.
ContactProblem with_attitude(const ContactProblem& problem, double tilt) {
  const Polynomial turned({-Rational(tilt) * *problem.load_at(), Rational(tilt)});
  std::vector<Indenter::Piece> pieces = problem.indenter().pieces();
  for (Indenter::Piece& piece : pieces) piece.profile = piece.profile + turned;
  return {problem.elasticity(), problem.friction(), Indenter(problem.indenter().left(), std::move(pieces)),
          problem.load(), problem.sliding()};
}

/// Continues a solution of a problem with the same places of the data, with this tilt of the reduced slope.
std::shared_ptr<RiemannHilbertSolution<double>> continued(const ContactProblem& problem,
                                                          const RiemannHilbertSolution<double>& from, double tilt) {
  const auto search = [&](const RoundedProblem<double>& reduced, JacobiRules<double>& rules) {
    const ContactState<double>& state = from.state();
    return search_contact(reduced, {ContactSet<double>::converted(reduced, state.set), state.q, tilt}, rules);
  };
  return std::make_shared<RiemannHilbertSolution<double>>(problem, from.problem().frame(), search);
}

/// Brackets the tilt by problems with a given attitude, then lets Newton's method go on from there. `stalled` is the
/// state that Newton's method has reached without it.
std::shared_ptr<RiemannHilbertSolution<double>> search_by_attitude(const ContactProblem& problem,
                                                                   const RiemannHilbertSolution<double>& stalled) {
  const auto compliance = to_real<double>(problem.elasticity().compliance());
  const auto load = to_real<double>(problem.load());
  const auto load_at = to_real<double>(*problem.load_at());
  const auto width = to_real<double>(Rational(problem.indenter().right() - problem.indenter().left()));
  std::map<double, std::shared_ptr<RiemannHilbertSolution<double>>> known;  // by tilt
  std::string why = stalled.failed_condition() + "; no bracket of the tilt was found";
  const auto offset = [&](double tilt) -> std::optional<double> {
    if (!std::isfinite(tilt)) return std::nullopt;
    const ContactProblem fixed = with_attitude(problem, tilt);
    std::shared_ptr<RiemannHilbertSolution<double>> found;
    const auto solves = [&found](std::shared_ptr<RiemannHilbertSolution<double>> next) {
      found = std::move(next);
      return found->failed_condition().empty();
    };
    // From the nearest solved attitudes on both sides, then from nothing.
    const auto above = known.lower_bound(tilt);
    const bool is_solved = (above != known.begin() && solves(continued(fixed, *std::prev(above)->second, 0))) ||
                           (above != known.end() && solves(continued(fixed, *above->second, 0))) ||
                           solves(search_from_nothing(fixed));
    if (!is_solved) {
      why = stalled.failed_condition() + "; with the tilt " + std::to_string(tilt) + ": " + found->failed_condition();
      return std::nullopt;
    }
    known[tilt] = found;
    return found->resultants().centre_of_pressure.value - load_at;
  };
  const std::optional<double> tilt =
      bracketed_tilt(offset, compliance * coarse_start(problem, 48).tilt, compliance * load / width / 16);
  if (tilt && offset(*tilt)) {
    auto found = continued(problem, *known[*tilt], *tilt / compliance);
    if (found->failed_condition().empty()) return found;
    why = found->failed_condition() + "; the tilt " + std::to_string(*tilt) + " is bracketed";
  }
  // The state is that of Newton's method, with the reason why the bracket does not help.
  const auto state = [&](const RoundedProblem<double>& reduced, JacobiRules<double>&) {
    const ContactState<double>& old = stalled.state();
    return SearchResult<double>{{ContactSet<double>::converted(reduced, old.set), old.q, old.tilt}, {}, why};
  };
  return std::make_shared<RiemannHilbertSolution<double>>(problem, stalled.problem().frame(), state);
}

/// Returns why double, in which every search begins, cannot hold the problem; empty if it can.
std::string beyond_double(const ContactProblem& problem) {
  constexpr double largest = 1e14;  // arctan(1/s)/pi, the distance of a power from its limit, is 3e-15
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) {
    if (std::abs(to_real<double>(problem.coupled_friction(k))) > largest)
      return "friction too large for the Riemann-Hilbert method; gamma f is at most 1e14";
  }
  std::vector<Rational> places = problem.friction().jumps();
  places.push_back(problem.indenter().left());
  for (const Indenter::Piece& piece : problem.indenter().pieces()) places.push_back(piece.to);
  std::sort(places.begin(), places.end());
  const Rational least = parse_rational("1e-300") * (problem.indenter().right() - problem.indenter().left());
  const auto near = [&](const Rational& a, const Rational& b) { return a != b && b - a < least; };
  if (std::adjacent_find(places.begin(), places.end(), near) != places.end())
    return "places too near for the Riemann-Hilbert method; the distance is at least 1e-300 of the support's width";
  return {};
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
  if (std::string reason = problem.body().beyond_half_plane(); !reason.empty()) return {nullptr, std::move(reason)};
  if (std::string reason = too_many_friction_pieces(problem, digits_of<R>); !reason.empty())
    return {nullptr, std::move(reason)};
  if (std::string reason = too_many_profile_breaks(problem, digits_of<R>); !reason.empty()) return {nullptr, reason};
  if (std::string reason = beyond_double(problem); !reason.empty()) return {nullptr, std::move(reason)};
  // For every precision, the contact is first found in double.
  std::shared_ptr<RiemannHilbertSolution<double>> rough;
  if (start) rough = search<double>(problem, start_from(problem, *start));
  if (!rough || !rough->failed_condition().empty()) rough = search_from_nothing(problem);
  const bool has_coarse_start = problem.indenter().pieces().size() <= most_pieces_of_coarse_start;
  if (problem.load_at() && has_coarse_start && !rough->failed_condition().empty())
    rough = search_by_attitude(problem, *rough);
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
