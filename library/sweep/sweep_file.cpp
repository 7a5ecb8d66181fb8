#include "library/sweep/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/input_file.hpp"
#include "library/problem_file/problem_reader.hpp"
#include "library/solve/method.hpp"
#include "library/sweep/random_decimals.hpp"
#include "library/sweep/varied_values.hpp"
#include "library/text/one_line.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t max_columns = 1000;
constexpr int max_cells = 4194304;

using Position = std::pair<std::size_t, std::size_t>;  // line and column

struct PlacedAxis {
  Position position;
  Axis axis;
};

class SweepReader {
 public:
  SweepReader(const Value& root, const std::string& name) : name_(name), reader_(root, name, "a sweep") {}

  SweepFile read(std::string_view text) {
    reader_.check_keys("", {"problem", "vary", "together", "output", "solve"});
    std::uint64_t fingerprint = fnv1a(text);
    auto [base, file] = read_base(fingerprint);
    std::vector<Axis> axes = read_axes();
    for (const std::string& trace : traces(base, axes)) fingerprint = fnv1a(contents_beside(file, trace), fingerprint);
    return {
        Combinations(std::move(base), file, std::move(axes), name_),
        read_columns(),
        read_method(),
        count("digits", 1, 100),
        count("cells", 16, max_cells),
        count("iterations", 1, 10000),
        checked_number("accuracy", accuracy_rule, is_accuracy),
        checked_number("over", "the length of a window is positive", [](const Rational& length) { return length > 0; }),
        checked_number("depth", "a depth is at least 0", [](const Rational& depth) { return depth >= 0; }),
        fingerprint};
  }

 private:
  struct Base {
    Value document;
    std::string file;
  };

  Base read_base(std::uint64_t& fingerprint) const {
    const Value& problem = reader_.required("problem", "a sweep has a problem: the name of a file, or a table");
    if (problem.kind == Value::Kind::table) return {problem, name_};
    const std::string file = (std::filesystem::path(name_).parent_path() / reader_.text("problem", problem)).string();
    std::string text;
    try {
      text = read_input(file == "-" ? "./-" : file, "a problem file");
    } catch (const UnreadableFile& unreadable) {
      throw reader_.error("problem", "no such problem file", "it is a file, relative to the sweep", unreadable.what());
    }
    fingerprint = fnv1a(text, fingerprint);
    return {parse_document(text, file), file};
  }

  /// Returns the names of the measured profiles.
  static std::vector<std::string> traces(const Value& base, const std::vector<Axis>& axes) {
    std::vector<std::string> names;
    for (const std::string path : {"indenter.samples", "indenter.samples.file"}) {
      const Value* value = ProblemReader(base, "").find(path);
      if (value != nullptr) names.push_back(value->text);
      for (const Axis& axis : axes) {
        for (const VariedDatum& datum : axis) {
          for (std::size_t k = 0; datum.path == path && k < datum.values.size(); ++k)
            names.push_back(datum.values[k].text);
        }
      }
    }
    return names;
  }

  /// Returns the contents of a file in the folder of `file`; empty if it cannot be read. Its problems report that
  /// error.
  static std::string contents_beside(const std::string& file, const std::string& name) {
    try {
      return name.empty() ? "" : read_input((std::filesystem::path(file).parent_path() / name).string(), "a trace");
    } catch (const std::exception&) {
      return "";
    }
  }

  /// In the order of the file: the data of [vary]; the data of [together] are one axis.
  std::vector<Axis> read_axes() const {
    std::vector<PlacedAxis> placed;
    for (auto& [position, datum] : read_data("vary")) placed.push_back({position, {std::move(datum)}});
    auto together = read_data("together");
    if (!together.empty()) {
      PlacedAxis axis{together.front().position, {}};
      for (auto& [position, datum] : together) axis.axis.push_back(std::move(datum));
      check_lengths(axis.axis);
      placed.push_back(std::move(axis));
    }
    if (placed.empty()) {
      throw reader_.error("vary", "nothing varied", "a sweep has data in [vary] or in [together]", "none");
    }
    std::ranges::stable_sort(placed, {}, &PlacedAxis::position);
    std::vector<Axis> axes;
    for (PlacedAxis& axis : placed) axes.push_back(std::move(axis.axis));
    return axes;
  }

  struct PlacedDatum {
    Position position;
    VariedDatum datum;
  };

  std::vector<PlacedDatum> read_data(const std::string& table) const {
    std::vector<PlacedDatum> data;
    const Value* value = reader_.find(table);
    if (value == nullptr) return data;
    if (value->kind != Value::Kind::table) {
      throw reader_.error(table, "wrong type", "it is a table", name_of(value->kind));
    }
    collect(*value, "", data);
    std::ranges::stable_sort(data, {}, &PlacedDatum::position);
    return data;
  }

  /// Keys with dots make tables inside tables: half_space.poisson is "half_space.poisson".
  void collect(const Value& table, const std::string& prefix, std::vector<PlacedDatum>& data) const {
    for (const Entry& entry : table.entries) {
      const std::string path = prefix + entry.key;
      if (entry.value.kind == Value::Kind::table && entry.value.find("random") == nullptr) {
        collect(entry.value, path + ".", data);
      } else {
        data.push_back({{entry.line, entry.column}, {path, entry.line, varied_values(path, entry, name_)}});
      }
    }
  }

  void check_lengths(const Axis& axis) const {
    const std::size_t length = axis.front().values.size();
    for (const VariedDatum& datum : axis) {
      if (datum.values.size() == length) continue;
      throw InvalidFile(fmt::format("{}:{}", name_, datum.line),
                        fmt::format("{}: not as many values; data that vary together have as many as {}; {}, not {}",
                                    datum.path, axis.front().path, datum.values.size(), length));
    }
  }

  std::vector<Word> read_columns() const {
    std::vector<Word> columns;
    if (reader_.find("output") == nullptr) return columns;
    reader_.check_table("output", {"columns"});
    const Value& list = reader_.required("output.columns", "output has columns");
    for (const Value& item : reader_.list("output.columns", list, "names", max_columns)) {
      const std::string field = fmt::format("output.columns[{}]", columns.size());
      columns.push_back({reader_.text(field, item), fmt::format("{}:{}: {}", name_, item.line, field)});
    }
    if (columns.empty()) throw reader_.error("output.columns", "no columns", "there is at least one", "none");
    return columns;
  }

  std::optional<Word> read_method() const {
    if (reader_.find("solve") == nullptr) return std::nullopt;
    reader_.check_table("solve", {"digits", "method", "cells", "accuracy", "iterations", "over", "depth"});
    const Value* method = reader_.find("solve.method");
    if (method == nullptr) return std::nullopt;
    return Word{reader_.text("solve.method", *method), fmt::format("{}:{}: solve.method", name_, method->line)};
  }

  std::optional<int> count(const std::string& key, int least, int most) const {
    const std::string field = "solve." + key;
    const Value* value = reader_.find(field);
    if (value == nullptr) return std::nullopt;
    const Rational number = reader_.number(field, *value);
    if (number < least || number > most || denominator(number) != 1) {
      throw reader_.error(field, "out of range", fmt::format("it is a whole number from {} to {}", least, most),
                          excerpt(value->text));
    }
    return number.convert_to<int>();
  }

  std::optional<Rational> checked_number(const std::string& key, const char* rule,
                                         bool (*is_allowed)(const Rational&)) const {
    const std::optional<Rational> number = reader_.number_if_any("solve." + key);
    if (!number || is_allowed(*number)) return number;
    throw reader_.error("solve." + key, "out of range", rule, to_string(*number));
  }

  const std::string& name_;
  ProblemReader reader_;
};

}  // namespace

SweepFile read_sweep(const std::string& name) {
  const std::string text = read_input(name, "a sweep");
  const Value root = parse_document(text, name, "a sweep");
  return SweepReader(root, name).read(text);
}

}  // namespace steadyslide::library
