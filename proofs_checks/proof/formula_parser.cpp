#include "proofs_checks/proof/formula_parser.hpp"

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cctype>
#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

using FormulaNode = Formula::Node;

/// Reads a formula by recursive descent: if, or, and, not, comparisons, sums, products, powers.
class FormulaParser {
 public:
  FormulaParser(std::string_view text, std::set<std::string>& names) : text_(text), names_(names) { next(); }

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
    } else if (!formula_functions().contains(name) && name != "max" && name != "min") {
      names_.insert(name + "(");
    }
    const bool outer = bound_.contains(variable);
    do {
      if (binds && node.parts.size() == 2) bound_.insert(variable);
      node.parts.push_back(states && node.parts.size() == 2 ? implication() : sum());
    } while (take(","));
    if (binds && !outer) bound_.erase(variable);
    want(")");
    const std::size_t wanted = binds ? 3 : formula_functions().contains(name) ? 1 : node.parts.size();
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

}  // namespace

const std::map<std::string, std::function<Real50(const Real50&)>>& formula_functions() {
  using N = const Real50&;
  static const std::map<std::string, std::function<Real50(N)>> all{
      {"abs", [](N x) { return Real50(abs(x)); }},
      {"arctan", [](N x) { return Real50(atan(x)); }},
      {"cos", [](N x) { return Real50(cos(x)); }},
      {"cosh", [](N x) { return Real50(cosh(x)); }},
      {"cot", [](N x) { return Real50(1 / tan(x)); }},
      {"digamma", [](N x) { return boost::math::digamma(x); }},
      {"exp", [](N x) { return Real50(exp(x)); }},
      {"floor", [](N x) { return Real50(floor(x)); }},
      {"gamma", [](N x) { return boost::math::tgamma(x); }},
      {"log", [](N x) { return Real50(log(x)); }},
      {"sgn", [](N x) { return Real50(x > 0   ? 1
                                      : x < 0 ? -1
                                              : 0); }},
      {"sin", [](N x) { return Real50(sin(x)); }},
      {"sinh", [](N x) { return Real50(sinh(x)); }},
      {"sqrt", [](N x) { return Real50(sqrt(x)); }},
      {"tan", [](N x) { return Real50(tan(x)); }}};
  return all;
}

Formula::Node parse_formula(std::string_view text, std::set<std::string>& names) {
  return FormulaParser(text, names).all();
}

}  // namespace steadyslide::proofs_checks
