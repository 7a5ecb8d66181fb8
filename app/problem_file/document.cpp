#include "app/problem_file/document.hpp"

#include <fmt/format.h>

// The library (3.3.0) asserts, or promises the optimizer, what its next line then tests and reports as an error of the
// document. Without its assertions that test decides.
#undef NDEBUG
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "app/problem_file/document_text.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

/// Tables that dotted keys imply have no place of their own: they get `line`, that of what contains them.
std::size_t line_of(const toml::node& node, std::size_t line) {
  return node.source().begin.line != 0 ? node.source().begin.line : line;
}

std::string shortest(double value) {
  std::array<char, 400> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

Value converted(const toml::node& node, std::size_t enclosing_line) {
  Value value;
  value.line = line_of(node, enclosing_line);
  if (const toml::table* table = node.as_table()) {
    value.kind = Value::Kind::table;
    for (const auto& [key, child] : *table) {
      const std::size_t key_line = key.source().begin.line != 0 ? key.source().begin.line : value.line;
      value.entries.push_back({std::string(key.str()), key_line, converted(child, key_line)});
    }
    std::stable_sort(value.entries.begin(), value.entries.end(),
                     [](const Entry& a, const Entry& b) { return a.line < b.line; });
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Value::Kind::list;
    value.items.reserve(array->size());
    for (const toml::node& child : *array) value.items.push_back(converted(child, value.line));
  } else if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Value::Kind::integer;
    value.text = std::to_string(integer->get());
  } else if (const auto* decimal = node.as_floating_point()) {
    value.kind = Value::Kind::decimal;
    value.text = shortest(decimal->get());
  } else {
    value.kind = node.is_boolean() ? Value::Kind::boolean : Value::Kind::date;
  }
  return value;
}

}  // namespace

const Value* Value::find(std::string_view key) const {
  const auto entry = std::ranges::find(entries, key, &Entry::key);
  return entry == entries.end() ? nullptr : &entry->value;
}

const char* name_of(Value::Kind kind) {
  switch (kind) {
    case Value::Kind::text: return "a string";
    case Value::Kind::integer: return "an integer";
    case Value::Kind::decimal: return "a decimal number";
    case Value::Kind::boolean: return "a boolean";
    case Value::Kind::date: return "a date or time";
    case Value::Kind::list: return "an array";
    case Value::Kind::table: return "a table";
  }
  return "";
}

Value parse_document(std::string_view text, const std::string& name) {
  const std::string ascii = ready_for_parser(text, name);
  try {
    return converted(toml::parse(std::string_view(ascii)), 1);
  } catch (const toml::parse_error& error) {
    throw Failure(ExitCode::bad_input,
                  fmt::format("{}:{}: not TOML; a problem file is written in TOML; {}", name,
                              std::max<std::size_t>(error.source().begin.line, 1), std::string(error.description())));
  }
}

}  // namespace steadyslide::app
