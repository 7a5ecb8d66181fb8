#include "symbolic/field/rational_function.hpp"

#include <map>
#include <numeric>
#include <stdexcept>

#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

void require_rational_function(const ex& expression) {
  if (!is_rational_function(expression)) {
    throw std::domain_error("rational function: only symbols, rational numbers, sums, products and integer powers");
  }
}

ex numerator_of(const ex& expression) { return expression.numer_denom().op(0).expand(); }

void require_no_zero_divisor(const ex& expression) {
  std::vector<ex> divisors;
  collect_divisors(expression, divisors);
  // Inner divisors come after the outer divisors that contain them.
  for (auto divisor = divisors.rbegin(); divisor != divisors.rend(); ++divisor) {
    if (numerator_of(*divisor).is_zero()) throw std::domain_error("rational function: division by zero");
  }
}

struct ByDegree {
  bool operator()(const std::vector<int>& a, const std::vector<int>& b) const {
    const int degree_a = std::accumulate(a.begin(), a.end(), 0);
    const int degree_b = std::accumulate(b.begin(), b.end(), 0);
    return degree_a != degree_b ? degree_a > degree_b : a > b;
  }
};
/// Maps the powers of the symbols, which are in the order of their names, to coefficients.
using Terms = std::map<std::vector<int>, Rational, ByDegree>;
using Symbols = std::map<std::string, GiNaC::symbol>;

void collect_symbols(const ex& expression, Symbols& symbols) {
  if (GiNaC::is_a<GiNaC::symbol>(expression)) {
    const auto& symbol = GiNaC::ex_to<GiNaC::symbol>(expression);
    const auto [place, is_new] = symbols.emplace(symbol.get_name(), symbol);
    if (!is_new && !place->second.is_equal(symbol)) {
      throw std::domain_error("canonical text: two symbols named " + symbol.get_name());
    }
  }
  for (std::size_t k = 0; k < expression.nops(); ++k) collect_symbols(expression.op(k), symbols);
}

void collect_terms(const ex& polynomial, Symbols::const_iterator next, Symbols::const_iterator end,
                   std::vector<int>& powers, Terms& terms) {
  if (next == end) {
    if (!polynomial.is_zero()) terms.emplace(powers, to_rational(GiNaC::ex_to<GiNaC::numeric>(polynomial)));
    return;
  }
  const ex& symbol = next->second;
  for (int k = polynomial.ldegree(symbol); k <= polynomial.degree(symbol); ++k) {
    powers.push_back(k);
    collect_terms(polynomial.coeff(symbol, k).expand(), std::next(next), end, powers, terms);
    powers.pop_back();
  }
}

Terms terms_of(const ex& polynomial, const Symbols& symbols) {
  Terms terms;
  std::vector<int> powers;
  collect_terms(polynomial.expand(), symbols.begin(), symbols.end(), powers, terms);
  return terms;
}

std::string text_of(const Terms& terms, const Symbols& symbols, const Rational& scale) {
  std::string text;
  for (const auto& [powers, coefficient] : terms) {
    const Rational scaled = coefficient * scale;
    if (text.empty()) {
      if (scaled < 0) text = "-";
    } else {
      text += scaled < 0 ? " - " : " + ";
    }
    std::string factors;
    auto symbol = symbols.begin();
    for (const int power : powers) {
      if (power != 0) {
        factors += (factors.empty() ? "" : "*") + symbol->first + (power == 1 ? "" : "^" + std::to_string(power));
      }
      ++symbol;
    }
    const Rational size = abs(scaled);
    if (factors.empty() || size != 1) text += size.str() + (factors.empty() ? "" : "*");
    text += factors;
  }
  return text.empty() ? "0" : text;
}

/// Returns the factor that makes all coefficients integers without a common divisor. Its sign is that of the first
/// coefficient of the denominator.
Rational common_scale(const Terms& numerator, const Terms& denominator) {
  Integer multiple = 1;
  Integer divisor = 0;
  for (const Terms* terms : {&numerator, &denominator}) {
    for (const auto& [powers, c] : *terms) {
      multiple = boost::multiprecision::lcm(multiple, Integer(boost::multiprecision::denominator(c)));
      divisor = boost::multiprecision::gcd(divisor, Integer(boost::multiprecision::numerator(c)));
    }
  }
  return denominator.begin()->second < 0 ? Rational(-multiple, divisor) : Rational(multiple, divisor);
}

/// Returns the numerator up to a factor, because GiNaC's choice of the sign changes from run to run.
std::string divisor_text(const ex& divisor) {
  Symbols symbols;
  collect_symbols(divisor, symbols);
  const Terms terms = terms_of(numerator_of(divisor), symbols);
  return text_of(terms, symbols, common_scale(terms, terms));
}

}  // namespace

void collect_divisors(const ex& expression, std::vector<ex>& divisors) {
  if (GiNaC::is_a<GiNaC::power>(expression) && expression.op(1).info(GiNaC::info_flags::negative)) {
    divisors.push_back(expression.op(0));
  }
  for (std::size_t k = 0; k < expression.nops(); ++k) collect_divisors(expression.op(k), divisors);
}

bool is_rational_function(const ex& expression) {
  if (GiNaC::is_a<GiNaC::symbol>(expression)) return true;
  if (GiNaC::is_a<GiNaC::numeric>(expression)) return GiNaC::ex_to<GiNaC::numeric>(expression).is_rational();
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    return expression.op(1).info(GiNaC::info_flags::integer) && is_rational_function(expression.op(0));
  }
  if (!GiNaC::is_a<GiNaC::add>(expression) && !GiNaC::is_a<GiNaC::mul>(expression)) return false;
  for (std::size_t k = 0; k < expression.nops(); ++k) {
    if (!is_rational_function(expression.op(k))) return false;
  }
  return true;
}

RationalDecision decide_equal(const ex& lhs, const ex& rhs) {
  RationalDecision decision;
  for (const ex& side : {lhs, rhs}) {
    require_rational_function(side);
    require_no_zero_divisor(side);
    std::vector<ex> divisors;
    collect_divisors(side, divisors);
    for (const ex& divisor : divisors) {
      if (!GiNaC::is_a<GiNaC::numeric>(divisor.normal())) decision.nonvanishing.insert(divisor_text(divisor));
    }
  }
  decision.identical = numerator_of(lhs - rhs).is_zero();
  return decision;
}

ex limit_at_infinity(const ex& expression, const GiNaC::symbol& symbol) {
  require_rational_function(expression);
  require_no_zero_divisor(expression);
  const ex parts = expression.numer_denom();
  const ex numerator = parts.op(0).expand();
  const ex denominator = parts.op(1).expand();
  if (numerator.is_zero()) return 0;
  const int above = numerator.degree(symbol);
  const int below = denominator.degree(symbol);
  if (above > below) throw std::domain_error("limit at infinity: the function is unbounded");
  return above < below ? ex(0) : numerator.lcoeff(symbol) / denominator.lcoeff(symbol);
}

std::string canonical_text(const ex& expression) {
  require_rational_function(expression);
  require_no_zero_divisor(expression);
  const ex parts = expression.numer_denom();
  Symbols symbols;
  collect_symbols(parts, symbols);
  const Terms numerator = terms_of(parts.op(0), symbols);
  const Terms denominator = terms_of(parts.op(1), symbols);
  if (numerator.empty()) return "0";
  const Rational scale = common_scale(numerator, denominator);
  const std::string above = text_of(numerator, symbols, scale);
  const std::string below = text_of(denominator, symbols, scale);
  return below == "1" ? above : "(" + above + ")/(" + below + ")";
}

}  // namespace steadyslide::symbolic
