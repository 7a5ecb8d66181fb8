// The errors above which there is a warning, and above which a state is not a solution.

#include "library/solve/warnings.hpp"
#include "library/solve/failed_condition.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/made_up_solution.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;
using namespace steadyslide::numeric;

namespace {

MadeUp with_error(const EstimatedError<double>& error) {
  MadeUp shown;
  shown.shown_error = error;
  return shown;
}

/// Contact from left to right on a trace over [-1, 1].
MadeUp with_contact(double left, double right) {
  MadeUp shown;
  const auto end = [](double x, End side) {
    if (std::abs(x) == 1) return ContactEnd<double>{{x}, SingularKind::edge, edge_exponent(side, 0), {}};
    return ContactEnd<double>{{x}, SingularKind::free, free_exponent(side, 0), {}};
  };
  shown.shown_contact.push_back({end(left, End::left), end(right, End::right), {right - left}});
  return shown;
}

Problem punch(bool is_trace) {
  return {ContactProblem(Elasticity::reduced(0), FrictionProfile({0}), Indenter(-1, {{1, Polynomial()}}), 1),
          "punch.toml", is_trace ? std::optional(MeasuredProfile{"trace.csv", 2}) : std::nullopt};
}

std::size_t count(const MadeUp& shown, bool is_trace = true) { return warnings(punch(is_trace), shown).size(); }

}  // namespace

TEST_CASE("an error above 10 % is warned of, above 50 % there is no solution") {
  CHECK(count(with_error({0.1, 0.1, 0.1})) == 0);
  for (const EstimatedError<double>& one : {EstimatedError<double>{0.11, 0, 0}, {0, 0.11, 0}, {0, 0, 0.11}}) {
    CHECK(count(with_error(one)) == 1);
  }
  CHECK(count(with_error({0.2, 0.2, std::nan("")})) == 3);
  CHECK(warnings(punch(false), with_error({0, 0.22, 0})).front() ==
        "traction: large estimated error; more than 10 % of its size; 22 %");

  CHECK(useless_error(EstimatedError<double>{0.5, 0.5, 0.5}).empty());
  CHECK(useless_error(EstimatedError<double>{1, 0, 0}) ==
        "the estimated error of the ends of contact is 100 % of the contact's length");
  CHECK_FALSE(useless_error(EstimatedError<double>{0, 0.51, 0}).empty());
  CHECK_FALSE(useless_error(EstimatedError<double>{0, 0, std::nan("")}).empty());
}

TEST_CASE("contact at the cut end of a trace, and contact nowhere else") {
  CHECK(count(with_contact(-0.5, 0.5)) == 0);
  CHECK(count(with_contact(-1, 0.5)) == 1);
  CHECK(count(with_contact(-1, 1)) == 1);
  CHECK(count(with_contact(0.98, 0.999)) == 1);  // 1 % of the support, which is 2 long
  CHECK(count(with_contact(0.97, 0.999)) == 0);
  CHECK(count(with_contact(0.99, 1)) == 2);
  CHECK(count(with_contact(-1, -0.99)) == 2);
  // A profile that is a formula has no cut end.
  CHECK(count(with_contact(0.99, 1), false) == 0);
  // Contact at both ends at once, as under a parabola turned upside down.
  MadeUp both = with_contact(-1, -0.99);
  both.shown_contact.push_back(with_contact(0.99, 1).shown_contact.front());
  CHECK(count(both) == 2);
  both.shown_contact.push_back(with_contact(0, 0.1).shown_contact.front());
  CHECK(count(both) == 1);
}

TEST_CASE("a gap over a notch is warned of, unless the notch is what coefficients have been rounded by") {
  const auto told = [](const Rational& kink, const Rational& place) {
    const Polynomial left({0, 0.1_r, 1});
    const Polynomial right = left + Polynomial({-place, 1}) * Polynomial::constant(kink);
    const Problem problem{ContactProblem(Elasticity::reduced(0.5_r), FrictionProfile({0.6_r}),
                                         Indenter(-1, {{place, left}, {1, right}}), 1),
                          "bump.toml", std::nullopt};
    const auto solution = riemann_hilbert<double>(problem.contact).solution;
    REQUIRE(solution->failed_condition() == "");
    REQUIRE(solution->unresolved_gaps().size() == 1U);
    return warnings(problem, *solution);
  };
  for (const Rational& place : {0_r, 0.125_r}) {
    // The slopes are 0.1 + 2 x on both sides; the limit is 2^-49 of their sum.
    const Rational least = 2 * (0.1_r + 2 * place) / (Integer(1) << 49);
    CHECK(told(-least * 0.9_r, place).empty());
    const std::vector<std::string> lines = told(-least * 1.1_r, place);
    REQUIRE(lines.size() == 1U);
    CHECK(lines.front().find("gaps over notches") == 0U);
  }
}

TEST_CASE("a residual may be larger under a profile of many pieces: the error of the traction, at most 1e-6") {
  const auto limit = [](int pieces, double traction_error) {
    std::vector<Indenter::Piece> profile;
    for (int k = 1; k <= pieces; ++k) profile.push_back({k, Polynomial({k % 2, 0, 1})});
    const ContactProblem problem(Elasticity::reduced(0), FrictionProfile({0}), Indenter(0, profile), 1);
    return largest_residual_of(problem, with_error({0, traction_error, 0}));
  };
  CHECK(limit(64, 1e-7) == 1e-9);
  CHECK(limit(65, 1e-7) == 1e-7);
  CHECK(limit(65, 1e-12) == 1e-9);
  CHECK(limit(65, 0.1) == 1e-6);
  CHECK(limit(65, std::numeric_limits<double>::quiet_NaN()) == 1e-9);
}
