#include "symbolic/field/phase_field.hpp"

#include <cstdlib>
#include <map>
#include <stdexcept>

#include "symbolic/field/expression.hpp"
#include "symbolic/field/rational_function.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

[[noreturn]] void outside(const std::string& what) { throw std::domain_error("phase field: " + what); }

/// Replaces complex numbers by the field's own imaginary unit.
class ImaginaryUnit : public GiNaC::map_function {
 public:
  explicit ImaginaryUnit(const GiNaC::symbol& unit) : unit_(unit) {}
  ex operator()(const ex& e) override {
    if (!GiNaC::is_a<GiNaC::numeric>(e)) return e.map(*this);
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(e);
    return number.is_real() ? e : ex(number.real()) + ex(number.imag()) * unit_;
  }

 private:
  GiNaC::symbol unit_;
};

void insert_coprime(std::vector<Integer>& base, const Integer& number) {
  if (number == 1) return;
  for (std::size_t k = 0; k < base.size(); ++k) {
    const Integer common = boost::multiprecision::gcd(base[k], number);
    if (common == 1) continue;
    const Integer old = base[k];
    base.erase(base.begin() + static_cast<std::ptrdiff_t>(k));
    if (old == number) {
      base.push_back(number);
      return;
    }
    insert_coprime(base, common);
    insert_coprime(base, Integer(old / common));
    insert_coprime(base, Integer(number / common));
    return;
  }
  base.push_back(number);
}

/// A friction: a symbol, minus a symbol, or a number.
struct Written {
  int sign = 1;
  GiNaC::symbol symbol;
  bool is_number = false;
  Rational number;
};

Written read(const ex& s) {
  if (GiNaC::is_a<GiNaC::symbol>(s)) return {1, GiNaC::ex_to<GiNaC::symbol>(s), false, 0};
  if (GiNaC::is_a<GiNaC::symbol>(-s)) return {-1, GiNaC::ex_to<GiNaC::symbol>(-s), false, 0};
  if (GiNaC::is_a<GiNaC::numeric>(s) && GiNaC::ex_to<GiNaC::numeric>(s).is_rational()) {
    return {1, GiNaC::symbol(), true, to_rational(GiNaC::ex_to<GiNaC::numeric>(s))};
  }
  outside("a friction is a symbol, minus a symbol, or a rational number");
}

/// Returns numerator^2 + denominator^2 = (r denominator)^2.
Integer radicand(const Rational& s) {
  const Integer p = boost::multiprecision::numerator(s);
  const Integer q = boost::multiprecision::denominator(s);
  return p * p + q * q;
}

GiNaC::numeric to_numeric(const Integer& value) { return to_expression(Rational(value)); }

}  // namespace

std::vector<Integer> coprime_base(const std::vector<Integer>& integers) {
  std::vector<Integer> base;
  for (const Integer& number : integers) insert_coprime(base, number);
  return base;
}

PhaseField::PhaseField(const std::vector<ex>& frictions) : i_("i") {
  radicals_.push_back({i_, -1});
  std::vector<Written> written;
  std::vector<Integer> radicands;
  for (const ex& s : frictions) {
    written.push_back(read(s));
    if (written.back().is_number) radicands.push_back(radicand(written.back().number));
  }

  // Square roots of the base: an integer for a perfect square, otherwise a new radical.
  std::vector<std::pair<Integer, ex>> roots;
  for (const Integer& b : coprime_base(radicands)) {
    const Integer root = boost::multiprecision::sqrt(b);
    if (root * root == b) {
      roots.emplace_back(b, to_numeric(root));
    } else {
      radicals_.push_back({GiNaC::symbol("sqrt" + b.str()), to_numeric(b)});
      roots.emplace_back(b, radicals_.back().root);
    }
  }

  std::map<std::string, std::pair<GiNaC::symbol, GiNaC::symbol>> symbols;  // name -> s, r
  for (std::size_t k = 0; k < frictions.size(); ++k) {
    ex r = 1;
    if (written[k].is_number) {
      Integer rest = radicand(written[k].number);
      for (const auto& [b, root] : roots) {
        for (; rest % b == 0; rest /= b) r *= root;
      }
      r /= to_numeric(boost::multiprecision::denominator(written[k].number));
    } else {
      const GiNaC::symbol& s = written[k].symbol;
      const auto [place, is_new] = symbols.emplace(s.get_name(), std::pair(s, GiNaC::symbol("r_" + s.get_name())));
      if (is_new) radicals_.push_back({place->second.second, 1 + ex(s) * s});
      if (!place->second.first.is_equal(s)) outside("two frictions named " + s.get_name());
      r = place->second.second;
    }
    r = reduced(r.expand());
    frictions_.push_back({frictions[k], r, 1 / r, frictions[k] / r});
  }
}

ex PhaseField::phase(const AngleForm& form, int times) const {
  ex result = 1;
  const int quarter_turns = ((form.halves() * times % 4) + 4) % 4;
  if (quarter_turns % 2 == 1) result *= i_;
  if (quarter_turns >= 2) result *= -1;
  for (const auto& [k, factor] : form.times()) {
    // exp(-i pi alpha) = conj(exp(i pi alpha)), so r is the only divisor.
    const Friction& f = friction(k);
    const int power = factor * times;
    result *= GiNaC::pow(f.cos + (power < 0 ? -i_ : ex(i_)) * f.sin, std::abs(power));
  }
  return result;
}

/// Returns the expression with i in place of GiNaC's complex numbers. Throws std::domain_error if it is not a rational
/// function of the field's symbols.
ex PhaseField::admitted(const ex& expression) const {
  ImaginaryUnit replace(i_);
  const ex result = replace(expression);
  if (!is_rational_function(result)) {
    outside("only symbols, rational numbers, i, sums, products and integer powers");
  }
  return result;
}

/// Reduces i and the radicals to their first powers.
ex PhaseField::reduced(const ex& polynomial) const {
  ex result = polynomial.expand();
  for (const Radical& radical : radicals_) {
    if (!result.has(radical.root)) continue;
    ex even = 0;
    ex odd = 0;
    for (int n = result.ldegree(radical.root); n <= result.degree(radical.root); ++n) {
      const ex term = result.coeff(radical.root, n) * GiNaC::pow(radical.square, n / 2);
      (n % 2 == 0 ? even : odd) += term;
    }
    result = (even + odd * radical.root).expand();
  }
  return result;
}

void PhaseField::require_no_zero_divisor(const ex& expression) const {
  std::vector<ex> divisors;
  collect_divisors(expression, divisors);
  for (auto divisor = divisors.rbegin(); divisor != divisors.rend(); ++divisor) {
    if (reduced(divisor->numer_denom().op(0)).is_zero()) outside("division by zero");
  }
}

PhaseField::Decision PhaseField::is_identically_zero(const ex& expression) const {
  const ex written = admitted(expression);
  require_no_zero_divisor(written);
  Decision decision{reduced(written.numer_denom().op(0)).is_zero(), {}};
  std::vector<ex> divisors;
  collect_divisors(written, divisors);
  for (const ex& divisor : divisors) {
    const ex numerator = reduced(divisor.numer_denom().op(0));
    // r > 0 and numbers vanish nowhere.
    bool always = GiNaC::is_a<GiNaC::numeric>(numerator);
    for (const Radical& radical : radicals_) always = always || numerator.is_equal(radical.root);
    if (always) continue;
    // The text is fixed up to a factor: GiNaC's choice of the sign changes from run to run.
    std::string text = canonical_text(numerator);
    if (text.starts_with('-')) text = canonical_text(-numerator);
    decision.nonvanishing.insert(std::move(text));
  }
  return decision;
}

PhaseField::Decision PhaseField::are_equal(const ex& lhs, const ex& rhs) const {
  return is_identically_zero(lhs - rhs);
}

ex PhaseField::canonical(const ex& expression) const {
  const ex written = admitted(expression);
  require_no_zero_divisor(written);
  const ex parts = written.numer_denom();
  ex numerator = reduced(parts.op(0));
  ex denominator = reduced(parts.op(1));
  for (const Radical& radical : radicals_) {
    if (!denominator.has(radical.root)) continue;
    const ex conjugate = denominator.subs(radical.root == -radical.root);
    numerator = reduced(numerator * conjugate);
    denominator = reduced(denominator * conjugate);
  }
  if (numerator.is_zero()) return 0;
  return (numerator / denominator).normal();
}

std::string PhaseField::text(const ex& expression) const { return canonical_text(canonical(expression)); }

}  // namespace steadyslide::symbolic
