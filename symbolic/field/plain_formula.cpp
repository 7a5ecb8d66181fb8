#include "symbolic/field/plain_formula.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "symbolic/field/character.hpp"

namespace steadyslide::symbolic {
namespace {

constexpr std::array<std::string_view, 26> commands{
    "alpha", "beta", "gamma", "delta", "theta", "kappa", "lambda", "mu",  "nu",  "pi",  "psi",    "sigma", "Phi",
    "Psi",   "int",  "sum",   "prod",  "sin",   "cos",   "tan",    "cot", "log", "exp", "arctan", "sqrt",  "xi"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> signs{
    {{"...", "\\dots "}, {"<=", "\\le "}, {">=", "\\ge "}, {"!=", "\\ne "}, {"->", "\\to "}, {"+-", "\\pm "}}};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::string latex() {
    std::string result;
    while (!text_.empty()) result += next();
    return result;
  }

 private:
  template <class Belongs>
  std::string_view take_while(Belongs belongs) {
    const auto length = static_cast<std::size_t>(std::ranges::find_if_not(text_, belongs) - text_.begin());
    const std::string_view taken = text_.substr(0, length);
    text_.remove_prefix(length);
    return taken;
  }

  bool take(std::string_view start) {
    if (!text_.starts_with(start)) return false;
    text_.remove_prefix(start.size());
    return true;
  }

  std::string next() {
    if (is_letter(text_.front())) return operand();
    if (take("^")) return "^" + script();
    for (const auto& [plain, latex] : signs) {
      if (take(plain)) return std::string(latex);
    }
    const char c = text_.front();
    text_.remove_prefix(1);
    return c == '{' || c == '}' ? std::string("\\") + c : std::string(1, c);
  }

  /// Reads a name with its accent, its subscript and its superscript.
  std::string operand() {
    const std::string_view letters = take_while(is_letter);
    std::string result = name(letters);
    if (take("_bar")) result = "\\bar" + (result[0] == '\\' ? result : "{" + result + "}");
    if (take("_")) result += "_" + script();
    const bool touches = !text_.empty() && (text_[0] == '+' || text_[0] == '-') && text_.substr(0, 2) != "+-";
    const bool alone = text_.size() < 2 || std::string_view(" ,;/)").find(text_[1]) != std::string_view::npos;
    if (touches && alone) {
      result += std::string("^") + text_[0];
      text_.remove_prefix(1);
    }
    return result;
  }

  static std::string name(std::string_view letters) {
    if (letters == "infinity" || letters == "oo") return "\\infty ";
    if (std::ranges::find(commands, letters) != commands.end()) return "\\" + std::string(letters) + " ";
    return letters.size() == 1 ? std::string(letters) : "\\mathrm{" + std::string(letters) + "}";
  }

  /// Reads a subscript or superscript: a side, a sign, a name, a number, or all between braces or parentheses.
  std::string script() {
    if (take("{")) return "{" + inside('}') + "}";
    if (take("(")) return "{" + inside(')') + "}";
    const std::string sign = take("-") ? "-" : take("+") ? "+" : "";
    if (!text_.empty() && is_digit(text_[0])) return "{" + sign + std::string(take_while(is_digit)) + "}";
    if (!sign.empty()) return sign;
    const std::string_view letters = take_while(is_letter);
    return letters == "l" ? "-" : letters == "r" ? "+" : "{" + name(letters) + "}";
  }

  std::string inside(char close) {
    const std::string_view all = text_.substr(0, text_.find(close));
    text_.remove_prefix(std::min(all.size() + 1, text_.size()));
    return Reader(all).latex();
  }

  std::string_view text_;
};

/// Returns words as LaTeX, with LaTeX's special characters escaped.
std::string escaped(std::string_view words) {
  std::string result;
  for (const char c : words) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '<': result += "\\textless{}"; break;
      case '>': result += "\\textgreater{}"; break;
      case '|': result += "\\textbar{}"; break;
      case '_':
      case '#':
      case '$':
      case '%':
      case '&':
      case '{':
      case '}':
        result += '\\';
        result += c;
        break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace

std::string latex_of_plain(std::string_view formula) { return Reader(formula).latex(); }

std::string without_marks(std::string_view sentence) {
  std::string result(sentence);
  std::erase(result, '`');
  return result;
}

std::string latex_sentence(std::string_view sentence) {
  std::string result;
  for (bool is_formula = false; !sentence.empty(); is_formula = !is_formula) {
    const std::string_view part = sentence.substr(0, sentence.find('`'));
    result += is_formula ? "$" + latex_of_plain(part) + "$" : escaped(part);
    sentence.remove_prefix(std::min(part.size() + 1, sentence.size()));
  }
  return result;
}

}  // namespace steadyslide::symbolic
