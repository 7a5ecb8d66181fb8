// Tests the estimated errors of contact ends on cells, compared with Riemann-Hilbert solutions.

#include "numeric/variational/variational_inequality.hpp"
#include "support/random_contact.hpp"
#include "support/solved_contact.hpp"

namespace {

struct Count {
  int ends = 0, uncovered = 0;
  int wide = 0;  ///< number of errors of more than ten cells
  int none = 0;  ///< number of ends of gaps that may not exist
};

double nearest(const std::vector<ContactComponent<double>>& contact, bool left, double x) {
  double least = infinity<double>();
  for (const auto& c : contact) least = std::min(least, std::abs((left ? c.left : c.right).x.value - x));
  return least;
}

/// Checks that every end lies within its error of a true one, unless the error says that its gap may not exist.
void compare(Count& count, const ContactProblem& problem, const ContactSolution<double>& exact,
             const VariationalOptions& options) {
  const std::size_t cells = options.cells;
  const auto found = variational_inequality(problem, options).solution;
  if (!found || !found->failed_condition().empty()) return;
  const auto truth = exact.contact();
  const auto contact = found->contact();
  const double cell =
      to_real<double>(Rational(problem.indenter().right() - problem.indenter().left())) / static_cast<double>(cells);
  double worst = 0;
  const auto look = [&](const ContactEnd<double>& end, bool left, double gap) {
    const double off = nearest(truth, left, end.x.value);
    worst = std::max(worst, end.x.error);
    if (end.kind != SingularKind::free) return;
    ++count.ends;
    if (end.x.error > 10 * cell) ++count.wide;
    if (end.x.error >= gap) {
      ++count.none;
    } else if (off > end.x.error) {
      ++count.uncovered;
      MESSAGE(cells, " cells, end ", end.x.value, " off by ", off / cell, " cells, said ", end.x.error / cell);
    }
  };
  for (std::size_t k = 0; k < contact.size(); ++k) {
    const double none = infinity<double>();
    look(contact[k].left, true, k == 0 ? none : contact[k].left.x.value - contact[k - 1].right.x.value);
    look(contact[k].right, false,
         k + 1 == contact.size() ? none : contact[k + 1].left.x.value - contact[k].right.x.value);
  }
  const double hull = contact.back().right.x.value - contact.front().left.x.value;
  CHECK(found->estimated_error().ends * hull >= 0.999 * worst);
}

void compare(Count& count, const ContactProblem& problem, const std::vector<VariationalOptions>& meshes) {
  const auto exact = riemann_hilbert<double>(problem).solution;
  if (!exact || !exact->failed_condition().empty()) return;
  for (const VariationalOptions& mesh : meshes) compare(count, problem, *exact, mesh);
}

ContactProblem on_falling_friction(const Rational& s, const Rational& load) {
  return reduced({s, 0}, {0}, one_piece(-1, 1, {0, 0, 1}), load);
}

}  // namespace

TEST_CASE("a strong fall of s: ends are within their errors, and a gap that is none says so") {
  for (const Rational& s : {2_r, 5_r, 8_r, 50_r}) {
    Count count;
    for (const Rational& load : {0.1_r, 0.3_r, 0.5_r, 1_r, 2_r}) {
      compare(count, on_falling_friction(s, load), {{.cells = 128}, {.cells = 512}});
    }
    CAPTURE(s);
    CHECK(count.uncovered == 0);
    // Up to s = 2 the equations are means over cells, which oscillate slightly. Beyond that nothing oscillates.
    if (s > 2) CHECK(count.none == 0);
    if (s == 2) CHECK(count.none >= 5);
  }
}

TEST_CASE("by means alone cells ring where s falls strongly, and their ends know it") {
  const auto by_means = [](std::size_t cells) {
    return VariationalOptions{.cells = cells, .friction_rule = variational::FrictionRule::galerkin};
  };
  Count count;
  for (const Rational& s : {5_r, 8_r}) {
    for (const Rational& load : {0.1_r, 0.3_r, 0.5_r, 1_r, 2_r}) {
      compare(count, on_falling_friction(s, load), {by_means(128), by_means(512)});
    }
  }
  CHECK(count.uncovered == 0);
  CHECK(count.none >= 10);
  // A gap opens behind the left edge, where the traction grows like d^(-0.94).
  const auto contact = variational_inequality(on_falling_friction(5, 0.5_r), by_means(4096)).solution->contact();
  REQUIRE(contact.size() == 2);
  CHECK(contact[1].left.x.error >= contact[1].left.x.value - contact[0].right.x.value);
}

TEST_CASE("strong friction on a side of a jump: contact is right to one cell, without a gap, on any mesh") {
  for (const auto& s : {std::vector{5_r, 0_r}, {0_r, 5_r}, {50_r, 0.1_r}, {0.1_r, 50_r}, {50_r, 50_r}, {8_r, 3_r}}) {
    for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
      const ContactProblem problem = reduced(s, {0}, one_piece(-3, 3, {0, 0, 1}), 1, std::nullopt, sliding);
      const auto exact = riemann_hilbert<double>(problem).solution->contact();
      REQUIRE(exact.size() == 1);
      for (const std::size_t cells : {1000U, 4096U, 16384U, 65536U}) {
        INFO("s = ", to_string(s[0]), " | ", to_string(s[1]), ", ", cells, " cells");
        const auto found = variational_inequality(problem, {.cells = cells}).solution;
        CHECK(found->failed_condition() == "");
        const auto contact = found->contact();
        REQUIRE(contact.size() == 1);
        const double cell = 6.0 / static_cast<double>(cells);
        for (const auto& [end, other] :
             {std::pair(contact[0].left, exact[0].left), {contact[0].right, exact[0].right}}) {
          const double off = std::abs(end.x.value - other.x.value);
          CHECK(off <= cell);
          CHECK(off <= end.x.error + 1e-12);
        }
      }
    }
  }
}

TEST_CASE("random problems: nearly all ends are within their errors, most of which are few cells") {
  Count count;
  for (std::uint64_t k = 0; k < 60; ++k) compare(count, random_contact(first_listed_seed + k), {{.cells = 256}});
  MESSAGE(count.ends, " ends, ", count.uncovered, " not within their errors, ", count.wide, " errors above ten cells, ",
          count.none, " at gaps that may be none");
  CHECK(count.ends >= 60);
  CHECK(30 * count.uncovered <= count.ends);
  CHECK(3 * count.wide <= count.ends);
}

TEST_CASE("a gap that half as many cells do not show is in doubt; the other ends and the forces are not") {
  // The gap over a notch grows with its angle, from zero to many cells.
  int met = 0;
  for (int k = 200; k < 900; k += 10) {
    const Rational slope(k, 1000);
    const Indenter notch(-1, {{0, Polynomial({0, slope, 2.5_r})}, {1, Polynomial({0, -slope, 2.5_r})}});
    const auto found = variational_inequality(reduced({0.3_r}, {}, notch, 0.5_r), {.cells = 512}).solution;
    REQUIRE(found->failed_condition() == "");
    const auto contact = found->contact();
    REQUIRE(contact.size() <= 2);
    const double gap = contact.back().left.x.value - contact.front().right.x.value;
    if (contact.size() < 2 || contact[0].right.x.error < gap) continue;
    ++met;
    CAPTURE(k);
    CHECK(contact[1].left.x.error >= gap);
    CHECK(contact[0].right.x.error <= gap + 1.5 / 256);
    for (const ContactEnd<double>& end : {contact.front().left, contact.back().right}) CHECK(end.x.error < 2.0 / 256);
    const double hull = contact.back().right.x.value - contact.front().left.x.value;
    CHECK(found->estimated_error().ends * hull <= gap + 1.5 / 256);
    CHECK(found->estimated_error().resultants < 0.1);
  }
  CHECK(met >= 3);
}
