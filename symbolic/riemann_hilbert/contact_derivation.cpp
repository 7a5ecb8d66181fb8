#include "symbolic/riemann_hilbert/contact_derivation.hpp"

#include <stdexcept>

#include "symbolic/field/rational_function.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

std::string number(std::size_t k) { return std::to_string(k); }

Formula formula_of(const AngleForm& form) {
  return symbolic::formula_of(form, [](std::size_t k) {
    return Formula{"alpha_" + number(k), "\\alpha_{" + number(k) + "}"};
  });
}

std::string kind_in_words(PointKind kind) {
  switch (kind) {
    case PointKind::left_edge: return "left edge: `t` may be infinite but is integrable, `-1 < p < 0`";
    case PointKind::left_free: return "free left end: `t` vanishes, `0 < p < 1`";
    case PointKind::jump: return "friction jump inside the contact: `p` vanishes with the jump";
    case PointKind::right_edge: return "right edge: `t` may be infinite but is integrable, `-1 < p < 0`";
    case PointKind::right_free: return "free right end: `t` vanishes, `0 < p < 1`";
  }
  return "";
}

class ContactDeriver {
 public:
  explicit ContactDeriver(const DerivationInput& input) : input_(input), field_(input.frictions) {
    for (std::size_t k = 1; k <= most_sums; ++k) names_["sigma_" + number(k)] = "\\sigma_{" + number(k) + "}";
    names_["pi"] = "\\pi";
  }

  Derivation derive() {
    data();
    relation();
    exponents();
    panels();
    polynomial();
    traction();
    return derivation_;
  }

 private:
  static constexpr std::size_t most_sums = 12;

  Formula of(const ex& expression) const {
    const std::string text = canonical_text(expression);
    return {product(text, {}, names_).text, latex_of(text, names_)};
  }
  static Formula equation(const Formula& left, const Formula& right) {
    return {left.text + " = " + right.text, left.latex + " = " + right.latex};
  }
  static Formula indexed(const std::string& name, const std::string& latex, std::size_t k) {
    return {name + "_" + number(k), latex + "_{" + number(k) + "}"};
  }
  Formula polynomial_of(const std::vector<ex>& coefficients) const {
    Formula result;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      if (coefficients[k].is_zero()) continue;
      const Formula power = k == 0   ? Formula{}
                            : k == 1 ? Formula{"x", "x"}
                                     : Formula{"x^" + number(k), "x^{" + number(k) + "}"};
      result = sum(result, product(canonical_text(coefficients[k]), power, names_));
    }
    return result.text.empty() ? Formula{"0", "0"} : result;
  }

  void data() {
    const auto& points = input_.solution.points();
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Formula name = indexed("e", "e", j);
      const bool known = input_.places[j].text != name.text;
      const std::string words = points[j].kind == PointKind::jump ? "A friction jump"
                                : is_free(points[j].kind)         ? "A free end of the contact"
                                                                  : "An end of the contact at an edge of the indenter";
      derivation_.assume(words + ".", known ? equation(name, input_.places[j]) : name);
    }
    for (std::size_t k = 0; k < input_.frictions.size(); ++k) {
      const Formula name = indexed("s", "s", k);
      const Formula angle{"alpha_" + number(k) + " = arctan(" + name.text + ")/pi",
                          "\\alpha_{" + number(k) + "} = \\tfrac{1}{\\pi}\\arctan " + name.latex};
      const Formula value = equation(name, of(input_.frictions[k]));
      derivation_.assume("Friction on panel " + number(k) + ", and its angle.",
                         {value.text + ", " + angle.text, value.latex + ",\\quad " + angle.latex});
    }
    derivation_.assume("The slope of the profile, divided by the compliance, is one polynomial on the contact.",
                       equation({"psi_bar'", "\\bar\\psi'"}, polynomial_of(input_.slope)));
    derivation_.assume("The surface equation on the contact.",
                       {"(1/pi) PV int t(x')/(x'-x) dx' + s t = psi_bar'",
                        "\\frac{1}{\\pi}\\,\\mathrm{PV}\\!\\int \\frac{t(x')}{x'-x}\\,dx' + s\\,t = \\bar\\psi'"});
  }

  void relation() {
    derivation_.act("Write it with the Cauchy integral's limits on both sides of the line (Plemelj).",
                    {"t = Phi+ - Phi-,  (1/pi) PV int t/(x'-x) dx' = i (Phi+ + Phi-)",
                     "t = \\Phi^+-\\Phi^-,\\quad \\frac{1}{\\pi}\\,\\mathrm{PV}\\!\\int\\frac{t}{x'-x}\\,dx' = "
                     "i(\\Phi^++\\Phi^-)"});
    const GiNaC::symbol s("s");
    const PhaseField one({s});
    const JumpRelation solved = jump_relation(s, one.i());
    Comparison angle(one);
    angle.equal("G", solved.ratio, one.phase({2, {{0, 2}}}));
    if (!angle.holds()) throw std::logic_error("contact derivation: G = -exp(2 pi i alpha)");
    const Formula g = of(solved.ratio);
    const Formula source = of(solved.source);
    derivation_.conclude("Solved for `Phi+`; with `s = tan(pi alpha)`, `G` is a phase.",
                         {"Phi+ = G Phi- + psi_bar' " + source.text + ",  G = " + g.text + " = -e^(2 pi i alpha)",
                          "\\Phi^+ = G\\,\\Phi^- + " + source.latex + "\\,\\bar\\psi',\\quad G = " + g.latex +
                              " = -e^{2\\pi i\\alpha}"});
  }

  void exponents() {
    derivation_.act(
        "Seek `Y` with `Y+ = G Y-` on the contact and `Y+ = Y-` off it. On the line its limits are phases, and "
        "crossing a point multiplies `Y+/Y-` by a known quotient: that leaves the exponent up to an integer.",
        {"Y(z) = prod (z - e_j)^p_j,  Y+- = |Y| e^(+-i pi sigma),  sigma(x) = sum of the p_j with e_j > x",
         "Y(z) = \\prod_j (z-e_j)^{p_j},\\quad Y^\\pm = |Y|\\,e^{\\pm i\\pi\\sigma},\\quad \\sigma(x) = \\sum_{e_j>x} "
         "p_j"});
    const auto& points = input_.solution.points();
    for (std::size_t j = 0; j < points.size(); ++j) {
      derivation_.conclude("At `e_" + number(j) + "`, a " + kind_in_words(points[j].kind) + ".",
                           equation(indexed("p", "p", j), formula_of(points[j].power)));
    }
  }

  void panels() {
    Comparison all(field_);
    input_.solution.compare(all, field_);
    if (!all.holds()) throw std::logic_error("contact derivation: Y+ = G Y- on every panel");
    for (const auto& region : input_.solution.regions()) {
      if (!region.friction) continue;
      const std::string k = number(*region.friction);
      const Formula sigma = formula_of(region.sigma);
      derivation_.conclude(
          "On panel " + k + " `Y+/Y-` is `G`: decided in the field of the friction angles.",
          {"sigma = " + sigma.text + ",  e^(2 pi i sigma) = -e^(2 pi i alpha_" + k + ")",
           "\\sigma = " + sigma.latex + ",\\quad e^{2\\pi i\\sigma} = -e^{2\\pi i\\alpha_{" + k + "}}"});
      epsilon_ = input_.solution.sign_on(field_, region);
    }
    derivation_.conclude("The exponents sum to the number of free ends less that of components.",
                         {"S = " + std::to_string(input_.solution.order()),
                          "S = \\sum_j p_j = " + std::to_string(input_.solution.order())});
    const std::string sign = epsilon_ > 0 ? "" : "-";
    derivation_.conclude(
        "On the contact `(s+i) Y+` is real and of one sign.",
        {"(s+i) Y+ = " + sign + "|Y|/cos(pi alpha)", "(s+i)\\,Y^+ = " + sign + "\\frac{|Y|}{\\cos\\pi\\alpha}"});
  }

  void polynomial() {
    const int order = input_.solution.order();
    derivation_.act(
        "Seek `F = 2i Phi = psi_bar' - Y N` with a polynomial `N`: then `A t = psi_bar'` on every panel, and `N` is "
        "the polynomial part of `psi_bar'/Y` at infinity, with what the load asks for.",
        {"Y = z^S exp(-sum_k sigma_k/(k z^k)),  sigma_k = sum_j p_j e_j^k,  F = P/(pi z) + O(1/z^2)",
         "Y = z^{S}\\exp\\Bigl(-\\sum_k \\frac{\\sigma_k}{k z^k}\\Bigr),\\quad \\sigma_k = \\sum_j p_j e_j^k,\\quad F "
         "= \\frac{P}{\\pi z} + O(z^{-2})"});
    const std::size_t needed = PolynomialSlope::sums_needed(order, input_.slope.size());
    if (needed > most_sums) throw std::domain_error("contact derivation: a profile of a smaller degree");
    const std::vector<ex> sums = power_sum_symbols(needed);
    const PolynomialSlope solution(order, input_.slope, sums, input_.load_over_pi);
    if (solution.factor().empty()) throw std::domain_error("contact derivation: no traction, N = 0");
    factor_ = polynomial_of(solution.factor());
    check(solution, sums);
    derivation_.conclude("The polynomial factor.", equation({"N", "N"}, factor_));
    for (const ex& condition : solution.conditions()) {
      derivation_.conclude("The order of `F` at infinity asks for this; it places the free ends.",
                           equation(of(condition), {"0", "0"}));
    }
  }

  /// Checks F = P/(pi z) + O(1/z^2) under the conditions.
  void check(const PolynomialSlope& solution, const std::vector<ex>& sums) const {
    const int order = solution.order();
    const std::vector<ex> series = series_at_infinity(sums, -1, sums.size());
    for (int power = static_cast<int>(input_.slope.size()) - 1; power >= -1; --power) {
      ex expected = power == -1 ? input_.load_over_pi : ex(0);
      for (int k = 0; k < static_cast<int>(solution.conditions().size()) && k + 1 <= order - power; ++k) {
        expected += solution.conditions()[static_cast<std::size_t>(k)] *
                    series.at(static_cast<std::size_t>(order - power - k - 1));
      }
      const ex value = field_coefficient(order, input_.slope, solution.factor(), series, power);
      if (!field_.are_equal(value, expected).holds) throw std::logic_error("contact derivation: F at infinity");
    }
  }

  void traction() {
    const std::string sign = epsilon_ > 0 ? "" : "-";
    Formula modulus;
    const auto& points = input_.solution.points();
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Formula p = formula_of(points[j].power);
      modulus.text += " |x - e_" + number(j) + "|^(" + p.text + ")";
      modulus.latex += "\\,|x-e_{" + number(j) + "}|^{" + p.latex + "}";
    }
    // A factor with several terms gets a name and its own line above.
    const bool is_sum = factor_.text.find(' ') != std::string::npos;
    const Formula factor = is_sum ? Formula{"N", "N"} : factor_;
    const bool minus = factor.text[0] == '-';
    derivation_.conclude("The traction is `t = (F+ - F-)/(2i)`.",
                         {"t = " + sign + "cos(pi alpha)" + modulus.text + (is_sum ? " N" : " (" + factor.text + ")"),
                          "t = " + sign + "\\cos(\\pi\\alpha)" + modulus.latex + "\\," +
                              (minus ? "\\left(" + factor.latex + "\\right)" : factor.latex)});
  }

  const DerivationInput& input_;
  PhaseField field_;
  LatexNames names_;
  Derivation derivation_;
  Formula factor_;
  int epsilon_ = 0;
};

}  // namespace

Derivation derive(const DerivationInput& input) { return ContactDeriver(input).derive(); }

}  // namespace steadyslide::symbolic
