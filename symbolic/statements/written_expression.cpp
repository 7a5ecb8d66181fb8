#include "symbolic/statements/written_expression.hpp"

#include <cctype>

#include "symbolic/field/rational_function.hpp"
#include "symbolic/statements/statement_lines.hpp"
#include "symbolic/statements/written_functions.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using Arguments = std::vector<ex>;

class ExpressionReader {
 public:
  ExpressionReader(std::string text, ExpressionMeaning& meaning) : text_(std::move(text)), meaning_(meaning) {}
  ex all() {
    const ex result = sum();
    if (at_ != text_.size()) refuse("not an expression", text_);
    return result;
  }

 private:
  bool next(char c) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  ex sum() {
    ex result = product();
    for (;;) {
      if (next('+')) {
        result = result + product();
      } else if (next('-')) {
        result = result - product();
      } else {
        return result;
      }
    }
  }
  ex product() {
    ex result = factor();
    for (;;) {
      if (next('*')) {
        result = result * factor();
      } else if (next('/')) {
        result = result / factor();
      } else {
        return result;
      }
    }
  }
  ex factor() {
    if (next('-')) return -factor();
    ex base = atom();
    while (next('[')) {
      const std::size_t k = count(value_of(enclosed(']'), meaning_));
      if (k >= entries(base).size()) refuse("no such entry", text_);
      base = base.op(k);
    }
    return next('^') ? GiNaC::pow(base, factor()) : base;
  }
  ex atom() {
    if (next('(')) {
      const ex inside = sum();
      close();
      return inside;
    }
    if (next('[')) return list_of(meaning_.items(enclosed(']')));
    std::string name;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '\'') break;
      name += c;
    }
    if (name.empty()) refuse("not an expression", text_);
    if (std::isdigit(static_cast<unsigned char>(name[0])) != 0) return GiNaC::numeric(name.c_str());
    if (name.back() == '_' && next('{'))
      return meaning_.named(name + canonical_text(value_of(enclosed('}'), meaning_)));
    if (!next('(')) return meaning_.named(name);
    Arguments arguments{sum()};
    while (next(',')) arguments.push_back(sum());
    close();
    return meaning_.call(name, arguments);
  }
  /// Returns the text up to the matching closing bracket.
  std::string enclosed(char bracket) {
    const std::size_t first = at_;
    for (int depth = 1; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
      if (depth == 0 && c == bracket) return text_.substr(first, at_++ - first);
    }
    refuse("a bracket is not closed", text_);
  }
  void close() {
    if (!next(')')) refuse("a parenthesis is not closed", text_);
  }

  std::string text_;
  ExpressionMeaning& meaning_;
  std::size_t at_ = 0;
};

}  // namespace

ex value_of(const std::string& text, ExpressionMeaning& meaning) { return ExpressionReader(text, meaning).all(); }

}  // namespace steadyslide::symbolic
