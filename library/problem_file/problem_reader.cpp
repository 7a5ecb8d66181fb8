#include "library/problem_file/problem_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace steadyslide::library {
namespace {

/// Returns the text up to the next '.' or '[' and removes it from `field`. An index is "2]".
std::string_view next_part(std::string_view& field) {
  const std::size_t end = std::min(field.find_first_of(".["), field.size());
  const std::string_view part = field.substr(0, end);
  field.remove_prefix(std::min(end + 1, field.size()));
  return part;
}

}  // namespace

ProblemReader::Found ProblemReader::locate(std::string_view field) const {
  Found found{&root_, root_.line, &file_};
  while (!field.empty()) {
    const std::string_view part = next_part(field);
    if (part.empty()) continue;
    const Value* inside = nullptr;
    if (part.back() == ']') {
      std::size_t index = 0;
      std::from_chars(part.data(), part.data() + part.size(), index);
      if (index < found.value->items.size()) inside = &found.value->items[index];
      if (inside != nullptr) found.line = inside->line;
    } else if (const Entry* entry = found.value->find(part)) {
      inside = &entry->value;
      found.line = entry->line;
    }
    if (inside != nullptr && inside->file != nullptr) {
      found.file = inside->file;
      found.line = inside->line;
    }
    found.value = inside;
    if (inside == nullptr) return found;
  }
  return found;
}

std::string ProblemReader::Found::place() const { return fmt::format("{}:{}", *file, line); }

InvalidFile ProblemReader::error(const std::string& field, const std::string& what) const {
  return {locate(field).place(), field + (field.empty() ? "" : ": ") + what};
}

InvalidFile ProblemReader::error(const std::string& field, const std::string& what, const std::string& rule,
                                 const std::string& value) const {
  return error(field, fmt::format("{}; {}; {}", what, rule, value));
}

const Value& ProblemReader::required(const std::string& field, const std::string& rule) const {
  const Value* value = find(field);
  if (value == nullptr) throw error(field, "missing", rule, "absent");
  return *value;
}

void ProblemReader::check_table(const std::string& field, std::initializer_list<std::string_view> keys) const {
  const Value& value = required(field, "the table is required");
  if (value.kind != Value::Kind::table) throw error(field, "wrong type", "it is a table", name_of(value.kind));
  check_keys(field, keys);
}

void ProblemReader::check_keys(const std::string& field, std::initializer_list<std::string_view> keys) const {
  for (const Entry& entry : find(field)->entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    const std::string& file = entry.value.file != nullptr ? *entry.value.file : file_;
    throw InvalidFile(fmt::format("{}:{}", file, entry.line),
                      fmt::format("unknown key; the keys of {} are {}; {}", field.empty() ? kind_ : field,
                                  fmt::join(keys, ", "), excerpt(entry.key)));
  }
}

Rational ProblemReader::number(const std::string& field, const Value& value) const {
  const bool fits =
      value.kind == Value::Kind::text || value.kind == Value::Kind::integer || value.kind == Value::Kind::decimal;
  if (!fits) throw error(field, "wrong type", "a number is a string, an integer or a decimal", name_of(value.kind));
  return accepted(field, [&] { return parse_rational(value.text); });
}

std::optional<Rational> ProblemReader::number_if_any(const std::string& field) const {
  const Value* value = find(field);
  return value == nullptr ? std::nullopt : std::optional(number(field, *value));
}

const std::string& ProblemReader::text(const std::string& field, const Value& value) const {
  if (value.kind == Value::Kind::text) return value.text;
  throw error(field, "wrong type", "it is a string", name_of(value.kind));
}

const std::vector<Value>& ProblemReader::list(const std::string& field, const Value& value, const std::string& of,
                                              std::size_t most) const {
  if (value.kind != Value::Kind::list) {
    throw error(field, "wrong type", "it is an array of " + of, name_of(value.kind));
  }
  if (value.items.size() > most) {
    throw error(field, "too many entries", fmt::format("there are at most {}", most),
                fmt::format("{} entries", value.items.size()));
  }
  return value.items;
}

std::vector<Rational> ProblemReader::numbers(const std::string& field, std::size_t most) const {
  std::vector<Rational> result;
  const Value* value = find(field);
  if (value == nullptr) return result;
  for (const Value& item : list(field, *value, "numbers", most)) {
    result.push_back(number(fmt::format("{}[{}]", field, result.size()), item));
  }
  return result;
}

}  // namespace steadyslide::library
