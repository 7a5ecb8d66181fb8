#include <variant>

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/operators/contact_forces.hpp"
#include "proofs_checks/instruments/operators/gap_functional.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::prop_05_equivalence {
namespace {

using Function = PiecewiseFunction;

/// Forces and gaps on nodes that satisfy (11) or violate it by construction.
struct Pair {
  ContactForces forces;
  std::optional<bool> is_solution;  ///< if absent, not known
};

/// A function v = u_n - psi with both signs, and the traction t_n = -weight t_0 with the given load.
struct Steps {
  Rational s;
  Rational load;
  Function v;
  Polynomial weight;
};

struct Case {
  std::string name;
  std::variant<Pair, Steps> data;
};

CaseList<Case> cases(const Context& context) {
  CaseList<Case> list{{}, "random polygons and friction of both signs, seed " + std::to_string(context.seed)};
  Random of_steps(context.seed, "prop-05-equivalence, steps");
  for (int k = 0; k < (context.quick ? 1 : 6); ++k) {
    const Rational s = of_steps.between(Rational(1, 10), 2) * (k % 2 == 0 ? 1 : -1);
    const Rational load = of_steps.between(Rational(1, 5), 4);
    const std::vector<Rational> points = random_points(of_steps);
    Function v = random_polygon(of_steps, points);
    for (Polynomial& piece : v.pieces) piece = piece + Polynomial({0, k % 2 == 0 ? 2 : -2});
    list.cases.push_back({"s = " + to_string(s), Steps{s, load, v, Polynomial({2, of_steps.between(-1, 1)})}});
  }
  // The violation may be arbitrarily small, because everything here is exact.
  const double smallest = numeric::at_precision(context.digits, []<Real R>() { return tolerance<R>(); });
  const std::vector<Rational> steps{1, Rational(1, 1000), Rational(smallest)};
  Random random(context.seed, "prop-05-equivalence");
  for (std::size_t k = 0; k < (context.quick ? 36 : 600); ++k) {
    ContactForces forces = random_forces(random, k, steps[k / 6 % steps.size()]);
    const std::string name = "pair " + std::to_string(k) + " on " + std::to_string(forces.size()) + " nodes";
    list.cases.push_back({name, Pair{std::move(forces), k % 6 == 5 ? std::nullopt : std::optional(k % 6 == 0)}});
  }
  return list;
}

/// The proposition, and two signs in its proof.
struct Equivalence {
  Conditions conditions;
  int test_function = -1;  ///< sign of (1/meas S) int P t_0
  int constant = 1;        ///< sign of C in (14)
};

void check_equivalence(Findings& findings, const Conditions& conditions, const Pair& pair) {
  const ContactForces& c = pair.forces;
  const bool truth = holds_11(c, conditions);
  findings.decide("(11) where it was built to hold, and not elsewhere",
                  !pair.is_solution || truth == *pair.is_solution);
  findings.decide("(11) <=> (i) by the corners of `K_0'`", truth == holds_i_by_corners(c, conditions));
  findings.decide("(11) <=> (i) by exchanges of force", truth == holds_i_by_exchanges(c));
  findings.decide("(11) <=> (ii) by the proof's test functions", truth == holds_ii_by_test_functions(c, conditions));
  findings.decide("(11) <=> (ii) by directions", truth == holds_ii_by_subsets(c, conditions));
}

/// The positive part of v, and the indicator of the set S with v > 0. The panels are divided at the zeros.
struct PositivePart {
  Function values;
  Function set;
  Function complement;
  Rational measure;
};

PositivePart positive_part(const Function& polygon) {
  PositivePart result;
  std::vector<Rational> points{-1};
  const auto close = [&](const Rational& at, const Polynomial& piece) {
    const bool positive = piece((points.back() + at) / 2) > 0;
    if (positive) result.measure += at - points.back();
    points.push_back(at);
    result.values.pieces.push_back(positive ? piece : Polynomial());
    result.set.pieces.push_back(Polynomial::constant(positive ? 1 : 0));
    result.complement.pieces.push_back(Polynomial::constant(positive ? 0 : 1));
  };
  for (std::size_t k = 0; k < polygon.pieces.size(); ++k) {
    const Polynomial& piece = polygon.pieces[k];
    const Rational left = piece(polygon.points[k]);
    const Rational right = piece(polygon.points[k + 1]);
    if (left * right < 0) close(-piece.coefficient(0) / piece.coefficient(1), piece);
    close(polygon.points[k + 1], piece);
  }
  for (Function* f : {&result.values, &result.set, &result.complement}) f->points = points;
  return result;
}

/// Returns the integral of a function that is linear on each piece.
Rational integral(const Function& f) {
  Rational sum = 0;
  for (std::size_t k = 0; k < f.pieces.size(); ++k) {
    const Rational length = f.points[k + 1] - f.points[k];
    sum += length * f.pieces[k]((f.points[k] + f.points[k + 1]) / 2);
  }
  return sum;
}

/// Checks the steps of (i) => (11): the constant C, and the traction t_hat that shows that S has measure zero.
template <Real R>
void check_steps(Findings& findings, const Equivalence& said, const Steps& steps) {
  using std::abs;
  const auto paired_with = [&](const Function& f) { return pairing<R>(steps.s, f); };
  const R p = to_real<R>(steps.load);
  const Function weight{{-1, 1}, {steps.weight}};
  Function product = steps.v;
  for (Polynomial& piece : product.pieces) piece = piece * steps.weight;
  // The integral of t_n comes from the moments, its load from quadrature.
  const R scale = -p / pairing_by_moments<R>(steps.s, steps.weight);
  const R paired = scale * paired_with(product);
  const R c = said.constant * paired / p;
  findings.compare("constant", static_cast<double>(abs(paired + c * scale * paired_with(weight)) / p));

  const PositivePart part = positive_part(steps.v);
  const R outside = p * paired_with(part.complement);
  const R rest = p - p * paired_with(part.set);
  const R level = said.test_function * rest / to_real<R>(part.measure);
  findings.compare("mean", static_cast<double>(abs(outside + level * to_real<R>(integral(part.set))) / p));
  findings.require(part.measure > 0, "u_n - psi + C is nowhere positive");
  findings.require(level < 0, "the test traction is not in K_0'");
  // <t_hat - P t_0, v> = int_S (level - P t_0) v
  const R contradiction = level * to_real<R>(integral(part.values)) - p * paired_with(part.values);
  findings.require(contradiction < 0, "(15) is not contradicted");
}

}  // namespace

Claim claim() {
  const auto conditions = [](auto member, auto value) {
    return [=](Equivalence& said) { said.conditions.*member = value; };
  };
  using C = Conditions;
  return formula_claim<Case, Equivalence>("prop-05-equivalence")
      .cases(cases)
      .checked([]<Real R>(Findings& findings, const Equivalence& said, const Case& c) {
        if (const auto* steps = std::get_if<Steps>(&c.data)) {
          check_steps<R>(findings, said, *steps);
        } else {
          check_equivalence(findings, said.conditions, std::get<Pair>(c.data));
        }
      })
      .wrong("the printed test function without the minus sign", &Equivalence::test_function, 1)
      .wrong("`-C` instead of `C` in (14)", &Equivalence::constant, -1)
      .wrong("(11) without the product", conditions(&C::complementary, false))
      .wrong("(11) without `t_n <= 0`", conditions(&C::compressive, false))
      .wrong("(i) with <= 0", conditions(&C::first, -1))
      .wrong("(i) for all `t_hat` of zero mean", conditions(&C::over_all, true))
      .wrong("(ii) without `phi`", conditions(&C::functional, 0))
      .wrong("(ii) with `-phi`", conditions(&C::functional, -1))
      .near_miss("a gap that counts as contact", [](Equivalence& said, const Number& step) {
        said.conditions.contact_within = Rational(static_cast<double>(step));
      });
}

}  // namespace steadyslide::proofs_checks::prop_05_equivalence
