// Gaps beside a contact that ends at a break of the profile, where the indenter continues with another polynomial.
// Heights by the form are compared with the profile minus the displacement due to the traction.

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "support/solved_contact.hpp"

namespace {

struct GapCase {
  const char* name;
  Indenter indenter;
  Rational load;
  std::size_t components;
};

std::vector<GapCase> cases() {
  const Polynomial bowl({0, 0, 1});
  const Polynomial high({1, 1});
  const Polynomial flat;
  const Polynomial between({0.5_r, 0, 0.25_r});
  return {{"a step up, an incline beyond", Indenter(-1, {{0, bowl}, {1, high}}), 1, 1},
          {"a step down, a bowl before it", Indenter(-1, {{0, Polynomial({1, 0, 2})}, {1, bowl}}), 1, 1},
          {"a step up, two polynomials beyond", Indenter(-1, {{0, bowl}, {0.5_r, high}, {1, between}}), 1, 1},
          {"two feet, an arch between", Indenter(-1, {{Rational(-1, 3), flat}, {0.25_r, between}, {1, flat}}), 2, 2}};
}

/// Contact from a step, where the traction grows like d^-0.82, to a free end.
ContactProblem edge_at_step() {
  const Polynomial profile({0, 1, 0.5_r});
  return {Elasticity(Solid(Rational(-5, 14), 1)), FrictionProfile({Rational(18, 7)}),
          Indenter(-4, {{Rational(-45, 14), profile}, {4, profile + Polynomial({-1})}}), 1};
}

/// Returns the gap to the left of the step.
template <Real R>
std::vector<double> openings() {
  const ContactProblem problem = edge_at_step();
  const RoundedProblem<R> reduced(problem, {0.125_r, 2});
  JacobiRules<R> rules;
  const TractionRepresentation<R> form(reduced, ContactSet<R>(reduced, {{-1.67, 0.7, true, false}}), {}, R(0), rules);
  const GapIntegral<R> gap(form, 1);
  std::vector<double> result;
  for (int i = 1; i < 1000; ++i) {
    const auto at = beside(form.set(), 0, Side::right, R(form.set().length(0) * i / 1000));
    result.push_back(static_cast<double>(gap.reduced_gap(at).value));
  }
  return result;
}

/// A flat punch with a step of this height at x = 1/4. On the high side, the distance `flat` from the step, its slope
/// changes to `bend`: positive if the face recedes.
Indenter punch_with_step(const std::string& height, bool up, const Rational& flat = 0, const Rational& bend = 0) {
  const Polynomial low, high({parse_rational(height)});
  const Rational step = 0.25_r, side = up ? 1 : -1, at = step + side * flat;
  const Polynomial bent = high + Polynomial({-side * bend * at, side * bend});
  if (flat == 0) return Indenter(-1, {{step, up ? low : bent}, {1, up ? bent : low}});
  if (up) return Indenter(-1, {{step, low}, {at, high}, {1, bent}});
  return Indenter(-1, {{at, bent}, {step, high}, {1, low}});
}

/// Returns the length of the gap beside the step of this punch, with these values of s.
template <Real R>
R gap_beside_step(const Indenter& punch, std::vector<Rational> s, const std::vector<Rational>& jumps) {
  const auto solution = solved<R>(reduced(std::move(s), jumps, punch, 1));
  const ContactSet<R>& set = solution->form().set();
  REQUIRE(solution->contact().size() == 2U);
  R length = 0;
  for (std::size_t k = set.all(ContactSet<R>::Kind::ends).front(); !set.in_contact(k); ++k) length += set.length(k);
  return length * to_real<R>(solution->problem().frame().unit);
}

}  // namespace

TEST_CASE("gaps beside a step whose other face is another polynomial") {
  int wrong_by_one_polynomial = 0;
  for (const GapCase& c : cases()) {
    CAPTURE(c.name);
    const auto solution = solved<double>(reduced({1, 0.5_r}, {-0.5_r}, c.indenter, c.load));
    REQUIRE(solution->contact().size() == c.components);
    const TractionRepresentation<double>& form = solution->form();
    const ContactSet<double>& set = form.set();
    const auto check = check_of(form);
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (set.in_contact(k)) continue;
      for (const double part : {1e-6, 0.03, 0.2, 0.45, 0.55, 0.8, 0.999}) {
        const SurfacePoint<double> at = beside(set, k, Side::right, part * set.length(k));
        CAPTURE(at.node.x);
        from_ends_of_gap(form, check, at, [&](std::size_t j, End side, double surface) {
          const GapIntegral<double> gap(form, j);
          const double expected = gap.profile_increment(at) - surface;
          CHECK(gap.reduced_gap(at).value == doctest::Approx(expected).epsilon(1e-10));
          // The control: the polynomial of the contact continued beyond the break.
          const std::size_t inside = side == End::right ? j - 1 : j;
          const double end = set.x(j);
          const double gone_on =
              form.problem().profile_increment(form.slope_at(inside), end, at.node.x - end) - surface;
          if (std::abs(gone_on - expected) > 1e-3) ++wrong_by_one_polynomial;
        });
      }
    }
  }
  CHECK(wrong_by_one_polynomial > 20);
}

TEST_CASE_TEMPLATE("a low step has a gap in proportion to its height, to 1e-270", R, double, Real50) {
  // If the gap is much shorter than the contact, the flat punch gives the pressure p beyond it. At the distance d from
  // the free end the traction is p (d/(d + l))^lambda, and so the height is pi lambda (1 + s^2) p l.
  const Rational s = 0.6_r;
  const auto flat = closed_form<R>(reduced({s}, {}, one_piece(-1, 1, {}), 1)).solution;
  REQUIRE(flat);
  const R p = -flat->at(0.25_r).traction.left.value;
  for (const bool up : {true, false}) {
    CAPTURE(up);
    const R lambda = Power<R>::of(free_exponent(up ? End::left : End::right, s)).value;
    const R expected = 1 / (pi<R>() * lambda * (1 + to_real<R>(s * s)) * p);
    for (const char* height : {"1e-20", "1e-60", "1e-140", "1e-200", "1e-270"}) {
      CAPTURE(height);
      const R ratio =
          gap_beside_step<R>(punch_with_step(height, up), {s}, {}) / to_real<R>(parse_rational(height)) / expected;
      CHECK(abs(ratio - 1) < (std::same_as<R, double> ? 1e-11 : 1e-18));
    }
  }
}

TEST_CASE("friction that jumps at a low step changes the power of the gap's length") {
  // The height is like l^(1+beta), where the traction of a flat punch is like d^beta.
  for (const auto& s : {std::vector<Rational>{0.2_r, 3}, {3, 0.2_r}}) {
    for (const bool up : {true, false}) {
      CAPTURE(up);
      const double beta = Power<double>::of(jump_exponent(s[0], s[1])).value;
      CHECK(std::abs(beta) > 0.3);
      const auto gap = [&](const char* height) {
        return gap_beside_step<double>(punch_with_step(height, up), s, {0.25_r});
      };
      CHECK(std::log10(gap("1e-60") / gap("1e-80")) * (1 + beta) == doctest::Approx(20).epsilon(1e-10));
    }
  }
}

TEST_CASE("a low step near a break keeps the power of the gap's length") {
  // Contact ends between the step and the break, so that the lengths on both sides of that end are short.
  for (const auto& s : {std::vector<Rational>{0.2_r, 3}, {3, 0.2_r}}) {
    for (const bool up : {true, false}) {
      CAPTURE(up);
      const double beta = Power<double>::of(jump_exponent(s[0], s[1])).value;
      const auto gap = [&](const char* height) {
        return gap_beside_step<double>(punch_with_step(height, up, 0.02_r, 0.01_r), s, {0.25_r});
      };
      CHECK(std::log10(gap("1e-60") / gap("1e-80")) * (1 + beta) == doctest::Approx(20).epsilon(1e-10));
      CHECK(std::log10(gap("1e-120") / gap("1e-150")) * (1 + beta) == doctest::Approx(30).epsilon(1e-10));
    }
  }
}

TEST_CASE("a short flat piece between a step and a break changes a long gap little") {
  // In double the step and the break are at the same place. Contact begins or ends at the step, not at the break.
  for (const bool up : {true, false}) {
    CAPTURE(up);
    for (const Rational& bend : {0.01_r, -0.01_r}) {
      for (const char* height : {"1e-3", "1e-6", "1e-10"}) {
        CAPTURE(height);
        const auto gap = [&](const char* flat) {
          return gap_beside_step<double>(punch_with_step(height, up, parse_rational(flat), bend), {0.6_r}, {});
        };
        CHECK(gap("1e-18") == doctest::Approx(gap("0")).epsilon(1e-7));
      }
    }
  }
}

TEST_CASE_TEMPLATE("a gap beside a step that double cannot represent is too short", R, double, Real50) {
  for (const char* height : {"1e-300", "1e-400"}) {
    CAPTURE(height);
    const Indenter punch = punch_with_step(height, true);
    const auto solution = riemann_hilbert<R>(reduced({0.6_r}, {}, punch, 1)).solution;
    REQUIRE(solution);
    CHECK(solution->failed_condition() == "the gap beside a step is too short");
  }
}

TEST_CASE("off the support there is no gap") {
  const auto solution = solved<double>(reduced({1}, {}, Indenter(-1, {{1, Polynomial({0, 0, 1})}}), 1));
  const auto& form = solution->form();
  const std::size_t end = form.set().segments();
  CHECK_THROWS_AS((void)GapIntegral(form, end - 1).reduced_gap(beside(form.set(), end, Side::right, 1.0)),
                  std::domain_error);
}

TEST_CASE("the gap beside an edge does not depend on how its place rounds") {
  const std::vector<double> rough = openings<double>(), fine = openings<Real50>();
  for (std::size_t i = 0; i < fine.size(); ++i) CHECK_MESSAGE(rough[i] == doctest::Approx(fine[i]).epsilon(1e-12), i);
}

TEST_CASE_TEMPLATE("the corner of a step's far end touches from its closing load on", R, double, Real50) {
  // At the load 0.302786423542875 the surface touches the corner at the support's end, and no other point of that face.
  for (const bool mirrored : {false, true}) {
    CAPTURE(mirrored);
    const auto zones = [&](const Rational& load) {
      const Indenter foot(-1, {{0, Polynomial()}, {1, Polynomial({0.3_r})}});
      const ContactProblem problem(Elasticity(Solid(0.2_r, 1)), FrictionProfile({0.3_r}), foot, load);
      const auto solution = riemann_hilbert<R>(mirrored ? problem.mirrored() : problem).solution;
      REQUIRE(fault(*solution) == "");
      const auto contact = solution->contact();
      const auto gap = solution->at(mirrored ? -1 : 1).gap;
      REQUIRE(gap);
      if (contact.size() == 1) CHECK(gap->value > 0);
      // The control: just below the closing load the gap is small.
      if (contact.size() == 1) CHECK(gap->value < 1e-9);
      if (contact.size() == 2) CHECK((mirrored ? contact[0].left : contact[1].right).kind == SingularKind::edge);
      return contact.size();
    };
    CHECK(zones(0.3027864234_r) == 1);
    CHECK(zones(0.30278642354_r) == 1);
    CHECK(zones(0.30278642355_r) == 2);
    CHECK(zones(0.3027864236_r) == 2);
    CHECK(zones(0.3028_r) == 2);
    CHECK(zones(0.31_r) == 2);
  }
}

TEST_CASE("a gap that closes between two places closes where it is lowest") {
  // A bowl beside a bowl: the lowest place of its gap is not that of its profile.
  const auto at_load = [](double load) {
    return solved<double>(reduced({0.3_r}, {},
                                  Indenter(-1, {{0.5_r, Polynomial({0, 0, 1})}, {2, Polynomial({1.6_r, -2.4_r, 1})}}),
                                  Rational(load)));
  };
  double below = 0.02, above = 2;
  REQUIRE(at_load(below)->contact().size() == 1);
  REQUIRE(at_load(above)->contact().size() == 2);
  while (above - below > 1e-9) {
    const double load = (below + above) / 2;
    (at_load(load)->contact().size() == 1 ? below : above) = load;
  }
  const auto found = at_load(below);
  double lowest = 1;
  for (int i = 0; i <= 4000; ++i) lowest = std::min(lowest, found->at(Rational(5000 + 3 * i, 10000)).gap->value);
  CAPTURE(below);
  CHECK(lowest > -1e-9);
  // The control: the gap is about to close.
  CHECK(lowest < 1e-6);
}
