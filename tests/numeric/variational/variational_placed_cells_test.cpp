// With a wanted accuracy, cells lie on the contact alone. The solution is still one of the whole support.

#include "numeric/variational/variational_inequality.hpp"
#include "support/solved_contact.hpp"

namespace {

std::shared_ptr<const ContactSolution<double>> placed(const ContactProblem& problem, double accuracy,
                                                      std::size_t locating = 4096) {
  const auto found = variational_inequality(problem, {.cells = locating, .accuracy = accuracy}).solution;
  REQUIRE(found);
  CHECK(found->failed_condition() == "");
  const auto [ends, traction, resultants] = found->estimated_error();
  CHECK(std::max(ends, resultants) <= accuracy);
  return found;
}

double length_of_cells(const ContactSolution<double>& solution) {
  return to_real<double>(Rational(solution.equal_cells()->right - solution.equal_cells()->left));
}

void within_error(const char* what, const Estimate<double>& found, const Estimate<double>& truth) {
  INFO(std::string(what), " ", found.value, " +- ", found.error, ", true ", truth.value);
  CHECK(std::abs(found.value - truth.value) <= found.error + 1e-12);
}

void within_error(const char* what, const TwoSided<double>& found, const TwoSided<double>& truth) {
  within_error(what, found.left, truth.left);
  within_error(what, found.right, truth.right);
}

/// Compares everything at places outside the cells, and the contact.
void agree_with_exact(const ContactProblem& problem, const ContactSolution<double>& found) {
  const auto exact = solved<double>(problem);
  const auto contact = found.contact(), truth = exact->contact();
  REQUIRE(contact.size() == truth.size());
  for (std::size_t k = 0; k < contact.size(); ++k) {
    for (const auto end : {&ContactComponent<double>::left, &ContactComponent<double>::right}) {
      within_error("end", (contact[k].*end).x, (truth[k].*end).x);
      CHECK((contact[k].*end).kind == (truth[k].*end).kind);
    }
  }
  const auto forces = found.resultants(), true_forces = exact->resultants();
  within_error("centre", forces.centre_of_pressure, true_forces.centre_of_pressure);
  within_error("friction", forces.effective_friction, true_forces.effective_friction);
  if (found.tilt()) within_error("tilt", *found.tilt(), *exact->tilt());
  const Rational left = problem.indenter().left(), right = problem.indenter().right();
  const EqualCells cells = *found.equal_cells();
  int outside = 0;
  for (int k = -3; k <= 43; ++k) {
    const Rational x = left + (right - left) * k / 40;
    if (x >= cells.left && x <= cells.right) continue;
    ++outside;
    CAPTURE(to_string(x));
    const auto a = found.details_at(x), b = exact->details_at(x);
    within_error("traction", a.traction, b.traction);
    CHECK(a.gap.has_value() == b.gap.has_value());
    if (a.gap && b.gap) within_error("gap", *a.gap, *b.gap);
    within_error("slope", a.slope, b.slope);
    within_error("displacement", a.displacement, b.displacement);
    within_error("shear slope", a.shear_slope, b.shear_slope);
    within_error("load", a.cumulative_load, b.cumulative_load);
    CHECK(a.friction.has_value() == b.friction.has_value());
    if (a.friction && b.friction) {
      CHECK(a.friction->left == b.friction->left);
      CHECK(a.friction->right == b.friction->right);
    }
  }
  CHECK(outside >= 6);
  const auto samples = found.samples(5);
  CHECK(samples.front().x < to_real<double>(left) + 1);
  CHECK(samples.back().x > to_real<double>(right) - 1);
}

/// A parabola with a tent at x = 7.
Indenter with_tent(const Rational& height, const Rational& half_width) {
  const Rational rise = height / half_width;
  const Polynomial base({0, 0, 0.05_r}), up({(7 - half_width) * rise, -rise}), down({-(7 + half_width) * rise, rise});
  return Indenter(-8, {{7 - half_width, base}, {7, base + up}, {7 + half_width, base + down}, {9, base}});
}

}  // namespace

TEST_CASE("cells on the contact: all quantities outside them are within their errors, both ways") {
  const Indenter parabola = one_piece(-8, 9, {0, 0, 1});
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const auto& load_at : {std::optional<Rational>(), std::optional(0.2_r)}) {
      // One jump of friction lies outside the cells.
      const ContactProblem problem = reduced({0.3_r, 1, 0.2_r}, {0.1_r, 3}, parabola, 0.1_r, load_at, sliding);
      for (const double accuracy : {1e-2, 1e-4}) {
        CAPTURE(accuracy);
        const auto found = placed(problem, accuracy);
        CHECK(length_of_cells(*found) < 2);
        agree_with_exact(problem, *found);
      }
    }
  }
}

TEST_CASE("cells on the contact of a measured profile: straight lines between points, with two zones or one") {
  std::vector<Indenter::Piece> lines;
  const auto height = [](const Rational& x) { return x * x / 4 + (x > 0 && x < 1 ? 0.1_r : 0_r); };
  for (Rational x = -8; x < 9; x += 0.25_r) {
    const Rational slope = (height(x + 0.25_r) - height(x)) / 0.25_r;
    lines.push_back({x + 0.25_r, Polynomial({height(x) - slope * x, slope})});
  }
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const Rational& load : {0.1_r, 0.5_r}) {
      const ContactProblem problem = reduced({0.3_r, 1}, {0.1_r}, {-8, lines}, load, std::nullopt, sliding);
      const auto found = placed(problem, 1e-3);
      CHECK(length_of_cells(*found) < 5);
      agree_with_exact(problem, *found);
    }
  }
}

TEST_CASE("cells on the contact: strong friction, whose equations apply at the ends of cells") {
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem problem = reduced({5, 8}, {0.1_r}, one_piece(-8, 9, {0, 0, 1}), 0.1_r, std::nullopt, sliding);
    const auto found = placed(problem, 1e-4);
    CHECK(length_of_cells(*found) < 3);
    agree_with_exact(problem, *found);
  }
}

TEST_CASE("a contact that reaches an end of the support has an edge there") {
  for (const auto& [left, right] : {std::pair(0.1_r, 9_r), {-9_r, -0.1_r}}) {
    const Rational jump = left > 0 ? 0.15_r : -0.15_r;
    const ContactProblem problem = reduced({0.3_r, 1}, {jump}, one_piece(left, right, {0, 0, 1}), 0.1_r);
    const auto found = placed(problem, 1e-3);
    CHECK(length_of_cells(*found) < 2);
    const auto contact = found->contact().front();
    CHECK((left > 0 ? contact.left : contact.right).kind == SingularKind::edge);
    agree_with_exact(problem, *found);
  }
}

TEST_CASE("a second bump outside the cells that touches under load is found, however narrow") {
  // 64 locating cells show neither, 4096 cells show the wide one.
  for (const std::size_t locating : {64U, 4096U}) {
    for (const Rational& half : {0.05_r, 0.005_r}) {
      const ContactProblem problem = reduced({0.3_r, 1}, {0.1_r}, with_tent(2.5_r, half), 0.2_r);
      const auto found = variational_inequality(problem, {.cells = locating, .accuracy = 1e-3}).solution;
      INFO(locating, " cells, half width ", to_string(half));
      CHECK(found->failed_condition() == "");
      CHECK(length_of_cells(*found) > 7);
      const auto exact = solved<double>(problem);
      REQUIRE(exact->contact().size() == 2);
      // The contact on the narrow one is shorter than a cell.
      if (half > 0.01_r) CHECK(found->contact().size() == 2);
    }
  }
  // A lower tent stays outside.
  const ContactProblem below = reduced({0.3_r, 1}, {0.1_r}, with_tent(1, 0.05_r), 0.2_r);
  CHECK(length_of_cells(*placed(below, 1e-3)) < 3);
}

TEST_CASE("cells on the contact are fewer: as many as a support of the contact's size needs") {
  const auto cells = [](const Rational& half_support, double accuracy) {
    return placed(reduced({0.3_r, 1}, {0.1_r}, one_piece(-half_support, half_support, {0, 0, 1}), 0.1_r), accuracy)
        ->equal_cells()
        ->count;
  };
  for (const double accuracy : {1e-3, 1e-5}) {
    CHECK(cells(100, accuracy) <= 4 * cells(0.5_r, accuracy));
    CHECK(cells(1000, accuracy) <= 4 * cells(0.5_r, accuracy));
  }
}
