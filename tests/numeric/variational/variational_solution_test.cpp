// Solutions on cells are compared with Riemann-Hilbert solutions of the same problems, for each quantity.

#include "numeric/variational/variational_solution.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/solved_contact.hpp"

namespace {

std::shared_ptr<const VariationalSolution> solved_on_cells(const ContactProblem& problem, std::size_t cells = 4096) {
  const Attempt<double> attempt = variational_inequality(problem, {.cells = cells});
  REQUIRE_MESSAGE(attempt.solution, attempt.reason);
  CHECK(attempt.solution->failed_condition() == "");
  return std::dynamic_pointer_cast<const VariationalSolution>(attempt.solution);
}

/// Checks that the difference is at most a few times the estimated error, and that this error is within a bound.
void agree(const Estimate<double>& found, const Estimate<double>& truth, double bound) {
  CHECK(std::abs(found.value - truth.value) <= 3 * found.error + 1e-12);
  CHECK(found.error <= bound * std::max(1.0, std::abs(truth.value)));
}

/// The errors of forces are reliable: the difference is within one error.
void agree_in_force(const Estimate<double>& found, const Estimate<double>& truth) {
  CHECK(std::abs(found.value - truth.value) <= found.error + 1e-12);
  CHECK(found.error <= 2e-3 * std::max(1.0, std::abs(truth.value)));
}

void agree_everywhere(const ContactProblem& problem) {
  const auto cells = solved_on_cells(problem);
  const auto exact = solved<double>(problem);
  const auto found = cells->contact();
  const auto truth = exact->contact();
  REQUIRE(found.size() == truth.size());
  const auto same_end = [&](const ContactEnd<double>& a, const ContactEnd<double>& b) {
    CHECK(a.kind == b.kind);
    CHECK(a.exponent == b.exponent);
    CHECK(std::abs(a.x.value - b.x.value) <= (a.kind == SingularKind::free ? cells->cell_length() : 1e-14));
    agree(a.intensity, b.intensity, 1e-3);
  };
  for (std::size_t k = 0; k < found.size(); ++k) {
    same_end(found[k].left, truth[k].left);
    same_end(found[k].right, truth[k].right);
  }
  const auto points = cells->singular_points();
  const auto true_points = exact->singular_points();
  REQUIRE(points.size() == true_points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    CHECK(points[k].kind == true_points[k].kind);
    CHECK(points[k].exponent == true_points[k].exponent);
    agree(points[k].intensity, true_points[k].intensity, 1e-3);
    agree(points[k].constant, true_points[k].constant, 1e-3);
  }
  const auto a = cells->resultants();
  const auto b = exact->resultants();
  agree(a.normal, b.normal, 1e-12);
  for (const auto total : {&Resultants<double>::tangential, &Resultants<double>::effective_friction,
                           &Resultants<double>::centre_of_pressure}) {
    agree_in_force(a.*total, b.*total);
  }
  for (std::size_t k = 0; k < a.load_share.size(); ++k) agree_in_force(a.load_share[k], b.load_share[k]);
  REQUIRE(cells->tilt().has_value() == exact->tilt().has_value());
  if (cells->tilt()) agree_in_force(*cells->tilt(), *exact->tilt());

  const Rational left = problem.indenter().left(), length = problem.indenter().right() - left;
  for (int i = -2; i <= 42; ++i) {
    const Rational x = left + length * Rational(7 * i + 3, 285);
    const Sample<double> here = cells->at(x), there = exact->at(x);
    CHECK(here.x == there.x);
    CHECK(here.gap.has_value() == there.gap.has_value());
    if (here.gap) {
      CHECK(std::abs(here.gap->value - there.gap->value) <= 3 * here.gap->error + 1e-6);
      CHECK(here.gap->error <= 2e-3);
    }
    CHECK(std::abs(here.slope.left.value - there.slope.left.value) <= 3 * here.slope.left.error + 2e-3);
    const double t = there.traction.left.value;
    CHECK(std::abs(here.traction.left.value - t) <= 3 * here.traction.left.error + 1e-3 * std::abs(t));
    CHECK(std::abs(here.shear.right.value - there.shear.right.value) <=
          3 * here.shear.right.error + 1e-3 * std::abs(t));
  }
}

/// A polygon in the parabola x^2/4 over [-1, 1] with a wedge every hundredth. The wedge at -1/10 is sharper by `bend`.
Indenter polygon(const Rational& bend) {
  std::vector<Indenter::Piece> pieces;
  Rational height = 0.25_r;
  for (int k = 1; k <= 200; ++k) {
    const Rational slope = Rational(2 * k - 201, 400) + (k > 90 ? bend : 0_r);
    const Rational to = Rational(k, 100) - 1;
    height += slope / 100;
    pieces.push_back({to, Polynomial({height - slope * to, slope})});
  }
  return {-1, pieces};
}

}  // namespace

TEST_CASE("free ends over a jump up, down, and sliding back") {
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  agree_everywhere(reduced({0.1_r, 0.6_r}, {0}, parabola, 1));
  agree_everywhere(reduced({0.6_r, 0.1_r}, {0}, parabola, 1));
  const FrictionProfile friction({0.5_r, 1.2_r}, {0.05_r});
  agree_everywhere({Elasticity(Solid(0.25_r, 3)), friction, parabola, 2, Sliding::minus_x});
}

TEST_CASE("edges, wedges and jumps") {
  const Indenter wedge = roof(-0.1_r, 0.1_r);
  agree_everywhere(reduced({0.3_r}, {}, wedge, 1));
  agree_everywhere(reduced({0.3_r, 0.1_r}, {0}, wedge, 1));
  agree_everywhere(reduced({0.1_r, 0.3_r, 0}, {-0.4_r, 0.3_r}, wedge, 1));
}

TEST_CASE("a step, two zones, a tilting punch") {
  const Indenter step(-1, {{-0.2_r, Polynomial({0.1_r, 0, 0.5_r})}, {1, Polynomial({0, 0, 0.5_r})}});
  agree_everywhere(reduced({0.3_r}, {}, step, 0.2_r));
  agree_everywhere(on_two_coatings(two_wells(), 8));
  agree_everywhere(reduced({0.1_r, 0.5_r}, {0}, one_piece(-1, 1, {0}), 1, 0.2_r));
}

TEST_CASE("an end where friction jumps has the friction of the contact's side, in any frame") {
  // Cells of the length 1/128: one of these jumps is at an end of contact. Found by 400 random laws.
  int met = 0;
  for (int k = 45; k < 65; ++k) {
    const Rational jump = -0.1_r + Rational(k, 128);
    const ContactProblem problem = reduced({0.1_r, 0.6_r}, {jump}, one_piece(-1.1_r, 0.9_r, {0, 0, 2.5_r}), 1);
    for (const Rational& scale : {Rational(1), Rational(1, 3), Rational(5, 7), Rational(7, 3)}) {
      const ContactProblem moved = problem.moved(scale, scale / 3);
      const auto end = solved_on_cells(moved, 256)->contact().back().right;
      if (std::abs(end.x.value - static_cast<double>(moved.friction().jumps()[0])) > 1e-12) continue;
      ++met;
      CHECK(end.exponent == free_exponent(End::right, 0.1_r));
    }
  }
  CHECK(met >= 4);
}

TEST_CASE("control: another load is another solution") {
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  const auto cells = solved_on_cells(reduced({0.1_r, 0.6_r}, {0}, parabola, 1));
  const auto other = solved<double>(reduced({0.1_r, 0.6_r}, {0}, parabola, 1.01_r));
  const auto found = cells->contact().front();
  CHECK(std::abs(found.left.x.value - other->contact().front().left.x.value) > cells->cell_length());
  const auto intensity = other->contact().front().left.intensity.value;
  CHECK(std::abs(found.left.intensity.value - intensity) > 10 * found.left.intensity.error);
}

TEST_CASE("jumps of friction and loads within cells") {
  // 1/3 is not the end of a cell, and 17 cells are few. The load shares still add up, and the load is met to rounding.
  const ContactProblem problem = reduced({0.1_r, 0.5_r}, {Rational(1, 3)}, one_piece(-1, 1, {0, 0, 0.1_r}), 1);
  const auto cells = solved_on_cells(problem, 17);
  const auto r = cells->resultants();
  CHECK(r.load_share[0].value + r.load_share[1].value == doctest::Approx(1).epsilon(1e-13));
  CHECK(r.normal.value == doctest::Approx(1).epsilon(1e-13));
  CHECK(cells->residuals().load <= 1e-13);
  CHECK(cells->contact().front().left.kind == SingularKind::edge);
  // There are too few cells for an intensity: it is not known, and its error is infinite.
  CHECK(std::isinf(cells->contact().front().left.intensity.error));
}

TEST_CASE("points that cells cannot tell apart are left out, jumps are not") {
  const ContactProblem problem = reduced({0.1_r, 0.5_r}, {0.001_r}, polygon(0), 0.5_r);
  int wedges = 0, jumps = 0;
  for (const auto& point : solved_on_cells(problem, 1024)->singular_points()) {
    wedges += point.kind == SingularKind::wedge ? 1 : 0;
    jumps += point.kind == SingularKind::friction_jump ? 1 : 0;
  }
  CHECK(wedges == 0);
  CHECK(jumps == 1);
}

TEST_CASE("a pressure is infinite on any mesh, and where its logarithm is strongest") {
  const ContactProblem problem = reduced({0.1_r}, {}, polygon(Rational(1, 500)), 0.05_r);
  const auto exact = riemann_hilbert<double>(problem).solution->largest_pressure();
  CHECK(exact.x.value == doctest::Approx(-0.1));
  for (const std::size_t cells : {128U, 512U, 2048U, 16384U}) {
    CAPTURE(cells);
    const auto found = variational_inequality(problem, {.cells = cells}).solution->largest_pressure();
    CHECK(std::isinf(found.value.value));
    CHECK_FALSE(found.exponent);
    CHECK(std::abs(found.x.value - exact.x.value) <= found.x.error + exact.x.error);
  }
  // At a jump up the strongest power comes first, for any number of cells. A jump down has none, and there is no wedge.
  const Indenter parabola = one_piece(-1, 1, {0, 0, 2.5_r});
  for (const std::size_t cells : {64U, 256U, 4096U}) {
    CAPTURE(cells);
    const auto rising =
        variational_inequality(reduced({0.1_r, 0.6_r, 0.7_r}, {0, 0.1_r}, parabola, 1), {.cells = cells});
    CHECK(rising.solution->largest_pressure().x.value == doctest::Approx(0));
    CHECK(rising.solution->largest_pressure().exponent == jump_exponent(0.1_r, 0.6_r));
    const auto falling = variational_inequality(reduced({0.6_r, 0.1_r}, {0}, parabola, 1), {.cells = cells});
    CHECK_FALSE(std::isinf(falling.solution->largest_pressure().value.value));
  }
}

TEST_CASE("samples: so many a zone and a gap, left to right, all of them solutions") {
  const auto cells = solved_on_cells(on_two_coatings(two_wells(), 8), 1024);
  const auto samples = cells->samples(20);
  CHECK(samples.size() == 20 * (2 * cells->contact().size() + 1));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (k > 0) CHECK(samples[k - 1].x < samples[k].x);
    CHECK(samples[k].traction.left.value <= 0);
    REQUIRE(samples[k].gap);
    CHECK(samples[k].gap->value >= -samples[k].gap->error);
  }
}

TEST_CASE("out of steps: the best state, and what is wrong with it") {
  const Attempt<double> attempt =
      variational_inequality(reduced({0.3_r}, {}, two_wells(), 2), {.cells = 2048, .most_steps = 1});
  REQUIRE(attempt.solution);
  CHECK(holds(attempt.solution->failed_condition(), "1 iteration"));
  CHECK(!attempt.solution->contact().empty());
}

TEST_CASE("fewer than 16 cells are refused") {
  CHECK_THROWS_AS(variational_inequality(reduced({0.3_r}, {}, two_wells(), 2), {.cells = 8}), std::invalid_argument);
}

TEST_CASE("cells are refined until the wanted accuracy is reached, and it is") {
  for (const ContactProblem& problem : {on_two_coatings(two_wells(), 0.4_r), on_two_coatings(two_wells(), 9)}) {
    const auto exact = solved<double>(problem);
    const auto truth = exact->contact();
    const double width = truth.back().right.x.value - truth.front().left.x.value;
    for (const double accuracy : {1e-3, 1e-5}) {
      const auto found = variational_inequality(problem, {.accuracy = accuracy}).solution;
      const EstimatedError<double> error = found->estimated_error();
      CHECK(std::max(error.ends, error.resultants) <= accuracy);
      CHECK(std::max(error.ends, error.resultants) >= accuracy / 100);  // not with far more cells than needed
      const auto contact = found->contact();
      REQUIRE(contact.size() == truth.size());
      for (std::size_t k = 0; k < truth.size(); ++k) {
        CHECK(std::abs(contact[k].left.x.value - truth[k].left.x.value) <= accuracy * width);
        CHECK(std::abs(contact[k].right.x.value - truth[k].right.x.value) <= accuracy * width);
      }
      CHECK(std::abs(found->resultants().effective_friction.value - exact->resultants().effective_friction.value) <=
            accuracy * exact->resultants().effective_friction.value);
    }
  }
}
