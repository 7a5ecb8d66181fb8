#include "app/results/exponent_text.hpp"

#include "app/results/number_format.hpp"
#include "symbolic/field/exponent_expression.hpp"

namespace steadyslide::app {

std::string format_exponent(const Exponent& exponent, int digits) {
  // Both types hold more digits than they serve.
  return digits <= 50 ? format_number(numeric::to_real<numeric::Real50>(exponent), digits)
                      : format_number(numeric::to_real<numeric::Real100>(exponent), digits);
}

ExponentText exponent_text(const std::optional<Exponent>& exponent, int digits) {
  if (!exponent) return {"log", "log", "\\log"};
  return {format_exponent(*exponent, digits), to_string(*exponent), symbolic::latex(*exponent)};
}

}  // namespace steadyslide::app
