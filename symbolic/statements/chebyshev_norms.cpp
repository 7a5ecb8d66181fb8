// Norms by Chebyshev's coefficients. For u = sum a_k T_k, x = cos(theta), Douglas' formula for the even function
// u(cos(theta)) on the circle is
//
//   sum k a_k^2 = (1/(4 pi^2)) int int (u-u')^2 (1/sin((theta-theta')/2)^2 + 1/sin((theta+theta')/2)^2) d theta d theta'
//
// over [0, pi]^2, and the sum of the two kernels is 4 (1 - x x')/(x-x')^2. Outside [-1, 1] u is continued by u(1/x),
// whose kernels are those inside, moved by x -> 1/x. [Bal16, section 3.1]

#include "symbolic/statements/cosines.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// Denominators 1 - cos(theta-+theta') = 2 sin((theta-+theta')/2)^2: their sum and their product.
DecidedStatement circle() {
  struct Variant {
    ex sum = 2;
    int sign = -1;  // 1 - x x'
    int power = 2;
    int weight = -1;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol x("x"), y("y"), p("p"), q("q");
    const PhaseField field;
    const auto squared = [&](const ex& f) {
      return f.expand().subs(GiNaC::lst{p * p == 1 - x * x, q * q == 1 - y * y}, GiNaC::subs_options::algebraic);
    };
    const ex minus = 1 - (x * y + p * q);
    const ex plus = 1 - (x * y - p * q);
    return Comparison(field)
        .equal("sum", minus + plus, v.sum * (1 + v.sign * x * y))
        .equal("product", squared(minus * plus), GiNaC::pow(x - y, v.power))
        .equal("(1-xx')^2 - sin^2 sin'^2", squared(GiNaC::pow(1 - x * y, 2) + v.weight * p * p * q * q),
               GiNaC::pow(x - y, 2))
        .as(words);
  };
  return {"chebyshev-circle",
          decided("the kernels of Douglas' formula add up to 4 (1-x x')/(x-x')^2, and (1-x x')^2 = (1-x^2)(1-x'^2) + "
                  "(x-x')^2",
                  {}),
          {decided("1 + x x'", {.sign = 1}), decided("1 - x x' for 2 (1 - x x')", {.sum = 1}),
           decided("(x-x')^4 below", {.power = 4}), decided("(x-x')^2 with the other sign", {.weight = 1})}};
}

/// y = 1/z, dy = dz/z^2 up to its sign.
DecidedStatement reflection() {
  struct Variant {
    int jacobian = 2;  // 1/z^2
    int between = -1;
    int outer = -1;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol x("x"), y("y");
    const PhaseField field;
    // Kernels (x - 1/x')^-2/x'^2 and (1/x - 1/x')^-2/(x x')^2, their reciprocals.
    const ex mixed = GiNaC::pow(x - 1 / y, 2) * GiNaC::pow(y, v.jacobian);
    const ex outside = GiNaC::pow(1 / x - 1 / y, 2) * GiNaC::pow(x * y, v.jacobian);
    return Comparison(field)
        .equal("inside and outside", mixed.normal(), GiNaC::pow(1 + v.between * x * y, 2))
        .equal("both outside", outside.normal(), GiNaC::pow(x - y, 2))
        .equal("excess", GiNaC::pow(1 - x * y, 2) - GiNaC::pow(x - y, 2), (1 - x * x) * (1 + v.outer * y * y))
        .as(words);
  };
  return {"chebyshev-reflection",
          decided("x -> 1/x takes the kernels outside to (1-x x')^-2 and (x-x')^-2, and (1-x x')^2 - (x-x')^2 = "
                  "(1-x^2)(1-x'^2)",
                  {}),
          {decided("without the factor 1/x'^2", {.jacobian = 0}), decided("1 + x x'", {.between = 1}),
           decided("(1-x^2)(1+x'^2)", {.outer = 1})}};
}

/// The sign form on all tractions: c_0 meets the odd k with 4/k^2. In units of the norm, (pi^2/(2k)) d_k^2 and
/// pi^2 log 2 c_0^2, this part has the square sum (4/k^2)^2 (2k/pi^2)/(pi^2 log 2) over odd k, and sum 1/k^3 there is
/// (1-1/8) zeta(3). With a bound 2m on the rest the whole is at most the larger root of r^2 = 2 m r + A^2.
DecidedStatement all_tractions() {
  struct Variant {
    ex cubes = ex(1) / 8;
    ex factor = 28;
    int root = 1;
  };
  const auto decided = [](const std::string& words, const Variant& v) {
    const symbol zeta("zeta3"), k("k"), m("m"), a("A"), r("r");
    const PhaseField field;
    const ex squared = GiNaC::pow(4 / (k * k), 2) * 2 * k;  // times pi^4 log 2
    const ex sum = (squared * GiNaC::pow(k, 3)).normal() * (1 - v.cubes) * zeta;
    const ex largest = m + v.root * r;
    const ex excess = (largest * largest - 2 * m * largest).expand().subs(r * r == m * m + a * a);
    return Comparison(field)
        .equal("pi^4 log 2 A^2", sum, v.factor * zeta)
        .equal("root", excess, a * a)
        .equal("the root that is positive", largest - m, r)
        .as(words);
  };
  return {"chebyshev-all-tractions",
          decided("A^2 = 28 zeta(3)/(pi^4 log 2), and m + sqrt(m^2+A^2) is the root r > 0 of r^2 = 2 m r + A^2", {}),
          {decided("sums over all k for odd k", {.cubes = 0}), decided("32 for 28", {.factor = 32}),
           decided("m - sqrt(m^2+A^2)", {.root = -1})}};
}

/// x = (L/2) cos(theta): log|x-x'| gains log(L/2), times <t,1> = pi c_0 in each argument.
DecidedStatement length() {
  const auto decided = [](const std::string& words, const ex& mean, int scale, int sign) {
    const symbol log2("log2"), length("logL"), pi("pi"), c("c"), d("d");
    const PhaseField field;
    const ex unit = pi * pi * log2 * c * d;
    return Comparison(field)
        .equal("c_0 d_0", unit - sign * (length - scale * log2) * (mean * pi * c) * (mean * pi * d),
               pi * pi * (2 * log2 - length) * c * d)
        .as(words);
  };
  return {
      "chebyshev-length",
      decided("pi^2 log 2 - pi^2 log(L/2) = pi^2 log(4/L) before c_0 d_0, nothing before the others", 1, 1, 1),
      {decided("log L for log(L/2)", 1, 0, 1), decided("<t,1> = 2 pi c_0", 2, 1, 1), decided("+log(L/2)", 1, 1, -1)}};
}

}  // namespace

void add_chebyshev_norms(std::vector<DecidedStatement>& all) {
  for (const auto& statement : {circle, reflection, all_tractions, length}) all.push_back(statement());
}

}  // namespace steadyslide::symbolic
