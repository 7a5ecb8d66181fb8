#include "symbolic/coq/coq_equation.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

/// Replaces GiNaC::I by the imaginary unit of the field.
class FieldUnit : public GiNaC::map_function {
 public:
  explicit FieldUnit(const std::vector<PhaseField::Radical>& radicals) : radicals_(radicals) {}
  ex operator()(const ex& e) override {
    if (!GiNaC::is_a<GiNaC::numeric>(e)) return e.map(*this);
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(e);
    if (number.is_real()) return e;
    return ex(number.real()) + ex(number.imag()) * radicals_.at(0).root;
  }

 private:
  const std::vector<PhaseField::Radical>& radicals_;
};

Rational number_of(const ex& e) { return to_rational(GiNaC::ex_to<GiNaC::numeric>(e)); }

int exponent_of(const ex& power) {
  if (!power.op(1).info(GiNaC::info_flags::integer)) throw std::domain_error("Coq: only integer powers");
  return GiNaC::ex_to<GiNaC::numeric>(power.op(1)).to_int();
}

bool is_negative(const ex& term) {
  const ex number = GiNaC::is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : term;  // a product's number is last
  return GiNaC::is_a<GiNaC::numeric>(number) && number.info(GiNaC::info_flags::negative);
}

/// Joins the texts of the operands in an order that is the same in every run.
std::string joined(std::vector<std::string> parts, const std::string& sign) {
  std::ranges::sort(parts);
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : sign) + part;
  return all;
}

}  // namespace

CoqEquation::CoqEquation(const WrittenEquation& equation, const std::vector<PhaseField::Radical>& radicals) {
  FieldUnit unit(radicals);
  lhs_ = unit(equation.lhs);
  rhs_ = unit(equation.rhs);
  collect(lhs_);
  collect(rhs_);
  for (const PhaseField::Radical& radical : radicals) {
    if (!symbols_.contains(radical.root.get_name())) continue;
    radicals_.push_back(radical);
    collect(radical.root);
    collect(radical.square);
  }
}

/// Returns the nesting depth of divisions in the expression.
int CoqEquation::collect(const ex& e) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    const auto& symbol = GiNaC::ex_to<GiNaC::symbol>(e);
    const auto [place, is_new] = symbols_.emplace(symbol.get_name(), symbol);
    if (!is_new && !place->second.is_equal(symbol)) {
      throw std::domain_error("Coq: two symbols named " + symbol.get_name());
    }
    return 0;
  }
  if (GiNaC::is_a<GiNaC::power>(e)) {
    const int depth = collect(e.op(0));
    if (exponent_of(e) > 0) return depth;
    divisors_.emplace(std::pair(depth, text(e.op(0), false)), e.op(0));
    return depth + 1;
  }
  int depth = 0;
  for (std::size_t k = 0; k < e.nops(); ++k) depth = std::max(depth, collect(e.op(k)));
  return depth;
}

std::vector<std::string> CoqEquation::names() const {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : symbols_) names.push_back(name);
  for (std::size_t k = 1; k <= divisors_.size(); ++k) names.push_back("inv_" + std::to_string(k));
  return names;
}

std::vector<Root> CoqEquation::roots() const {
  std::vector<Root> roots;
  for (const auto& [root, square] : radicals_) {
    const auto place = symbols_.find(root.get_name());
    roots.push_back({static_cast<std::size_t>(std::distance(symbols_.begin(), place)), polynomial(square)});
  }
  return roots;
}

std::vector<Inverse> CoqEquation::inverses() const {
  std::vector<Inverse> inverses;
  for (const auto& [key, divisor] : divisors_) {
    inverses.push_back({symbols_.size() + inverses.size(), polynomial(divisor)});
  }
  return inverses;
}

std::vector<CoqEquation::Relation> CoqEquation::relations() const {
  std::vector<Relation> relations;
  for (const auto& [root, square] : radicals_) relations.push_back({root.get_name() + "^2", text(square)});
  for (const auto& [key, divisor] : divisors_) {
    relations.push_back({factor(divisor, true) + " * " + inverse_of(divisor), "[1]"});
  }
  return relations;
}

std::string CoqEquation::inverse_of(const ex& divisor) const {
  const auto place = std::ranges::find_if(divisors_, [&](const auto& entry) { return entry.second.is_equal(divisor); });
  return "inv_" + std::to_string(std::distance(divisors_.begin(), place) + 1);
}

/// Returns the text. If `named`, a divisor appears as the name of its inverse; otherwise it appears as its own text,
/// which distinguishes divisors.
std::string CoqEquation::text(const ex& e, bool named) const {
  if (GiNaC::is_a<GiNaC::symbol>(e)) return GiNaC::ex_to<GiNaC::symbol>(e).get_name();
  if (GiNaC::is_a<GiNaC::numeric>(e)) return coq_number(number_of(e));
  if (GiNaC::is_a<GiNaC::add>(e)) {
    std::vector<std::string> plus;
    std::vector<std::string> minus;
    for (std::size_t k = 0; k < e.nops(); ++k) {
      is_negative(e.op(k)) ? minus.push_back(text(-e.op(k), named)) : plus.push_back(text(e.op(k), named));
    }
    if (plus.empty()) plus.emplace_back("[0]");
    return joined(plus, " + ") + (minus.empty() ? "" : " - " + joined(minus, " - "));
  }
  if (GiNaC::is_a<GiNaC::mul>(e)) {
    std::vector<std::string> factors;
    for (std::size_t k = 0; k < e.nops(); ++k) factors.push_back(factor(e.op(k), named));
    return joined(factors, " * ");
  }
  if (!GiNaC::is_a<GiNaC::power>(e)) throw std::domain_error("Coq: only rational functions");
  const int n = exponent_of(e);
  const std::string base = n > 0 ? factor(e.op(0), named) : named ? inverse_of(e.op(0)) : "/" + factor(e.op(0), named);
  return std::abs(n) == 1 ? base : base + "^" + std::to_string(std::abs(n));
}

std::string CoqEquation::factor(const ex& e, bool named) const {
  const bool sum = GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e);
  return sum ? "(" + text(e, named) + ")" : text(e, named);
}

Polynomial CoqEquation::generator(const std::string& name) const {
  const std::vector<std::string> all = names();
  return Polynomial::generator(static_cast<std::size_t>(std::distance(all.begin(), std::ranges::find(all, name))));
}

Polynomial CoqEquation::polynomial(const ex& e) const {
  if (GiNaC::is_a<GiNaC::symbol>(e)) return generator(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
  if (GiNaC::is_a<GiNaC::numeric>(e)) return Polynomial(number_of(e));
  if (GiNaC::is_a<GiNaC::power>(e)) {
    const int n = exponent_of(e);
    return (n > 0 ? polynomial(e.op(0)) : generator(inverse_of(e.op(0)))).to_the(std::abs(n));
  }
  const bool product = GiNaC::is_a<GiNaC::mul>(e);
  Polynomial result(product ? 1 : 0);
  for (std::size_t k = 0; k < e.nops(); ++k) {
    if (product) {
      result = result * polynomial(e.op(k));
    } else {
      result += polynomial(e.op(k));
    }
  }
  return result;
}

}  // namespace steadyslide::symbolic
