#include <chrono>

#include "model/singular_point.hpp"
#include "support/test.hpp"
#include "symbolic/field/expression.hpp"
#include "symbolic/field/field_linear.hpp"
#include "symbolic/local/local_derivations.hpp"
#include "symbolic/local/local_form.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;

using GiNaC::symbol;

namespace {

const symbol s("s"), s_l("s_l"), s_r("s_r");

std::vector<ex> slopes(const std::string& name) {
  return {symbol(name + "_0"), symbol(name + "_1"), symbol(name + "_2")};
}

bool solves_equations(const LocalForm& form) {
  const LocalFrame& frame = form.frame;
  const LocalConstants constants = form.exponent ? frame.constants(*form.exponent) : LocalConstants{0, 0, frame.pi()};
  for (const LocalEquation& equation : local_equations(form.place, constants, form.density())) {
    if (!frame.field().are_equal(equation.lhs, equation.rhs).holds) return false;
  }
  return true;
}

const LocalFormTerm& term(const LocalForm& form, bool fractional, int order, int logs, bool forced) {
  for (const LocalFormTerm& t : form.terms) {
    if (t.fractional == fractional && t.order == order && t.logs == logs && t.forced == forced) return t;
  }
  throw std::out_of_range("no such term");
}

std::vector<LocalPlace> symbolic_places() {
  const LocalSide left{s_l, slopes("u")};
  const LocalSide right{s_r, slopes("v")};
  std::vector<LocalPlace> places{{ContactSide::both, {s, left.slopes}, {s, left.slopes}},
                                 {ContactSide::both, {s, left.slopes}, {s, right.slopes}}};
  for (const bool increases : {true, false}) {
    places.push_back({ContactSide::both, left, {s_r, left.slopes}, Beyond::indenter, increases});
    places.push_back({ContactSide::both, left, right, Beyond::indenter, increases});
  }
  for (const ContactSide contact : {ContactSide::left, ContactSide::right}) {
    for (const Beyond beyond : {Beyond::nothing, Beyond::indenter, Beyond::step}) {
      places.push_back({contact, left, right, beyond});
    }
  }
  return places;
}

Rational random_coefficient() { return Rational(uniform(-40, 40), uniform(1, 12)); }

}  // namespace

TEST_CASE("every derived form satisfies the local equation to all three orders, and quickly") {
  for (const LocalPlace& place : symbolic_places()) {
    const auto start = std::chrono::steady_clock::now();
    const LocalForm form = derive_local_form(place);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    CAPTURE(form.derivation.title);
    CHECK(solves_equations(form));
    // A control: one coefficient is changed on one side.
    LocalForm wrong = form;
    for (LocalFormTerm& t : wrong.terms) {
      (place.in_contact(Side::right) ? t.right : t.left) *= 2;
      if (place.contact == ContactSide::both) CHECK(!solves_equations(wrong));
    }
    for (const std::string& divisor : form.nonvanishing) CHECK(divisor == "s_l - s_r");
  }
}

TEST_CASE("theorem 2: forced constants, forced logarithms, amplitude ratios") {
  const LocalForm jump = derive_local_form(symbolic_places()[3]);
  const LocalFrame& frame = jump.frame;
  CHECK(jump.kind == SingularKind::wedge_and_jump);
  CHECK(jump.exponent == local_exponent(0, 1, -1));
  CHECK(frame.field().are_equal(*jump.ratio, frame.friction(Side::left).cos / frame.friction(Side::right).cos).holds);
  for (int n = 0; n < 3; ++n) {
    const auto k = static_cast<std::size_t>(n);
    const ex d = jump.place.right.slopes[k] - jump.place.left.slopes[k];
    const LocalFormTerm& constant = term(jump, false, n, 0, true);
    for (const ex& side : {constant.left, constant.right}) CHECK(frame.field().are_equal(side, d / (s_r - s_l)).holds);
  }
  CHECK(jump.terms.size() == 6);

  const LocalForm wedge = derive_local_form(symbolic_places()[1]);
  const LocalFrame& one = wedge.frame;
  CHECK(wedge.kind == SingularKind::wedge);
  CHECK(!wedge.exponent);
  const ex d = wedge.place.right.slopes[0] - wedge.place.left.slopes[0];
  const LocalFormTerm& logarithm = term(wedge, false, 0, 1, true);
  for (const ex& side : {logarithm.left, logarithm.right}) {
    CHECK(one.field().are_equal(side, d / (one.pi() * (1 + s * s))).holds);
  }
  CHECK(term(wedge, false, 0, 0, true).left.is_zero());
  CHECK(one.field().are_equal(term(wedge, false, 0, 0, true).right, s * d / (1 + s * s)).holds);
  CHECK(wedge.terms.size() == 9);
  CHECK(derive_local_form(symbolic_places()[0]).terms.size() == 3);
}

TEST_CASE("the root of the characteristic determinant is simple: the system with a logarithm has no other solution") {
  const LocalPlace place = symbolic_places()[2];
  const LocalFrame frame(place);
  const std::vector<symbol> unknowns{symbol("b_l"), symbol("b_r"), symbol("a_l"), symbol("a_r")};
  LocalDensity density;
  for (std::size_t k = 0; k < 4; ++k) {
    density[{k % 2 == 0 ? Side::left : Side::right, true, 0, k < 2 ? 1 : 0}] = unknowns[k];
  }
  const auto system = [&](const AngleForm& lambda) {
    std::vector<FieldRow> rows;
    for (const LocalEquation& e : local_equations(place, frame.constants(lambda), density)) {
      FieldRow row;
      for (const symbol& u : unknowns) row.push_back(e.lhs.diff(u));
      rows.push_back(row);
    }
    return solve(frame.field(), unknowns.size(), rows, FieldRow(rows.size()));
  };
  const LinearSolution at_root = system(local_exponent(0, 1, -1));
  REQUIRE(at_root.kernel.size() == 1);
  CHECK(at_root.kernel[0][0].is_zero());
  CHECK(at_root.kernel[0][1].is_zero());
  CHECK(system(local_exponent(0, -1, 1)).kernel.empty());
  CHECK(system(local_exponent(1, 1, -1)).kernel.empty());
}

TEST_CASE("ends: powers and outside slopes") {
  for (const LocalPlace& place : symbolic_places()) {
    if (place.contact == ContactSide::both) continue;
    const LocalForm form = derive_local_form(place);
    const LocalFrame& frame = form.frame;
    const bool right = place.contact == ContactSide::right;
    const int free = place.beyond == Beyond::indenter ? 1 : -1;
    CAPTURE(form.derivation.title);
    CHECK(form.exponent == (right ? local_exponent(free, 0, -1) : local_exponent(free, 1, 0)));
    const ex r = frame.friction(right ? Side::right : Side::left).r;
    // On both sides, all amplitudes refer to the distance d.
    for (const LocalFormTerm& t : form.terms) CHECK(t.text.text.starts_with("-theta"));
    const int sign = (right ? 1 : -1) * free;
    CHECK(frame.field().are_equal(form.outside->coefficient, sign * form.theta * r).holds);
  }
}

TEST_CASE("the derived exponents of numbers are the model's") {
  const auto exponent_of = [](const LocalForm& form) { return *form.frame.exact(*form.exponent); };
  CHECK(rc::check([&] {
    const Rational left = random_coefficient(), right = random_coefficient();
    const LocalSide l{to_expression(left), {1, 0, 0}};
    const LocalSide r{to_expression(right), {GiNaC::numeric(uniform(-1, 1)), 0, 0}};
    for (const ContactSide contact : {ContactSide::left, ContactSide::right}) {
      const bool is_left_end = contact == ContactSide::right;
      const End end = is_left_end ? End::left : End::right;
      const Rational& inside = is_left_end ? right : left;
      for (const Beyond beyond : {Beyond::nothing, Beyond::step}) {
        RC_ASSERT(exponent_of(derive_local_form({contact, l, r, beyond})) == edge_exponent(end, inside));
      }
      const LocalForm form = derive_local_form({contact, l, r});
      RC_ASSERT(exponent_of(form) == free_exponent(end, inside));
      RC_ASSERT(solves_equations(form));
    }
    RC_PRE(left != right);
    const LocalForm form = derive_local_form({ContactSide::both, l, r});
    RC_ASSERT(exponent_of(form) == jump_exponent(left, right));
    RC_ASSERT(solves_equations(form));
  }));
}

TEST_CASE("the signs: where contact around a wedge is possible") {
  const auto wedge = [](const ex& left, const ex& right, int jump) {
    const LocalForm form = derive_local_form({ContactSide::both, {left, {0, 0, 0}}, {right, {jump, 0, 0}}});
    for (const LocalCondition& condition : form.conditions) {
      if (condition.holds == Truth::no) return false;
    }
    return true;
  };
  for (const bool increases : {true, false}) {
    const LocalForm form =
        derive_local_form({ContactSide::both, {s_l, slopes("u")}, {s_r, slopes("v")}, Beyond::indenter, increases});
    REQUIRE(form.conditions.size() == 1);
    CHECK(form.conditions[0].expression.has(form.theta) == increases);
    CHECK(form.conditions[0].holds == Truth::unknown);
    // The power is the leading term if s increases, the constant if it decreases.
    CHECK(form.terms[0].fractional == increases);
  }
  const ex a = GiNaC::numeric(1, 10), b = GiNaC::numeric(6, 10);
  CHECK(wedge(a, a, 1));
  CHECK(!wedge(a, a, -1));
  CHECK(wedge(a, b, 1));
  CHECK(wedge(a, b, -1));  // increasing friction admits a re-entrant wedge
  CHECK(wedge(b, a, 1));
  CHECK(!wedge(b, a, -1));
  const auto end = [](ContactSide contact, int jump) {
    const LocalForm form =
        derive_local_form({contact, {GiNaC::numeric(1, 3), {0, 0, 0}}, {GiNaC::numeric(1, 3), {jump, 0, 0}}});
    return form.conditions.back().holds;
  };
  for (const ContactSide contact : {ContactSide::left, ContactSide::right}) {
    CHECK(end(contact, 1) == Truth::yes);
    CHECK(end(contact, 0) == Truth::yes);
    CHECK(end(contact, -1) == Truth::no);
  }
}

TEST_CASE("what leaves the question open is refused") {
  CHECK_THROWS_AS(derive_local_form({ContactSide::both, {s_l}, {s_r}}), std::domain_error);
  CHECK_THROWS_AS(derive_local_form({ContactSide::both, {s, {0}}, {s, {0}}}), std::domain_error);
  CHECK_THROWS_AS(derive_local_form({ContactSide::both, {GiNaC::numeric(0.5)}, {s}}), std::domain_error);
  CHECK_NOTHROW(derive_local_form({ContactSide::right, {s_l}, {s_r}}));
}

TEST_CASE("one derivation for each place of a problem, the same text every time") {
  const Indenter indenter(-2, {{0, Polynomial({0, -1})}, {1, Polynomial({0, 1, 1, 1})}, {2, Polynomial({5, 1})}});
  const ContactProblem problem(Elasticity(Solid(0.3_r, 1)), FrictionProfile({0.2_r, 0.6_r}, {0.5_r}), indenter, 1);
  const std::vector<Derivation> all = local_derivations(problem);
  const std::vector<SingularPoint> points = possible_singular_points(problem);
  REQUIRE(all.size() == points.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string text = to_text(all[k]);
    CAPTURE(text);
    CHECK(holds(all[k].title, points[k].x ? "x = " + to_string(*points[k].x) : "anywhere"));
    if (points[k].exponent) CHECK(holds(text, to_string(*points[k].exponent)));
    CHECK(text == to_text(local_derivations(problem)[k]));
  }
  CHECK(all[2].title == "Local form of `t`: wedge, `x = 0`");
  // psi_bar' jumps by 2/c, c = 2(1 - nu^2): 100/91; s = 2/7 f = 2/35.
  CHECK(holds(to_text(all[2]), "[psi_bar'] = 100/91 >= 0"));
  // The slope on the right is 1 + 2x + 3x^2: 3 * 50/91 / (1 + s^2) at x^2.
  CHECK(holds(to_text(all[2]), "26250*x^2*log|x|/pi/15977"));
}
