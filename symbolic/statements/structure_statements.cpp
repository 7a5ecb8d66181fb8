// The steps of the structure theorem: next to every kind of point F = 2i Phi, less a particular solution F_0 of
//
//   (F+ + F-)/2 + s (F+ - F-)/(2i) = g,   t = (F+ - F-)/(2i),   Y+- = epsilon |Y|/((s +- i) cos(pi alpha)),
//
// is Y times a function that is one on both banks. g is a number here: what is decided at a place holds for functions.

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// F and Y on the banks of one panel; F+ is free, F- follows from the equation.
struct Banks {
  Banks(const PhaseField& field, std::size_t k, int epsilon, const ex& g)
      : friction(field.friction(k)), i(field.i()), epsilon(epsilon), g(g) {
    u_plus = epsilon * friction.r / (friction.s + i);
    u_minus = epsilon * friction.r / (friction.s - i);
    f_minus = (f_plus * (friction.s + i) - 2 * i * g) / (friction.s - i);
  }
  ex action(const ex& plus, const ex& minus) const { return (plus + minus) / 2 + friction.s * traction(plus, minus); }
  ex traction(const ex& plus, const ex& minus) const { return (plus - minus) / (2 * i); }
  /// |Y| (((F_0 - F)/Y)+ - ((F_0 - F)/Y)-)
  ex jump(const ex& plus, const ex& minus) const {
    return epsilon * friction.cos * ((plus - f_plus) * (friction.s + i) - (minus - f_minus) * (friction.s - i));
  }

  PhaseField::Friction friction;
  ex i;
  int epsilon;
  ex g;
  symbol f_plus{"F_plus"};
  symbol modulus{"Y"};
  ex u_plus, u_minus, f_minus;  // Y+- = |Y| u+-
};

const std::vector<int> signs{1, -1};

std::string with_sign(const std::string& what, int epsilon) {
  return what + (epsilon > 0 ? ", epsilon = 1" : ", epsilon = -1");
}

/// (b - F)/Y jumps by -2i d, d = epsilon cos (g - b)/|Y|: with (1/pi) int d/(x'-z) dx', whose limits are m +- i d, it is
/// one function. Conversely F = b - Y (N -+ i d) solves the equation whatever N is. `density` is |Y| d.
DecidedStatement structure_panel() {
  const PhaseField field({symbol("s")});
  const symbol g("g");
  const symbol b("b");
  const symbol n("N");
  const auto decided = [&](const std::string& words, const auto& density, int sign) {
    Comparison comparison(field);
    for (const int epsilon : signs) {
      const Banks banks(field, 0, epsilon, g);
      const ex d = density(banks);
      comparison.equal(with_sign("jump", epsilon), banks.jump(b, b) + sign * 2 * banks.i * d, 0);
      const ex plus = b - banks.u_plus * (banks.modulus * n - sign * banks.i * d);
      const ex minus = b - banks.u_minus * (banks.modulus * n + sign * banks.i * d);
      comparison.equal(with_sign("A t", epsilon), banks.action(plus, minus), g)
          .equal(with_sign("t where g = b", epsilon), banks.traction(plus, minus).subs(g == b),
                 epsilon * banks.friction.cos * banks.modulus * n);
    }
    return comparison.as(words);
  };
  const auto right = [&](const Banks& k) -> ex { return k.epsilon * k.friction.cos * (k.g - b); };
  return {
      "rh-structure-panel",
      decided("(b - F)/Y jumps by -2i epsilon cos(pi alpha) (g - b)/|Y|, and F = b - Y B with B of this jump solves "
              "A t = g, t = epsilon cos(pi alpha) |Y| B where g = b",
              right, 1),
      {decided(
           "without cos", [&](const Banks& k) -> ex { return right(k) / k.friction.cos; }, 1),
       decided(
           "sin for cos", [&](const Banks& k) -> ex { return right(k) * k.friction.s; }, 1),
       decided("the jump's other sign", right, -1),
       decided(
           "times |Y|", [&](const Banks& k) -> ex { return right(k) * k.modulus; }, 1),
       decided(
           "g + b", [&](const Banks& k) -> ex { return k.epsilon * k.friction.cos * (k.g + b); }, 1)}};
}

/// At a jump F_0+- = m +- i a with [s] a = D, m = g_l - s_l a: one pair of polynomials on both sides.
DecidedStatement structure_jump() {
  const symbol s_l("s_l");
  const symbol s_r("s_r");
  const PhaseField field({s_l, s_r});
  const symbol g_l("g_l");
  const symbol a("a");
  const symbol rest("R");
  const ex g_r = g_l + (s_r - s_l) * a;
  const auto decided = [&](const std::string& words, const ex& constant, const ex& m) {
    Comparison comparison(field);
    for (const std::size_t side : {0U, 1U}) {
      for (const int epsilon : signs) {
        const Banks banks(field, side, epsilon, side == 0 ? ex(g_l) : g_r);
        const std::string name = with_sign(side == 0 ? "left" : "right", epsilon);
        const ex plus = m + banks.i * constant;
        const ex minus = m - banks.i * constant;
        comparison.equal(name + ": one function", banks.jump(plus, minus), 0)
            .equal(name + ": t",
                   banks.traction(plus - banks.modulus * banks.u_plus * rest,
                                  minus - banks.modulus * banks.u_minus * rest),
                   a + epsilon * banks.friction.cos * banks.modulus * rest);
      }
    }
    return comparison.as(words);
  };
  return {
      "rh-structure-jump",
      decided("at a friction jump t = a + epsilon cos(pi alpha) |Y| R, [s] a = D, with one R on both banks and both "
              "sides",
              a, g_l - s_l * a),
      {decided("[s] taken from right to left", -a, g_l + s_l * a),
       decided("D for D/[s]", g_r - g_l, g_l - s_l * (g_r - g_l)), decided("without the constant", 0, g_l),
       decided("m of the other side", a, g_r - s_l * a), decided("m without s a", a, g_l)}};
}

/// At a wedge under one friction F_0+- = g_l + D (w+- log(z-c) + v+-), w = (-s + i)/(pi (1+s^2)), v = (1 + i s)/(1+s^2).
DecidedStatement structure_wedge() {
  const symbol s("s");
  const PhaseField field({s});
  const symbol g_l("g_l");
  const symbol d("D");
  const symbol rest("R");
  const symbol pi("pi");
  const symbol logarithm("L");
  const ex i = field.i();
  const auto decided = [&](const std::string& words, const ex& w_real, const ex& w_imaginary, const ex& v_real,
                           const ex& v_imaginary) {
    Comparison comparison(field);
    for (const std::size_t side : {0U, 1U}) {
      for (const int epsilon : signs) {
        const Banks banks(field, 0, epsilon, side == 0 ? ex(g_l) : g_l + d);
        const std::string name = with_sign(side == 0 ? "left" : "right", epsilon);
        const ex argument = side == 0 ? ex(pi) : ex(0);
        const ex plus = g_l + d * ((w_real + i * w_imaginary) * (logarithm + i * argument) + v_real + i * v_imaginary);
        const ex minus = g_l + d * ((w_real - i * w_imaginary) * (logarithm - i * argument) + v_real - i * v_imaginary);
        const ex heaviside = side == 0 ? ex(0) : s;
        comparison.equal(name + ": one function", banks.jump(plus, minus), 0)
            .equal(
                name + ": t",
                banks.traction(plus - banks.modulus * banks.u_plus * rest,
                               minus - banks.modulus * banks.u_minus * rest),
                d / (1 + s * s) * (logarithm / pi + heaviside) + epsilon * banks.friction.cos * banks.modulus * rest);
      }
    }
    return comparison.as(words);
  };
  const ex one = 1 / (1 + s * s);
  const ex w = one / pi;
  return {
      "rh-structure-wedge",
      decided("at a wedge t = D/(1+s^2) (log|x-c|/pi + s H(x-c)) + epsilon cos(pi alpha) |Y| R with one R on both "
              "banks and both sides",
              -s * w, w, one, s * one),
      {decided("pi missing", -s * one, one, one, s * one),
       decided("Heaviside's function on the left", s * w, w, one, 0),
       decided("the sign of the logarithm", s * w, -w, one, s * one),
       decided("without 1/(1+s^2)", -s / pi, 1 / ex(pi), 1, s), decided("without the logarithm", 0, 0, one, s * one)}};
}

/// Beyond an end u' - g = -Y R, in the contact t = epsilon cos |Y| R: from one to the other by the phase of the power.
DecidedStatement structure_outside() {
  const PhaseField field({symbol("s")});
  const symbol theta("theta");
  struct End {
    PointKind kind;
    bool left;
    int sign;
  };
  const std::vector<End> ends{{PointKind::left_edge, true, -1},
                              {PointKind::right_edge, false, 1},
                              {PointKind::left_free, true, 1},
                              {PointKind::right_free, false, -1}};
  const auto decided = [&](const std::string& words, const std::vector<int>& factor, bool root, bool exchanged) {
    Comparison comparison(field);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const End& end = ends[exchanged ? k ^ 1U : k];
      for (const int epsilon : signs) {
        const Banks banks(field, 0, epsilon, 0);
        const ex rest = -theta / (epsilon * banks.friction.cos);  // t = -theta |Y|
        const AngleForm power = derived_exponent(end.kind).renamed({0, 0});
        const ex beyond = banks.modulus * banks.u_plus * field.phase(power, end.left ? 1 : -1);
        comparison.equal(with_sign("u' - g", epsilon), -beyond * rest,
                         factor[k] * ends[k].sign * theta * banks.modulus * (root ? banks.friction.r : ex(1)));
      }
    }
    return comparison.as(words);
  };
  return {
      "rh-structure-outside",
      decided("beyond an end u' - g = -+theta sqrt(1+s^2) |Y| at a left and a right edge, the other sign at free ends, "
              "where t = -theta |Y| in the contact",
              {1, 1, 1, 1}, true, false),
      {decided("without sqrt(1+s^2)", {1, 1, 1, 1}, false, false),
       decided("the other sign", {-1, -1, -1, -1}, true, false),
       decided("one sign for edges and free ends", {1, 1, -1, -1}, true, false),
       decided("left and right exchanged", {1, 1, 1, 1}, true, true)}};
}

}  // namespace

void add_structure(std::vector<DecidedStatement>& all) {
  all.push_back(structure_panel());
  all.push_back(structure_jump());
  all.push_back(structure_wedge());
  all.push_back(structure_outside());
}

}  // namespace steadyslide::symbolic
