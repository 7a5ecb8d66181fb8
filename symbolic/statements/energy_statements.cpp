// The energy of a traction t of zero mean, with T(x) = int_{-1}^x t and friction s_0, s_1, ... between jumps c_k:
//
//   b(t, t) = -(1/pi) <t*log|x|, t> + <int_{-1}^x s t, t> = -(1/pi) <t*log|x|, t> + 1/2 sum_k (s_k - s_{k-1}) T(c_k)^2.
//
// By parts <int s t, t> = -int s t T, and t T = (T^2)'/2: nothing is left but the jumps of s. Decided exactly for
// families of t with symbolic coefficients and jump places: piecewise polynomials, and polynomials over sqrt(1-x^2),
// for which the logarithmic form is (pi/2) sum a_n^2/n. [Bal16, section 3.1]

#include "symbolic/statements/contact_symbols.hpp"
#include "symbolic/statements/polynomial_families.hpp"
#include "symbolic/statements/written_statements.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view energy_txt;
}

namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// [-1, 1] cut at symbolic jumps, a symbolic friction on each panel.
struct Panels {
  explicit Panels(std::size_t jumps) : s(symbols("s", jumps + 1)) {
    cuts.push_back(-1);
    for (const ex& c : symbols("c", jumps)) cuts.push_back(c);
    cuts.push_back(1);
  }
  std::size_t count() const { return s.size(); }
  symbol x{"x"};
  std::vector<ex> s;
  std::vector<ex> cuts;  // -1, c_0, c_1, ..., 1
  PhaseField field;
};

/// T on each panel, continuous, T(-1) = 0 and, if the mean is zero, T(1) = 0.
std::vector<ex> primitives(const Panels& panels, const std::string& name, int degree, bool zero_mean) {
  const ex x = panels.x;
  ex polynomial = 0;
  for (const ex& b : symbols(name, static_cast<std::size_t>(degree) + 1)) polynomial = polynomial * x + b;
  std::vector<ex> result{(1 - x * x) * polynomial + (zero_mean ? ex(0) : (1 + x) * symbol(name + "_mean"))};
  const std::vector<ex> kinks = symbols(name + "_kink", panels.count());
  for (std::size_t k = 1; k < panels.count(); ++k) {
    result.push_back(result.back() + kinks[k] * (x - panels.cuts[k]) * (x - 1));
  }
  return result;
}

/// <int_{-1}^x s t_1, t_2> as it is written: the inner integral first, then the outer one.
ex friction_form(const Panels& panels, const std::vector<ex>& first, const std::vector<ex>& second) {
  const symbol& x = panels.x;
  ex sum = 0;
  ex inner = 0;  // its value at the panel's left end
  for (std::size_t k = 0; k < panels.count(); ++k) {
    const ex density = first[k].diff(x) * panels.s[k];
    const ex primitive = antiderivative(density, x);
    const ex inside = inner + primitive - primitive.subs(x == panels.cuts[k]);
    sum += integral(inside * second[k].diff(x), x, panels.cuts[k], panels.cuts[k + 1]);
    inner = inside.subs(x == panels.cuts[k + 1]);
  }
  return sum;
}

struct EnergyVariant {
  ex factor = ex(1) / 2;
  int before = -1;  // sign of s_{k-1}
  int power = 2;
  bool zero_mean = true;
};

/// factor * sum (s_k + before s_{k-1}) T(c_k)^power
ex jump_terms(const Panels& panels, const std::vector<ex>& primitive, const EnergyVariant& variant) {
  ex sum = 0;
  for (std::size_t k = 1; k < panels.count(); ++k) {
    const ex value = primitive[k].subs(panels.x == panels.cuts[k]);
    sum += (panels.s[k] + variant.before * panels.s[k - 1]) * GiNaC::pow(value, variant.power);
  }
  return variant.factor * sum;
}

DecidedStatement piecewise() {
  const auto decided = [](const std::string& words, const EnergyVariant& variant) {
    const Panels panels(2);
    const std::vector<ex> t = primitives(panels, "b", 2, variant.zero_mean);
    return Comparison(panels.field)
        .equal("<int s t, t>", friction_form(panels, t, t), jump_terms(panels, t, variant))
        .as(words);
  };
  return {
      "energy-piecewise-polynomial",
      decided("<int s t, t> = 1/2 sum (s_k - s_(k-1)) T(c_k)^2: two jumps, t piecewise polynomial of zero mean", {}),
      {decided("without 1/2", {.factor = 1}), decided("jumps of the other sign", {.factor = ex(-1) / 2}),
       decided("the sum for the difference", {.before = 1}), decided("T for T^2", {.power = 1}),
       decided("a mean that is not zero", {.zero_mean = false})}};
}

DecidedStatement bilinear() {
  enum class Form { sum, difference, one };
  const auto decided = [](const std::string& words, const ex& factor, int before, Form form) {
    const Panels panels(2);
    const std::vector<ex> t = primitives(panels, "b", 1, true);
    const std::vector<ex> u = primitives(panels, "d", 1, true);
    ex jumps = 0;
    for (std::size_t k = 1; k < panels.count(); ++k) {
      jumps += (panels.s[k] + before * panels.s[k - 1]) * (t[k] * u[k]).subs(panels.x == panels.cuts[k]);
    }
    const int sign = form == Form::sum ? 1 : form == Form::difference ? -1 : 0;
    return Comparison(panels.field)
        .equal("sum of both orders", friction_form(panels, t, u) + sign * friction_form(panels, u, t), factor * jumps)
        .as(words);
  };
  return {"energy-bilinear",
          decided("<int s t, u> + <int s u, t> = sum (s_k - s_(k-1)) T(c_k) U(c_k)", 1, -1, Form::sum),
          {decided("1/2 of it", ex(1) / 2, -1, Form::sum), decided("the other sign", -1, -1, Form::sum),
           decided("the sum for the difference", 1, 1, Form::sum),
           decided("the difference of both orders", 1, -1, Form::difference), decided("one order", 1, -1, Form::one)}};
}

DecidedStatement skew() {
  const auto decided = [](const std::string& words, bool zero_mean, bool one_friction, int order) {
    const Panels two(2);
    Panels panels(2);
    if (one_friction) panels.s = {two.s[0], two.s[0], two.s[0]};
    const std::vector<ex> t = primitives(panels, "b", 2, zero_mean);
    ex sum = 0;
    for (std::size_t k = 0; k < panels.count(); ++k) {
      const ex other = order == 0 ? t[k] : t[k].diff(panels.x);
      const ex left = order == 2 ? t[k] * t[k].diff(panels.x) : t[k].diff(panels.x);
      sum += integral(panels.s[k] * left * other, panels.x, panels.cuts[k], panels.cuts[k + 1]);
    }
    return Comparison(panels.field).equal("int s t T", sum, 0).as(words);
  };
  return {"energy-skew",
          decided("int s t T = 0 for one friction and zero mean", true, true, 0),
          {decided("a mean that is not zero", false, true, 0), decided("frictions that jump", true, false, 0),
           decided("int s t t", true, true, 1), decided("int s t^2 T", true, true, 2)}};
}

constexpr int most = 5;  // terms of the Chebyshev family

/// T = -sqrt(1-x^2) sum a_n U_{n-1}/n for t = sum a_n T_n/sqrt(1-x^2).
DecidedStatement primitive() {
  const auto decided = [](const std::string& words, const auto& t, const auto& factor) {
    const symbol x("x");
    const PhaseField field;
    Comparison comparison(field);
    for (int n = 1; n <= most; ++n) {
      // sqrt(1-x^2) d/dx (sqrt(1-x^2) u) = (1-x^2) u' - x u
      const ex u = factor(n) * chebyshev_u(n - 1, x);
      comparison.equal("n = " + std::to_string(n), (1 - x * x) * u.diff(x) - x * u, t(n, x));
    }
    return comparison.as(words);
  };
  const auto first = [](int n, const ex& x) { return chebyshev_t(n, x); };
  return {
      "energy-chebyshev-primitive",
      decided("-sqrt(1-x^2) U_(n-1)/n is the primitive of T_n/sqrt(1-x^2), n = 1..5", first,
              [](int n) { return ex(-1) / n; }),
      {decided("the other sign", first, [](int n) { return ex(1) / n; }),
       decided("without 1/n", first, [](int) { return ex(-1); }),
       decided(
           "of T_(n+1)", [](int n, const ex& x) { return chebyshev_t(n + 1, x); }, [](int n) { return ex(-1) / n; }),
       decided(
           "of U_n", [](int n, const ex& x) { return chebyshev_u(n, x); }, [](int n) { return ex(-1) / n; })}};
}

/// -int s t T, t T a polynomial, against the jumps of s with T(c)^2 = (1-c^2) (sum a_n U_{n-1}(c)/n)^2.
DecidedStatement weighted() {
  const auto decided = [](const std::string& words, const EnergyVariant& variant, bool with_weight) {
    const Panels panels(3);
    const symbol& x = panels.x;
    ex numerator = 0;
    ex u = 0;
    const std::vector<ex> a = symbols("a", most + 1);
    for (int n = 1; n <= most; ++n) {
      numerator += a[static_cast<std::size_t>(n)] * chebyshev_t(n, x);
      u += a[static_cast<std::size_t>(n)] * chebyshev_u(n - 1, x) / n;
    }
    ex form = 0;
    ex jumps = 0;
    for (std::size_t k = 0; k < panels.count(); ++k) {
      form += panels.s[k] * integral(numerator * u, x, panels.cuts[k], panels.cuts[k + 1]);
      if (k == 0) continue;
      const ex value = (with_weight ? 1 - x * x : ex(1)) * GiNaC::pow(u, variant.power);
      jumps += (panels.s[k] + variant.before * panels.s[k - 1]) * value.subs(x == panels.cuts[k]);
    }
    return Comparison(panels.field).equal("<int s t, t>", form, variant.factor * jumps).as(words);
  };
  return {
      "energy-chebyshev-friction",
      decided("<int s t, t> = 1/2 sum (s_k - s_(k-1)) T(c_k)^2: three jumps, t = sum a_n T_n/sqrt(1-x^2)", {}, true),
      {decided("without 1/2", {.factor = 1}, true), decided("jumps of the other sign", {.factor = ex(-1) / 2}, true),
       decided("the sum for the difference", {.before = 1}, true), decided("T for T^2", {.power = 1}, true),
       decided("without 1-c^2", {}, false)}};
}

/// u = -(1/pi) int log|x-y| t(y) dy has u' = (1/pi) PV int t/(y-x) dy, so u = sum a_n T_n/n + constant.
DecidedStatement logarithmic() {
  const auto decided = [](const std::string& words, const auto& diagonal) {
    const symbol x("x");
    const PhaseField field;
    Comparison comparison(field);
    const std::vector<ex> powers{ex(-1) / 2, ex(-1) / 2};
    const std::vector<ex> a = symbols("a", most + 1);
    ex potential = 0;
    ex numerator = 0;
    for (int n = 1; n <= most; ++n) {
      // U_{n-1} as psi' of a contact without friction: the traction it gives is T_n/sqrt(1-x^2).
      std::vector<ex> slope;
      const ex u = chebyshev_u(n - 1, x);
      for (int k = 0; k < n; ++k) slope.push_back(u.coeff(x, k));
      const std::vector<ex> sums = power_sums(powers, {-1, 1}, PolynomialSlope::sums_needed(-1, slope.size()));
      comparison.equal("t of U_" + std::to_string(n - 1), PolynomialSlope(-1, slope, sums, 0).factor(x),
                       chebyshev_t(n, x));
      potential += a[static_cast<std::size_t>(n)] * antiderivative(u, x);
      numerator += a[static_cast<std::size_t>(n)] * chebyshev_t(n, x);
    }
    // int x^m/sqrt(1-x^2) dx = pi g_m, the series of z/sqrt(z^2-1) at infinity. Constants of u do not count: the mean
    // of t is zero.
    const std::vector<ex> moments = series_at_infinity(power_sums(powers, {-1, 1}, 2 * most + 1), -1, 2 * most + 1);
    const auto mean = [&](const ex& polynomial) {
      const ex expanded = polynomial.expand();
      ex sum = 0;
      for (int m = 0; m <= expanded.degree(x); ++m) sum += expanded.coeff(x, m) * moments[static_cast<std::size_t>(m)];
      return sum;
    };
    ex expected = 0;
    for (int n = 1; n <= most; ++n) expected += diagonal(n) * GiNaC::pow(a[static_cast<std::size_t>(n)], 2);
    return comparison.equal("mean of t", mean(numerator), 0)
        .equal("form/pi", mean(potential * numerator), expected)
        .as(words);
  };
  return {"energy-logarithmic-form",
          decided("-(1/pi) <t*log|x|, t> = (pi/2) sum a_n^2/n for t = sum a_n T_n/sqrt(1-x^2), n = 1..5",
                  [](int n) { return ex(1) / (2 * n); }),
          {decided("pi sum a_n^2/n", [](int n) { return ex(1) / n; }),
           decided("the other sign", [](int n) { return ex(-1) / (2 * n); }),
           decided("(pi/2) sum a_n^2/n^2", [](int n) { return ex(1) / (2 * n * n); }),
           decided("(pi/2) sum n a_n^2", [](int n) { return ex(n) / 2; }),
           decided("(pi/2) sum a_n^2", [](int) { return ex(1) / 2; })}};
}

}  // namespace

std::vector<DecidedStatement> energy_statements() {
  return written_statements(embedded::energy_txt,
                            {piecewise(), bilinear(), skew(), primitive(), weighted(), logarithmic()});
}

}  // namespace steadyslide::symbolic
