#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "proofs_checks/instruments/operators/gap_functional.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks::lemma_04_functional {
namespace {

using std::numbers::pi;
using Function = PiecewiseFunction;
using Gauss = boost::math::quadrature::gauss<double, 20>;

/// Functions u_hat - psi, and the parameters of the laws.
struct Functions {
  std::size_t number;
  Rational s;
  Rational load;
  Function v;
  Function w;
  Function given;    ///< u_n - psi of another displacement
  Rational between;  ///< parameter of a chord
  Rational factor;
  Rational constant;
  Function cubic;

  bool has_spikes() const { return number < 2; }
};

std::string text_of(const Functions& c) { return "s = " + to_string(c.s) + ", P = " + to_string(c.load); }

CaseList<Functions> functions(const Context& context) {
  const auto make = [&](Random& random, std::size_t k) {
    const Rational s = random.between(Rational(1, 10), 3) * (k % 2 == 0 ? 1 : -1);
    const Rational load = random.between(Rational(1, 5), 4);
    const std::vector<Rational> points = random_points(random);
    const bool smooth = !context.quick && k % 3 == 2;
    const auto draw = [&] { return smooth ? random_cubic(random) : random_polygon(random, points); };
    return Functions{k,
                     s,
                     load,
                     draw(),
                     draw(),
                     draw(),
                     random.between(0, 1),
                     random.between(0, 5),
                     random.between(-3, 3),
                     random_cubic(random)};
  };
  return random_cases(context, "lemma-04-functional", 12, 2, "random `s` of both signs, polygons and cubics", make);
}

/// The formula phi(psi + v) = size (reference - <t_0, paired>), with t_0 for the friction s.
struct Functional {
  Number size;
  Rational s;
  Number (*reference)(const Function&) = supremum<Number>;
  std::optional<Function> paired = std::nullopt;  ///< if absent, v
  Number spike = 1;                               ///< phi(u_hat + w_L) -> phi(u_hat) + spike P

  template <Real R>
  R at(const Function& v) const {
    return R(size) * (R(reference(v)) - pairing<R>(s, paired ? *paired : v));
  }
};

/// Checks convexity, homogeneity and the two lines of (13).
template <Real R>
void check_functional(Findings& findings, const Functional& form, const Functions& c) {
  using std::abs, std::max;
  const auto phi = [&](const Function& v) { return form.at<R>(v); };
  const R load = to_real<R>(c.load);
  const auto error = [&](const R& a) { return static_cast<double>(a / load); };
  const R phi_v = phi(c.v);
  findings.compare("lines", error(abs(-load * (pairing<R>(c.s, c.v) + largest_shift<R>(c.v)) - phi_v)));
  findings.compare("proper", error(max(R(-phi_v), R(0))));
  const R part = to_real<R>(c.between);
  const R chord = part * phi_v + (1 - part) * phi(c.w);
  findings.compare("convex", error(max(R(phi(Function::combined(c.between, c.v, 1 - c.between, c.w)) - chord), R(0))));
  const Function shifted = Function::combined(c.factor, c.v, c.constant, Function::constant(1, c.v.points));
  findings.compare("scaled", error(abs(phi(shifted) - to_real<R>(c.factor) * phi_v)));
}

template <Real R>
void check_pairings(Findings& findings, const Functions& c, bool quick) {
  using std::abs;
  const auto compare = [&](const char* quantity, const R& a, const R& b) {
    findings.compare(quantity, static_cast<double>(abs(a - b)));
  };
  compare("moments", pairing<R>(c.s, c.cubic), pairing_by_moments<R>(c.s, c.cubic.pieces.front()));
  if (!quick) compare("panels", pairing<R>(c.s, c.v), pairing_by_tanh_sinh<R>(c.s, c.v));
}

// Spikes of height 1 with an arbitrarily small norm in H^{1/2}:
//
//   w_L(x) = min(1, log(1/|2x|)/L) for |x| < 1/2, 0 elsewhere:  1 for |x| < e^-L/2.
//
// Their energy is half of the double integral of (w(x)-w(y))^2/(x-y)^2 over the whole line, divided by pi. This is the
// energy of the harmonic extension, at most that of the extension min(1, log(1/|2z|)/L), pi/L. Partial integration
// gives
//
//   -(1/pi) int int w'(x) w'(y) log|x-y| = (4/(pi L^2)) int_0^L (L-r) log coth(r/2) dr
//                                        = (4/(pi L^2)) (pi^2 L/4 - 7 zeta(3)/4 + 2 sum_{k odd} e^{-kL}/k^3).
//
// In double. Distances enter only by their logarithms, so that L may have any size.

double spike_energy(double l) {
  double tail = 0;
  for (int k = 1; k < 40; k += 2) tail += std::exp(-k * l) / (k * k * k);
  const double zeta3 = boost::math::constants::zeta_three<double>();
  return 4 / (pi * l * l) * (pi * pi * l / 4 - 7 * zeta3 / 4 + 2 * tail);
}

double spike_energy_by_quadrature(double l) {
  const double length = std::min(l, 40.0);  // the rest is of the order of e^-40
  const auto integrand = [l](const Node<double>& node) {
    const double r = node.from_left;
    return (l - r) * (std::log1p(std::exp(-r)) - std::log(-std::expm1(-r)));
  };
  const numeric::Power<double> none{0, 1};
  return 4 / (pi * l * l) * tanh_sinh::panel_integral<double>({{0, length, length}, none, none, integrand}).value;
}

/// Returns int t_0 w_L, with t_0 for the friction s.
double spike_weight(const Rational& s, double l) {
  const auto alpha = to_real<double>(Exponent::angle(s));
  const auto unit = [alpha](double x) {
    return std::cos(pi * alpha) / pi * std::pow(1 + x, -0.5 - alpha) * std::pow(1 - x, -0.5 + alpha);
  };
  // The integral is (1/L) int_0^L (mass of t_0 on |x| < e^-r/2) dr.
  const auto mass = [&](double r) {
    const double radius = std::exp(-r) / 2;
    return Gauss::integrate(unit, -radius, radius);
  };
  double sum = 0;
  const double most = std::min(l, 40.0);
  for (double from = 0; from < most; from += 2) sum += Gauss::integrate(mass, from, std::min(from + 2, most));
  return sum / l;
}

/// Checks psi + v + w_L. v is a hat with its top under the spike, so that the spike raises the maximum by its whole
/// height.
void check_spikes(Findings& findings, const Functional& form, const Rational& s, double load) {
  findings.begin_case("spikes, s = " + to_string(s));
  const Function hat{{-1, 0, 1}, {Polynomial({Rational(1, 3), Rational(1, 2)}), Polynomial({Rational(1, 3), -1})}};
  const double at_limit = load * (supremum<double>(hat) - pairing<double>(s, hat));
  const double limit = at_limit + static_cast<double>(form.spike) * load;
  std::vector<Level> energies;
  std::vector<Level> phis;
  for (const double l : {64.0, 256.0, 1024.0, 4096.0, 16384.0}) {
    findings.compare<double>("energy", spike_energy(l), spike_energy_by_quadrature(l));
    energies.push_back({l, spike_energy(l)});
    const double weight = spike_weight(s, l);
    const double with = load * (supremum<double>(hat) + 1 - pairing<double>(s, hat) - weight);
    phis.push_back({l, std::abs(with - limit)});
  }
  const Rate vanishing = fitted_rate(energies);
  findings.measure({"energy of spikes of height 1 against their sharpness `L`", vanishing.value, vanishing.error_bar, 1,
                    0.02, "at most `pi/L`"});
  const Rate jump = fitted_rate(phis);
  findings.measure(
      {"`phi(u_hat + spike)` to `phi(u_hat) + P`", jump.value, jump.error_bar, 1, 0.02, "strictly above `phi(u_hat)`"});
}

}  // namespace

Claim claim() {
  const auto with_reference = [](Number (*reference)(const Function&)) {
    return [reference](Functional& form) { form.reference = reference; };
  };
  return formula_claim<Functions, Functional>("lemma-04-functional")
      .cases(functions)
      .says([](const Functions& c) {
        return Functional{to_real<Number>(c.load), c.s};
      })
      .checked([]<Real R>(Findings& findings, const Functional& form, const Functions& c, const Context& context) {
        check_functional<R>(findings, form, c);
        check_pairings<R>(findings, c, context.quick);
        if (c.has_spikes()) check_spikes(findings, form, c.s, to_real<double>(c.load));
      })
      .wrong("the printed `u_bar_n` instead of `u_hat` in the second line of (13)",
             [](Functional& form, const Functions& c) { form.paired = c.given; })
      .wrong("ess inf instead of ess sup", with_reference([](const Function& v) {
               return Number(-supremum<Number>(Function::combined(-1, v, 0, v)));
             }))
      .wrong("the value at 0 instead of ess sup",
             with_reference([](const Function& v) { return to_real<Number>(v.at(0)); }))
      .wrong("`-P t_0` instead of `P t_0`", [](Functional& form) { form.size *= -1; })
      .wrong("the `t_0` of `-alpha`", [](Functional& form) { form.s *= -1; })
      .wrong("`phi` continuous: `phi(u_hat + w_L) -> phi(u_hat)`", &Functional::spike, 0)
      .wrong("`phi` upper, not lower semicontinuous: `phi(u_hat + w_L) -> phi(u_hat) - P`", &Functional::spike, -1)
      .near_miss("`phi`", &Functional::size);
}

}  // namespace steadyslide::proofs_checks::lemma_04_functional
