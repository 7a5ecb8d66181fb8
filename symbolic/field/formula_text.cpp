#include "symbolic/field/formula_text.hpp"

#include <cstdlib>

#include "symbolic/field/character.hpp"
#include "symbolic/field/exponent_expression.hpp"

namespace steadyslide::symbolic {
namespace {

std::string latex_name(const std::string& name, const LatexNames& names) {
  const auto known = names.find(name);
  if (known != names.end()) return known->second;
  if (name.starts_with("sqrt")) return "\\sqrt{" + name.substr(4) + "}";
  return name;
}

/// Returns the LaTeX of a sum of products without parentheses.
std::string latex_sum(const std::string& text, const LatexNames& names) {
  std::string result;
  for (std::size_t k = 0; k < text.size();) {
    const char c = text[k];
    if (is_letter(c)) {
      std::size_t end = k;
      while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]) || text[end] == '_')) ++end;
      result += latex_name(text.substr(k, end - k), names);
      k = end;
    } else if (c == '^') {
      std::size_t end = k + 1;
      while (end < text.size() && is_digit(text[end])) ++end;
      result += "^{" + text.substr(k + 1, end - k - 1) + "}";
      k = end;
    } else {
      if (c == '*') result += ' ';
      if (c != '*' && c != ' ') result += c;
      ++k;
    }
  }
  return result;
}

/// True if the text is a sum of at least two terms, outside all parentheses.
bool is_sum(const std::string& text) {
  return text.find(" + ") != std::string::npos || text.find(" - ") != std::string::npos;
}

struct Fraction {
  std::string above;
  std::string below;  ///< the denominator; empty if it is not a fraction
};

Fraction fraction(const std::string& text) {
  const std::size_t bar = text.find(")/(");
  if (bar == std::string::npos) return {text, ""};
  return {text.substr(1, bar - 1), text.substr(bar + 3, text.size() - bar - 4)};
}

/// Replaces the names of radicals by their values: "r_s", if it has a LaTeX name, by "sqrt(1+s^2)", and "sqrt7" by
/// "sqrt(7)".
std::string readable(const std::string& text, const LatexNames& names) {
  std::string result;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]) || text[end] == '_')) ++end;
    const std::string name = text.substr(k, end - k);
    if (name.empty()) {
      result += text[k++];
      continue;
    }
    if (name.starts_with("r_") && names.contains(name)) {
      result += "sqrt(1+" + name.substr(2) + "^2)";
    } else if (name.starts_with("sqrt")) {
      result += "sqrt(" + name.substr(4) + ")";
    } else {
      result += name;
    }
    k = end;
  }
  return result;
}

std::string parenthesized(const std::string& text) {
  return is_sum(text) || text.find('*') != std::string::npos ? "(" + text + ")" : text;
}

}  // namespace

std::string latex_of(const std::string& canonical_text, const LatexNames& names) {
  const auto [above, below] = fraction(canonical_text);
  if (below.empty()) return latex_sum(above, names);
  const bool minus = above[0] == '-' && !is_sum(above);
  return (minus ? "-\\frac{" : "\\frac{") + latex_sum(minus ? above.substr(1) : above, names) + "}{" +
         latex_sum(below, names) + "}";
}

Formula product(const std::string& canonical_text, const Formula& factor, const LatexNames& names) {
  if (canonical_text == "0") return {"0", "0"};
  const auto [above, below] = fraction(canonical_text);
  const bool minus = above[0] == '-' && !is_sum(above);
  const std::string size = minus ? above.substr(1) : above;
  const std::string sign = minus ? "-" : "";
  const std::string divisor = below.empty() ? "" : "/" + parenthesized(readable(below, names));
  const bool in_parentheses = is_sum(size) && !(below.empty() && factor.text.empty());
  std::string text = in_parentheses ? "(" + readable(size, names) + ")" : readable(size, names);
  if (!factor.text.empty()) text = size == "1" ? factor.text : text + "*" + factor.text;
  std::string head = latex_of(canonical_text, names);
  if (!factor.latex.empty()) {
    if (below.empty()) head = size == "1" ? sign : in_parentheses ? "(" + head + ") " : head + " ";
    head += factor.latex;
  }
  return {sign + text + divisor, head};
}

Formula sum(const Formula& a, const Formula& b) {
  if (a.text.empty() || a.text == "0") return b;
  if (b.text.empty() || b.text == "0") return a;
  const bool minus = b.text[0] == '-';
  return {a.text + (minus ? " - " + b.text.substr(1) : " + " + b.text), a.latex + (minus ? "" : "+") + b.latex};
}

Formula formula_of(const AngleForm& form, const std::function<Formula(std::size_t)>& angle) {
  Formula result;
  if (form.halves() != 0 || form.times().empty()) {
    const Rational half(form.halves(), 2);
    result = {half.str(), latex(half)};
  }
  for (const auto& [k, factor] : form.times()) {
    const std::string sign = factor < 0 ? "-" : "";
    const std::string size = std::abs(factor) == 1 ? "" : std::to_string(std::abs(factor));
    const Formula name = angle(k);
    result = sum(result, {sign + size + (size.empty() ? "" : "*") + name.text, sign + size + name.latex});
  }
  return result;
}

}  // namespace steadyslide::symbolic
