// phi is proper, convex and lower semicontinuous. [Bal16, (13) and lemma 4]

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "proofs_checks/claims/section_3/functional_parts.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/gap_functional.hpp"
#include "proofs_checks/instruments/logarithmic_spike.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Real;
using Function = PiecewiseFunction;

/// <sign P t_0, reference - v>
struct FunctionalSaid {
  enum class Reference { supremum, infimum, value_at_0 } reference = Reference::supremum;
  int sign = 1;
  int angle = 1;                 ///< of alpha in t_0
  bool own_displacement = true;  ///< v = u_hat - psi, not u_n - psi
  double moved = 0;
  enum class Spikes { lower, continuous, upper } spikes = Spikes::lower;  ///< what sequences are said to do
};

template <class R>
struct Case {
  Rational s;
  R load;
  Function given;  ///< u_n - psi of another displacement
  UnitPairing<R>& pairing;

  R phi(const Function& v, const FunctionalSaid& said) const {
    using Reference = FunctionalSaid::Reference;
    const Function& paired = said.own_displacement ? v : given;
    R reference = said.reference == Reference::infimum      ? R(-supremum<R>(Function::combined(-1, v, 0, v)))
                  : said.reference == Reference::value_at_0 ? numeric::to_real<R>(v.at(0))
                                                            : supremum<R>(v);
    return said.sign * load * (reference - pairing(said.angle * s, paired)) * (1 + R(said.moved) * R(tolerance<R>()));
  }
};

/// Convexity, homogeneity and the two lines of (13), on one pair of functions.
template <Real R>
void check_pair(Findings& findings, Random& random, const Case<R>& c, const Function& v, const Function& w,
                const FunctionalSaid& said) {
  using std::abs, std::max;
  const Quantity lines{"phi(u_hat)", {"infimum over C", "ess sup"}, tolerance<R>()};
  const Quantity convex{"phi between two functions, above the chord", {"phi", "chord"}, tolerance<R>()};
  const Quantity scaled{"phi(psi + k v + C), k > 0", {"phi", "k phi(psi + v)"}, tolerance<R>()};
  const Quantity proper{"phi below zero, and at psi", {"phi", "0"}, tolerance<R>()};
  const R phi_v = c.phi(v, said);
  const R phi_w = c.phi(w, said);
  const R scale = c.load;
  const auto error = [&](const R& a) { return static_cast<double>(R(a / scale)); };
  findings.compare(lines, error(abs(-c.load * (c.pairing(c.s, v) + largest_shift<R>(v)) - phi_v)));
  findings.compare(proper, error(max(R(-phi_v), R(0))));
  findings.compare(proper, error(abs(c.phi(Function::constant(0, v.points), said))));
  const Rational between = random.between(0, 1);
  const R part = numeric::to_real<R>(between);
  const R chord = part * phi_v + (1 - part) * phi_w;
  findings.compare(convex, error(max(R(c.phi(Function::combined(between, v, 1 - between, w), said) - chord), R(0))));
  const Rational k = random.between(0, 5);
  const Function shifted = Function::combined(k, v, random.between(-3, 3), Function::constant(1, v.points));
  findings.compare(scaled, error(abs(c.phi(shifted, said) - numeric::to_real<R>(k) * phi_v)));
}

template <Real R>
void check_pairings(Findings& findings, const Case<R>& c, const Function& v, const Function& cubic, bool quick) {
  using std::abs;
  const Quantity moments{"int t_0 v, polynomials", {"Gauss-Jacobi", "recurrence of moments"}, tolerance<R>()};
  findings.compare(
      moments, static_cast<double>(R(abs(c.pairing(c.s, cubic) - pairing_by_moments<R>(c.s, cubic.pieces.front())))));
  if (quick) return;
  const Quantity panels{"int t_0 v, piecewise", {"Gauss-Jacobi", "tanh-sinh"}, tolerance<R>()};
  findings.compare(panels, static_cast<double>(R(abs(c.pairing(c.s, v) - pairing_by_tanh_sinh<R>(c.s, v)))));
}

/// psi + v + w_L: v a hat with its top under the spike, so that the spike is felt in full.
void check_spikes(Findings& findings, const Rational& s, double load, const FunctionalSaid& said) {
  using Spikes = FunctionalSaid::Spikes;
  const Quantity energy{"energy of a spike", {"series", "quadrature"}, tolerance<double>()};
  findings.begin_case("spikes, s = " + to_string(s));
  const Function hat{{-1, 0, 1}, {Polynomial({Rational(1, 3), Rational(1, 2)}), Polynomial({Rational(1, 3), -1})}};
  UnitPairing<double> pairing;
  const double at_limit = load * (supremum<double>(hat) - pairing(s, hat));
  std::vector<Level> energies;
  std::vector<Level> phis;
  double last = 0;
  for (const double l : {64.0, 256.0, 1024.0, 4096.0, 16384.0}) {
    findings.compare(energy, relative_difference(spike_energy(l), spike_energy_by_quadrature(l)));
    energies.push_back({l, spike_energy(l)});
    const double weight = spike_weight(s, l);
    const double with = load * (supremum<double>(hat) + 1 - pairing(s, hat) - weight);
    const double without = load * (supremum<double>(hat) - pairing(s, hat) + weight);
    const double limit = said.spikes == Spikes::continuous ? at_limit : at_limit + load;
    phis.push_back({l, std::abs(with - limit)});
    last = with;
    if (said.spikes != Spikes::upper) {
      findings.require(with >= at_limit - load * weight && without >= at_limit,
                       "phi falls below its value at the limit");
    }
  }
  if (said.spikes == Spikes::upper) findings.require(last <= at_limit, "phi stays above its value at the limit");
  const Rate vanishing = fitted_rate(energies);
  findings.measure({"energy of spikes of height 1 against their sharpness L", vanishing.value, vanishing.error_bar, 1,
                    0.02, "at most pi/L"});
  const Rate jump = fitted_rate(phis);
  findings.measure(
      {"phi(u_hat + spike) to phi(u_hat) + P", jump.value, jump.error_bar, 1, 0.02, "strictly above phi(u_hat)"});
}

using Pairings = std::tuple<UnitPairing<double>, UnitPairing<numeric::Real50>, UnitPairing<numeric::Real100>>;

std::vector<Evidence> check(const Context& context, const FunctionalSaid& said, Pairings& pairings) {
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "lemma-04-functional");
    Findings findings;
    for (int k = 0; k < (context.quick ? 2 : 12); ++k) {
      const Rational s = random.between(Rational(1, 10), 3) * (k % 2 == 0 ? 1 : -1);
      const Rational load = random.between(Rational(1, 5), 4);
      const std::vector<Rational> points = random_points(random);
      const bool smooth = !context.quick && k % 3 == 2;
      const Function v = smooth ? random_cubic(random) : random_polygon(random, points);
      const Function w = smooth ? random_cubic(random) : random_polygon(random, points);
      const Function given = smooth ? random_cubic(random) : random_polygon(random, points);
      findings.begin_case("s = " + to_string(s) + ", P = " + to_string(load));
      const Case<R> c{s, numeric::to_real<R>(load), given, std::get<UnitPairing<R>>(pairings)};
      check_pair(findings, random, c, v, w, said);
      check_pairings(findings, c, v, random_cubic(random), context.quick);
      if (k < 2) check_spikes(findings, s, numeric::to_real<double>(load), said);
    }
    return findings.evidence("random s of both signs, polygons and cubics, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim functional_claim() {
  using S = FunctionalSaid;
  const auto examine = [pairings = std::make_shared<Pairings>()](const Context& context, const S& said) {
    return check(context, said, *pairings);
  };
  return make_claim(
      claim_text("lemma-04-functional"), examine, S(),
      std::vector<Wrong<S>>{
          {"the printed u_bar_n instead of u_hat in the second line of (13)",
           changed<S>([](S& said) { said.own_displacement = false; })},
          {"ess inf instead of ess sup", changed<S>([](S& said) { said.reference = S::Reference::infimum; })},
          {"the value at 0 instead of ess sup", changed<S>([](S& said) { said.reference = S::Reference::value_at_0; })},
          {"-P t_0 instead of P t_0", changed<S>([](S& said) { said.sign = -1; })},
          {"the t_0 of -alpha", changed<S>([](S& said) { said.angle = -1; })},
          {"phi continuous: phi(u_hat + w_L) -> phi(u_hat)",
           changed<S>([](S& said) { said.spikes = S::Spikes::continuous; })},
          {"phi upper semicontinuous", changed<S>([](S& said) { said.spikes = S::Spikes::upper; })},
          {"near miss: phi moved by ten times the tolerance", changed<S>([](S& said) { said.moved = 10; })}});
}

}  // namespace steadyslide::proofs_checks
