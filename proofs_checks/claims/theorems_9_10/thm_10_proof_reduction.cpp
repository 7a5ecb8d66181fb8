// How an inner end of the contact becomes the left edge of ]c, 1[ in the proof of theorem 10. [Bal16, theorem 10]

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/cauchy/traction_density.hpp"
#include "proofs_checks/instruments/solutions/near.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

template <class R>
struct ReductionPoint {
  numeric::SlidingTerms<R> zone;  ///< A t of the second zone alone
  R profile;
  R slope;    ///< u~'
  R printed;  ///< (d/dx) of the printed u~, taken for u~ itself
};
template <class R>
struct ReductionFacts {
  std::vector<ReductionPoint<R>> points;
  R load;
  R first_zone;   ///< int t~
  R second_zone;  ///< int of the rest
  R smooth;       ///< u~' on the left of c, less what its values on the right extrapolate to
};

template <Real R>
ReductionFacts<R> measure_reduction() {
  using std::abs;
  const auto solution = solve<R>(cell_case("two-zones"));
  const auto& form = solution->form();
  auto zones = numeric::traction_density(form);
  if (zones.size() != 2) throw Refutation{{"two bumps", "not two contact zones"}};
  const R between = zones[1].gap;
  zones[1].gap = 0;
  const numeric::trapezoidal::Grid<R> first({zones[0]});
  const numeric::trapezoidal::Grid<R> second({zones[1]});
  const std::size_t segment = segments_of(form).back();
  const numeric::SlidingOperator<R> A(second, {friction_of(form).back()});
  ReductionFacts<R> facts{{}, form.problem().load(), first.integral(), second.integral(), 0};
  for (const int percent : {10, 50, 95}) {
    const auto at = second.midpoint_near(0, R(percent) / 100);
    const R distance = between + at.node.from_left;
    auto squared = zones[0];
    squared.smooth = [smooth = squared.smooth, distance](const numeric::Node<R>& node) {
      const R d = distance + node.from_right;
      return R(smooth(node) / (d * d));
    };
    facts.points.push_back({A.at(at), form.problem().slope(form.slope_at(segment), at.node.x),
                            first.cauchy(Side::right, distance),
                            R(numeric::trapezoidal::Grid<R>({squared}).integral() / numeric::pi<R>())});
  }
  std::vector<R> values;
  const R h = extrapolation_step<R>();
  for (int i = 1; i <= extrapolation_values<R>; ++i) values.push_back(first.cauchy(Side::right, R(between + i * h)));
  facts.smooth = abs(R(extrapolated(values, 1) - first.cauchy(Side::right, R(between - h))));
  return facts;
}

struct ReductionSaid {
  int sign = -1;  ///< of u~' in the new profile's slope
  bool printed = false;
  int load_sign = 1;  ///< of int t~ in the new load
  int miss = 0;
};

std::vector<Evidence> check_reduction(const Context& context, Once<ReductionFacts>& once, const ReductionSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    using std::abs, std::max;
    const Quantity equation{
        "equation of the second zone alone", {"H t + s t, trapezoidal rule", "psi_bar' - u~'"}, tolerance<R>()};
    const Quantity load{"load of the second zone", {"trapezoidal rule", "P + int t~"}, tolerance<R>()};
    const Quantity smooth{"u~' continued across c", {"from c+h, ..., to c-h", "at c-h"}, tolerance<R>()};
    const ReductionFacts<R>& facts = once.at<R>(context.quick, [] { return measure_reduction<R>(); });
    Findings findings;
    findings.begin_case("two bumps, s = 3/10");
    for (const ReductionPoint<R>& point : facts.points) {
      const R slope = (said.printed ? point.printed : point.slope) * (1 + said.miss * R(tolerance<R>()));
      const R size = max(
          {R(abs(point.zone.hilbert.value)), R(abs(point.zone.friction)), R(abs(point.profile)), R(abs(point.slope))});
      const R rest = point.zone.sum().value - (point.profile + said.sign * slope);
      findings.compare(equation, static_cast<double>(R(abs(rest) / size)));
    }
    findings.compare(load,
                     relative_difference<R>(R(-facts.second_zone), R(facts.load + said.load_sign * facts.first_zone)));
    findings.compare(smooth, static_cast<double>(facts.smooth));
    return findings.evidence("a solved problem with two contact zones");
  });
}

}  // namespace

// In its plain form: both sides of the equation are measured, on one solution.
Claim thm_10_proof_reduction() {
  using Said = ReductionSaid;
  return make_claim(
      claim_text("thm-10-proof-reduction"),
      [once = std::make_shared<Once<ReductionFacts>>()](const Context& context, const Said& said) {
        return check_reduction(context, *once, said);
      },
      Said{},
      std::vector<Wrong<Said>>{
          {"the printed u~ where its derivative must stand", changed<Said>([](Said& said) { said.printed = true; })},
          {"psi_bar + u~", changed<Said>([](Said& said) { said.sign = 1; })},
          {"psi_bar unchanged", changed<Said>([](Said& said) { said.sign = 0; })},
          {"P unchanged", changed<Said>([](Said& said) { said.load_sign = 0; })},
          {"P - int t~", changed<Said>([](Said& said) { said.load_sign = -1; })},
          {"near miss: u~' moved by ten times the tolerance", changed<Said>([](Said& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
