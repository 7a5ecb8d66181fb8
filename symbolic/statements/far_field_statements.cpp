// Far below given tractions, -P and Q their integrals: C_n = P/(pi zeta) and C_t = -Q/(pi zeta) in the stresses of
// half_plane_statements.cpp, zeta = exp(i theta)/rho; the energy of what they make, and the surface beside them. theta/2 is the
// angle of a friction, so that cos(theta) and sin(theta) are rational in its tangent. [Bal16, section 2]

#include "symbolic/field/comparison.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

DecidedStatement two_forces() {
  const PhaseField field({symbol("y")});
  const ex i = field.i();
  const AngleForm theta(0, {{0, 2}});
  const ex e = field.phase(theta, 1);
  const ex conjugate = field.phase(theta, -1);
  const ex cosine = (e + conjugate) / 2;
  const ex sine = (e - conjugate) / (2 * i);
  const symbol load("P"), shear("Q"), pi("pi"), rho("rho");
  const auto decided = [&](const std::string& words, int size, int side, int turned) {
    const ex f = rho / pi * conjugate * (-shear - i * load);
    const ex f_conjugate = rho / pi * e * (-shear + i * load);
    const ex c_t = -shear * rho / pi * conjugate;
    const ex c_t_conjugate = -shear * rho / pi * e;
    // -i z F' - C_t with z F' = -sin(theta) exp(-i theta) F.
    const ex d = i * sine * conjugate * f - c_t;
    const ex d_conjugate = -i * sine * e * f_conjugate - c_t_conjugate;
    const ex mean = (f + f_conjugate) / 2;
    const ex radial = -size * rho / pi * (load * (turned ? cosine : sine) + side * shear * (turned ? sine : cosine));
    return Comparison(field)
        .equal("sigma_xx", mean - (d + d_conjugate) / 2, radial * cosine * cosine)
        .equal("sigma_zz", mean + (d + d_conjugate) / 2, radial * sine * sine)
        .equal("sigma_xz", (d - d_conjugate) / (2 * i), radial * sine * cosine)
        .as(words);
  };
  return {"equation-far-stresses",
          decided("C_n = P/(pi zeta), C_t = -Q/(pi zeta) make sigma_rr = -2 (P sin(theta) + Q cos(theta))/(pi r) alone",
                  2, 1, 0),
          {decided("1 for 2", 1, 1, 0), decided("P sin(theta) - Q cos(theta)", 2, -1, 0),
           decided("sine and cosine exchanged", 2, 1, 1), decided("a tension", -2, 1, 0)}};
}

/// Stresses e sigma_rr and e^2 times bounded ones, e = 1/r: what e^2 has in the energy, and its integral over the angles.
DecidedStatement far_energy() {
  const PhaseField field({symbol("y")});
  const AngleForm theta(0, {{0, 2}});
  const ex cosine = (field.phase(theta, 1) + field.phase(theta, -1)) / 2;
  const ex sine = (field.phase(theta, 1) - field.phase(theta, -1)) / (2 * field.i());
  const symbol nu("nu"), young("E"), small("e"), radial("sigma"), load("P"), shear("Q"), pi("pi"), angle("theta");
  const symbol c("c"), s("s"), xx("tau_xx"), zz("tau_zz"), xz("tau_xz"), log2("log2");
  const auto energy = [&](const ex& a, const ex& b, const ex& t) -> ex {
    return (1 + nu) / (2 * young) * ((1 - nu) * (a * a + b * b) - 2 * nu * a * b + 2 * t * t);
  };
  const auto decided = [&](const std::string& words, const ex& modulus, const ex& total, int half) {
    const ex density = energy(small * radial * c * c + small * small * xx, small * radial * s * s + small * small * zz,
                              small * radial * s * c + small * small * xz)
                           .expand();
    const auto part = [&](int k) { return density.coeff(small, k).subs(GiNaC::lst{c == cosine, s == sine}); };
    // A primitive of (P sin + Q cos)^2, sin' = cos, cos' = -sin.
    const ex primitive =
        (load * load + shear * shear) * angle / 2 + (shear * shear - load * load) * s * c / half + load * shear * s * s;
    const ex derived = primitive.diff(angle) + primitive.diff(s) * c - primitive.diff(c) * s;
    const ex over_angles = primitive.subs(GiNaC::lst{angle == pi, s == 0, c == -1}) -
                           primitive.subs(GiNaC::lst{angle == 0, s == 0, c == 1});
    return Comparison(field)
        .equal("e^0", part(0), 0)
        .equal("e^1", part(1), 0)
        .equal("e^2", part(2), modulus * radial * radial)
        .equal("primitive", derived.subs(GiNaC::lst{c == cosine, s == sine}),
               GiNaC::pow(load * sine + shear * cosine, 2))
        .equal("annulus", modulus * 4 / (pi * pi) * over_angles * log2, total)
        .as(words);
  };
  const ex modulus = (1 - nu * nu) / (2 * young);
  const ex total = 2 * modulus * (load * load + shear * shear) * log2 / pi;
  return {
      "equation-far-energy",
      decided(
          "energy (1-nu^2) sigma_rr^2/(2 E) + O(1/r^3); over 0 < theta < pi and R < r < 2 R: (1-nu^2) (P^2+Q^2) log "
          "2/(pi E)",
          modulus, total, 2),
      {decided("twice the energy", 2 * modulus, 2 * total, 2),
       decided("plane stress", modulus / (1 - nu * nu), total, 2), decided("half of it", modulus, total / 2, 2),
       decided("another primitive", modulus, total, 1)}};
}

/// u_n' = c H t_n beside the tractions, H t_n = C_n on the line; log(2 R) - log(R) = log 2.
DecidedStatement far_surface() {
  const PhaseField field;
  const symbol x("x"), load("P"), pi("pi"), c("c"), log2("log2"), logarithm("logR");
  const auto decided = [&](const std::string& words, int sign, const ex& rise) {
    const auto height = [&](const ex& log_x) -> ex { return c * load / pi * log_x; };
    // d log(x)/dx = 1/x, times x.
    return Comparison(field)
        .equal("x u_n'", c * -(-load) / pi, sign * height(logarithm).diff(logarithm))
        .equal("rise", height(logarithm + log2) - height(logarithm), rise)
        .as(words);
  };
  const ex rise = c * load * log2 / pi;
  return {"equation-far-surface",
          decided("u_n' = c P/(pi x) + O(1/x^2) rises by c P log 2/pi from R to 2 R", 1, rise),
          {decided("it sinks", -1, -rise), decided("without 1/pi", 1, pi * rise), decided("twice", 1, 2 * rise)}};
}

}  // namespace

void add_far_field(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {two_forces, far_energy, far_surface}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
