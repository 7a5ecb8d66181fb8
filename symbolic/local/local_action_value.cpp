#include "symbolic/local/local_action_value.hpp"

#include <ginac/ginac.h>

#include <stdexcept>

#include "symbolic/cln/cln_number.hpp"
#include "symbolic/field/expression.hpp"
#include "symbolic/local/local_action.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

void require(bool condition, const char* what) {
  if (!condition) throw std::domain_error(std::string("local action: ") + what);
}

/// Returns a float with its own precision; GiNaC's global number of digits does not change.
numeric number(const cln::cl_F& value) { return numeric(cln::cl_N(value)); }

struct Values {
  LocalConstants constants;
  numeric power;      ///< |x|^lambda
  numeric logarithm;  ///< log|x|
};

Values values_at(const LocalAction& action, const Rational& x, cln::float_format_t format) {
  const cln::cl_F pi = cln::pi(format);
  const cln::cl_F distance = to_cln(abs(x), format);
  const cln::cl_F logarithm = cln::ln(distance);
  Values values{{0, 0, number(pi)}, numeric(1), number(logarithm)};
  if (action.fractional) {
    const cln::cl_F lambda = to_cln(action.lambda, format);
    const cln::cl_F angle = pi * lambda;
    values.constants.cot = number(cln::cos(angle) / cln::sin(angle));
    values.constants.cosecant = number(cln::cl_float(1, format) / cln::sin(angle));
    values.power = number(cln::exp(lambda * logarithm));
  }
  return values;
}

}  // namespace

Decimal local_action_value(const LocalAction& action, const Rational& x, int digits, std::optional<WrongSymbol> wrong) {
  require(digits >= 1, "at least one digit");
  require(x != 0 && 4 * abs(x) <= 1, "0 < |x| <= 1/4");
  if (action.fractional) {
    require(action.lambda > -1 && boost::multiprecision::denominator(action.lambda) != 1, "lambda > -1 and no integer");
  }
  const Values values = values_at(action, x, cln_format(digits + cln_guard_digits));
  LocalConstants constants = values.constants;
  if (wrong == WrongSymbol::cotangent_sign) constants.cot = -constants.cot;
  if (wrong == WrongSymbol::cosecant_sign) constants.cosecant = -constants.cosecant;
  if (wrong == WrongSymbol::pi_missing) constants.pi = 1;
  const LocalMonomial monomial{action.side, action.fractional, action.order, action.logs};

  Side side = x < 0 ? Side::left : Side::right;
  if (wrong == WrongSymbol::sides_exchanged) side = opposite(side);
  ex sum = 0;
  for (const auto& [term, coefficient] : act({{monomial, 1}}, constants)) {
    if (term.side != side) continue;
    const ex whole = GiNaC::pow(to_expression(x), term.order) * GiNaC::pow(values.logarithm, term.logs);
    sum += coefficient * whole * (term.fractional ? ex(values.power) : ex(1));
  }
  // 4^-terms < 10^-digits. The far part is 1/pi times a rational number.
  const int terms = 2 * (digits + cln_guard_digits);
  const ex far = far_part(monomial, to_expression(action.lambda), to_expression(x), terms);
  sum += far.subs(GiNaC::Pi == values.constants.pi);
  const ex result = sum.expand();
  require(GiNaC::is_a<numeric>(result), "not a number");
  return rounded(from_cln(cln::the<cln::cl_F>(GiNaC::ex_to<numeric>(result).to_cl_N())), digits);
}

}  // namespace steadyslide::symbolic
