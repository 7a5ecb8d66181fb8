// The parser of formulas in the ASCII notation of docs/theory.md.
//
//   row     = { operand | sign | a "/" b }
//   operand = (number | name | "(" row ")" | "[" row "[" | "|" row "|" | "<<" row ">>" | "sqrt" operand) scripts
//   scripts = { "_" script | "^" script | "'" }
//   script  = "{" row "}" | [sign] (number | name | "(" row ")") | sign
//
// A fraction is stacked unless it stands in small text. All factors before the solidus go above the bar: a b/c is the
// same number either way.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "app/html/math_row.hpp"

namespace steadyslide::app {
namespace {

using Shape = MathItem::Shape;

constexpr int deepest = 40;

struct NoFormula {};

/// The bracket around a row.
struct Surroundings {
  std::string_view open;  ///< the bracket; empty: none
  bool list = false;      ///< true if the row has had a comma
};

class Parser {
 public:
  explicit Parser(const std::vector<MathToken>& tokens) : tokens_(tokens) {}

  MathRow whole() {
    MathRow row = read_row("", false);
    if (token().kind != MathToken::Kind::end || row.empty()) throw NoFormula();
    return row;
  }

 private:
  const MathToken& token(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  bool at(std::string_view sign) const { return token().is(sign); }
  bool take(std::string_view sign) {
    if (!at(sign)) return false;
    ++at_;
    return true;
  }

  static bool after_operand(const MathRow& row) { return !row.empty() && row.back().role == MathRole::operand; }

  bool closes(const Surroundings& around, const MathRow& row) const {
    const bool bracket = around.open == "[" || around.open == "]";
    const bool after = after_operand(row);
    if (at(")")) return around.open == "(" || (bracket && around.list);
    if (at("]")) return around.open == "[" || (after && (bracket || (around.open == "(" && around.list)));
    if (at("[")) return after && bracket && around.list;
    if (at("|")) return after && around.open == "|";
    return (at("}") && around.open == "{") || (at(">>") && around.open == "<<");
  }

  /// True if the name is a relation or a word, such as `in` and `for`: an operand before it ends.
  static bool separates(const MathToken& name) {
    const auto symbol = math_name(name.text);
    return symbol && (symbol->role == MathRole::relation || symbol->role == MathRole::word);
  }

  /// True if no operand follows that the sign could belong to: c+, Y- = .
  bool is_postfix() const {
    const MathToken& next = token(1);
    if (next.kind == MathToken::Kind::end) return true;
    if (next.kind == MathToken::Kind::name) return separates(next);
    if (next.kind != MathToken::Kind::sign) return false;
    const auto sign = math_sign(next.text);
    if (!token().space_before && sign && (next.space_before || at("*"))) return true;
    return next.is(")") || next.is("}") || next.is(">>") || (next.is("|") && !next.space_before) ||
           (sign && sign->role != MathRole::binary);
  }

  /// True behind the solidus of a fraction of two numbers, such as 1/2, without a factor before or after it. In one
  /// line it is as clear as stacked, and does not make the line taller.
  bool is_plain_number(const MathRow& row) const {
    const bool numbers = after_operand(row) && row.back().shape == Shape::number &&
                         token().kind == MathToken::Kind::number && token(1).kind != MathToken::Kind::number;
    if (!numbers || (row.size() > 1 && row[row.size() - 2].role == MathRole::operand)) return false;
    const MathToken& next = token(1);
    if (next.is(")") && row.size() == 1) return false;  // (1/2) x
    if (next.kind == MathToken::Kind::name) return separates(next);
    const bool bracket = next.is(")") || next.is("]") || next.is("[") || next.is("}") || next.is(">>");
    return next.kind == MathToken::Kind::end || bracket || math_sign(next.text).has_value();
  }

  MathRow read_row(std::string_view open, bool small) {
    if (++depth_ > deepest) throw NoFormula();
    Surroundings around{open};
    MathRow row;
    while (token().kind != MathToken::Kind::end && !closes(around, row)) {
      const bool space = token().space_before;
      if (take("/")) {
        add_quotient(row, small || is_plain_number(row));
        continue;
      }
      around.list = around.list || at(",");
      row.push_back(read_item(row, small));
      row.back().space_before = space;
      drop_idle_brackets(row);
    }
    --depth_;
    return row;
  }

  MathItem read_item(const MathRow& row, bool small) {
    const MathToken& t = token();
    auto symbol = t.kind == MathToken::Kind::name ? math_name(t.text) : math_sign(t.text);
    if (t.is(":") && t.space_before) symbol->role = MathRole::relation;  // a ratio
    if (!symbol || t.kind == MathToken::Kind::number || symbol->role == MathRole::operand) return read_operand(small);
    if (symbol->role == MathRole::binary) return read_sign(row, *symbol, small);
    ++at_;
    MathItem item = symbol_item(*symbol, small);
    const bool takes_scripts = symbol->role == MathRole::function || symbol->role == MathRole::big;
    return takes_scripts ? with_scripts(std::move(item)) : item;
  }

  MathItem read_sign(const MathRow& row, const MathSymbol& symbol, bool small) {
    const bool postfix = after_operand(row) && is_postfix();
    ++at_;
    if (postfix) return postfix_item(symbol);
    if (!row.empty() && row.back().shape == Shape::prefix) throw NoFormula();
    const bool prefix = row.empty() || (!after_operand(row) && row.back().role != MathRole::big);
    return prefix ? prefix_item(symbol) : symbol_item(symbol, small);
  }

  void add_quotient(MathRow& row, bool small) {
    if (!after_operand(row)) throw NoFormula();
    MathRow denominator{read_operand(true)};
    const MathItem& below = denominator.front();
    const bool call =
        at("(") && !token().space_before && below.shape == Shape::plain && below.xml != name_item("pi").xml;
    if (call || below.role == MathRole::function) denominator.push_back(read_operand(true));
    divide(row, std::move(denominator), small);
  }

  MathItem read_operand(bool small) {
    if (++depth_ > deepest) throw NoFormula();
    const MathToken t = token();
    MathItem item;
    if (t.kind == MathToken::Kind::number) {
      ++at_;
      item = number_item(t.text);
    } else if (t.kind == MathToken::Kind::name) {
      ++at_;
      item = read_name(t, small);
    } else if (take("...")) {
      item = {R"(<mo lspace="0" rspace="0">…</mo>)"};
    } else {
      item = read_group(small);
    }
    --depth_;
    return with_scripts(std::move(item));
  }

  MathItem read_name(const MathToken& t, bool small) {
    if (t.text == "sqrt") {
      const MathItem under = read_operand(small);
      const std::string inside = under.inside.empty() ? under.xml : row_xml(under.inside);
      return {fmt::format("<msqrt>{}</msqrt>", inside), MathRole::operand, Shape::plain, under.width + 1};
    }
    const auto symbol = math_name(t.text);
    if (symbol && symbol->role == MathRole::function) return symbol_item(*symbol, small);
    if (symbol && symbol->role != MathRole::operand) throw NoFormula();
    return name_item(t.text);
  }

  MathItem read_group(bool small) {
    const std::string open = token().text;
    if (open != "(" && open != "[" && open != "]" && open != "{" && open != "|" && open != "<<") throw NoFormula();
    ++at_;
    MathRow row = read_row(open, small);
    if (token().kind != MathToken::Kind::sign || row.empty()) throw NoFormula();
    const std::string close = token().text;
    ++at_;
    return group_item(open, std::move(row), close);
  }

  MathItem with_scripts(MathItem item) {
    Scripts scripts;
    while (at("_") || at("^") || (at("'") && !token().space_before)) {
      if (take("'")) {
        ++scripts.primes;
      } else if (at("_") && token(1).kind == MathToken::Kind::name && math_accent(token(1).text) && scripts.empty()) {
        item = accented(std::move(item), *math_accent(token(1).text));
        at_ += 2;
      } else {
        const bool sub = take("_");
        if (!sub) ++at_;
        (sub ? scripts.sub : scripts.sup).push_back(read_script(sub));
      }
    }
    return scripts.empty() ? item : scripted(std::move(item), scripts);
  }

  std::string read_script(bool sub) {
    if (take("{")) {
      const MathRow row = read_row("{", true);
      if (!take("}") || row.empty()) throw NoFormula();
      return row_xml(row);
    }
    const MathToken t = token();
    const auto symbol = t.kind == MathToken::Kind::sign ? math_sign(t.text) : std::nullopt;
    if (symbol && symbol->role == MathRole::binary) {
      ++at_;
      const bool alone =
          sub || token().space_before || token().kind == MathToken::Kind::sign || token().kind == MathToken::Kind::end;
      const std::string sign = prefix_item(*symbol).xml;
      return alone ? sign : sign + script_leaf();
    }
    return script_leaf();
  }

  std::string script_leaf() {
    const MathToken t = token();
    if (t.kind == MathToken::Kind::sign && t.text != "(") throw NoFormula();
    if (t.kind == MathToken::Kind::sign) return read_group(true).xml;
    if (t.kind == MathToken::Kind::end) throw NoFormula();
    ++at_;
    return t.kind == MathToken::Kind::number ? number_item(t.text).xml : script_name(t.text);
  }

  const std::vector<MathToken>& tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::optional<MathRow> parse_math(std::string_view formula) {
  const auto tokens = math_tokens(formula);
  if (!tokens) return std::nullopt;
  try {
    return Parser(*tokens).whole();
  } catch (const NoFormula&) {
    return std::nullopt;
  }
}

}  // namespace steadyslide::app
