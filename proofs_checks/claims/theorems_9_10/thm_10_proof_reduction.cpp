// Checks how an inner contact end becomes the left edge of ]c, 1[ in the proof of theorem 10. [Bal16, theorem 10]

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_10_proof_reduction {
namespace {

/// The equation H t + s t = psi_bar' + slope u~' on the second component alone, under the load P + load int t~.
struct Reduction {
  Number slope = -1;
  bool printed = false;  ///< use the derivative of the printed u~ for u~'
  int load = 1;
};

template <class R>
struct ReductionPoint {
  numeric::SlidingTerms<R> zone;  ///< A t of the second component alone
  R profile;
  R slope;    ///< u~'
  R printed;  ///< (d/dx) of the printed u~, as if this were u~ itself
};
template <class R>
struct ReductionFacts {
  std::vector<ReductionPoint<R>> points;
  R load;
  R first_zone;   ///< int t~
  R second_zone;  ///< integral over the second component
  /// The difference between u~' on the left of c and its extrapolation from values on the right.
  R smooth;
};

template <Real R>
ReductionFacts<R> measure(const ContactProblem& problem) {
  using std::abs;
  const auto solution = solve<R>(problem);
  const auto& form = solution->form();
  auto zones = numeric::traction_density(form);
  if (zones.size() != 2) throw Refutation{{"two bumps", "not two contact zones"}};
  const R between = zones[1].gap;
  zones[1].gap = 0;
  const trapezoidal::Grid<R> first({zones[0]});
  const trapezoidal::Grid<R> second({zones[1]});
  const std::size_t segment = segments_of(form).back();
  const numeric::SlidingOperator<R> A(second, {friction_of(form).back()});
  ReductionFacts<R> facts{{}, form.problem().load(), first.integral(), second.integral(), 0};
  for (const int percent : {10, 50, 95}) {
    const auto at = second.midpoint_near(0, R(percent) / 100);
    const R distance = between + at.node.from_left;
    auto squared = zones[0];
    squared.smooth = [smooth = squared.smooth, distance](const Node<R>& node) {
      const R d = distance + node.from_right;
      return R(smooth(node) / (d * d));
    };
    facts.points.push_back({A.at(at), form.problem().slope(form.slope_at(segment), at.node.x),
                            first.cauchy(Side::right, distance),
                            R(trapezoidal::Grid<R>({squared}).integral() / numeric::pi<R>())});
  }
  std::vector<R> values;
  const R h = extrapolation_step<R>();
  for (int i = 1; i <= extrapolation_values<R>; ++i) values.push_back(first.cauchy(Side::right, R(between + i * h)));
  facts.smooth = abs(R(extrapolated(values, 1) - first.cauchy(Side::right, R(between - h))));
  return facts;
}

template <Real R>
void check(Findings& findings, const Reduction& said, const ReductionFacts<R>& facts) {
  using std::abs, std::max;
  for (const ReductionPoint<R>& point : facts.points) {
    const R expected = point.profile + R(said.slope) * (said.printed ? point.printed : point.slope);
    findings.compare("equation", point.zone.sum().value, expected,
                     max({R(abs(point.zone.hilbert.value)), R(abs(point.zone.friction)), R(abs(point.profile)),
                          R(abs(point.slope))}));
  }
  findings.compare("load", R(-facts.second_zone), R(facts.load + said.load * facts.first_zone));
  findings.compare("smooth", static_cast<double>(facts.smooth));
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, Reduction>("thm-10-proof-reduction")
      .cases(fixed_cases<ContactProblem>({cell_case("two-zones")}, 1, "a solved problem with two contact zones"))
      .precision(Precision::quick_in_double)
      .checked([kept = std::make_shared<KeptForCases>()]<Real R>(Findings& findings, const Reduction& said,
                                                                 const ContactProblem& c) {
        check(findings, said, kept->at(c, [&] { return measure<R>(c); }));
      })
      .wrong("the printed u~ where its derivative must stand", &Reduction::printed, true)
      .wrong("psi_bar + u~", &Reduction::slope, 1)
      .wrong("`psi_bar` unchanged", &Reduction::slope, 0)
      .wrong("`P` unchanged", &Reduction::load, 0)
      .wrong("P - int t~", &Reduction::load, -1)
      .near_miss("u~'", &Reduction::slope);
}

}  // namespace steadyslide::proofs_checks::thm_10_proof_reduction
