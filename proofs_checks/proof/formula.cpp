#include "proofs_checks/proof/formula.hpp"

#include <algorithm>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cctype>
#include <functional>
#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

using FormulaNode = Formula::Node;

const Real50& pi() {
  static const Real50 value = numeric::pi<Real50>();
  return value;
}

Truth negated(Truth t) { return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t; }
Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes ? b : a;
}
Truth truth_of(bool b) { return b ? Truth::yes : Truth::no; }

const std::map<std::string, std::function<Real50(const Real50&)>>& functions() {
  using N = const Real50&;
  static const std::map<std::string, std::function<Real50(N)>> all{
      {"abs", [](N x) { return Real50(abs(x)); }},     {"arctan", [](N x) { return Real50(atan(x)); }},
      {"cos", [](N x) { return Real50(cos(x)); }},     {"cosh", [](N x) { return Real50(cosh(x)); }},
      {"cot", [](N x) { return Real50(1 / tan(x)); }}, {"digamma", [](N x) { return boost::math::digamma(x); }},
      {"exp", [](N x) { return Real50(exp(x)); }},     {"floor", [](N x) { return Real50(floor(x)); }},
      {"gamma", [](N x) { return boost::math::tgamma(x); }},
      {"log", [](N x) { return Real50(log(x)); }},     {"sgn", [](N x) { return Real50(x > 0 ? 1 : x < 0 ? -1 : 0); }},
      {"sin", [](N x) { return Real50(sin(x)); }},     {"sinh", [](N x) { return Real50(sinh(x)); }},
      {"sqrt", [](N x) { return Real50(sqrt(x)); }},   {"tan", [](N x) { return Real50(tan(x)); }}};
  return all;
}

/// Reads a formula by recursive descent: if, or, and, not, comparisons, sums, products, powers.
class Parser {
 public:
  Parser(std::string_view text, std::set<std::string>& names) : text_(text), names_(names) { next(); }

  FormulaNode all() {
    FormulaNode node = implication();
    if (!token_.empty()) refuse();
    return node;
  }

 private:
  [[noreturn]] void refuse() const {
    throw std::logic_error("not a formula: " + std::string(text_) + (token_.empty() ? "" : ", at " + token_));
  }

  void next() {
    spaced_ = at_ < text_.size() && text_[at_] == ' ';
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    const std::size_t from = at_;
    const auto is = [&](auto test) { return at_ < text_.size() && test(static_cast<unsigned char>(text_[at_])); };
    if (is([](int c) { return std::isdigit(c); })) {
      while (is([](int c) { return std::isdigit(c) || c == '.'; })) ++at_;
    } else if (is([](int c) { return std::isalpha(c); })) {
      while (is([](int c) { return std::isalnum(c) || c == '_' || c == '\''; })) ++at_;
    } else if (at_ < text_.size()) {
      ++at_;
      if ((text_[from] == '<' || text_[from] == '>' || text_[from] == '!') && is([](int c) { return c == '='; })) ++at_;
    }
    token_ = text_.substr(from, at_ - from);
  }
  bool take(std::string_view token) {
    if (token_ != token) return false;
    next();
    return true;
  }
  void want(std::string_view token) {
    if (!take(token)) refuse();
  }
  bool is_name() const {
    return !token_.empty() && std::isalpha(static_cast<unsigned char>(token_[0])) && token_ != "in" && token_ != "if" &&
           token_ != "and" && token_ != "or" && token_ != "not";
  }

  FormulaNode implication() {
    FormulaNode node = disjunction();
    return take("if") ? FormulaNode{"if", {}, 0, {std::move(node), disjunction()}} : node;
  }
  FormulaNode disjunction() {
    FormulaNode node = conjunction();
    while (take("or")) node = {"or", {}, 0, {std::move(node), conjunction()}};
    return node;
  }
  FormulaNode conjunction() {
    FormulaNode node = statement();
    while (take("and")) node = {"and", {}, 0, {std::move(node), statement()}};
    return node;
  }
  FormulaNode statement() {
    if (take("not")) return {"not", {}, 0, {statement()}};
    FormulaNode left = sum();
    if (take("in")) {
      const std::string opens = token_;
      if (!take("]")) want("[");
      FormulaNode from = sum();
      want(",");
      FormulaNode to = sum();
      const std::string closes = token_;
      if (!take("]")) want("[");
      FormulaNode low{opens == "]" ? "<" : "<=", {}, 0, {std::move(from), left}};
      return {"and", {}, 0, {std::move(low), {closes == "[" ? "<" : "<=", {}, 0, {std::move(left), std::move(to)}}}};
    }
    FormulaNode result;
    while (token_ == "<" || token_ == "<=" || token_ == "=" || token_ == "!=" || token_ == ">=" || token_ == ">") {
      const std::string sign = token_;
      next();
      FormulaNode right = sum();
      FormulaNode one{sign, {}, 0, {std::move(left), right}};
      result = result.op.empty() ? std::move(one) : FormulaNode{"and", {}, 0, {std::move(result), std::move(one)}};
      left = std::move(right);
    }
    return result.op.empty() ? left : result;
  }
  FormulaNode sum() {
    FormulaNode node = product();
    while (token_ == "+" || token_ == "-") {
      const std::string sign = token_;
      next();
      node = {sign, {}, 0, {std::move(node), product()}};
    }
    return node;
  }
  bool begins_factor() const {
    return is_name() || token_ == "(" || (!token_.empty() && std::isdigit(static_cast<unsigned char>(token_[0])));
  }
  FormulaNode product() {
    if (take("-")) return {"neg", {}, 0, {product()}};
    FormulaNode node = power();
    while (true) {
      if (take("*")) {
        node = {"*", {}, 0, {std::move(node), power()}};
      } else if (take("/")) {
        node = {"/", {}, 0, {std::move(node), power()}};
      } else if (begins_factor()) {
        node = {"*", {}, 0, {std::move(node), power()}};
      } else {
        return node;
      }
    }
  }
  FormulaNode power() {
    FormulaNode node = factor();
    if (!take("^")) return node;
    const bool minus = take("-");
    FormulaNode exponent = power();
    if (minus) exponent = {"neg", {}, 0, {std::move(exponent)}};
    return {"^", {}, 0, {std::move(node), std::move(exponent)}};
  }
  FormulaNode factor() {
    if (take("(")) {
      FormulaNode node = implication();
      want(")");
      return node;
    }
    if (is_name()) {
      const std::string name = token_;
      next();
      if (token_ == "(" && !spaced_) return call(name);
      if (name != "pi" && !bound_.contains(name)) names_.insert(name);
      return {"name", name};
    }
    if (token_.empty() || !std::isdigit(static_cast<unsigned char>(token_[0]))) refuse();
    FormulaNode node{"number", {}, Real50(token_)};
    next();
    return node;
  }
  FormulaNode call(const std::string& name) {
    next();
    FormulaNode node{"call", name};
    const bool states = name == "all";
    const bool binds = states || name == "int" || name == "sum";
    std::string variable;
    if (binds) {
      variable = token_;
      if (!is_name()) refuse();
      next();
      want(",");
    } else if (!functions().contains(name) && name != "max" && name != "min") {
      names_.insert(name + "(");
    }
    const bool outer = bound_.contains(variable);
    do {
      if (binds && node.parts.size() == 2) bound_.insert(variable);
      node.parts.push_back(states && node.parts.size() == 2 ? implication() : sum());
    } while (take(","));
    if (binds && !outer) bound_.erase(variable);
    want(")");
    const std::size_t wanted = binds ? 3 : functions().contains(name) ? 1 : node.parts.size();
    if (node.parts.size() != wanted) refuse();
    if (binds) node.parts.push_back({"name", variable});
    return node;
  }

  std::string_view text_;
  std::set<std::string>& names_;
  std::set<std::string> bound_;
  std::size_t at_ = 0;
  std::string token_;
  bool spaced_ = false;  ///< a space stands before the token
};

/// Evaluates a formula on an instance.
class Evaluation {
 public:
  explicit Evaluation(const Instance& instance) : instance_(instance) {}
  Evaluation(const Instance& instance, std::map<std::string, Real50> bound)
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
    const Real50 tolerance = (abs(a) + abs(b)) * (exact ? Real50("1e-40") : instance_.accuracy) + Real50("1e-44");
    const bool equal = abs(a - b) <= tolerance;
    if (n.op == "=") return truth_of(equal);
    if (equal && !exact) return Truth::unknown;
    if (n.op == "!=") return truth_of(!equal);
    if (n.op == "<") return truth_of(!equal && a < b);
    if (n.op == ">") return truth_of(!equal && a > b);
    return truth_of(equal || (n.op == "<=" ? a < b : a > b));
  }

 private:
  Real50 named(const std::string& name) const {
    if (name == "pi") return pi();
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
    if (const auto at = functions().find(n.name); at != functions().end()) return at->second(arguments[0]);
    if (n.name == "max") return *std::ranges::max_element(arguments);
    if (n.name == "min") return *std::ranges::min_element(arguments);
    const auto at = instance_.functions.find(n.name);
    if (at == instance_.functions.end()) throw std::logic_error("the instance has no function " + n.name);
    const auto& [parameters, body] = at->second;
    if (parameters.size() != arguments.size()) throw std::logic_error("another number of arguments of " + n.name);
    std::map<std::string, Real50> inner;
    for (std::size_t k = 0; k < parameters.size(); ++k) inner[parameters[k]] = arguments[k];
    return Evaluation(instance_, std::move(inner)).value(body.root());
  }

  /// Returns the evaluation with a value of the variable that int, sum or all binds.
  Evaluation inside(const FormulaNode& n, const Real50& number) const {
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
      const Real50 e = exp(-pi() * abs(sinh(u)));
      const Real50 part = e / (1 + e);  // the distance from the nearer end, as a part of the whole
      const Real50 x = k < 0 ? a + (b - a) * part : b - (b - a) * part;
      if (x == a || x == b) continue;  // nearer to an end than the numbers can tell
      sum += inside(n, x).value(n.parts[2]) * cosh(u) * part / (1 + e);
    }
    return sum * (b - a) * pi() / 16;
  }

  const Instance& instance_;
  std::map<std::string, Real50> bound_;
};

}  // namespace

Formula::Formula(std::string_view text) : root_(Parser(text, names_).all()) {}

Real50 Formula::value(const Instance& instance) const { return Evaluation(instance).value(root_); }

Truth Formula::holds(const Instance& instance) const { return Evaluation(instance).holds(root_); }

std::string text_of(const Instance& instance) {
  std::string text;
  for (const auto& [name, number] : instance.numbers) {
    text += (text.empty() ? "" : ", ") + name + " = " + number.str(10);
  }
  return text;
}

}  // namespace steadyslide::proofs_checks
