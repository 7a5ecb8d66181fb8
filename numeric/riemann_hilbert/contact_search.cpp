#include "numeric/riemann_hilbert/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "model/most_components.hpp"
#include "numeric/riemann_hilbert/contact_inequalities.hpp"

namespace steadyslide::numeric {
namespace {

template <Real R>
class Search {
 public:
  Search(const RoundedProblem<R>& problem, ContactState<R> start, JacobiRules<R>& rules)
      : problem_(problem), rules_(rules), state_(std::move(start)) {}

  SearchResult<R> run() {
    // A search in higher precision starts from the result in double. A long search means that an end moves back and
    // forth forever.
    constexpr int max_rounds = std::same_as<R, double> ? 60 : 20;
    std::string why = "the contact set kept changing";
    for (int round = 0; round < max_rounds; ++round) {
      NewtonResult<R> newton = solve_newton(problem_, state_, limits(), rules_);
      state_ = std::move(newton.state);
      switch (newton.status) {
        case NewtonResult<R>::Status::stalled:
          if (!newton.restless || !open_notch_at(*newton.restless)) {
            return failure("Newton's method for the contact's ends stalled", R(0));
          }
          break;
        case NewtonResult<R>::Status::collapse:
          if (cannot_vanish(newton.collapsing)) return failure("the gap beside a step is too short", R(0));
          if (!collapse(newton.collapsing)) return failure("an end of the contact has nowhere to go", R(0));
          break;
        case NewtonResult<R>::Status::converged: {
          snap();
          const TractionRepresentation<R> form(problem_, state_.set, state_.q, state_.tilt, rules_);
          const std::vector<Violation<R>> found = violations(form, newton.step);
          if (found.empty()) {
            std::string excess = too_many_components(problem_.problem(), state_.set.components());
            if (!excess.empty()) return result(std::move(excess), newton.step);
            SearchResult<R> solved = result({}, std::max(newton.step, newton.rounding.ends.distance));
            solved.errors.ends.length = 4 * std::max(newton.change, newton.rounding.ends.length) + 16 * epsilon<R>();
            solved.errors.tilt = newton.rounding.tilt;
            solved.errors.polynomial = std::move(newton.rounding.polynomial);
            solved.hairline_gaps = hairline_gaps(form, newton.step);
            return solved;
          }
          why = in_words(form, found, newton.step);
          before_gap_.reset();
          if (std::any_of(found.begin(), found.end(),
                          [](const Violation<R>& v) { return v.what == What::tension && v.anchor; })) {
            before_gap_ = result(why, newton.step);
          }
          if (round + 1 == max_rounds || !repair(found)) return failure(why, newton.step);
          break;
        }
      }
    }
    return failure(why, R(0));
  }

 private:
  using Set = ContactSet<R>;
  using What = typename Violation<R>::What;

  /// Returns the state; `error` is the error of its free ends.
  SearchResult<R> result(std::string failed_condition, const R& error) const {
    const R distance = std::max(error, epsilon<R>() * state_.set.span_length());
    return {state_, {{distance, R(1), R(1)}}, std::move(failed_condition)};
  }

  /// If a gap over a notch was not found, the state with contact there is the best one, and its violated condition has
  /// a name.
  SearchResult<R> failure(std::string why, const R& step) const {
    return before_gap_ ? *before_gap_ : result(std::move(why), step);
  }

  /// Returns a message with the first anchor that has tension, if there is one.
  static std::string in_words(const TractionRepresentation<R>& form, const std::vector<Violation<R>>& found,
                              const R& end_error) {
    for (const Violation<R>& v : found) {
      if (!v.anchor) continue;
      if (v.what == What::step)
        return "contact over a step of the profile at x = " + to_string(form.problem().place(*v.anchor));
      const std::size_t j = form.set().point_of(*v.anchor);
      return numeric::in_words(form, j, *leading_term(form, j, end_error));
    }
    bool tension = false;
    bool penetration = false;
    for (const Violation<R>& v : found) (v.what == What::tension ? tension : penetration) = true;
    if (tension && penetration) return "the traction pulls and the surfaces penetrate";
    return tension ? "the traction pulls in part of the contact" : "the surfaces penetrate outside the contact";
  }

  /// Returns the distances from an anchor within which an end may cross it. Every crossing reduces the distance, so
  /// that an end very close to the anchor converges and does not jump over it forever. The same holds for gaps that
  /// close and for components that vanish, because contact at a corner begins with length 0.
  std::vector<R> limits() const {
    const Set& set = state_.set;
    const R hull = set.span_length();
    std::vector<R> result(set.segments(), R(1e-3) * hull);
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (!set.in_contact(k) && set.point(k).is_end() && set.point(k + 1).is_end()) {
        result[k] = hull * pow(R(1e-3), closings_ + 1);
      }
      if (set.in_contact(k) && set.point(k).is_end() && set.point(k + 1).is_end()) {
        result[k] = hull * pow(R(1e-3), removals_ + 1);
      }
      if (cannot_vanish(k)) result[k] = problem_.shortest_gap();
      for (const std::size_t j : {k, k + 1}) {
        if (!set.point(j).anchor) continue;
        if (const auto found = crossings_.find(*set.point(j).anchor); found != crossings_.end()) {
          result[k] = std::min(result[k], hull * pow(R(1e-3), found->second + 1));
        }
      }
    }
    return result;
  }

  /// True for the gap beside a step. It cannot close for any length, and contact cannot cross it.
  bool cannot_vanish(std::size_t k) const {
    const Set& set = state_.set;
    if (set.in_contact(k)) return false;
    const auto stays = [&](std::size_t step, std::size_t end) {
      return set.is_at_step(step) && set.point(end).is_movable() &&
             !problem_.edge_possible(end == k ? End::right : End::left, *set.point(step).anchor);
    };
    return stays(k, k + 1) || stays(k + 1, k);
  }

  /// Returns false and changes nothing if the set is inconsistent, because two simultaneous changes contradict each
  /// other.
  bool renew(Set set) {
    if (!set.is_consistent()) return false;
    state_ = ContactState<R>::initial(problem_, std::move(set), state_.tilt);
    return true;
  }

  bool collapse(std::size_t k) {
    Set set = state_.set;
    const auto left = set.point(k);
    const auto right = set.point(k + 1);
    const bool left_moves = left.is_movable();
    const std::size_t j = left_moves ? k : k + 1;
    const Side towards = left_moves ? Side::right : Side::left;
    if (set.is_over_notch(k)) {
      const std::size_t begin = left_moves ? k : k - 1;
      // If both halves are about as short as the shortest gap, there is no gap, or a shorter one that cannot be found.
      if (std::max(set.length(begin), set.length(begin + 1)) > R(1e6) * problem_.shortest_gap())
        return cross(j, towards);
      vanished_.insert(*set.point(begin + 1).anchor);
      set.remove_interval(begin);
      return renew(std::move(set));
    }
    if (left.is_end() && right.is_end()) {
      if (set.in_contact(k) ? set.components() == 1 : !left_moves || !right.is_movable()) return false;
      ++(set.in_contact(k) ? removals_ : closings_);
      set.remove_interval(k);
      return renew(std::move(set));
    }
    if (set.in_contact(k)) return cross(j, towards);
    const std::size_t anchor = *(left_moves ? right : left).anchor;
    const bool is_support_end = anchor == 0 || anchor + 1 == problem_.anchors().size();
    if (!is_support_end && problem_.anchors()[anchor].step_sign == 0) return cross(j, towards);
    const End end = left_moves ? End::right : End::left;
    if (!problem_.edge_possible(end, anchor)) return false;
    ++crossings_[anchor];
    set.attach_to_anchor(j, towards, false);
    return renew(std::move(set));
  }

  /// Contact that ends just beyond a notch has tension in the notch, and Newton's method may find no length for the
  /// part beyond it. Then there are a gap over the notch and a component behind it. Returns false if the end j is not
  /// such an end.
  bool open_notch_at(std::size_t j) {
    Set set = state_.set;
    const std::size_t notch = set.neighbour(j);
    const auto* anchor = set.anchor_at(notch);
    if (!anchor || !(anchor->exact.wedge < 0) || set.point(notch).is_end()) return false;
    if (!opened_at_ends_.insert(*set.point(notch).anchor).second) return false;
    const R half = std::min(set.length(notch - 1), set.length(notch)) / 2;
    set.open({notch - 1, set.length(notch - 1) - half, half}, {notch, half, set.length(notch) - half});
    return renew(std::move(set));
  }

  bool cross(std::size_t j, Side towards) {
    Set set = state_.set;
    const auto& neighbour = set.point(towards == Side::left ? j - 1 : j + 1);
    if (!neighbour.anchor || neighbour.is_end()) return false;
    ++crossings_[*neighbour.anchor];
    const R distance = set.length(towards == Side::left ? j - 1 : j);
    set.cross_anchor(j, towards, distance);
    if (!set.is_consistent()) return false;
    state_.set = std::move(set);
    return true;
  }

  /// Moves a free end to a friction jump if the distance is within rounding. It does not do so at a wedge: contact that
  /// reaches beyond a wedge by a length l carries a load of order l^(1/2 - |alpha|), which matters even for a tiny l.
  void snap() {
    const R rounding = 4 * epsilon<R>() * state_.set.span_length();
    for (const std::size_t j : state_.set.movable()) {
      const std::size_t neighbour = state_.set.neighbour(j);
      const auto* anchor = state_.set.anchor_at(neighbour);
      if (state_.set.length(state_.set.inside(j)) > rounding || !anchor || anchor->is_break ||
          state_.set.point(neighbour).is_end()) {
        continue;
      }
      state_.set.attach_to_anchor(j, state_.set.contact_side(j), true);
      return snap();
    }
  }

  bool repair(const std::vector<Violation<R>>& found) {
    Set set = state_.set;
    if (std::any_of(found.begin(), found.end(),
                    [&](const auto& v) { return v.anchor && vanished_.count(*v.anchor) != 0; }))
      return false;
    // From right to left, so that indices on the left stay valid.
    for (std::size_t i = found.size(); i-- > 0;) {
      const Violation<R>& v = found[i];
      if (v.what == What::penetration) {
        add_component(set, v);
      } else if (v.what == What::step) {
        open_beside_step(set, *v.anchor);
      } else if (!remove_contact(set, v)) {
        return false;
      }
    }
    return renew(std::move(set));
  }

  using SegmentPlace = typename Set::SegmentPlace;
  static SegmentPlace place(const SurfacePoint<R>& at) {
    return {static_cast<std::size_t>(at.segment), at.node.from_left, at.node.from_right};
  }
  static SegmentPlace between(const SegmentPlace& a, const SegmentPlace& b, const R& part) {
    return {a.segment, a.from_left + part * (b.from_left - a.from_left),
            a.from_right + part * (b.from_right - a.from_right)};
  }

  void add_component(Set& set, const Violation<R>& v) {
    const SegmentPlace from = place(v.from);
    const SegmentPlace to = place(v.to);
    // The new contact is shorter than the interval of penetration: take its middle.
    const bool together = from.segment == to.segment;
    const SegmentPlace first_end = together ? to : SegmentPlace{from.segment, from.from_left + from.from_right, R(0)};
    const SegmentPlace last_end = together ? from : SegmentPlace{to.segment, R(0), to.from_left + to.from_right};
    const R part = together ? 0.25 : 0.5;
    set.open(between(from, first_end, part), between(to, last_end, part));
    // A corner that penetrates touches first. The indices refer to the new points and to the corners.
    const std::size_t right = to.segment + 3, left = from.segment;
    if (to.from_right == 0 && is_corner(set, End::right, right)) set.attach_to_anchor(right - 1, Side::right, false);
    if (from.from_left == 0 && is_corner(set, End::left, left)) set.attach_to_anchor(left + 1, Side::left, false);
  }

  bool is_corner(const Set& set, End end, std::size_t j) const {
    return set.point(j).anchor && !set.point(j).is_end() && problem_.edge_possible(end, *set.point(j).anchor);
  }

  /// Opens a gap over an anchor with tension, if the tension reaches much less far than the next anchors and ends. The
  /// gap is equally long on both sides, because the law of the corner is symmetric.
  static bool open_over(Set& set, const Violation<R>& v) {
    if (!v.log_reach) return false;
    const std::size_t j = set.point_of(*v.anchor);
    const R reach = exp(*v.log_reach);
    const R& left = set.length(j - 1);
    const R& right = set.length(j);
    if (set.point(j).is_end() || !(reach < R(0.05) * std::min(left, right))) return false;
    set.open({j - 1, left - reach, reach}, {j, reach, right - reach});
    return true;
  }

  /// Opens a gap beside a step, on the side that recedes. On the other side contact ends at the step.
  void open_beside_step(Set& set, std::size_t anchor) {
    const std::size_t j = set.point_of(anchor);
    const bool left_recedes = problem_.edge_possible(End::left, anchor);
    const R left = set.length(j - 1) / 2;
    const R right = set.length(j) / 2;
    set.open({j - 1, left, left}, {j, right, right});
    set.attach_to_anchor(left_recedes ? j + 2 : j, left_recedes ? Side::left : Side::right, false);
  }

  bool remove_contact(Set& set, const Violation<R>& v) {
    const SegmentPlace from = place(v.from);
    const SegmentPlace to = place(v.to);
    if (v.anchor && open_over(set, v)) return true;
    const bool at_left = from.from_left == 0 && set.point(from.segment).is_end();
    const bool at_right = to.from_right == 0 && set.point(to.segment + 1).is_end();
    if (at_left && at_right) {
      if (set.components() == 1) return false;
      set.remove_interval(from.segment);
      return true;
    }
    // An end with tension beside it moves to the place where the tension stops.
    if (at_left) {
      set.move_end(from.segment, to.segment, std::min(to.from_left, set.length(to.segment) * R(0.9)));
    } else if (at_right) {
      set.move_end(to.segment + 1, from.segment, std::max(from.from_left, set.length(from.segment) * R(0.1)));
    } else {
      set.open(from, to);
    }
    return true;
  }

  const RoundedProblem<R>& problem_;
  JacobiRules<R>& rules_;
  ContactState<R> state_;
  std::optional<SearchResult<R>> before_gap_;
  std::set<std::size_t> vanished_;        ///< anchors over which a gap became shorter than the shortest gap
  std::set<std::size_t> opened_at_ends_;  ///< anchors that open_notch_at() has treated
  std::map<std::size_t, int> crossings_;
  int closings_ = 0;
  int removals_ = 0;  ///< number of components that vanished
};

}  // namespace

template <Real R>
SearchResult<R> search_contact(const RoundedProblem<R>& problem, ContactState<R> start, JacobiRules<R>& rules) {
  return Search<R>(problem, std::move(start), rules).run();
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template SearchResult<R> search_contact(const RoundedProblem<R>&, ContactState<R>, JacobiRules<R>&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
