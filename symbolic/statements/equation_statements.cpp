// What leaves the contact problem what it is [Bal16, (2), (3)]. A map takes
//
//   x = a + e k y,   t -> m t,   u_bar -> n u_bar + h,   psi_bar -> n' psi_bar + h',   s -> sigma s,   P -> q P,
//
// k > 0, e = 1 or -1. With x'-x = e k (y'-y), dx' = k dy' and d/dx = (1/(e k)) d/dy, the terms of A t = u_bar' at x are those
// at y times one factor, c = e m, exactly if sigma = e and n = m k; the gap is n times what it was if n' = n, h' = h; the load
// is m k times what it was. Each is an identity between polynomials in the values of t, u_bar' and psi_bar at two places.

#include "symbolic/field/comparison.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

const symbol& k() {
  static const symbol factor("k");
  return factor;
}
const symbol& h() {
  static const symbol height("h");
  return height;
}

struct Map {
  ex shift = 0;                     // a
  int direction = 1;                // e
  ex length = 1;                    // k
  ex traction = 1;                  // m
  ex displacement = 1, raised = 0;  // n, h
  ex profile = 1, lifted = 0;       // n', h'
  int friction = 1;                 // sigma
  ex load = 1;                      // q
};

ExactIdentity decided(const std::string& words, const Map& map) {
  const symbol y("y"), y1("y'"), t("t"), t1("t'"), s("s"), slope("u'"), u("u"), psi("psi");
  const auto x = [&](const ex& place) -> ex { return map.shift + map.direction * map.length * place; };
  const ex c = map.direction * map.traction;
  const ex gap = map.profile * psi + map.lifted - (map.displacement * u + map.raised);
  // Multiplied by the distances x'-x and y'-y, and by e k: no divisor is left.
  const PhaseField field;
  return Comparison(field)
      .equal("the integrand", map.traction * t1 * map.length * (y1 - y), c * t1 * (x(y1) - x(y)))
      .equal("s t", map.friction * s * map.traction * t, c * s * t)
      .equal("u_bar'", map.displacement * slope, c * slope * map.direction * map.length)
      .equal("the gap", gap, map.displacement * (psi - u))
      .equal("the load's integrand", map.traction * map.length * t, map.load * t)
      .as(words);
}

/// t_t = shear t_n in u_n' = H t_n - gamma t_t, against H t_n + s t_n.
ExactIdentity reduced(const std::string& words, int shear_over_f, int s_over_gamma_f) {
  const symbol integral("H"), t("t"), f("f"), gamma("gamma");
  const PhaseField field;
  return Comparison(field)
      .equal("u_n'", integral - gamma * (shear_over_f * f * t), integral + s_over_gamma_f * gamma * f * t)
      .as(words);
}

}  // namespace

std::vector<DecidedStatement> equation_statements() {
  const symbol a("a");
  const std::string same =
      "the terms of A t - u_bar', the gap and the load are what they were, times one factor each: ";
  const Map dilation{.shift = a, .length = k(), .displacement = k(), .profile = k(), .load = k()};
  const Map scaling{.traction = k(), .displacement = k(), .profile = k(), .load = k()};
  const Map raising{.raised = h(), .lifted = h()};
  const Map mirror{.direction = -1, .friction = -1};
  const auto changed = [](Map map, const auto& change) {
    change(map);
    return map;
  };
  std::vector<DecidedStatement> all{
      {"equation-dilation",
       decided(same + "x = a + k y, t, k u_bar, k psi_bar, k P", dilation),
       {decided("psi_bar for k psi_bar", changed(dilation, [](Map& m) { m.profile = 1; })),
        decided("u_bar for k u_bar", changed(dilation, [](Map& m) { m.displacement = m.profile = 1; })),
        decided("P for k P", changed(dilation, [](Map& m) { m.load = 1; })),
        decided("k t for t", changed(dilation, [](Map& m) { m.traction = k(); })),
        decided("the friction of the other direction", changed(dilation, [](Map& m) { m.friction = -1; }))}},
      {"equation-scaling",
       decided(same + "k t, k u_bar, k psi_bar, k P", scaling),
       {decided("t for k t", changed(scaling, [](Map& m) { m.traction = 1; })),
        decided("psi_bar for k psi_bar", changed(scaling, [](Map& m) { m.profile = 1; })),
        decided("P for k P", changed(scaling, [](Map& m) { m.load = 1; }))}},
      {"equation-raising",
       decided(same + "u_bar + h, psi_bar + h", raising),
       {decided("psi_bar for psi_bar + h", changed(raising, [](Map& m) { m.lifted = 0; })),
        decided("psi_bar - h", changed(raising, [](Map& m) { m.lifted = -h(); })),
        decided("2 P for P", changed(raising, [](Map& m) { m.load = 2; }))}},
      {"equation-mirror",
       decided(same + "x = -y, -s", mirror),
       {decided("s for -s", changed(mirror, [](Map& m) { m.friction = 1; })),
        decided("-t for t", changed(mirror, [](Map& m) { m.traction = -1; })),
        decided("-P for P", changed(mirror, [](Map& m) { m.load = -1; })),
        decided("-u_bar for u_bar", changed(mirror, [](Map& m) { m.displacement = -1; }))}},
      {"equation-forward",
       reduced("u_n' = H t_n - gamma t_t with t_t = -f t_n is H t_n + s t_n, s = gamma f", -1, 1),
       {reduced("s = -gamma f", -1, -1), reduced("t_t = f t_n", 1, 1), reduced("s = 0", -1, 0)}},
      {"equation-backward",
       reduced("u_n' = H t_n - gamma t_t with t_t = f t_n is H t_n + s t_n, s = -gamma f", 1, -1),
       {reduced("s = gamma f", 1, 1), reduced("t_t = -f t_n", -1, -1), reduced("s = 0", 1, 0)}},
  };
  add_half_plane(all);
  add_far_field(all);
  return all;
}

}  // namespace steadyslide::symbolic
