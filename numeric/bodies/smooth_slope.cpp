#include "numeric/bodies/smooth_slope.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/chebyshev.hpp"
#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric {
namespace {

/// The points of a panel. Its singularities are at least a panel's length away, so the series converges like 4.2^-n.
constexpr std::size_t panel_points = 26;

/// Returns the coefficients of 1, y, y^2, ... of a Chebyshev series in y.
std::vector<double> powers_of(const std::vector<double>& series) {
  std::vector<double> result(series.size()), before{1}, last{0, 1};
  for (std::size_t k = 0; k < series.size(); ++k) {
    for (std::size_t j = 0; j < before.size(); ++j) result[j] += series[k] * before[j];
    std::vector<double> next(last.size() + 1);
    for (std::size_t j = 0; j < last.size(); ++j) next[j + 1] += 2 * last[j];
    for (std::size_t j = 0; j < before.size(); ++j) next[j] -= before[j];
    before = std::move(last);
    last = std::move(next);
  }
  return result;
}

/// The digits lost by a polynomial of this degree at the far end of the contact, and the length of its piece for which
/// the truncation loses the same.
struct Loss {
  double error;
  double length;
};
Loss loss_of(int degree, double distance, double radius) {
  const double error = epsilon<double>() * std::max(1.0, std::pow(distance / radius, degree));
  return {error, 4 * radius * std::pow(error / 2, 1 / (degree + 1.0))};
}

}  // namespace

double SmoothSlope::Panel::at(double x) const { return chebyshev_sum(series, (2 * x - left - right) / (right - left)); }

SmoothSlope::Division SmoothSlope::division(double length, double distance, double radius, int most) {
  constexpr int highest_degree = 24;
  Division best;
  for (int degree = 1; degree <= highest_degree; ++degree) {
    const auto [error, piece] = loss_of(degree, distance, radius);
    const double pieces = std::ceil(length / piece);
    if (pieces > most || std::pair(error, pieces) >= std::pair(best.error, static_cast<double>(best.pieces))) continue;
    best = {static_cast<int>(pieces), degree, error};
  }
  return best;
}

SmoothSlope::SmoothSlope(const Indenter& indenter, double left, double right,
                         const std::function<double(double)>& radius) {
  const auto end = to_real<double>(indenter.right());
  const ChebyshevPoints<double> points(panel_points);
  for (auto from = to_real<double>(indenter.left()); from < end;) {
    // A panel is not longer than the distance of the singularities from its points.
    double length = radius(from);
    while (length > radius(from + length)) length = std::max(length / 2, radius(from + length));
    if (!(length > 0 && std::isfinite(length))) {
      panels_.clear();
      nodes_.clear();
      return;
    }
    // Ends with few digits keep the numbers of the polynomials short.
    const double grid = std::exp2(std::floor(std::log2(length)) - 6);
    double to = std::floor((from + length) / grid) * grid;
    if (to <= from || to + length / 4 >= end) to = end;
    const double middle = (from + to) / 2, reach = radius(middle);
    const double distance = std::max(std::abs(right - middle), std::abs(middle - left));
    Panel panel{from, to, division(to - from, distance, reach, 8), division(to - from, distance, reach, 64), {}};
    if (middle > left - reach && middle < right + reach) {
      rough_error_ = std::max(rough_error_, panel.rough.error);
      fine_error_ = std::max(fine_error_, panel.fine.error);
    }
    for (std::size_t i = 0; i < panel_points; ++i) nodes_.push_back(middle + (to - from) / 2 * points.place(i));
    panels_.push_back(std::move(panel));
    from = to;
  }
}

void SmoothSlope::set(std::vector<double> values) {
  const ChebyshevPoints<double> points(panel_points);
  auto next = values.begin();
  for (Panel& panel : panels_) {
    panel.series = points.series({next, next + panel_points});
    next += panel_points;
  }
}

ContactProblem SmoothSlope::added_to(const ContactProblem& problem, const Rational& factor, Detail detail) const {
  const Indenter& indenter = problem.indenter();
  const std::vector<Indenter::Piece>& old = indenter.pieces();
  std::vector<Indenter::Piece> pieces;
  std::size_t k = 0;
  Rational height = 0, from = indenter.left();
  double slope = panels_.front().at(panels_.front().left);
  for (const Panel& panel : panels_) {
    const auto [count_of_pieces, degree, error] = detail == Detail::rough ? panel.rough : panel.fine;
    const double length = (panel.right - panel.left) / count_of_pieces;
    for (int i = 0; i < count_of_pieces; ++i) {
      const double left = panel.left + i * length;
      const bool is_last = &panel == &panels_.back() && i + 1 == count_of_pieces;
      const double right = i + 1 == count_of_pieces ? panel.right : panel.left + (i + 1) * length;
      const Rational middle = (Rational(left) + Rational(right)) / 2, half = (Rational(right) - Rational(left)) / 2;
      const ChebyshevPoints<double> points(static_cast<std::size_t>(degree + 1));
      std::vector<double> values;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const double y = points.place(j);
        values.push_back(panel.at((left * (1 - y) + right * (1 + y)) / 2));
      }
      std::vector<Rational> powers;
      for (const double c : powers_of(points.series(values))) powers.emplace_back(c);
      // The polynomial in y = (x - middle)/half is corrected by rounding errors, so that slopes join exactly.
      const double next = panel.at(right);
      const Polynomial raw(powers);
      const Rational before = Rational(slope) - raw(-1), after = Rational(next) - raw(1);
      const Polynomial of_y = raw + Polynomial({(before + after) / 2, (after - before) / 2});
      slope = next;
      std::vector<Rational> integral{0};
      for (std::size_t j = 0; j < of_y.coefficients().size(); ++j)
        integral.push_back(half * of_y.coefficients()[j] / static_cast<int>(j + 1));
      const Polynomial rise(integral);
      const Rational to = is_last ? indenter.right() : Rational(right);
      const Polynomial added = (rise + Polynomial::constant(height - rise(-1))).composed(1 / half, -middle / half);
      height += rise(1) - rise(-1);
      // Pieces of the profile end inside.
      while (true) {
        const Rational& end = std::min(old[k].to, to);
        if (end > from) pieces.push_back({end, old[k].profile + Polynomial::constant(factor) * added});
        from = end;
        if (old[k].to > to || k + 1 == old.size()) break;
        ++k;
        if (from == to) break;
      }
    }
  }
  return {problem.elasticity(), problem.friction(), Indenter(indenter.left(), std::move(pieces)),
          problem.load(),       problem.sliding(),  problem.load_at()};
}

}  // namespace steadyslide::numeric
