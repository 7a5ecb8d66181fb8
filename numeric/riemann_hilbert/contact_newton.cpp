#include "numeric/riemann_hilbert/contact_newton.hpp"

#include <cmath>
#include <random>

#include "numeric/number/dense_lu.hpp"
#include "numeric/number/linear_system.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"

namespace steadyslide::numeric {
namespace {

/// q(z)/(z - e) without its remainder.
template <Real R>
std::vector<R> quotient(const std::vector<R>& q, const R& e) {
  std::vector<R> result(q.empty() ? 0 : q.size() - 1, R(0));
  R carry = 0;
  for (std::size_t k = q.size(); k-- > 1;) {
    carry = carry * e + q[k];
    result[k - 1] = carry;
  }
  return result;
}

/// Large systems in double by blocks.
std::optional<std::vector<double>> solve_equations(const std::vector<std::vector<double>>& rows) {
  constexpr std::size_t few = 48;
  if (rows.size() <= few) return solve_linear(rows);
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix(n, n);
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Map<const Eigen::VectorXd> row(rows[static_cast<std::size_t>(i)].data(), n + 1);
    const double largest = row.head(n).cwiseAbs().maxCoeff();
    if (!(largest > 0)) return std::nullopt;
    matrix.row(i) = row.head(n) / largest;
    right(i) = row(n) / largest;
  }
  const Eigen::VectorXd x = DenseLu(matrix).solve(right);
  return std::vector<double>(x.begin(), x.end());
}

template <Real R>
std::optional<std::vector<R>> solve_equations(const std::vector<std::vector<R>>& rows) {
  return solve_linear(rows);
}

/// |J^-1| e: what errors of the equations, at most e, do to the unknowns. Of many equations, for which the inverse costs
/// more than all steps, what a few choices of signs make of them.
template <Real R>
std::vector<R> amplified(const std::vector<std::vector<R>>& rows, const std::vector<R>& errors) {
  constexpr Eigen::Index few = 48, choices = 4;
  using std::abs;
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd matrix(n, n);
  Eigen::VectorXd sizes(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<R>& row = rows[static_cast<std::size_t>(i)];
    R largest = 0;
    for (std::size_t j = 0; j < rows.size(); ++j) largest = std::max(largest, R(abs(row[j])));
    for (Eigen::Index j = 0; j < n; ++j)
      matrix(i, j) = static_cast<double>(R(row[static_cast<std::size_t>(j)] / largest));
    sizes(i) = static_cast<double>(R(errors[static_cast<std::size_t>(i)] / (epsilon<R>() * largest)));
  }
  const DenseLu lu(matrix);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  if (n <= few) {
    sum = lu.inverse().cwiseAbs() * sizes;
  } else {
    std::minstd_rand signs;
    for (Eigen::Index k = 0; k < choices; ++k) {
      const Eigen::VectorXd choice = sizes.unaryExpr([&](double e) { return signs() % 2 == 0 ? e : -e; });
      sum += lu.solve(choice).cwiseAbs();
    }
  }
  std::vector<R> result;
  for (const double x : sum) result.push_back(epsilon<R>() * x);
  return result;
}

/// One linearisation: the unknowns rho_f, r and the change of the tilt.
template <Real R>
class Linearisation {
 public:
  explicit Linearisation(const RiemannHilbertForm<R>& form)
      : form_(form),
        degree_(form.degree_at_infinity()),
        movable_(form.set().movable()),
        free_(columns(form, movable_)),
        coefficients_(static_cast<std::size_t>(std::max(-degree_ - 1, 0))),
        tilts_(form.problem().load_at().has_value()),
        size_(free_.size() + coefficients_ + (tilts_ ? 1 : 0)),
        equations_(size_, std::vector<R>(size_ + 1, R(0))),
        errors_(size_, R(0)) {
    // With pivots the load is what an end that stays on a jump leaves to be checked.
    if (!has_pivots()) add_moments();
    add_gaps();
    if (tilts_) add_centre();
    if (has_pivots()) add_moments();
  }

  /// False where the number of conditions is not that of the unknowns (ends that cannot move, though they are free).
  bool solve() {
    if (row_ != size_) return false;
    const std::optional<std::vector<R>> solution = solve_equations(equations_);
    if (solution) solution_ = *solution;
    return solution.has_value();
  }

  /// Do the conditions beyond the number of unknowns hold? With an end that stays on a jump there is one more than
  /// there are ends that move: the end belongs there, or this is no solution.
  bool is_complete() const { return complete_; }

  std::vector<R> end_steps() const {
    std::vector<R> steps;
    std::size_t f = 0;
    for (const std::size_t j : movable_) {
      const Side side = form_.set().contact_side(j);
      R b = form_.regular_factor_at(j, side).value;
      if (has_pivots()) {
        const std::size_t component = form_.y().component_of(j);
        const R& at_pivot = form_.pivot_moment(component).value;
        const SurfacePoint<R> place = beside(form_.set(), j, side, R(0));
        if (is_pivot(form_, j)) {
          steps.push_back((neighbours_at(place) - at_pivot - tilt_step()) / (form_.power(j).value * b));
          continue;
        }
        b = b * form_.y().to_pivot(place) + at_pivot;
      }
      steps.push_back(solution_[f++] / (form_.power(j).value * b));
    }
    return steps;
  }

  R tilt_step() const { return tilts_ ? solution_.back() : R(0); }

  /// What rounding in the equations may have done to any end, and to the tilt.
  std::pair<R, R> rounding() const {
    using std::abs;
    if (size_ == 0) return {R(0), R(0)};
    const std::vector<R> unknowns = amplified(equations_, errors_);
    const R tilt = tilts_ ? unknowns.back() : R(0);
    R largest = 0;
    std::size_t f = 0;
    for (const std::size_t j : movable_) {
      const Side side = form_.set().contact_side(j);
      R b = form_.regular_factor_at(j, side).value;
      R error = 0;
      const SurfacePoint<R> place = beside(form_.set(), j, side, R(0));
      if (has_pivots() && is_pivot(form_, j)) {
        const std::vector<R> distances = form_.distances(place);
        error = tilt + form_.pivot_moment(form_.y().component_of(j)).error;
        for (std::size_t i = 0; i < free_.size(); ++i) error += abs(unknowns[i] / distances[free_[i]]);
      } else {
        if (has_pivots()) b *= form_.y().to_pivot(place);
        error = unknowns[f++];
      }
      largest = std::max(largest, R(abs(error / (form_.power(j).value * b))));
    }
    return {largest, tilt};
  }

  /// The change of q that goes with ends moved by `moved`, when `part` of the step is taken.
  std::vector<R> q_step(const std::vector<R>& moved, const R& part) const {
    if (has_pivots()) return theta_step(moved, part);
    std::vector<R> step(form_.q().size(), R(0));
    for (std::size_t k = 0; k < coefficients_; ++k) {
      step[k] += part * pi<R>() * solution_[free_.size() + k];
    }
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const std::vector<R> quot = quotient(form_.q(), form_.set().x(free_[f]));
      const R factor = form_.power(free_[f]).value * moved[f];
      for (std::size_t k = 0; k < quot.size(); ++k) step[k] += factor * quot[k];
    }
    return step;
  }

 private:
  bool has_pivots() const { return !form_.y().pivots().empty(); }
  /// Of a component with two free ends.
  static bool is_pivot(const RiemannHilbertForm<R>& form, std::size_t j) {
    const auto& pivot = form.y().pivots()[form.y().component_of(j)];
    return pivot.order > 0 && pivot.point == j;
  }

  /// The points that have a rho: free ends, but no pivots; then the poles of components without a free end.
  static std::vector<std::size_t> columns(const RiemannHilbertForm<R>& form, const std::vector<std::size_t>& movable) {
    if (form.y().pivots().empty()) return movable;
    std::vector<std::size_t> result;
    for (const std::size_t j : movable) {
      if (!is_pivot(form, j)) result.push_back(j);
    }
    for (const auto& pivot : form.y().pivots()) {
      if (pivot.order < 0) result.push_back(pivot.point);
    }
    return result;
  }

  /// sum_f rho_f/(x - e_f)
  R neighbours_at(const SurfacePoint<R>& place) const {
    const std::vector<R> distances = form_.distances(place);
    R sum = 0;
    for (std::size_t f = 0; f < free_.size(); ++f) sum += solution_[f] / distances[free_[f]];
    return sum;
  }

  /// theta_j/pi is the residue of u'/(c Y) at e_j: Y, too, changes with the ends.
  std::vector<R> theta_step(const std::vector<R>& moved, const R& part) const {
    const auto& pivots = form_.y().pivots();
    std::vector<R> step(pivots.size(), R(0));
    std::size_t f = 0;
    while (f < free_.size() && form_.set().point(free_[f]).is_movable()) ++f;
    for (std::size_t i = 0; i < pivots.size(); ++i) {
      if (pivots[i].order >= 0) continue;
      const R& pole = form_.set().x(pivots[i].point);
      step[i] = part * pi<R>() * solution_[f++];
      for (std::size_t k = 0; k < movable_.size(); ++k) {
        const R& p = form_.fundamental_solution().powers()[movable_[k]].value;
        step[i] += form_.q()[i] * p * moved[k] / (pole - form_.set().x(movable_[k]));
      }
    }
    return step;
  }

  R& at(std::size_t column) { return equations_[row_][column]; }
  void set_right(const Estimate<R>& value) {
    at(size_) = value.value;
    errors_[row_] = value.error;
  }
  R end(std::size_t f) const { return form_.set().x(free_[f]); }

  void add_moments() {
    if (degree_ < 0) return;
    const auto count = static_cast<std::size_t>(degree_ + 1);
    const std::vector<Estimate<R>> m = form_.moments(count);
    for (std::size_t j = 0; j < count; ++j) {
      const Estimate<R> missing = Estimate<R>{j + 1 == count ? form_.problem().load() / pi<R>() : R(0), R(0)} - m[j];
      if (row_ >= size_) {
        using std::abs, std::sqrt;
        if (!(abs(missing.value) <= sqrt(epsilon<R>()) * form_.problem().load())) complete_ = false;
        continue;
      }
      for (std::size_t f = 0; f < free_.size(); ++f) {
        R power = 1;
        for (std::size_t i = 0; i < j; ++i) power *= end(f);
        at(f) = power;
      }
      if (tilts_) at(free_.size()) = form_.expansion().tilt_moment(j);
      set_right(missing);
      ++row_;
    }
  }

  void add_gaps() {
    const ContactSet<R>& set = form_.set();
    std::vector<std::size_t> ends = set.all(ContactSet<R>::Kind::ends);
    ends.pop_back();
    for (const std::size_t j : ends) {
      if (row_ >= size_) {
        ++row_;
        continue;
      }
      const GapIntegral<R> gap(form_, j);
      const auto rule = gap.rule();
      for (const auto& node : rule) {
        // Over a tiny gap the weight times Y alone may be no number any more.
        const std::vector<R> distances = form_.distances(node.at);
        for (std::size_t f = 0; f < free_.size(); ++f) at(f) -= node.weight * (node.y / distances[free_[f]]);
        const R weight = node.weight * node.y;
        R power = weight;
        for (std::size_t k = 0; k < coefficients_; ++k) {
          at(free_.size() + k) -= power;
          power *= node.at.node.x;
        }
        if (tilts_) at(free_.size() + coefficients_) += weight * form_.expansion().tilt_polynomial(node.at.node.x);
      }
      set_right(-gap.closure_error(rule));
      ++row_;
    }
  }

  /// The coefficient of z^-2 of u'/c is P load_at/pi.
  void add_centre() {
    if (row_ >= size_) {
      ++row_;
      return;
    }
    const std::vector<R>& d = form_.expansion().series();
    const auto count = static_cast<std::size_t>(std::max(degree_ + 2, 0));
    const auto series = [&](std::size_t j) { return d[static_cast<std::size_t>(degree_ + 1) - j]; };
    for (std::size_t l = 0; l < coefficients_; ++l) {
      const int index = degree_ + 2 + static_cast<int>(l);
      if (index >= 0) at(free_.size() + l) += d[static_cast<std::size_t>(index)];
    }
    for (std::size_t f = 0; f < free_.size(); ++f) {
      R power = 1;
      for (std::size_t j = 0; j < count; ++j) {
        at(f) += power * series(j);
        power *= end(f);
      }
    }
    for (std::size_t j = 0; j < count; ++j)
      at(free_.size() + coefficients_) += form_.expansion().tilt_moment(j) * series(j);
    const R wanted = form_.problem().load() * *form_.problem().load_at();
    set_right((Estimate<R>{wanted, R(0)}.widened(epsilon<R>()) - form_.moment_of_load()) / pi<R>());
    ++row_;
  }

  const RiemannHilbertForm<R>& form_;
  int degree_;
  std::vector<std::size_t> movable_;
  std::vector<std::size_t> free_;  ///< those that have a rho
  std::size_t coefficients_;       ///< of r
  bool tilts_;
  std::size_t size_;
  std::vector<std::vector<R>> equations_;  ///< with their right sides
  std::vector<R> errors_;                  ///< of the right sides
  std::vector<R> solution_;
  std::size_t row_ = 0;
  bool complete_ = true;
};

template <Real R>
bool is_finite(const std::vector<R>& values) {
  using std::abs;
  for (const R& v : values) {
    if (!(abs(v) < infinity<R>())) return false;
  }
  return true;
}

/// The iteration on one kind of contact set.
template <Real R>
class Newton {
 public:
  using Status = typename NewtonResult<R>::Status;

  Newton(const ReducedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits, JacobiRules<R>& rules)
      : problem_(problem), state_(std::move(state)), limits_(limits), rules_(rules) {}

  NewtonResult<R> run() {
    using std::abs, std::sqrt;
    constexpr int max_steps = 100;
    // Within this part of the hull quadratic convergence has left nothing but rounding.
    const R rounding = 8 * epsilon<R>();
    R previous = infinity<R>();
    R previous_beside = infinity<R>();
    for (int iteration = 0; iteration < max_steps; ++iteration) {
      const RiemannHilbertForm<R> form(problem_, state_.set, state_.q, state_.tilt, rules_);
      Linearisation<R> linear(form);
      if (!linear.solve()) break;
      std::vector<R> ends = linear.end_steps();
      const R tilt_step = linear.tilt_step();
      if (!is_finite(ends) || !(abs(tilt_step) < infinity<R>())) break;

      free_ = state_.set.movable();
      R largest = 0;
      for (const R& step : ends) largest = std::max(largest, abs(step));
      const R hull = state_.set.span_length();
      const R beside_wedges = follow_lengths(ends, hull);
      const auto [part, tightest] = admissible_part(ends);
      const bool moves = largest > rounding * hull || state_.set.is_over_notch(tightest);
      if (part < 1 && state_.set.length(tightest) < limit(tightest) && moves) {
        return {std::move(state_), Status::collapse, tightest, largest};
      }
      for (R& step : ends) step *= part;
      const std::vector<R> q_step = linear.q_step(ends, part);
      state_.set.move(ends);
      for (std::size_t k = 0; k < q_step.size(); ++k) state_.q[k] += q_step[k];
      state_.tilt += part * tilt_step;

      const R movement = std::max({largest / hull, relative_change(q_step, state_.q) / part,
                                   abs(tilt_step) / std::max(abs(state_.tilt), R(1))});
      if (!(movement < infinity<R>())) break;
      const bool settled = movement <= rounding && beside_wedges <= R(1e-7);
      // Rounding may keep the last steps above that: they are small, and no longer shrink.
      const bool at_rounding_level = movement < sqrt(epsilon<R>()) && movement >= previous / 2 &&
                                     beside_wedges <= R(1e-3) &&
                                     (beside_wedges <= R(1e-7) || beside_wedges >= previous_beside / 2);
      // An end that rounding alone drives across an anchor takes part of the step for ever: it is where it belongs.
      if (settled || (part == 1 && at_rounding_level)) {
        if (!linear.is_complete()) break;
        const auto [ends_rounding, tilt_rounding] = linear.rounding();
        return {std::move(state_), Status::converged, 0, movement * hull, ends_rounding, tilt_rounding};
      }
      previous = part == 1 ? movement : infinity<R>();
      // Orders of magnitude that swing to and fro want shorter steps.
      damping_ = beside_wedges > R(0.5) && beside_wedges > previous_beside / 2 ? damping_ * 0.7
                                                                               : std::min(1.5 * damping_, R(1));
      previous_beside = beside_wedges;
    }
    return {std::move(state_), Status::stalled};
  }

 private:
  R limit(std::size_t k) const { return state_.set.is_over_notch(k) ? R(shortest_gap) : limits_[k]; }

  /// Does contact at the free end j reach just beyond a break of the profile? There the length l of that piece counts
  /// by its order of magnitude: it carries a load like l^(1 - p), and p may be near 1.
  bool is_beside_break(std::size_t j, const R& hull) const {
    const auto* anchor = state_.set.anchor_at(state_.set.neighbour(j));
    return anchor && anchor->is_break && state_.set.length(state_.set.inside(j)) < R(0.05) * hull;
  }

  /// The logarithm of the factor of a gap's length over a notch, for the linear step `growth` of that logarithm: what
  /// is linear is not the logarithm but the traction beside the gap, like length^-beta.
  R notch_step(const R& growth, const R& beta) const {
    using std::log1p;
    const R part = std::max(-beta * growth, R(-0.99));
    return std::clamp(beta == 0 ? growth : -log1p(part) / beta, R(-30), R(6)) * damping_;
  }

  /// Steps of such ends, and of gaps over notches, are steps of log l. Returns the largest of them.
  R follow_lengths(std::vector<R>& ends, const R& hull) const {
    using std::abs, std::expm1;
    R largest = 0;
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const std::size_t j = free_[f];
      const bool begins = state_.set.contact_side(j) == Side::right;
      const R outwards = begins ? R(-1) : R(1);
      if (const std::size_t outside = begins ? j - 1 : j; state_.set.is_over_notch(outside)) {
        const R& length = state_.set.length(outside);
        const R growth = -outwards * ends[f] / length;
        largest = std::max(largest, abs(growth));
        const R& beta = problem_.jump(*state_.set.point(begins ? j - 1 : j + 1).anchor).power.value;
        ends[f] = -outwards * length * expm1(notch_step(growth, beta));
        continue;
      }
      if (!is_beside_break(j, hull)) continue;
      const R& length = state_.set.length(state_.set.inside(j));
      const R growth = outwards * ends[f] / length;
      largest = std::max(largest, abs(growth));
      ends[f] = outwards * length * expm1(std::clamp(growth, R(-7), R(3)));
    }
    return largest;
  }

  /// How much of the step leaves every segment a tenth of its length at least, and the segment that says so. The length
  /// beyond a break counts as admissible until it is below its limit.
  std::pair<R, std::size_t> admissible_part(const std::vector<R>& ends) const {
    std::vector<R> change(state_.set.segments(), R(0));
    for (std::size_t f = 0; f < free_.size(); ++f) {
      change[free_[f] - 1] += ends[f];
      change[free_[f]] -= ends[f];
    }
    const R hull = state_.set.span_length();
    std::vector<char> by_order(state_.set.segments(), 0);
    for (const std::size_t j : free_) {
      const std::size_t k = state_.set.inside(j);
      by_order[k] = is_beside_break(j, hull) && state_.set.length(k) >= limits_[k];
    }
    for (std::size_t k = 0; k < change.size(); ++k) {
      if (state_.set.is_over_notch(k)) by_order[k] = state_.set.length(k) >= limit(k);
    }
    R part = 1;
    std::size_t tightest = 0;
    for (std::size_t k = 0; k < change.size(); ++k) {
      if (by_order[k] || !(change[k] < 0)) continue;
      const R allowed = -R(0.9) * state_.set.length(k) / change[k];
      if (allowed < part) {
        part = allowed;
        tightest = k;
      }
    }
    return {part, tightest};
  }

  R relative_change(const std::vector<R>& step, const std::vector<R>& q) const {
    using std::abs;
    R change = 0;
    R size = problem_.load();
    for (const R& c : step) change = std::max(change, abs(c));
    for (const R& c : q) size = std::max(size, abs(c));
    return change / size;
  }

  const ReducedProblem<R>& problem_;
  ContactState<R> state_;
  const std::vector<R>& limits_;
  JacobiRules<R>& rules_;
  std::vector<std::size_t> free_;
  R damping_ = 1;  ///< of steps over notches
};

}  // namespace

template <Real R>
ContactState<R> ContactState<R>::initial(const ReducedProblem<R>& problem, ContactSet<R> set, const R& tilt) {
  if (set.components() > problem.most_coupled()) {
    std::vector<R> theta;
    R poles = 0;
    for (const std::size_t begin : set.all(ContactSet<R>::Kind::begins)) {
      std::size_t end = begin + 1;
      while (!set.point(end).is_end()) ++end;
      theta.push_back(set.point(begin).vanishes || set.point(end).vanishes ? 0 : 1);
      poles += theta.back();
    }
    for (R& t : theta) t *= problem.load() / std::max(poles, R(1));
    return {std::move(set), std::move(theta), tilt};
  }
  int degree = -static_cast<int>(set.components());
  for (const auto& point : set.points()) degree += point.is_free() ? 1 : 0;
  std::vector<R> q(static_cast<std::size_t>(std::max(-degree, 0)), R(0));
  if (!q.empty()) q.back() = problem.load();
  return {std::move(set), std::move(q), tilt};
}

template <Real R>
NewtonResult<R> solve_newton(const ReducedProblem<R>& problem, ContactState<R> state, const std::vector<R>& limits,
                             JacobiRules<R>& rules) {
  return Newton<R>(problem, std::move(state), limits, rules).run();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                        \
  template struct ContactState<R>;                                                                        \
  template NewtonResult<R> solve_newton(const ReducedProblem<R>&, ContactState<R>, const std::vector<R>&, \
                                        JacobiRules<R>&);
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
