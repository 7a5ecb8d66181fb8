// The half-plane z > 0 under tractions [Bal16, (1)]. With zeta = x + i z, C_n, C_t holomorphic, F = C_t - i C_n:
//
//   sigma_xx + sigma_zz = 2 Re F,   (sigma_zz - sigma_xx)/2 + i sigma_xz = -i z F' - C_t,   rotation = 2 (1-nu^2) Im F/E.
//
// Values of C_n, C_t and their derivatives at a place are symbols: d/dx takes C to C', d/dz to i C'.

#include "symbolic/field/comparison.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr std::size_t potential_orders = 3;

struct Potential {
  explicit Potential(const std::string& name) {
    for (std::size_t k = 0; k < potential_orders; ++k) {
      const std::string order = name + std::to_string(k);
      re.emplace_back("Re_" + order);
      im.emplace_back("Im_" + order);
    }
  }
  std::vector<symbol> re, im;
};

enum class BodyVariant { right, sign, depth, flat, rotation, shear };

struct HalfPlane {
  explicit HalfPlane(BodyVariant variant) {
    const int sign = variant == BodyVariant::sign ? 1 : -1;
    const int deep = variant == BodyVariant::depth ? -1 : variant == BodyVariant::flat ? 0 : 1;
    // F = C_t - i C_n, its derivative alike.
    const ex re_f = tangential.re[0] - sign * normal.im[0];
    const ex im_f = tangential.im[0] + sign * normal.re[0];
    const ex re_f1 = tangential.re[1] - sign * normal.im[1];
    const ex im_f1 = tangential.im[1] + sign * normal.re[1];
    const ex deviator = deep * z * im_f1 - tangential.re[0];
    xx = re_f - deviator;
    zz = re_f + deviator;
    xz = (variant == BodyVariant::shear ? -1 : 1) * (-deep * z * re_f1 - tangential.im[0]);
    const ex factor = (1 + nu) / young;
    strain_xx = factor * ((1 - nu) * xx - nu * zz);
    strain_zz = factor * ((1 - nu) * zz - nu * xx);
    strain_xz = factor * xz;
    rotation = (variant == BodyVariant::rotation ? 1 : 2) * (1 - nu * nu) * im_f / young;
  }
  ex along(const ex& f) const { return derivative(f, false); }
  ex down(const ex& f) const { return derivative(f, true); }
  /// C_n = H t_n + i t_n and C_t likewise, at z = 0.
  ex at_surface(const ex& f) const {
    return f.subs(
        GiNaC::lst{z == 0, normal.re[0] == h_n, normal.im[0] == t_n, tangential.re[0] == h_t, tangential.im[0] == t_t});
  }

  symbol z{"z"}, nu{"nu"}, young{"E"}, h_n{"H_n"}, t_n{"t_n"}, h_t{"H_t"}, t_t{"t_t"};
  Potential normal{"n"}, tangential{"t"};
  ex xx, zz, xz, strain_xx, strain_zz, strain_xz, rotation;

 private:
  ex derivative(const ex& f, bool down) const {
    ex sum = down ? f.diff(z) : ex(0);
    for (const Potential* c : {&normal, &tangential}) {
      for (std::size_t k = 0; k + 1 < potential_orders; ++k) {
        const ex re = down ? ex(-c->im[k + 1]) : ex(c->re[k + 1]);
        const ex im = down ? ex(c->re[k + 1]) : ex(c->im[k + 1]);
        sum += f.diff(c->re[k]) * re + f.diff(c->im[k]) * im;
      }
    }
    return sum;
  }
};

DecidedStatement half_plane_equilibrium() {
  const auto decided = [](const std::string& words, BodyVariant variant) {
    const HalfPlane body(variant);
    const PhaseField field;
    return Comparison(field)
        .equal("along x", body.along(body.xx) + body.down(body.xz), 0)
        .equal("along z", body.along(body.xz) + body.down(body.zz), 0)
        .as(words);
  };
  return {"equation-half-plane-equilibrium",
          decided("d sigma_xx/dx + d sigma_xz/dz = 0, d sigma_xz/dx + d sigma_zz/dz = 0", BodyVariant::right),
          {decided("without z F'", BodyVariant::flat), decided("+i z F'", BodyVariant::depth),
           decided("sigma_xz of the other sign", BodyVariant::shear)}};
}

/// Strains and rotation are a gradient: du_x = e_xx dx + (e_xz - w) dz, du_z = (e_xz + w) dx + e_zz dz.
DecidedStatement half_plane_gradient() {
  const auto decided = [](const std::string& words, BodyVariant variant) {
    const HalfPlane body(variant);
    const PhaseField field;
    return Comparison(field)
        .equal("u_x", body.down(body.strain_xx), body.along(body.strain_xz - body.rotation))
        .equal("u_z", body.down(body.strain_xz + body.rotation), body.along(body.strain_zz))
        .as(words);
  };
  return {"equation-half-plane-gradient",
          decided("strains by Hooke's law in plane strain and the rotation 2 (1-nu^2) Im F/E are the gradient of a "
                  "displacement",
                  BodyVariant::right),
          {decided("without z F'", BodyVariant::flat), decided("half of the rotation", BodyVariant::rotation),
           decided("+i z F'", BodyVariant::depth)}};
}

DecidedStatement half_plane_surface() {
  const auto decided = [](const std::string& words, BodyVariant variant, int sign, bool stress) {
    const HalfPlane body(variant);
    const PhaseField field;
    const ex compliance = 2 * (1 - body.nu * body.nu) / body.young;
    const ex gamma = sign * (stress ? (1 - body.nu) / 2 : (1 - 2 * body.nu) / (2 * (1 - body.nu)));
    return Comparison(field)
        .equal("sigma_zz", body.at_surface(body.zz), body.t_n)
        .equal("sigma_xz", body.at_surface(body.xz), -body.t_t)
        .equal("u_n'", body.at_surface(-(body.strain_xz + body.rotation)), compliance * (body.h_n - gamma * body.t_t))
        .equal("u_t'", body.at_surface(body.strain_xx), compliance * (body.h_t + gamma * body.t_n))
        .as(words);
  };
  return {
      "equation-half-plane-surface",
      decided(
          "where C_n = H t_n + i t_n, C_t = H t_t + i t_t, z F' = 0: sigma_zz = t_n, sigma_xz = -t_t, -du_z/dx = c (H "
          "t_n - gamma t_t), du_x/dx = c (H t_t + gamma t_n), c = 2 (1-nu^2)/E",
          BodyVariant::right, 1, false),
      {decided("gamma of the other sign", BodyVariant::right, -1, false),
       decided("gamma of plane stress", BodyVariant::right, 1, true),
       decided("half of the rotation", BodyVariant::rotation, 1, false),
       decided("F = C_t + i C_n", BodyVariant::sign, 1, false)}};
}

}  // namespace

void add_half_plane(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {half_plane_equilibrium, half_plane_gradient, half_plane_surface})
    all.push_back(statement());
}

}  // namespace steadyslide::symbolic
