// The slope of the surface beyond the ends of the contact of solved problems, against the traction within.

#include "numeric/cauchy/traction_density.hpp"
#include "proofs_checks/instruments/solutions/near.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::RiemannHilbertForm;

struct Solvable {
  ContactProblem problem;
  std::vector<numeric::ContactInterval> zones;
};

/// Two flanks that meet at 1/8, where the friction jumps.
Solvable flanks(const Rational& rear, const Rational& front, const Polynomial& left, const Polynomial& right,
                const Rational& load, const numeric::ContactInterval& zone) {
  const Rational c(1, 8);
  return {ContactProblem(Elasticity(Solid(Rational(-1, 2), 1)), FrictionProfile({rear, front}, {c}),
                         Indenter(-4, {{c, left - Polynomial({left(c)})}, {4, right - Polynomial({right(c)})}}), load),
          {zone}};
}

std::vector<Solvable> problems(const Context& context) {
  std::vector<Solvable> all{
      flanks(1, Rational(1, 4), Polynomial(), Polynomial({0, 0, 1}), 30, {-2.0625, 0.5, true, false})};
  if (context.quick) return all;
  all.push_back(flanks(Rational(1, 3), 2, Polynomial({0, Rational(-1, 10)}), Polynomial({0, Rational(1, 10)}), 60,
                       {-2.0625, 1.9375, true, true}));
  all.push_back(flanks(2, 0, Polynomial({0, -1, 1}), Polynomial({0, 1, 2}), 5, {-0.7, 0.6, false, false}));
  return all;
}

/// u'/c - psi'/c = coefficient (-t/d^p) d^p beyond an end, -t/d^p continued across it.
template <class R>
struct EndSaid {
  R coefficient;
  R power;
  bool free;
};
template <class R>
struct EndsSaid {
  EndSaid<R> ends[2];
};
using EndsFormula = Formula<EndsSaid, Solvable>;

EndsFormula ends_formula() {
  return EndsFormula::from([]<Real R>(const Solvable& c) {
    EndsSaid<R> said;
    const bool edges[2] = {c.zones.front().left_at_edge, c.zones.back().right_at_edge};
    for (const int i : {0, 1}) {
      const bool free = !edges[i];
      const Rational s = c.problem.coupled_friction(i == 0 ? 0 : c.problem.friction().values().size() - 1);
      const Exponent angle = i == 0 ? -Exponent::angle(s) : Exponent::angle(s);
      const R root = 1 / numeric::cos_pi_alpha<R>(s);
      said.ends[i] = {(i == 0) == free ? root : R(-root), numeric::to_real<R>((free ? half : -half) + angle), free};
    }
    return said;
  });
}

/// One end of the contact with what is near it.
template <class R>
struct Neighbourhood {
  const RiemannHilbertForm<R>& form;
  Side side;
  EndSaid<R> end;
  std::size_t segment;  ///< of the contact, next to the end

  numeric::SurfacePoint<R> at(const R& distance, bool inside) const {
    const auto& set = form.set();
    const bool leftwards = (side == Side::left) != inside;
    const R x = set.x(side == Side::left ? segment : segment + 1) + (leftwards ? R(-distance) : distance);
    const auto k = static_cast<std::ptrdiff_t>(segment) + (inside ? 0 : side == Side::left ? -1 : 1);
    const bool in_support = k >= 0 && k < static_cast<std::ptrdiff_t>(set.segments());
    const R rest = in_support ? R(set.length(static_cast<std::size_t>(k)) - distance) : numeric::infinity<R>();
    return {k, leftwards ? numeric::Node<R>{x, rest, distance} : numeric::Node<R>{x, distance, rest}};
  }
  /// theta(x) within, 1, 2, ... steps from the end.
  std::vector<R> theta() const {
    std::vector<R> values;
    for (int i = 1; i <= extrapolation_values<R>; ++i) {
      const R d = i * extrapolation_step<R>();
      using std::pow;
      values.push_back(R(-form.traction(at(d, true)).value / pow(d, end.power)));
    }
    return values;
  }
  /// (u' - psi')/(coefficient d^power), beyond.
  R theta_from(const R& slope, const R& distance) const {
    using std::pow;
    const R profile = form.problem().slope(form.slope_at(segment), at(distance, false).node.x) + form.tilt();
    return (slope - profile) / (end.coefficient * pow(distance, end.power));
  }
};

/// A solved problem and u'/c by quadrature one step beyond its outer ends.
template <class R>
struct SolvedEnds {
  std::string name;
  std::shared_ptr<const numeric::RiemannHilbertSolution<R>> solution;
  R slope[2];
};
template <class R>
using SolvedEndsList = std::vector<SolvedEnds<R>>;

template <Real R>
SolvedEndsList<R> measure(const std::vector<Solvable>& all) {
  SolvedEndsList<R> list;
  for (const Solvable& c : all) {
    SolvedEnds<R> found{text_of(c.problem), solved<R>(c.problem, c.zones), {}};
    const numeric::trapezoidal::Grid<R> grid(numeric::traction_density(found.solution->form()));
    const R d = extrapolation_step<R>();
    found.slope[0] = grid.cauchy(Side::left, d);
    found.slope[1] = grid.cauchy(Side::right, d);
    list.push_back(std::move(found));
  }
  return list;
}

template <Real R>
void check_ends(Findings& findings, const SolvedEnds<R>& found, const EndsSaid<R>& said) {
  const Quantity by_rule{
      "u' - psi' beyond an end, by quadrature",
      {"(1/pi) int t(x')/(x'-x) dx', trapezoidal rule", "t/d^p continued from inside of the contact"},
      tolerance<R>()};
  const RiemannHilbertForm<R>& form = found.solution->form();
  const auto segments = segments_of(form);
  const auto components = found.solution->contact();
  const Neighbourhood<R> ends[2] = {{form, Side::left, said.ends[0], segments.front()},
                                    {form, Side::right, said.ends[1], segments.back()}};
  for (const int i : {0, 1}) {
    findings.compare(by_rule, relative_difference<R>(ends[i].theta_from(found.slope[i], extrapolation_step<R>()),
                                                     extrapolated(ends[i].theta(), 1)));
  }
  findings.require(components.front().left.intensity.value >= 0 && components.back().right.intensity.value >= 0,
                   "theta < 0 where t <= 0 forbids it");
}

std::vector<Evidence> check(const Context& context, Once<SolvedEndsList>& once, const EndsFormula& formula) {
  return gather_at_fifty(context, [&]<Real R>() {
    const std::vector<Solvable> all = problems(context);
    const SolvedEndsList<R>& solved_ends = once.at<R>(context.quick, [&] { return measure<R>(all); });
    Findings findings;
    for (std::size_t k = 0; k < all.size(); ++k) {
      findings.begin_case(solved_ends[k].name);
      check_ends(findings, solved_ends[k], formula.at<R>(all[k]));
    }
    return findings.evidence(std::to_string(all.size()) + " solved problems");
  });
}

}  // namespace

// In its plain form: what is measured, t/d^p continued from inside of the contact, depends on the power that is said.
Claim thm_03_solved_ends() {
  const EndsFormula right = ends_formula();
  return make_claim(
      claim_text("thm-03-solved-ends"),
      [once = std::make_shared<Once<SolvedEndsList>>()](const Context& context, const EndsFormula& formula) {
        return check(context, *once, formula);
      },
      right,
      std::vector<Wrong<EndsFormula>>{
          {"the other sign of u' - psi' behind the rear end",
           right.changed([](auto& said, const Solvable&) { said.ends[0].coefficient = -said.ends[0].coefficient; })},
          {"the other sign of u' - psi' beyond a free end", right.changed([](auto& said, const Solvable&) {
             for (auto& end : said.ends) end.coefficient *= end.free ? -1 : 1;
           })},
          {"sqrt(1+s^2) missing", right.changed([](auto& said, const Solvable&) {
             for (auto& end : said.ends) end.coefficient = end.coefficient > 0 ? 1 : -1;
           })},
          {"the powers of both ends exchanged",
           right.changed([](auto& said, const Solvable&) { std::swap(said.ends[0].power, said.ends[1].power); })},
          {"near miss: the power at the front moved by ten times the tolerance",
           right.changed([]<class R>(EndsSaid<R>& said, const Solvable&) { said.ends[1].power += near_miss<R>(); })},
          {"near miss: u' in front moved by ten times the tolerance",
           right.changed(
               []<class R>(EndsSaid<R>& said, const Solvable&) { said.ends[1].coefficient *= 1 + near_miss<R>(); })}});
}

}  // namespace steadyslide::proofs_checks
