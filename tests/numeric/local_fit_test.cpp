// What fits read off cells next to singular points, on cells whose means are known: those of Riemann-Hilbert forms.

#include <doctest/doctest.h>

#include <cmath>

#include "support/cell_means.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;
using namespace steadyslide::numeric::variational;
using testing::cell_means;
using testing::CellMeans;
using testing::local_place;
using testing::one_piece;
using testing::reduced;
using testing::solved;

namespace {

struct Named {
  std::string name;
  ContactProblem problem;
  int wedge = -1;  ///< degree of the jump of slope
};

const Rational low(1, 10);
const Rational high(3, 5);

std::vector<Named> problems() {
  const Indenter flat = one_piece(-1, 1, {0});
  const Indenter parabola = one_piece(-1, 1, {0, 0, Rational(5, 2)});
  const Indenter wedge(-1,
                       {{0, Polynomial({0, Rational(-1, 2)})}, {1, Polynomial({0, Rational(1, 2), Rational(1, 2)})}});
  const Indenter step(-1, {{Rational(-1, 5), Polynomial({Rational(1, 10), 0, Rational(1, 2)})},
                           {1, Polynomial({0, 0, Rational(1, 2)})}});
  return {{"flat punch", reduced({high}, {}, flat, 1)},
          {"flat punch, a jump down", reduced({high, low}, {Rational(3, 10)}, flat, 1)},
          {"flat punch, three jumps",
           reduced({low, Rational(2, 5), 0, Rational(1, 5)}, {Rational(-1, 2), Rational(1, 10), high}, flat, 1)},
          {"parabola", reduced({Rational(3, 10)}, {}, parabola, 1)},
          {"parabola, a jump up", reduced({low, high}, {0}, parabola, 1)},
          {"parabola, a jump down", reduced({high, low}, {0}, parabola, 1)},
          {"two bumps", reduced({Rational(3, 10)}, {}, one_piece(-2, 2, {1, Rational(1, 5), -2, 0, 1}), 2)},
          {"a step", reduced({Rational(3, 10)}, {}, step, Rational(1, 5))},
          {"wedge", reduced({Rational(3, 10)}, {}, wedge, 1), 1},
          {"wedge, a jump up", reduced({low, high}, {0}, wedge, 1), 1},
          {"wedge, a jump down", reduced({high, low}, {0}, wedge, 1), 1}};
}

struct Solved {
  std::vector<SolvedSingularPoint<double>> points;
  std::vector<Side> contact;  ///< of ends
  CellMeans cells;
};

Solved with_cells(const ContactProblem& problem, std::size_t count) {
  const auto solution = solved<double>(problem);
  Solved result{solution->singular_points(), {}, cell_means(problem, *solution, count)};
  for (const auto& point : result.points) {
    bool left = false;
    for (const auto& zone : solution->contact()) left = left || zone.left.x.value == point.x.value;
    result.contact.push_back(left ? Side::right : Side::left);
  }
  return result;
}

bool is_end(SingularKind kind) {
  return kind == SingularKind::edge || kind == SingularKind::free || kind == SingularKind::step;
}

double s_at(const ContactProblem& problem, double x, Side side) {
  // Next to x: a place in double is a jump but for rounding.
  const Rational c(x + (side == Side::left ? -1e-9 : 1e-9));
  return to_real<double>(problem.coupled_friction(problem.friction().piece(c, side)));
}

double cosine(double s) { return 1 / std::hypot(1, s); }

FittedIntensity fitted_at(const Named& named, const Solved& solution, std::size_t j, double exponent) {
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
double reversed(const SolvedSingularPoint<double>& point) {
  const double lambda = to_real<double>(*point.exponent);
  if (point.kind == SingularKind::free) return 1 - lambda;
  return is_end(point.kind) ? -1 - lambda : -lambda;
}

std::vector<Side> sides_of(const Solved& solution, std::size_t j) {
  if (is_end(solution.points[j].kind)) return {solution.contact[j]};
  return {Side::left, Side::right};
}

}  // namespace

TEST_CASE("intensities and constants of exact cells") {
  for (const Named& named : problems()) {
    CAPTURE(named.name);
    const Solved solution = with_cells(named.problem, 4096);
    for (std::size_t j = 0; j < solution.points.size(); ++j) {
      const auto& point = solution.points[j];
      CAPTURE(point.x.value);
      const double exponent = point.exponent ? to_real<double>(*point.exponent) : 0;
      const FittedIntensity found = fitted_at(named, solution, j, exponent);
      const double theta = point.intensity.value;
      REQUIRE(found.intensity.convergence == Convergence::reached);
      MESSAGE(named.name << " " << point.x.value << " theta " << theta << " off "
                         << (found.intensity.value - theta) / theta << " error " << found.intensity.error / theta
                         << " constant off " << found.constant.value - point.constant.value << " error "
                         << found.constant.error);
      CHECK(found.intensity.value == doctest::Approx(theta).epsilon(1e-6));
      CHECK(found.constant.value == doctest::Approx(point.constant.value).epsilon(1e-6));
      if (!point.exponent) continue;
      // Control: the wrong exponent says so itself.
      const FittedIntensity wrong = fitted_at(named, solution, j, reversed(point));
      MESSAGE("wrong error " << wrong.intensity.error / theta);
    }
  }
}

TEST_CASE("exponents of spoilt cells") {
  // From one cell to the next forgotten errors, 16/d^2 of the values at d cells, drown the exponents: the bars say so.
  for (const double random : {0., 1e-4, 1e-3, 1e-2, 0.5}) {
    double largest=0, worst=0; int stalled=0, missed=0;
    for (const Named& named : problems()) {
      CAPTURE(named.name);
      Solved solution = with_cells(named.problem, 16384);
      testing::spoil(solution.cells, solution.points, random, 0.5);
      for (std::size_t j = 0; j < solution.points.size(); ++j) {
        const auto& point = solution.points[j];
        if (!point.exponent || point.kind==SingularKind::wedge_and_jump) continue;
        const double lambda = to_real<double>(*point.exponent);
        for (const Side side : sides_of(solution, j)) {
          const FittedExponent found =
              fitted_exponent(solution.cells.cells(), local_place(solution.points, j), side);
          if (found.exponent.convergence == Convergence::stalled) { ++stalled; continue; }
          const double off=std::abs(found.exponent.value-lambda);
          if (off>found.exponent.error) ++missed;
          largest=std::max(largest,found.exponent.error); worst=std::max(worst,off);
        }
      }
    }
    MESSAGE("random " << random << " largest bar " << largest << " worst " << worst << " stalled " << stalled << " missed " << missed);
  }
}
