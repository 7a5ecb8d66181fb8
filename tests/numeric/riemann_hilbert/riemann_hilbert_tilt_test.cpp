// Indenters that may tilt.

#include "numeric/riemann_hilbert/bracketed_tilt.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/random_contact.hpp"
#include "support/solved_contact.hpp"

namespace {

template <Real R>
void agree(const R& a, const R& b) {
  CHECK(size_of(R(a - b)) <= 2000 * epsilon<R>());
}

}  // namespace

TEST_CASE_TEMPLATE("load_at at the centre of pressure of the indenter that keeps its attitude: no tilt", R, double,
                   Real50) {
  const Indenter step(-1, {{0, Polynomial({0, 0, 1})}, {1, Polynomial({0.1_r, 0, 1})}});
  const auto indenters = std::same_as<R, double> ? std::vector{two_wells(), step, roof(-1, 1), one_piece(-1, 1, {0})}
                                                 : std::vector{two_wells()};
  for (const Indenter& indenter : indenters) {
    const auto fixed = solved<R>(on_two_coatings(indenter, 3));
    CHECK(!fixed->tilt());
    const R centre = fixed->resultants().centre_of_pressure.value;
    const auto free = solved<R>(on_two_coatings(indenter, 3, Rational(centre)));
    agree<R>(free->tilt()->value, 0);
    agree(free->resultants().centre_of_pressure.value, centre);
    solutions_agree<R, R>(*free, *fixed, 20 * epsilon<R>());
  }
}

TEST_CASE("the load acts where it should; its moment by an unrelated quadrature") {
  double last = 1e9;
  for (int i = -8; i <= 8; ++i) {
    for (const Indenter& indenter : {one_piece(-1, 1, {0, 0, 1}), one_piece(-1, 1, {0})}) {
      CAPTURE(i);
      const ContactProblem p = on_two_coatings(indenter, 1, Rational(i, 10));
      const auto found = solved<double>(p);
      agree(found->resultants().centre_of_pressure.value, i / 10.);
      // In the frame of the form, load and load_at are its own data.
      const trapezoidal::Grid<double> grid(traction_density(found->form()));
      const double moment = grid.moment(0) / grid.integral();
      agree(moment, *found->problem().load_at());
      agree(found->form().moment_of_load().value / found->problem().load(), moment);
      if (indenter.pieces()[0].profile.degree() < 0) {
        // If the load acts further to the right, it presses the right side down: psi + tilt x is lower there.
        CHECK(found->tilt()->value < last);
        last = found->tilt()->value;
      }
    }
  }
}

TEST_CASE("tilting does what an incline of the profile does") {
  const Rational load_at(1, 4);
  const Indenter indenter = one_piece(-1, 1, {0, 0, 1});
  const auto free = solved<Real50>(on_two_coatings(indenter, 1, load_at));
  const Rational tilt(free->tilt()->value);
  const auto fixed = solved<Real50>(on_two_coatings(one_piece(-1, 1, {0, tilt, 1}), 1));
  agree(fixed->resultants().centre_of_pressure.value, to_real<Real50>(load_at));
  solutions_agree<Real50, Real50>(*fixed, *free, 20 * epsilon<Real50>());
}

TEST_CASE("the tilt is bracketed from either side, from near and from far") {
  for (const double root : {-3e4, -1.0, 1e-9, 0.25, 7e5}) {
    for (const double start : {-2.0, 0.0, 0.25, 1e6}) {
      // Strictly falling, flat far away, with a corner at the root.
      const auto offset = [&](double tilt) -> std::optional<double> {
        return tilt < root ? std::atan(root - tilt) : 9 * std::atan(root - tilt);
      };
      const std::optional<double> found = bracketed_tilt(offset, start, 1e-3);
      REQUIRE(found);
      CHECK(std::abs(*found - root) <= 1e-12 * std::max({1.0, std::abs(root)}));
    }
  }
  // Absent: an attitude that is not solved, and no change of sign.
  const auto unsolved = [](double tilt) { return tilt < 3 ? std::optional(5 - tilt) : std::nullopt; };
  CHECK_FALSE(bracketed_tilt(unsolved, 0, 1));
  CHECK_FALSE(bracketed_tilt([](double) { return std::optional(1.0); }, 0, 1));
}

// The load lies between a notch and an edge, over a flank that is almost parallel to the surface. The pressure moves
// from the one to the other within a change of the tilt by one per cent, and Newton's method finds no free tilt.
TEST_CASE("a free tilt that only its bracket finds; cells find the same") {
  struct Case {
    std::uint64_t seed;
    Rational load_at;
  };
  for (const Case& c : {Case{20170096, {-5, 8}}, {20170119, {-5, 32}}, {20170217, {-5, 8}}}) {
    CAPTURE(c.seed);
    const ContactProblem fixed = random_contact(c.seed, ContactFamily::notches);
    const ContactProblem problem(fixed.elasticity(), fixed.friction(), fixed.indenter(), fixed.load(), fixed.sliding(),
                                 c.load_at);
    const auto found = riemann_hilbert<double>(problem).solution;
    REQUIRE(found);
    CHECK(found->failed_condition() == "");
    const auto cells = variational_inequality(problem, {.cells = 16384}).solution;
    const auto agree = [](const Estimate<double>& a, const Estimate<double>& b) {
      CHECK(std::abs(a.value - b.value) <= a.error + b.error);
      CHECK(std::abs(a.value - b.value) <= 1e-3 * std::abs(a.value));
    };
    agree(*found->tilt(), *cells->tilt());
    agree(found->resultants().effective_friction, cells->resultants().effective_friction);
    const double place = to_real<double>(c.load_at);
    CHECK(std::abs(found->resultants().centre_of_pressure.value - place) <= 1e-9);
  }
}
