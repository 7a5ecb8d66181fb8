// The contact conditions and two inequalities that say the same. [Bal16, (11), (14), (15) and proposition 5]

#include <cmath>
#include <memory>
#include <tuple>

#include "proofs_checks/claims/section_3/functional_parts.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/contact_forces.hpp"
#include "proofs_checks/instruments/gap_functional.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Real;
using Function = PiecewiseFunction;
using Pairings = std::tuple<UnitPairing<double>, UnitPairing<numeric::Real50>, UnitPairing<numeric::Real100>>;

struct EquivalenceSaid {
  ConditionsSaid conditions;
  int near_contact = 0;    ///< in (11), in tolerances
  int test_function = -1;  ///< the sign of (1/meas S) int P t_0
  int constant = 1;        ///< the sign of C
};

void check_equivalence(Findings& findings, const Context& context, const EquivalenceSaid& said, double tolerance) {
  ConditionsSaid conditions = said.conditions;
  const Rational unit = parse_rational("1e" + std::to_string(std::lround(std::log10(tolerance))));
  conditions.contact_within = said.near_contact * unit;
  // What is wrong may be as small as one likes: everything here is exact.
  const std::vector<Rational> steps{1, Rational(1, 1000), unit};
  Random random(context.seed, "prop-05-equivalence");
  for (std::size_t k = 0; k < (context.quick ? 36 : 600); ++k) {
    const ContactForces c = random_forces(random, k, steps[k / 6 % steps.size()]);
    findings.begin_case("pair " + std::to_string(k) + " on " + std::to_string(c.size()) + " nodes");
    const bool truth = holds_11(c, conditions);
    findings.decide("(11) where it was built to hold, and not elsewhere", truth == (k % 6 == 0) || k % 6 == 5);
    findings.decide("(11) <=> (i) by the corners of K_0'", truth == holds_i_by_corners(c, conditions));
    findings.decide("(11) <=> (i) by exchanges of force", truth == holds_i_by_exchanges(c));
    findings.decide("(11) <=> (ii) by the proof's test functions", truth == holds_ii_by_test_functions(c, conditions));
    findings.decide("(11) <=> (ii) by directions", truth == holds_ii_by_subsets(c, conditions));
  }
}

/// v where it is positive, 0 elsewhere, and the indicator of that set S: the panels are cut at the zeros.
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

Rational integral(const Function& f) {
  Rational sum = 0;
  for (std::size_t k = 0; k < f.pieces.size(); ++k) {
    const Rational length = f.points[k + 1] - f.points[k];
    // Linear.
    sum += length * f.pieces[k]((f.points[k] + f.points[k + 1]) / 2);
  }
  return sum;
}

/// The steps of (i) => (11): the constant C, and the traction t_hat that shows that S has no measure.
template <Real R>
void check_steps(Findings& findings, const Context& context, const EquivalenceSaid& said, UnitPairing<R>& pairing) {
  using std::abs;
  const Quantity constant{"<t_n, u_n - psi + C> with the C of (14)", {"Gauss-Jacobi", "0"}, tolerance<R>()};
  const Quantity mean{
      "mean of the test traction", {"int over the complement, and 1 less that over S", "0"}, tolerance<R>()};
  Random random(context.seed, "prop-05-equivalence, steps");
  for (int k = 0; k < (context.quick ? 1 : 6); ++k) {
    const Rational s = random.between(Rational(1, 10), 2) * (k % 2 == 0 ? 1 : -1);
    const Rational load = random.between(Rational(1, 5), 4);
    const R p = numeric::to_real<R>(load);
    const std::vector<Rational> points = random_points(random);
    // v = u_n - psi with both signs, and t_n = -density t_0 of the load P.
    const Function v = Function::combined(1, random_polygon(random, points), 2, [&] {
      Function tilt = Function::constant(0, points);
      for (Polynomial& piece : tilt.pieces) piece = Polynomial({0, k % 2 == 0 ? 1 : -1});
      return tilt;
    }());
    const Function weight{{-1, 1}, {Polynomial({2, random.between(-1, 1)})}};
    Function product = v;
    for (Polynomial& piece : product.pieces) piece = piece * weight.pieces[0];
    findings.begin_case("s = " + to_string(s));
    // t_n by its integral from the moments, its load by quadrature.
    const R scale = -p / pairing_by_moments<R>(s, weight.pieces[0]);
    const R paired = scale * pairing(s, product);
    const R c = said.constant * paired / p;
    findings.compare(constant, static_cast<double>(R(abs(paired + c * scale * pairing(s, weight)) / p)));

    const PositivePart part = positive_part(v);
    const R outside = p * pairing(s, part.complement);
    const R rest = p - p * pairing(s, part.set);
    const R level = said.test_function * rest / numeric::to_real<R>(part.measure);
    findings.compare(mean, static_cast<double>(R(abs(outside + level * numeric::to_real<R>(integral(part.set))) / p)));
    findings.require(part.measure > 0, "u_n - psi + C is nowhere positive");
    findings.require(level < 0, "the test traction is not in K_0'");
    // <t_hat - P t_0, v> = int_S (level - P t_0) v
    const R contradiction = level * numeric::to_real<R>(integral(part.values)) - p * pairing(s, part.values);
    findings.require(contradiction < 0, "(15) is not contradicted");
  }
}

}  // namespace

Claim contact_conditions_claim() {
  using S = EquivalenceSaid;
  const auto check = [pairings = std::make_shared<Pairings>()](const Context& context, const S& said) {
    const auto walk = [&]<Real R>() {
      Findings findings;
      check_steps<R>(findings, context, said, std::get<UnitPairing<R>>(*pairings));
      check_equivalence(findings, context, said, tolerance<R>());
      return findings.evidence("random polygons and friction of both signs, seed " + std::to_string(context.seed));
    };
    return gather([&] { return numeric::at_precision(context.digits, walk); });
  };
  const auto in_conditions = [](auto change) { return changed<S>([&](S& said) { change(said.conditions); }); };
  using C = ConditionsSaid;
  return make_claim(
      claim_text("prop-05-equivalence"), check, S(),
      std::vector<Wrong<S>>{
          {"the printed test function without the minus sign", changed<S>([](S& said) { said.test_function = 1; })},
          {"-C instead of C in (14)", changed<S>([](S& said) { said.constant = -1; })},
          {"(11) without the product", in_conditions([](C& said) { said.complementary = false; })},
          {"(11) without t_n <= 0", in_conditions([](C& said) { said.compressive = false; })},
          {"(i) with <= 0", in_conditions([](C& said) { said.first = -1; })},
          {"(i) for all t_hat of zero mean", in_conditions([](C& said) { said.over_all = true; })},
          {"(ii) without phi", in_conditions([](C& said) { said.functional = 0; })},
          {"(ii) with -phi", in_conditions([](C& said) { said.functional = -1; })},
          {"near miss: a gap of ten times the tolerance counts as contact",
           changed<S>([](S& said) { said.near_contact = 10; })}});
}

}  // namespace steadyslide::proofs_checks
