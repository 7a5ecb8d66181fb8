#include "symbolic/cln/cln_layer.hpp"

#include <stdexcept>

#include "symbolic/cln/cln_number.hpp"
#include "symbolic/cln/layer_formulas.hpp"

namespace steadyslide::symbolic {

ClnLayerSymbols cln_layer_symbols(const Layer& layer, const std::optional<Solid>& base, Plane plane, const Rational& k,
                                  int digits) {
  if (k <= 0 || digits < 1) throw std::domain_error("CLN evaluation of a layer: k > 0, at least one digit");
  const Rational kappa = layer.solid.kolosov(plane);
  Rational K = -1 / kappa;
  Rational L = -kappa;
  Rational rho = 1;
  if (base) {
    const Rational kappa_b = base->kolosov(plane);
    const Rational n = base->shear_modulus() / layer.solid.shear_modulus();
    const Rational m = (kappa_b + 1) / (n * (kappa + 1));
    K = (1 - n) / (1 + n * kappa);
    L = (kappa_b - n * kappa) / (kappa_b + n);
    rho = (1 - m) / (1 + m);
  }
  // Numerator and denominator cancel like the fourth power of xi at most, and times the contrast of the solids.
  const Rational exact_xi = k * layer.thickness;
  int lost = 0;
  for (Rational small = exact_xi; small < 1; small *= 10) lost += 4;
  const cln::float_format_t format = cln_format(2 * digits + lost + cln_guard_digits);
  const auto number = [&](const Rational& value) { return cln::cl_R(to_cln(value, format)); };
  const cln::cl_R xi = number(exact_xi);
  const cln::cl_R e = cln::exp(-2 * xi);
  const auto formula =
      layer.below == Interface::bonded ? bonded_layer(number(K), number(L), xi, e) : slipping_layer(number(rho), xi, e);
  const auto decimal = [&](const cln::cl_R& value) { return rounded(from_cln(cln::cl_float(value, format)), digits); };
  return {decimal(formula.normal), decimal(number((kappa - 1) / (kappa + 1)) - formula.coupling_defect)};
}

}  // namespace steadyslide::symbolic
