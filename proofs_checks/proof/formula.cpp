#include "proofs_checks/proof/formula.hpp"

#include <algorithm>
#include <stdexcept>

#include "proofs_checks/proof/formula_parser.hpp"

namespace steadyslide::proofs_checks {
namespace {

using FormulaNode = Formula::Node;

const Real50& exact_pi() {
  static const auto value = numeric::pi<Real50>();
  return value;
}

Truth negated(Truth t) { return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t; }
Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes ? b : a;
}
Truth truth_of(bool b) { return b ? Truth::yes : Truth::no; }

/// Evaluates a formula on an instance.
class FormulaEvaluation {
 public:
  explicit FormulaEvaluation(const Instance& instance) : instance_(instance) {}
  FormulaEvaluation(const Instance& instance, std::map<std::string, Real50> bound)
      : instance_(instance), bound_(std::move(bound)) {}

  Real50 value(const FormulaNode& n) {
    const auto part = [&](std::size_t k) { return value(n.parts[k]); };
    if (n.op == "number") return n.number;
    if (n.op == "name") return named(n.name);
    if (n.op == "call") return called(n);
    if (n.op == "neg") return -part(0);
    if (n.op == "+") return part(0) + part(1);
    if (n.op == "-") return part(0) - part(1);
    if (n.op == "*") return part(0) * part(1);
    if (n.op == "/") return part(0) / part(1);
    if (n.op == "^") return pow(part(0), part(1));
    throw std::logic_error("a statement stands for a number");
  }

  Truth holds(const FormulaNode& n) {
    const auto part = [&](std::size_t k) { return holds(n.parts[k]); };
    if (n.op == "if") return negated(both(negated(part(0)), part(1)));
    if (n.op == "or") return negated(both(negated(part(0)), negated(part(1))));
    if (n.op == "and") return both(part(0), part(1));
    if (n.op == "not") return negated(part(0));
    if (n.op == "call" && n.name == "all") {
      Truth all = Truth::yes;
      const Real50 last = value(n.parts[1]);
      for (Real50 k = value(n.parts[0]); k <= last; k += 1) all = both(all, inside(n, k).holds(n.parts[2]));
      return all;
    }
    if (n.parts.size() != 2 || std::string_view("<=>=!=").find(n.op) == std::string_view::npos) {
      throw std::logic_error("a number stands for a statement");
    }
    const Real50 a = value(n.parts[0]);
    const Real50 b = value(n.parts[1]);
    if (!isfinite(a) || !isfinite(b)) return Truth::unknown;
    const bool exact = instance_.accuracy == 0;
    const Real50 size = abs(a) + abs(b);
    const Real50 tolerance = exact ? size * Real50("1e-40") + Real50("1e-44") : (1 + size) * instance_.accuracy;
    const bool equal = abs(a - b) <= tolerance;
    if (n.op == "=") return truth_of(equal);
    if (equal && !exact && a != b) return Truth::unknown;
    if (n.op == "!=") return truth_of(!equal);
    if (n.op == "<") return truth_of(!equal && a < b);
    if (n.op == ">") return truth_of(!equal && a > b);
    return truth_of(equal || (n.op == "<=" ? a < b : a > b));
  }

 private:
  Real50 named(const std::string& name) const {
    if (name == "pi") return exact_pi();
    if (const auto at = bound_.find(name); at != bound_.end()) return at->second;
    if (const auto at = instance_.numbers.find(name); at != instance_.numbers.end()) return at->second;
    throw std::logic_error("the instance has no value of " + name);
  }

  Real50 called(const FormulaNode& n) {
    if (n.name == "int") return integral(n);
    std::vector<Real50> arguments;
    if (n.name == "sum") {
      Real50 sum = 0;
      const Real50 last = value(n.parts[1]);
      for (Real50 k = value(n.parts[0]); k <= last; k += 1) sum += inside(n, k).value(n.parts[2]);
      return sum;
    }
    for (const FormulaNode& part : n.parts) arguments.push_back(value(part));
    if (const auto at = formula_functions().find(n.name); at != formula_functions().end())
      return at->second(arguments[0]);
    if (n.name == "max") return *std::ranges::max_element(arguments);
    if (n.name == "min") return *std::ranges::min_element(arguments);
    const auto* functions = instance_.functions.get();
    if (!functions || !functions->contains(n.name)) throw std::logic_error("the instance has no function " + n.name);
    const auto& [parameters, body] = functions->at(n.name);
    if (parameters.size() != arguments.size()) throw std::logic_error("another number of arguments of " + n.name);
    std::map<std::string, Real50> inner;
    for (std::size_t k = 0; k < parameters.size(); ++k) inner[parameters[k]] = arguments[k];
    return FormulaEvaluation(instance_, std::move(inner)).value(body.root());
  }

  /// Returns the evaluation with a value of the variable that int, sum or all binds.
  FormulaEvaluation inside(const FormulaNode& n, const Real50& number) const {
    std::map<std::string, Real50> bound = bound_;
    bound[n.parts[3].name] = number;
    return {instance_, std::move(bound)};
  }

  /// The double exponential rule: x = a + (b-a)/(1 + exp(-pi sinh(u))), with equal steps of u.
  Real50 integral(const FormulaNode& n) {
    const Real50 a = value(n.parts[0]);
    const Real50 b = value(n.parts[1]);
    Real50 sum = 0;
    for (int k = -96; k <= 96; ++k) {
      const Real50 u = Real50(k) / 16;
      const Real50 e = exp(-exact_pi() * abs(sinh(u)));
      const Real50 part = e / (1 + e);  // the distance from the nearer end, as a part of the whole
      const Real50 x = k < 0 ? a + (b - a) * part : b - (b - a) * part;
      if (x == a || x == b) continue;  // nearer to an end than the numbers can tell
      sum += inside(n, x).value(n.parts[2]) * cosh(u) * part / (1 + e);
    }
    return sum * (b - a) * exact_pi() / 16;
  }

  const Instance& instance_;
  std::map<std::string, Real50> bound_;
};

}  // namespace

Formula::Formula(std::string_view text) : root_(parse_formula(text, names_)) {}

Real50 Formula::value(const Instance& instance) const { return FormulaEvaluation(instance).value(root_); }

Truth Formula::holds(const Instance& instance) const { return FormulaEvaluation(instance).holds(root_); }

std::string text_of(const Instance& instance) {
  std::string text;
  for (const auto& [name, number] : instance.numbers) {
    text += (text.empty() ? "" : ", ") + name + " = " + number.str(10);
  }
  return text;
}

}  // namespace steadyslide::proofs_checks
