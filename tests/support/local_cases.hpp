#pragma once
// Singular points of every kind with the cells around them, and what fits to the cells have to say of them.

#include <cmath>

#include "support/cell_means.hpp"

namespace steadyslide::testing {

using namespace numeric;
using namespace numeric::variational;

struct Named {
  std::string name;
  ContactProblem problem;
  int wedge = -1;  ///< degree of the jump of slope
};

inline const Rational low(1, 10);
inline const Rational high(3, 5);

inline std::vector<Named> problems() {
  const Indenter flat = one_piece(-1, 1, {0});
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  const Indenter wedge(-1, {{0, Polynomial({0, -0.5_r})}, {1, Polynomial({0, 0.5_r, 0.5_r})}});
  const Indenter step(-1, {{-0.2_r, Polynomial({0.1_r, 0, 0.5_r})}, {1, Polynomial({0, 0, 0.5_r})}});
  return {{"flat punch", reduced({high}, {}, flat, 1)},
          {"flat punch, a jump down", reduced({high, low}, {0.3_r}, flat, 1)},
          {"flat punch, three jumps", reduced({low, 0.4_r, 0, 0.2_r}, {-0.5_r, 0.1_r, high}, flat, 1)},
          {"parabola", reduced({0.3_r}, {}, parabola, 1)},
          {"parabola, a jump up", reduced({low, high}, {0}, parabola, 1)},
          {"parabola, a jump down", reduced({high, low}, {0}, parabola, 1)},
          {"two bumps", reduced({0.3_r}, {}, one_piece(-2, 2, {1, 0.2_r, -2, 0, 1}), 2)},
          {"a step", reduced({0.3_r}, {}, step, 0.2_r)},
          {"wedge", reduced({0.3_r}, {}, wedge, 1), 1},
          {"wedge, a jump up", reduced({low, high}, {0}, wedge, 1), 1},
          {"wedge, a jump down", reduced({high, low}, {0}, wedge, 1), 1}};
}

struct SolvedCells {
  std::vector<SolvedSingularPoint<double>> points;
  std::vector<Side> contact;  ///< of ends
  CellMeans cells;
};

inline SolvedCells with_cells(const ContactProblem& problem, std::size_t count) {
  const auto solution = solved<double>(problem);
  SolvedCells result{solution->singular_points(), {}, cell_means(problem, *solution, count)};
  for (const auto& point : result.points) {
    bool left = false;
    for (const auto& zone : solution->contact()) left = left || zone.left.x.value == point.x.value;
    result.contact.push_back(left ? Side::right : Side::left);
  }
  return result;
}

inline bool is_end(SingularKind kind) {
  return kind == SingularKind::edge || kind == SingularKind::free || kind == SingularKind::step;
}

inline double s_at(const ContactProblem& problem, double x, Side side) {
  // Next to x: a place in double is a jump but for rounding.
  const Rational c(x + (side == Side::left ? -1e-9 : 1e-9));
  return to_real<double>(problem.coupled_friction(problem.friction().piece(c, side)));
}

inline double cosine(double s) { return 1 / std::hypot(1, s); }

inline FittedIntensity fitted_at(const Named& named, const SolvedCells& solution, std::size_t j, double exponent) {
  const auto& point = solution.points[j];
  const LocalPlace place = local_place(solution.points, j);
  const Cells cells = solution.cells.cells();
  const double left = s_at(named.problem, place.x, Side::left);
  const double right = s_at(named.problem, place.x, Side::right);
  if (is_end(point.kind)) return fitted_end(cells, place, solution.contact[j], exponent);
  if (point.kind == SingularKind::wedge) return fitted_wedge(cells, place, left, named.wedge);
  return fitted_jump(cells, place, exponent, cosine(left), cosine(right), named.wedge);
}

/// The exponent by the friction of the other direction of sliding.
inline double reversed(const SolvedSingularPoint<double>& point) {
  const double lambda = to_real<double>(*point.exponent);
  if (point.kind == SingularKind::free) return 1 - lambda;
  return is_end(point.kind) ? -1 - lambda : -lambda;
}

inline std::vector<Side> sides_of(const SolvedCells& solution, std::size_t j) {
  if (is_end(solution.points[j].kind)) return {solution.contact[j]};
  return {Side::left, Side::right};
}

/// Does a bar hold the derived exponent, and not the one of the other direction of sliding?
inline void check_exponent(const FittedExponent& found, const SolvedSingularPoint<double>& point, double most) {
  const double lambda = to_real<double>(*point.exponent);
  CHECK(found.exponent.convergence == Convergence::reached);
  CHECK(std::abs(found.exponent.value - lambda) <= found.exponent.error);
  CHECK(std::abs(found.exponent.value - reversed(point)) > found.exponent.error);
  CHECK(found.exponent.error <= most);
}

}  // namespace steadyslide::testing
