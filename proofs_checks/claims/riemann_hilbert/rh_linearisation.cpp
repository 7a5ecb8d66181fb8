// What Newton's method for the contact's ends takes for the derivative of a solution, against differences.

#include <array>

#include "numeric/number/polynomial.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::ContactSet;
using numeric::RiemannHilbertForm;
using numeric::SurfacePoint;

/// d(u'/c)/de = Y (pole/(x - e) + sum_k polynomial_k x^k), q and the tilt fixed; in the contact dt = -eps cos(pi alpha)
/// |Y| (...). d(u'/c)/dtilt = 1 - Y tilt_polynomial.
template <class R>
struct Neighbour {
  std::size_t end;
  R pole;
  std::vector<R> polynomial;
};
template <class R>
struct Derivatives {
  std::shared_ptr<const TrialForm<R>> trial;
  std::vector<Neighbour<R>> neighbours;
  R tilt_factor = 1;
};
using LinearFormula = Formula<Derivatives, Trial>;

LinearFormula linear_formula() {
  return LinearFormula::from([]<Real R>(const Trial& trial) {
    Derivatives<R> derivatives{std::make_shared<const TrialForm<R>>(trial), {}};
    const RiemannHilbertForm<R>& form = derivatives.trial->form();
    for (const std::size_t j : form.set().movable()) {
      const R& p = form.fundamental_solution().powers()[j].value;
      const R& e = form.set().x(j);
      const bool begins = form.set().in_contact(j);
      Neighbour<R> neighbour{j, R(p * form.regular_factor_at(j, begins ? Side::right : Side::left).value), {}};
      // [q/(z - e)]_poly: coefficient i is q_{i+1} + q_{i+2} e + ...
      for (std::size_t i = 0; i + 1 < form.q().size(); ++i) {
        R sum = 0;
        for (std::size_t l = form.q().size(); l-- > i + 1;) sum = sum * e + form.q()[l];
        neighbour.polynomial.push_back(R(-p / numeric::pi<R>() * sum));
      }
      derivatives.neighbours.push_back(std::move(neighbour));
    }
    return derivatives;
  });
}

/// In the middle of every segment, and beyond both ends of the support.
template <Real R>
std::vector<SurfacePoint<R>> places(const ContactSet<R>& set) {
  const R d = R(1) / 3;
  std::vector<SurfacePoint<R>> result;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    const R half = set.length(k) / 2;
    result.push_back({static_cast<std::ptrdiff_t>(k), {R(set.x(k) + half), half, half}});
  }
  const auto last = static_cast<std::ptrdiff_t>(set.segments());
  result.push_back({-1, {R(set.x(0) - d), numeric::infinity<R>(), d}});
  result.push_back({last, {R(set.x(set.segments()) + d), d, numeric::infinity<R>()}});
  return result;
}

/// t in the contact, u'/c off it.
template <Real R>
R value(const RiemannHilbertForm<R>& form, const SurfacePoint<R>& at) {
  const bool inside = at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(form.set().segments()) &&
                      form.set().in_contact(static_cast<std::size_t>(at.segment));
  return inside ? form.traction(at).value : form.surface_slope(at).value;
}

/// What Y (...) is for u' is -eps cos(pi alpha) |Y| (...) for t.
template <Real R>
R factor(const RiemannHilbertForm<R>& form, const SurfacePoint<R>& at) {
  const R y = form.sign(at.segment) * form.modulus(at);
  const bool inside = at.segment >= 0 && at.segment < static_cast<std::ptrdiff_t>(form.set().segments()) &&
                      form.set().in_contact(static_cast<std::size_t>(at.segment));
  return inside ? R(-y * form.problem().cos_alpha(form.friction_at(static_cast<std::size_t>(at.segment)))) : y;
}

/// Central differences of order ten: their error and rounding, eps/h, stay far below the tolerance.
template <Real R>
std::vector<R> differences(const TrialForm<R>& trial, std::size_t f, const std::vector<SurfacePoint<R>>& at) {
  const ContactSet<R>& set = trial.form().set();
  const std::size_t end = set.movable()[f];
  const R h = std::same_as<R, numeric::Real50> ? R(1e-7) : R(1e-12);
  constexpr std::array<std::array<int, 2>, 5> weights{{{5, 6}, {-5, 21}, {5, 84}, {-5, 504}, {1, 1260}}};
  std::vector<R> result(at.size(), R(0));
  for (int k = 1; k <= 5; ++k) {
    for (const int sign : {1, -1}) {
      const R step = sign * k * h;
      std::vector<R> steps(set.movable().size(), R(0));
      steps[f] = step;
      ContactSet<R> moved = set;
      moved.move(steps);
      const RiemannHilbertForm<R> form = trial.form_on(std::move(moved), trial.form().tilt());
      const auto [numerator, denominator] = weights[static_cast<std::size_t>(k - 1)];
      for (std::size_t i = 0; i < at.size(); ++i) {
        SurfacePoint<R> place = at[i];
        if (place.segment == static_cast<std::ptrdiff_t>(end)) place.node.from_left -= step;
        if (place.segment == static_cast<std::ptrdiff_t>(end) - 1) place.node.from_right += step;
        result[i] += sign * value(form, place) * numerator / (denominator * h);
      }
    }
  }
  return result;
}

template <Real R>
void check_ends(Findings& findings, const Derivatives<R>& derivatives) {
  const Quantity quantity{"derivative of u'/c and t with respect to a free end",
                          {"the formula", "differences of neighbouring solutions"},
                          tolerance<R>()};
  const RiemannHilbertForm<R>& form = derivatives.trial->form();
  const std::vector<SurfacePoint<R>> at = places(form.set());
  for (std::size_t f = 0; f < derivatives.neighbours.size(); ++f) {
    // The first and the last one: an end costs ten forms.
    if (f > 0 && f + 1 < derivatives.neighbours.size()) continue;
    const Neighbour<R>& neighbour = derivatives.neighbours[f];
    const std::vector<R> measured = differences(*derivatives.trial, f, at);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const R sum =
          numeric::value_of(neighbour.polynomial, at[i].node.x) + neighbour.pole / form.distance(at[i], neighbour.end);
      findings.compare(quantity, relative_difference<R>(R(factor(form, at[i]) * sum), measured[i]));
    }
  }
}

template <Real R>
void check_tilt(Findings& findings, const Derivatives<R>& derivatives) {
  const Quantity quantity{"derivative of u'/c and t with respect to the tilt",
                          {"the formula", "difference of two solutions"},
                          tolerance<R>()};
  const RiemannHilbertForm<R>& form = derivatives.trial->form();
  const RiemannHilbertForm<R> tilted = derivatives.trial->form_on(form.set(), R(form.tilt() + 1));
  for (const SurfacePoint<R>& at : places(form.set())) {
    const R y = factor(form, at);
    const bool inside = y != form.sign(at.segment) * form.modulus(at);
    const R expected = (inside ? 0 : 1) - derivatives.tilt_factor * y * form.expansion().tilt_polynomial(at.node.x);
    using std::abs, std::max;
    const R measured = value(tilted, at) - value(form, at);
    findings.compare(quantity, static_cast<double>(R(abs(measured - expected) / max(R(abs(value(form, at))), R(1)))));
  }
}

std::vector<Evidence> check(const Context& context, const LinearFormula& formula) {
  // Differences need digits to spare: where 16 are asked for they are taken at 50.
  const numeric::Digits digits = std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() -> std::vector<Evidence> {
    if constexpr (std::same_as<R, double>) {
      return {};
    } else {
      std::vector<Trial> all = trials(context, "rh-linearisation", count_for(context, {2, 2, 1}), true);
      // q/(z - e) leaves a polynomial where q has two coefficients: three components with one free end.
      all.insert(all.begin() + 1, with_ends({{true, true}, {false, true}, {true, true}}));
      Findings findings;
      for (const Trial& trial : all) {
        const Derivatives<R> derivatives = formula.at<R>(trial);
        findings.begin_case(trial.name + ": " + text_of(trial.problem), !derivatives.neighbours.empty());
        check_tilt(findings, derivatives);
        check_ends(findings, derivatives);
      }
      return findings.evidence(detail_of(context, all));
    }
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

LinearFormula changed_ends(const LinearFormula& right, auto change) {
  return right.changed([change](auto& derivatives, const Trial&) {
    for (auto& neighbour : derivatives.neighbours) change(derivatives.trial->form(), neighbour);
  });
}

}  // namespace

Claim rh_linearisation() {
  const LinearFormula right = linear_formula();
  // Plain: the formula is the solver's form, which lives at the number type it is examined in.
  return make_claim(
      claim_text("rh-linearisation"), check, right,
      std::vector<Wrong<LinearFormula>>{
          {"the residue -p B(e)", changed_ends(right, [](const auto&, auto& n) { n.pole = -n.pole; })},
          {"the residue B(e), p missing",
           changed_ends(
               right, [](const auto& form, auto& n) { n.pole /= form.fundamental_solution().powers()[n.end].value; })},
          {"alpha of the other sign in the residue's p",
           changed_ends(right,
                        [](const auto& form, auto& n) {
                          const auto& p = form.fundamental_solution().powers()[n.end].value;
                          n.pole *= (1 - p) / p;
                        })},
          {"[q/(z-e)]_poly left out", changed_ends(right, [](const auto&, auto& n) { n.polynomial.clear(); })},
          {"[q/(z-e)]_poly without 1/pi", changed_ends(right,
                                                       []<class R>(const RiemannHilbertForm<R>&, Neighbour<R>& n) {
                                                         for (R& c : n.polynomial) c *= numeric::pi<R>();
                                                       })},
          {"Y [1/Y]_poly left out",
           right.changed([](auto& derivatives, const Trial&) { derivatives.tilt_factor = 0; })},
          {"near miss: the residue moved by ten times the tolerance",
           right.changed([]<class R>(Derivatives<R>& derivatives, const Trial&) {
             for (Neighbour<R>& n : derivatives.neighbours) n.pole *= 1 + near_miss<R>();
           })}});
}

}  // namespace steadyslide::proofs_checks
