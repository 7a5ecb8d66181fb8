#include "app/html/math_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steadyslide::app {
namespace {

using Shape = MathItem::Shape;

/// Returns an <mi>. Browsers set an identifier of one letter in italics, and an identifier of several letters upright.
std::string identifier(std::string_view glyph, bool upright = false) {
  return fmt::format("<mi{}>{}</mi>", upright ? R"( mathvariant="normal")" : "", glyph);
}

bool is_letter_name(std::string_view name) {
  const auto symbol = math_name(name);
  return symbol ? symbol->role == MathRole::operand && !symbol->upright : name.size() == 1;
}

/// Returns a bracket. As the first and last items of a row, brackets are prefix and postfix operators, which have no
/// spaces. Brackets around a row that is not tall are identifiers, because those are not stretched: stretching would
/// only move the brackets apart.
std::string bracket(std::string_view sign, bool tall) {
  const std::string_view glyph = sign == "<<" ? "⟨" : sign == ">>" ? "⟩" : sign;
  return fmt::format("<{0}>{1}</{0}>", tall ? "mo" : "mi", glyph);
}

}  // namespace

MathItem number_item(std::string_view digits) {
  const std::size_t e = digits.find('e');
  if (e == std::string_view::npos) {
    constexpr std::size_t longest = 14, kept = 9;
    const std::string xml = digits.size() <= longest
                                ? fmt::format("<mn>{}</mn>", digits)
                                : fmt::format(R"(<mn title="{}">{}…</mn>)", digits, digits.substr(0, kept));
    return {xml, MathRole::operand, Shape::number, std::min(digits.size(), longest)};
  }
  const std::string_view mantissa = digits.substr(0, e);
  const std::string_view exponent = digits.substr(e + 1);
  const std::size_t first = exponent.find_first_not_of("+-0");
  if (first == std::string_view::npos) return number_item(mantissa);
  const std::string power = fmt::format("<msup><mn>10</mn><mrow>{}<mn>{}</mn></mrow></msup>",
                                        exponent.starts_with('-') ? "<mo>−</mo>" : "", exponent.substr(first));
  const bool one = mantissa == "1" || mantissa == "1.0";
  const std::string xml =
      one ? power : fmt::format(R"(<mrow><mn>{}</mn><mo lspace=".1em" rspace=".1em">×</mo>{}</mrow>)", mantissa, power);
  return {xml, MathRole::operand, Shape::number, digits.size() + 2};
}

MathItem name_item(std::string_view name) {
  if (const auto symbol = math_name(name)) {
    return {identifier(symbol->glyph, symbol->upright), MathRole::operand, Shape::plain, 1};
  }
  if (name.size() == 1) return {identifier(name), MathRole::operand, Shape::plain, 1};
  if (name == "PV") return {identifier(name), MathRole::big, Shape::upright, 2};
  if (name.front() == 'd' && is_letter_name(name.substr(1))) {
    const std::string xml = "<mi>d</mi>" + name_item(name.substr(1)).xml;
    return {fmt::format("<mrow>{}</mrow>", xml), MathRole::operand, Shape::differential, 2};
  }
  return {identifier(name), MathRole::operand, Shape::upright, name.size()};
}

MathItem symbol_item(const MathSymbol& symbol, bool small) {
  const auto& [glyph, role, upright] = symbol;
  if (role == MathRole::function) return {identifier(glyph), role, Shape::plain, glyph.size()};
  if (role == MathRole::word) return {fmt::format("<mtext>{}</mtext>", glyph), role, Shape::upright, glyph.size()};
  if (role == MathRole::big) {
    return {fmt::format(R"(<mo lspace="0" rspace="0" movablelimits="false">{}</mo>)", glyph), role};
  }
  if (role == MathRole::punctuation) {
    return {fmt::format(R"(<mo lspace="0" rspace="{}em">{}</mo>)", small ? ".1" : ".3", glyph), role};
  }
  const std::string_view space = small ? ".08" : role == MathRole::relation ? ".28" : ".22";
  return {fmt::format(R"(<mo lspace="{0}em" rspace="{0}em">{1}</mo>)", space, glyph), role};
}

MathItem prefix_item(const MathSymbol& symbol) {
  return {fmt::format(R"(<mo lspace="0" rspace="0">{}</mo>)", symbol.glyph), MathRole::binary, Shape::prefix};
}

MathItem postfix_item(const MathSymbol& symbol) {
  return {fmt::format(R"(<mo lspace="0" rspace="0">{}</mo>)", symbol.glyph)};
}

MathItem group_item(std::string_view open, MathRow row, std::string_view close) {
  const bool tall = std::ranges::any_of(row, &MathItem::tall);
  const std::string inside = bracket(open, tall) + row_xml(row) + bracket(close, tall);
  MathItem item{tall ? fmt::format("<mrow>{}</mrow>", inside) : inside};
  item.shape = Shape::group;
  item.width = row_width(row) + 2;
  item.tall = tall;
  if (open == "(" && close == ")") item.inside = std::move(row);
  return item;
}

MathItem scripted(MathItem base, const Scripts& scripts) {
  constexpr std::array marks{"", "′", "″", "‴"};
  const std::string mark = marks.at(std::min(scripts.primes, marks.size() - 1));
  const std::string sub = fmt::format("{}", fmt::join(scripts.sub, ""));
  const std::string sup = fmt::format("{}", fmt::join(scripts.sup, ""));
  // The prime of a text font is high enough. As a superscript it would be too high (report.css, .prime).
  if (!mark.empty())
    base.xml = fmt::format(R"(<mrow>{}<mo class="prime" lspace="0" rspace="0">{}</mo></mrow>)", base.xml, mark);
  if (sub.empty() && sup.empty()) {
    // Only a prime: nothing more to add.
  } else if (sub.empty()) {
    base.xml = math_element("msup", {base.xml, sup});
  } else if (sup.empty()) {
    base.xml = math_element("msub", {base.xml, sub});
  } else {
    base.xml = math_element("msubsup", {base.xml, sub, sup});
  }
  base.inside.clear();
  base.width += 1 + scripts.sub.size() + scripts.sup.size();
  return base;
}

MathItem accented(MathItem base, std::string_view accent) {
  // In common fonts a bar that is marked as an accent touches its letter.
  const bool bar = accent == math_accent("bar");
  base.xml = fmt::format(R"(<mover accent="{}"><mrow>{}</mrow><mo stretchy="{}">{}</mo></mover>)", !bar, base.xml, bar,
                         accent);
  base.inside.clear();
  return base;
}

std::string script_name(std::string_view name) {
  const bool axes = name.size() == 2 && std::ranges::all_of(name, [](char c) { return c >= 'i' && c <= 'z'; });
  if (!axes || math_name(name)) return name_item(name).xml;
  return identifier(name.substr(0, 1)) + identifier(name.substr(1));
}

}  // namespace steadyslide::app
