// Closed forms, as what the solution of the Riemann-Hilbert problem gives for their profiles.

#include "proofs_checks/instruments/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

Family flat_punch(const std::string& about, std::vector<std::string> ids, bool jumps) {
  Family family{about,
                std::move(ids),
                {"edges exchanged", "every alpha of the other sign", "1/2 for 1/2 + alpha at the left edge",
                 "without 1/sqrt(1+s^2)", "without 1/pi", "t of the other sign"}};
  if (jumps) {
    family.variants.emplace_back("beta of the other sign");
    family.variants.emplace_back("cos(pi alpha) of one side on both");
  }
  return family;
}

Claim punch_without_jump() {
  return derived("eq-04-derived", decided_riemann_hilbert,
                 {flat_punch("flat punch", {"rh-flat-punch-0", "rh-kernel"}, false)});
}

Claim punch_with_jumps() {
  return derived(
      "eq-05-07-derived", decided_riemann_hilbert,
      {flat_punch("flat punch", {"rh-flat-punch-1", "rh-flat-punch-2", "rh-flat-punch-3", "rh-flat-punch-4"}, true)});
}

Claim inverse() {
  return derived("eq-10-derived", decided_riemann_hilbert,
                 {{"inverse",
                   {"rh-inversion-"},
                   {"the integral's other sign", "the load's other sign", "s u' for s u'/(1+s^2)",
                    "1/sqrt(1+s^2) for 1/(1+s^2) before the integral", "alpha of the other sign in the weight"}}});
}

Claim tilted_punch() {
  return derived("tilted-punch-derived", decided_riemann_hilbert,
                 {{"tilted punch",
                   {"rh-tilted-punch"},
                   {"N = delta (x - sigma_1) - P/pi", "the load's other sign", "beta of the other sign", "without 1/pi",
                    "edges exchanged"}},
                  {"tilt at which an edge lifts",
                   {"rh-lifting-"},
                   {"the other sign", "the other end", "without pi", "half of it", "without sigma_1"}},
                  {"both tilts on [-1, 1]",
                   {"rh-tilted-punch-unit"},
                   {"exchanged", "alpha for 2 alpha", "P/pi and -P/pi", "both positive"}}});
}

Claim parabola() {
  const std::string against = "parabola against an edge";
  return derived(
      "parabola-derived", decided_riemann_hilbert,
      {{"contact zone",
        {"rh-parabola-zone"},
        {"the mirrored zone", "the centred zone", "1/4 + alpha^2", "a^2 without the 2", "a^2 without pi",
         "alpha for 2 alpha"}},
       {"largest pressure", {"rh-parabola-peak"}, {"4 alpha a", "-2 alpha a, the middle", "0", "-alpha a"}},
       {"printed factors",
        {"rh-parabola-traction"},
        {"1/4 + alpha^2", "without 1/sqrt(1+s^2)", "powers exchanged", "2/R", "t of the other sign"}},
       {"jumps, free ends",
        {"rh-parabola-jumps"},
        {"beta of the other sign", "sum p r^2 = P R/pi", "sum p r of the other sign", "r^2 not from the vertex"}},
       {against,
        {"rh-parabola-left-edge", "rh-parabola-right-edge"},
        {"beta of the other sign", "P R/pi for 2 P R/pi", "N = (x - v - sigma_1)/R", "without sigma_1^2"}},
       {"parabola in full contact",
        {"rh-parabola-two-edges"},
        {"beta of the other sign", "without the 1/2", "x - sigma_1", "without sigma_1^2", "the load's other sign"}}});
}

Claim quartic() {
  return derived(
      "quartic-derived", decided_riemann_hilbert,
      {{"traction and conditions",
        {"rh-quartic"},
        {"-sigma_1 x", "h_2 = (sigma_2 - sigma_1^2)/2", "sigma_1^3/3 in h_3", "sigma_4/2 in h_4"}},
       {"middle and width",
        {"rh-quartic-ends"},
        {"alpha of the other sign", "the middle at 0", "10 alpha missing", "56 alpha^2 missing", "twice the load"}},
       {"without friction",
        {"rh-quartic-frictionless"},
        {"psi' = 4 x^3", "a^4 = 3/4", "a^2 for a^2/2", "half the pressure"}}});
}

}  // namespace

std::vector<Claim> derived_tractions() {
  return {punch_without_jump(), punch_with_jumps(), inverse(), tilted_punch(), parabola(), quartic()};
}

}  // namespace steadyslide::proofs_checks
