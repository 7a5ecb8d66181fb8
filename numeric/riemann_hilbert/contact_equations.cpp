#include "numeric/riemann_hilbert/contact_equations.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "numeric/number/dense_lu.hpp"
#include "numeric/number/mapped.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns q(z)/(z - e) without its remainder.
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

/// Solves the equations row[0] x_0 + ... + row[n-1] x_{n-1} = row[n] by elimination; in double, many equations are
/// solved by blocks. Rows may have very different sizes: each is scaled to one. The result is absent if a row is zero,
/// and not finite if the rows are linearly dependent.
template <Real R>
std::optional<std::vector<R>> solve_equations(std::vector<std::vector<R>> rows) {
  const std::size_t n = rows.size();
  for (std::vector<R>& row : rows) {
    R largest = 0;
    for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, R(abs(row[k])));
    if (!(largest > 0)) return std::nullopt;
    for (R& entry : row) entry /= largest;
  }
  if constexpr (std::same_as<R, double>) {
    constexpr std::size_t few = 48;
    if (n > few) {
      const auto size = static_cast<Eigen::Index>(n);
      Eigen::MatrixXd matrix(size, size);
      Eigen::VectorXd right(size);
      for (Eigen::Index i = 0; i < size; ++i) {
        const std::vector<double>& row = rows[static_cast<std::size_t>(i)];
        matrix.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), size);
        right(i) = row.back();
      }
      const Eigen::VectorXd x = DenseLu(matrix).solve(right);
      return std::vector<double>(x.begin(), x.end());
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const R factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k + 1; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<R> x(n);
  for (std::size_t k = n; k-- > 0;) {
    x[k] = rows[k][n] / rows[k][k];
    for (std::size_t i = 0; i < k; ++i) rows[i][n] -= rows[i][k] * x[k];
  }
  return x;
}

/// Returns |J^-1| e, the errors of the unknowns if the errors of the equations are at most e. For many equations the
/// inverse would cost more than all steps; then a few choices of the signs of e are used as an estimate.
template <Real R>
std::vector<R> amplified(const std::vector<std::vector<R>>& rows, const std::vector<R>& errors) {
  constexpr Eigen::Index few = 48, choices = 4;
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
  return mapped(sum, [](double x) { return R(epsilon<R>() * x); });
}

/// True if point j is the pivot of a component with two free ends.
template <Real R>
bool is_free_pivot(const TractionRepresentation<R>& form, std::size_t j) {
  const auto& pivot = form.y().pivots()[form.y().component_of(j)];
  return pivot.order > 0 && pivot.point == j;
}

/// Returns the points that have a rho: free ends that are not pivots, then the poles of components without a free end.
template <Real R>
std::vector<std::size_t> columns(const TractionRepresentation<R>& form, const std::vector<std::size_t>& movable) {
  if (form.y().pivots().empty()) return movable;
  std::vector<std::size_t> result;
  for (const std::size_t j : movable) {
    if (!is_free_pivot(form, j)) result.push_back(j);
  }
  for (const auto& pivot : form.y().pivots()) {
    if (pivot.order < 0) result.push_back(pivot.point);
  }
  return result;
}

}  // namespace

template <Real R>
ContactEquations<R>::ContactEquations(const TractionRepresentation<R>& form)
    : form_(form),
      degree_(form.degree_at_infinity()),
      movable_(form.set().movable()),
      free_(columns(form, movable_)),
      coefficients_(static_cast<std::size_t>(std::max(-degree_ - 1, 0))),
      tilts_(form.problem().load_at().has_value()),
      size_(free_.size() + coefficients_ + (tilts_ ? 1 : 0)),
      equations_(size_, std::vector<R>(size_ + 1, R(0))),
      errors_(size_, R(0)) {
  // With pivots, the load is the condition that remains to be checked for an end that stays on a jump.
  if (!has_pivots()) add_moments();
  add_gaps();
  if (tilts_) add_centre();
  if (has_pivots()) add_moments();
}

template <Real R>
bool ContactEquations<R>::solve() {
  if (row_ != size_) return false;
  const std::optional<std::vector<R>> solution = solve_equations(equations_);
  if (solution) solution_ = *solution;
  return solution.has_value();
}

template <Real R>
std::vector<R> ContactEquations<R>::end_steps() const {
  std::vector<R> steps;
  std::size_t f = 0;
  for (const std::size_t j : movable_) {
    const Side side = form_.set().contact_side(j);
    R b = form_.regular_factor_at(j, side).value;
    if (has_pivots()) {
      const std::size_t component = form_.y().component_of(j);
      const R& at_pivot = form_.pivot_moment(component).value;
      const SurfacePoint<R> place = beside(form_.set(), j, side, R(0));
      if (is_free_pivot(form_, j)) {
        steps.push_back((neighbours_at(place) - at_pivot - tilt_step()) / (form_.power(j).value * b));
        continue;
      }
      b = b * form_.y().to_pivot(place) + at_pivot;
    }
    steps.push_back(solution_[f++] / (form_.power(j).value * b));
  }
  return steps;
}

template <Real R>
StateErrors<R> ContactEquations<R>::rounding() const {
  if (size_ == 0) return {};
  const std::vector<R> unknowns = amplified(equations_, errors_);
  const R tilt = tilts_ ? unknowns.back() : R(0);
  R largest = 0;
  R relative = 0;
  std::size_t f = 0;
  for (const std::size_t j : movable_) {
    R b = form_.regular_factor_at(j, form_.set().contact_side(j)).value;
    R error = 0;
    const SurfacePoint<R> place = beside(form_.set(), j, form_.set().contact_side(j), R(0));
    if (has_pivots() && is_free_pivot(form_, j)) {
      const std::vector<R> distances = form_.distances(place);
      error = tilt + form_.pivot_moment(form_.y().component_of(j)).error;
      for (std::size_t i = 0; i < free_.size(); ++i) error += abs(unknowns[i] / distances[free_[i]]);
    } else {
      if (has_pivots()) b *= form_.y().to_pivot(place);
      error = unknowns[f++];
    }
    error = abs(error / (form_.power(j).value * b));
    largest = std::max(largest, error);
    if (!form_.set().counts_by_order(j)) continue;
    relative = std::max(relative, R(error / std::min(form_.set().length(j - 1), form_.set().length(j))));
  }
  // The order is: free ends, poles, coefficients of r.
  const auto first = unknowns.begin() + static_cast<std::ptrdiff_t>(f);
  return {{largest, R(1), relative}, tilt, std::vector<R>(first, unknowns.end() - (tilts_ ? 1 : 0))};
}

template <Real R>
void ContactEquations<R>::set_right(const Estimate<R>& value) {
  at(size_) = value.value;
  errors_[row_] = value.error;
}

template <Real R>
std::vector<R> ContactEquations<R>::q_step(const std::vector<R>& moved, const R& part) const {
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

template <Real R>
R ContactEquations<R>::neighbours_at(const SurfacePoint<R>& place) const {
  const std::vector<R> distances = form_.distances(place);
  R sum = 0;
  for (std::size_t f = 0; f < free_.size(); ++f) sum += solution_[f] / distances[free_[f]];
  return sum;
}

/// theta_j/pi is the residue of u'/(c Y) at e_j. Y also changes with the ends.
template <Real R>
std::vector<R> ContactEquations<R>::theta_step(const std::vector<R>& moved, const R& part) const {
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

template <Real R>
void ContactEquations<R>::add_moments() {
  if (degree_ < 0) return;
  const auto count = static_cast<std::size_t>(degree_ + 1);
  const std::vector<Estimate<R>> m = form_.moments(count);
  for (std::size_t j = 0; j < count; ++j) {
    const Estimate<R> missing = Estimate<R>{j + 1 == count ? form_.problem().load() / pi<R>() : R(0), R(0)} - m[j];
    if (row_ >= size_) {
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

template <Real R>
void ContactEquations<R>::add_gaps() {
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
    std::size_t end = j + 1;
    while (!set.point(end).is_end()) ++end;
    // x - e_f for a place x of the gap: its distance from an end of the gap plus the distance from there to e_f.
    const std::vector<R> from_left = form_.distances(beside(set, j, Side::right, R(0)));
    const std::vector<R> from_right = form_.distances(beside(set, end, Side::left, R(0)));
    std::vector<R> beyond;
    for (const std::size_t point : free_) beyond.push_back(point <= j ? from_left[point] : R(-from_right[point]));
    for (const auto& node : rule) {
      // Divide Y first: for a tiny gap, the weight times Y may be out of range.
      const R to_left = form_.distance(node.at, j);
      const R to_right = -form_.distance(node.at, end);
      for (std::size_t f = 0; f < free_.size(); ++f) {
        const bool left = free_[f] <= j;
        at(f) -= (left ? node.weight : R(-node.weight)) * (node.y / ((left ? to_left : to_right) + beyond[f]));
      }
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
template <Real R>
void ContactEquations<R>::add_centre() {
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

STEADYSLIDE_INSTANTIATE_CLASS(ContactEquations)

}  // namespace steadyslide::numeric
