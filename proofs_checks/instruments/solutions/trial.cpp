#include "proofs_checks/instruments/solutions/trial.hpp"

#include <algorithm>

#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Returns the piece of the profile around a point.
template <Real R>
const Polynomial& piece_around(const ContactProblem& problem, const R& x) {
  const auto& pieces = problem.indenter().pieces();
  std::size_t k = 0;
  while (k + 1 < pieces.size() && x > to_real<R>(pieces[k].to)) ++k;
  return pieces[k].profile;
}

}  // namespace

template <Real R>
R height(const ContactProblem& problem, const R& around, const R& x) {
  return value_of(piece_around(problem, around), x) / to_real<R>(problem.elasticity().compliance());
}

template <Real R>
R slope(const ContactProblem& problem, const R& around, const R& x) {
  return value_of(piece_around(problem, around).derivative(), x) / to_real<R>(problem.elasticity().compliance());
}

template <class R>
TrialForm<R>::TrialForm(const Trial& trial) : problem_(trial.problem), reduced_(problem_, Trial::frame()) {
  auto state =
      numeric::ContactState<R>::initial(reduced_, ContactSet<R>(reduced_, trial.zones), to_real<R>(trial.tilt));
  for (std::size_t j = 0; j < state.q.size(); ++j) state.q[j] = to_real<R>(trial.q.at(j));
  form_.emplace(reduced_, std::move(state.set), std::move(state.q), state.tilt, rules_);
}

template <class R>
TractionRepresentation<R> TrialForm<R>::form_on(ContactSet<R> set, const R& tilt) const {
  return {reduced_, std::move(set), form_->q(), tilt, rules_};
}

template <Real R>
R coefficient_at_infinity(const TractionRepresentation<R>& form, int power) {
  const int top = form.degree_at_infinity() - power;
  const std::vector<numeric::Estimate<R>> m = form.moments(static_cast<std::size_t>(std::max(top, 0)));
  R sum = 0;
  for (int j = 0; j < top; ++j) {
    sum += m[static_cast<std::size_t>(j)].value * form.expansion().series()[static_cast<std::size_t>(top - 1 - j)];
  }
  for (std::size_t l = 0; l < form.q().size(); ++l) {
    const int index = top + static_cast<int>(l);
    if (index >= 0) sum += form.q()[l] / numeric::pi<R>() * form.expansion().series()[static_cast<std::size_t>(index)];
  }
  return sum;
}

template <Real R>
std::vector<R> excess(const TractionRepresentation<R>& form) {
  std::vector<R> result;
  for (int power = 0; power < form.degree_at_infinity(); ++power) {
    result.push_back(coefficient_at_infinity(form, power));
  }
  return result;
}

template <Real R>
std::vector<std::size_t> segments_of(const TractionRepresentation<R>& form) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (form.set().in_contact(k)) result.push_back(k);
  }
  return result;
}

template <Real R>
R load_scale(const TractionRepresentation<R>& form) {
  using std::abs;
  R sum = 0;
  for (const std::size_t k : segments_of(form)) {
    const R half = form.set().length(k) / 2;
    sum +=
        2 * half * abs(form.traction({static_cast<std::ptrdiff_t>(k), {R(form.set().x(k) + half), half, half}}).value);
  }
  return sum;
}

template <Real R>
std::vector<R> friction_of(const TractionRepresentation<R>& form) {
  const ContactProblem& problem = form.problem().problem();
  std::vector<R> result;
  for (const std::size_t k : segments_of(form)) {
    const R middle = (form.set().x(k) + form.set().x(k + 1)) / 2;
    const Frame& frame = form.problem().frame();
    const R x = to_real<R>(frame.origin) + to_real<R>(frame.unit) * middle;
    std::size_t piece = 0;
    for (const Rational& c : problem.friction().jumps()) piece += to_real<R>(c) < x ? 1 : 0;
    result.push_back(to_real<R>(s_of(problem, piece)));
  }
  return result;
}

template <Real R>
PiecewiseDensity<R> density_of(const TractionRepresentation<R>& form, const numeric::FundamentalSolution<R>& weight,
                               const Bracket<R>& bracket) {
  PiecewiseDensity<R> density;
  // At a wedge a vanishing power is smaller than the constant or the logarithm, so it is not the leading one.
  const auto leading = [&](std::size_t j) {
    const numeric::Power<R>& p = weight.powers()[j];
    return form.changes_polynomial(j) && p.value > 0 ? numeric::Power<R>{R(0), R(1)} : p;
  };
  R gap = 0;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (!form.set().in_contact(k)) {
      gap += form.set().length(k);
      continue;
    }
    const bool left_kink = leading(k).value != weight.powers()[k].value;
    const bool right_kink = leading(k + 1).value != weight.powers()[k + 1].value;
    const auto smooth = [weight, bracket, k, left_kink, right_kink](const Node<R>& node) {
      using std::pow;
      R value = weight.smooth_modulus(k, node) * bracket(k, node);
      if (left_kink) value *= pow(node.from_left, weight.powers()[k].value);
      if (right_kink) value *= pow(node.from_right, weight.powers()[k + 1].value);
      return value;
    };
    density.push_back({weight.panel(k), leading(k), leading(k + 1), smooth, density.empty() ? R(0) : gap});
    gap = 0;
  }
  return density;
}

template <Real R>
R equation_error(const TractionRepresentation<R>& solution) {
  const ContactSet<R>& set = solution.set();
  const R origin = to_real<R>(solution.problem().frame().origin);
  const R unit = to_real<R>(solution.problem().frame().unit);
  const std::vector<std::size_t> segments = segments_of(solution);
  const numeric::SurfaceCheck<R> check(
      traction_density(solution), friction_of(solution), [&](std::size_t k, const Node<R>& node) {
        const R middle = (set.x(segments[k]) + set.x(segments[k] + 1)) / 2;
        const ContactProblem& problem = solution.problem().problem();
        return R(slope<R>(problem, R(origin + unit * middle), R(origin + unit * node.x)) + solution.tilt());
      });
  return check.equation();
}

template <Real R>
void check_equation(Findings& findings, const TractionRepresentation<R>& solution) {
  const Quantity equation{"`A t = psi'/c` for the solved problem",
                          {"`(1/pi) PV int t/(x'-x) dx' + s t`, trapezoidal rule", "`psi'/c`"},
                          tolerance<R>()};
  findings.compare(equation, static_cast<double>(equation_error(solution)));
}

template <Real R>
R extrapolated(const std::vector<R>& f, int to) {
  R sum = 0;
  const int n = static_cast<int>(f.size());
  for (int i = 1; i <= n; ++i) {
    R term = f[static_cast<std::size_t>(i - 1)];
    for (int k = 1; k <= n; ++k) {
      if (k != i) term *= R(to + k) / (k - i);
    }
    sum += term;
  }
  return sum;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                                  \
  template R height(const ContactProblem&, const R&, const R&);                                                     \
  template R slope(const ContactProblem&, const R&, const R&);                                                      \
  template class TrialForm<R>;                                                                                      \
  template R coefficient_at_infinity(const TractionRepresentation<R>&, int);                                        \
  template R load_scale(const TractionRepresentation<R>&);                                                          \
  template std::vector<R> excess(const TractionRepresentation<R>&);                                                 \
  template std::vector<std::size_t> segments_of(const TractionRepresentation<R>&);                                  \
  template std::vector<R> friction_of(const TractionRepresentation<R>&);                                            \
  template PiecewiseDensity<R> density_of(const TractionRepresentation<R>&, const numeric::FundamentalSolution<R>&, \
                                          const Bracket<R>&);                                                       \
  template R equation_error(const TractionRepresentation<R>&);                                                      \
  template void check_equation(Findings&, const TractionRepresentation<R>&);                                        \
  template R extrapolated(const std::vector<R>&, int);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
