#include "library/problem_file/sample_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "library/problem_file/input_file.hpp"

namespace steadyslide::library {
namespace {

/// Each unit is a thousandth of the one before.
const std::vector<std::string> length_units{"m", "mm", "um", "nm"};

/// 1 unit is 10^exponent m.
int exponent_of(const std::string& unit) {
  return -3 * static_cast<int>(std::find(length_units.begin(), length_units.end(), unit) - length_units.begin());
}

}  // namespace

std::string word(const ProblemReader& reader, const std::string& field, const std::string& what,
                 const std::vector<std::string>& words, const std::string& otherwise) {
  const Value* value = reader.find(field);
  if (value == nullptr) return otherwise;
  const std::string& given = reader.text(field, *value);
  if (std::find(words.begin(), words.end(), given) != words.end()) return given;
  throw reader.error(field, what, fmt::format("it is one of {}", fmt::join(words, ", ")), excerpt(given));
}

std::string length_unit(const ProblemReader& reader, const std::string& field) {
  return word(reader, field, "unknown unit", length_units, "");
}

Rational unit_ratio(const std::string& from, const std::string& to) {
  return parse_rational(fmt::format("1e{}", exponent_of(from) - exponent_of(to)));
}

std::string file_field(const ProblemReader& reader, const std::string& field,
                       std::initializer_list<std::string_view> keys) {
  const Value& value = *reader.find(field);
  if (value.kind == Value::Kind::text) return field;
  if (value.kind != Value::Kind::table) {
    throw reader.error(field, "wrong type", fmt::format("it is a string or a table {{{}}}", fmt::join(keys, ", ")),
                       name_of(value.kind));
  }
  reader.check_keys(field, keys);
  std::string file = field + ".file";
  reader.text(file, reader.required(file, "samples have a file"));
  return file;
}

SampleFile read_samples(const ProblemReader& reader, const std::string& field, const std::string& beside,
                        const std::string& kind) {
  const std::string& given = reader.find(field)->text;
  if (is_table(given)) {
    const InvalidFile place = reader.error(field, "");
    const std::string name = beside.empty() ? place.complaint() : place.what();
    return {name.substr(0, name.size() - 2) + "[]", given};
  }
  const auto unreadable = [&](const std::string& value) {
    return reader.error(field, "no such " + kind, "it names a file, relative to the problem file", value);
  };
  std::string path = (std::filesystem::path(beside).parent_path() / given).string();
  if (path == "-") path = "./-";
  if (path.find('\0') != std::string::npos) throw unreadable(excerpt(path));
  try {
    return {path, read_input(path, "a " + kind)};
  } catch (const UnreadableFile& file) {
    throw unreadable(file.what());
  }
}

}  // namespace steadyslide::library
