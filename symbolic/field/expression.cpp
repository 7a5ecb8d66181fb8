#include "symbolic/field/expression.hpp"

#include <sstream>
#include <stdexcept>

namespace steadyslide::symbolic {

GiNaC::numeric to_expression(const Rational& value) {
  const GiNaC::numeric numerator(boost::multiprecision::numerator(value).str().c_str());
  const GiNaC::numeric denominator(boost::multiprecision::denominator(value).str().c_str());
  return numerator / denominator;
}

Rational to_rational(const GiNaC::numeric& value) {
  std::ostringstream numerator;
  std::ostringstream denominator;
  if (!value.is_rational()) {
    numerator << value;
    throw std::domain_error("to_rational: the number is rational; " + numerator.str());
  }
  numerator << value.numer();
  denominator << value.denom();
  return Rational(Integer(numerator.str()), Integer(denominator.str()));
}

std::vector<GiNaC::ex> symbols(const std::string& name, std::size_t count, std::size_t first) {
  std::vector<GiNaC::ex> result;
  for (std::size_t k = first; k < first + count; ++k)
    result.emplace_back(GiNaC::symbol(name + "_" + std::to_string(k)));
  return result;
}

}  // namespace steadyslide::symbolic
