#include "numeric/closed_form/closed_form.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "support/numeric_test.hpp"

namespace {

const Elasticity steel(Solid(0.3_r, 1));

/// Two coatings: f = 1/5 left of x = 1/4, f = 3/5 right of it.
ContactProblem coated_punch(Sliding sliding) {
  return {steel, FrictionProfile({0.2_r, 0.6_r}, {0.25_r}), Indenter(-1, {{1, Polynomial::constant(Rational(1, 3))}}),
          2.5_r, sliding};
}

ContactProblem coated_parabola() {
  return {steel, FrictionProfile({2, 0, 1}, {-0.1_r, 0.2_r}),
          Indenter(-3, {{4, Polynomial({5, Rational(1, 7), 1.5_r})}}), Rational(2, 3)};
}

template <Real R>
std::shared_ptr<const ContactSolution<R>> solve(const ContactProblem& problem) {
  return closed_form<R>(problem).solution;
}

}  // namespace

TEST_CASE("flat punch with one jump is formula (5)-(7), written out") {
  const auto solution = solve<double>(coated_punch(Sliding::plus_x));
  const double gamma = (1 - 2 * 0.3) / (2 * (1 - 0.3)), pi_ = pi<double>();
  const double rear = std::atan(gamma * 0.2) / pi_, front = std::atan(gamma * 0.6) / pi_;
  for (const char* at : {"-0.9", "-0.1", "0.2", "0.26", "0.8"}) {
    const double x = to_real<double>(parse_rational(at)), s = gamma * (x < 0.25 ? 0.2 : 0.6);
    const double expected = -2.5 / (pi_ * std::sqrt(1 + s * s)) * std::pow(std::abs(x - 0.25), rear - front) /
                            (std::pow(1 + x, 0.5 + rear) * std::pow(1 - x, 0.5 - front));
    const Sample<double> sample = solution->at(parse_rational(at));
    CHECK(sample.traction.left.value == doctest::Approx(expected).epsilon(1e-13));
    CHECK(sample.shear.left.value == doctest::Approx(-(x < 0.25 ? 0.2 : 0.6) * expected).epsilon(1e-13));
    CHECK(sample.gap->value == 0);
    CHECK(sample.slope.left.value == 0);
  }
}

TEST_CASE("the traction at a jump blows up towards the rougher front and vanishes the other way") {
  for (const auto& [sliding, size] : {std::pair(Sliding::plus_x, infinity<double>()), {Sliding::minus_x, 0}}) {
    const Sample<double> jump = solve<double>(coated_punch(sliding))->at(0.25_r);
    for (const auto& side : {&TwoSided<double>::left, &TwoSided<double>::right}) {
      CHECK((jump.traction.*side).value == -size);
      CHECK((jump.shear.*side).value == size);
    }
  }
}

TEST_CASE("edges: infinite traction inside, infinite slope outside, nothing beyond") {
  const auto solution = solve<double>(coated_punch(Sliding::plus_x));
  const Sample<double> left = solution->at(-1);
  CHECK(left.traction.left.value == 0);
  CHECK(left.traction.right.value == -infinity<double>());
  CHECK(left.slope.left.value == -infinity<double>());
  CHECK(left.slope.right.value == 0);
  const Sample<double> right = solution->at(1);
  CHECK(right.traction.left.value == -infinity<double>());
  CHECK(right.slope.right.value == infinity<double>());
  const Sample<double> beyond = solution->at(1.5_r);
  CHECK(beyond.traction.left.value == 0);
  CHECK(!beyond.gap);
  CHECK(beyond.slope.left.value > 0);
}

TEST_CASE("slope and gap outside the contact are those of the traction, integrated by another route") {
  for (const ContactProblem& problem :
       {coated_punch(Sliding::plus_x), coated_punch(Sliding::minus_x), coated_parabola()}) {
    const auto solution = solve<Real50>(problem);
    const auto data = std::get<ClosedFormData<Real50>>(closed_form_data<Real50>(problem));
    const trapezoidal::Grid<Real50> grid(data.traction.density());
    const Real50 c = to_real<Real50>(problem.elasticity().compliance());
    const auto contact = solution->contact().front();
    for (const char* at : {"-2.5", "-1.25", "1.001", "1.5", "3.9"}) {
      const Rational x = parse_rational(at);
      const Real50 before = contact.left.x.value - to_real<Real50>(x),
                   behind = to_real<Real50>(x) - contact.right.x.value;
      if (before <= 0 && behind <= 0) continue;
      const Real50 expected = c * (before > 0 ? grid.cauchy(Side::left, before) : grid.cauchy(Side::right, behind));
      CHECK(abs(solution->at(x).slope.left.value / expected - 1) < 1e-50);
    }
  }
  // gap = int (psi' - u') dx by Simpson's rule in the square root of the distance, starting at the free end.
  const auto solution = solve<double>(coated_parabola());
  const double end = solution->contact().front().right.x.value;
  const auto rate = [&](double x) { return 1.0 / 7 + 3 * x - solution->at(Rational(x)).slope.left.value; };
  const int n = 2000;
  const double root = std::sqrt(3.5 - end);
  double sum = 0;
  for (int i = 1; i <= n; ++i) {
    const double v = root * i / n;
    sum += (i == n ? 1 : i % 2 == 1 ? 4 : 2) * 2 * v * rate(end + v * v);
  }
  CHECK(solution->at(3.5_r).gap->value == doctest::Approx(sum * root / n / 3).epsilon(1e-9));
}

TEST_CASE("resultants: centre of pressure from power sums and from the moment of the traction") {
  for (const ContactProblem& problem : {coated_punch(Sliding::plus_x), coated_parabola()}) {
    const auto data = std::get<ClosedFormData<Real50>>(closed_form_data<Real50>(problem));
    const trapezoidal::Grid<Real50> grid(data.traction.density());
    const Resultants<Real50> r = solve<Real50>(problem)->resultants();
    const Real50 moment = grid.moment(Real50(0)) / grid.integral() + to_real<Real50>(data.origin);
    CHECK(abs(moment - r.centre_of_pressure.value) < 1e-53);
    Real50 sum = 0;
    for (const auto& share : r.load_share) sum += share.value;
    CHECK(abs(sum - 1) < 1e-54);
    CHECK(abs(r.normal.value - to_real<Real50>(problem.load())) < 1e-53);
    CHECK(abs(r.tangential.value - r.effective_friction.value * r.normal.value) < 1e-53);
  }
}

TEST_CASE("the parts of the load that are not in contact are zero") {
  const ContactProblem problem(steel, FrictionProfile({1, 2, 3}, {-2, 2}), Indenter(-3, {{3, Polynomial({0, 0, 1})}}),
                               0.01_r);
  const Resultants<double> r = solve<double>(problem)->resultants();
  CHECK(r.load_share[0].value == 0);
  CHECK(r.load_share[1].value == doctest::Approx(1).epsilon(1e-14));
  CHECK(r.load_share[2].value == 0);
  CHECK(r.effective_friction.value == doctest::Approx(2).epsilon(1e-14));
}

TEST_CASE("intensities are the limits of t d^-lambda") {
  for (const ContactProblem& problem :
       {coated_punch(Sliding::plus_x), coated_punch(Sliding::minus_x), coated_parabola()}) {
    const auto data = std::get<ClosedFormData<Real50>>(closed_form_data<Real50>(problem));
    const ClosedForm<Real50> solution(problem, data);
    const FundamentalSolution<Real50>& y = data.traction.weight;
    const Real50 d("1e-30");
    const auto points = solution.singular_points();
    CHECK(points.size() == y.panel_count() + 1);
    for (std::size_t j = 0; j < points.size(); ++j) {
      const std::size_t panel = j == y.panel_count() ? j - 1 : j;
      const Node<Real50> node = panel == j ? y.panel(panel).node_from_left(d) : y.panel(panel).node_from_right(d);
      Real50 theta = -solution.traction(panel, node) * pow(d, Real50(-to_real<Real50>(*points[j].exponent)));
      if (points[j].kind == SingularKind::friction_jump) {
        theta /= cos_pi_alpha<Real50>(problem.coupled_friction(data.first_piece + panel));
      }
      CHECK(abs(theta / points[j].intensity.value - 1) < 1e-27);
    }
  }
}

TEST_CASE(
    "samples: as many as asked for in the contact and in each gap, from left to right, dense at singular points") {
  const auto punch = solve<double>(coated_punch(Sliding::plus_x))->samples(50);
  CHECK(punch.size() == 50);
  const auto parabola = solve<double>(coated_parabola())->samples(31);
  CHECK(parabola.size() == 3 * 31);
  for (const auto& samples : {punch, parabola}) {
    for (std::size_t k = 1; k < samples.size(); ++k) CHECK(samples[k].x > samples[k - 1].x);
  }
  CHECK(punch[0].x + 1 < 1e-3);
  for (const auto& sample : parabola) CHECK(sample.gap->value >= 0);
}

TEST_CASE("residuals come from another rule than the solution, and see a wrong load") {
  auto data = std::get<ClosedFormData<double>>(closed_form_data<double>(coated_parabola()));
  CHECK(ClosedForm<double>(coated_parabola(), data).residuals().equation < 1e-13);
  CHECK(ClosedForm<double>(coated_parabola(), data).residuals().penetration < 1e-13);
  for (double& amplitude : data.traction.amplitudes) amplitude *= 1 + 1e-9;
  const Residuals<double> wrong = ClosedForm<double>(coated_parabola(), data).residuals();
  CHECK(wrong.load > 1e-10);
  CHECK(wrong.equation > 1e-10);
}
