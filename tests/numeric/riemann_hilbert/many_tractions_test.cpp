// Tractions at many places, compared with those at one place, which takes the exact x.

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

/// Places over more than the support, evenly; at each end and jump that is data: the place itself, the neighbouring
/// doubles, and places close to it.
std::vector<double> places(const ContactProblem& problem, const ContactSolution<double>& solution) {
  std::vector<double> result;
  const auto left = to_real<double>(problem.indenter().left());
  const auto right = to_real<double>(problem.indenter().right());
  for (int i = -20; i <= 620; ++i) result.push_back(left + (right - left) * i / 600);
  for (const auto& point : solution.singular_points()) {
    const double x = point.x.value;
    result.insert(result.end(), {x - 1e-4, x + 1e-4});
    if (point.kind == SingularKind::free) continue;  // a free end has an error, and so has the traction next to it
    for (const double d : {0.0, 1e-15, 1e-9}) result.insert(result.end(), {x - d, x + d});
    result.insert(result.end(), {std::nextafter(x, -9), std::nextafter(x, 9)});
  }
  return result;
}

struct Tractions {
  std::vector<double> normal, shear;
  Tractions(const ContactSolution<double>& solution, const std::vector<double>& x) : normal(x.size()), shear(x.size()) {
    solution.tractions(x, normal, shear);
  }
};

bool equal(double a, double b, double units) { return a == b || close(a, b, units); }

/// If the two limits differ, returns the one of the larger pressure.
template <Real R>
std::pair<R, R> larger(const Sample<R>& s) {
  if (s.traction.right.value < s.traction.left.value) return {s.traction.right.value, s.shear.right.value};
  return {s.traction.left.value, s.shear.left.value};
}

void agrees_with_single_places(const ContactProblem& problem, const ContactSolution<double>& solution, double units) {
  std::vector<double> x = places(problem, solution);
  for (const bool in_order : {false, true}) {
    if (in_order) std::ranges::sort(x);
    const Tractions found(solution, x);
    int in_contact = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      CAPTURE(x[i]);
      const Sample<double> there = solution.at(Rational(x[i]));
      const auto [t, shear] = larger(there);
      CHECK((equal(found.normal[i], t, units) || std::abs(found.normal[i] - t) <= there.traction.left.error));
      CHECK((equal(found.shear[i], shear, units) || std::abs(found.shear[i] - shear) <= there.shear.left.error));
      if (t < 0 && std::isfinite(t)) ++in_contact;
    }
    CHECK(in_contact >= 80);
  }
}

ContactProblem jumps_of_tenths() {
  return reduced({0.2_r, 1, 0.1_r, 3}, {-0.7_r, 0.1_r, 0.3_r}, one_piece(-1, 1.2_r, {}), 2.5_r);
}

}  // namespace

TEST_CASE("a flat punch at many places, next to its jumps too, beside 50 digits") {
  const ContactProblem problem = jumps_of_tenths();
  const auto solution = closed_form<double>(problem).solution;
  const auto exact = closed_form<Real50>(problem).solution;
  const std::vector<double> x = places(problem, *solution);
  const Tractions found(*solution, x);
  bool naive_is_wrong = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    CAPTURE(x[i]);
    const auto [t, shear] = larger(exact->at(Rational(x[i])));
    // The powers are rounded, too: by 2^-54 log(d) at the distance d, 18 units next to a jump.
    CHECK(equal(found.normal[i], static_cast<double>(t), 40));
    CHECK(equal(found.shear[i], static_cast<double>(shear), 40));
    // Control: without the difference between 0.1 and its double, a place next to it has another distance.
    const double naive = std::abs(x[i] - 0.1), true_distance = std::abs(to_real<double>(Rational(x[i]) - 0.1_r));
    naive_is_wrong = naive_is_wrong || (naive > 0 && !equal(naive, true_distance, 1e14));
  }
  CHECK(naive_is_wrong);
  agrees_with_single_places(problem, *solution, 12);
}

TEST_CASE("parabolas, curved punches, wedges and two zones at many places") {
  const ContactProblem parabola = reduced({0.3_r, 1}, {0.1_r}, one_piece(-3, 3, {0, 0, 1}), 2);
  agrees_with_single_places(parabola, *closed_form<double>(parabola).solution, 16);
  for (const ContactProblem& problem :
       {reduced({0.3_r, 1}, {0.1_r}, one_piece(-3, 3, {0, 0.1_r, 1, 0, 1}), 2),
        reduced({0.3_r, 1}, {0.1_r}, roof(-1, 1), 0.4_r), on_two_coatings(two_wells(), 1)}) {
    const auto solution = riemann_hilbert<double>(problem).solution;
    REQUIRE(solution);
    agrees_with_single_places(problem, *solution, 64);
  }
}

TEST_CASE("many zones at many places, sliding both ways") {
  std::vector<Indenter::Piece> bumps;
  for (int i = -3; i <= 4; ++i) {
    const Rational middle = i - 0.5_r;
    bumps.push_back({i, Polynomial({middle * middle, -2 * middle, 1})});
  }
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem problem = reduced({0.5_r}, {}, Indenter(-4, bumps), 2, std::nullopt, sliding);
    const auto solution = riemann_hilbert<double>(problem).solution;
    REQUIRE(solution->contact().size() == 8);
    agrees_with_single_places(problem, *solution, 64);
  }
}

TEST_CASE("50 digits at many places are those at one") {
  const ContactProblem problem = jumps_of_tenths();
  const auto solution = closed_form<Real50>(problem).solution;
  const std::vector<Real50> x{Real50(-2), Real50(-1), Real50(-0.5), to_real<Real50>(0.1_r), Real50(0.75), Real50(3)};
  std::vector<Real50> normal(x.size()), shear(x.size());
  solution->tractions(x, normal, shear);
  const Real50 served("1e-51");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto [t, s] = larger(solution->at(Rational(x[i])));
    CHECK((normal[i] == t || abs(normal[i] - t) <= served * abs(t)));
    CHECK((shear[i] == s || abs(shear[i] - s) <= served * abs(s)));
  }
}
