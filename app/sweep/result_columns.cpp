#include "app/sweep/result_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/results/solve_json.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array all_entries{"method",          "digits",     "cells",           "contact",
                                 "singular_points", "resultants", "estimated_error", "residuals",
                                 "largest_stress",  "uniqueness", "warnings"};

/// A result with all possible keys, without values. No problem is solved for it.
SolutionText all_keys() {
  SolutionText keys;
  keys.cells.emplace();
  keys.contact.resize(1);
  keys.width.resize(1);
  keys.component_load.resize(1);
  keys.singular_points.resize(2);
  keys.singular_points.back().stress_intensity.apart = true;  // a jump
  answer::for_each_quantity(keys.resultants, []<class Value>(const answer::Quantity&, Value& value) {
    if constexpr (requires { value.emplace(); }) value.emplace();
    if constexpr (requires { value.resize(1); }) value.resize(1);
  });
  keys.field.largest_stress.emplace().average.emplace();
  for (const char* part : {"ends", "traction", "resultants"}) keys.errors.push_back({part, ""});
  for (const auto& [name, size] : library::named(numeric::Residuals<double>{})) keys.residuals.push_back({name, ""});
  return keys;
}

/// Returns the value at the end of the steps; null if there is none. `any`: an index stands for any index.
const Json* found(const Json& json, std::span<const Step> steps, bool any = false) {
  if (steps.empty()) return &json;
  if (const auto* key = std::get_if<std::string>(&steps[0])) {
    const auto entry = json.is_object() ? json.find(*key) : json.end();
    return entry == json.end() ? nullptr : found(*entry, steps.subspan(1), any);
  }
  if (!json.is_array()) return nullptr;
  if (!any) {
    const std::size_t index = std::get<std::size_t>(steps[0]);
    return index < json.size() ? found(json[index], steps.subspan(1)) : nullptr;
  }
  for (const Json& item : json) {
    if (const Json* there = found(item, steps.subspan(1), any)) return there;
  }
  return nullptr;
}

bool asks_size(const std::vector<Step>& steps) { return !steps.empty() && steps.back() == Step("size"); }

/// True for a number with its error (rows.hpp).
bool is_number(const Json& json) { return json.is_object() && json.contains("error"); }

/// The text of a value. For a number, `part` chooses its value or its error.
std::string text_of(const Json& json, const char* part) {
  if (json.is_null()) return "";
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number()) return full_number(json.get<double>(), 16);
  if (!json.is_structured()) return json.dump();
  if (is_number(json)) return text_of(json.at(part), part);
  // Two limits that differ in this solution; the shape with which the name was checked has one.
  std::vector<std::string> parts;
  for (const Json& one : json) parts.push_back(text_of(one, part));
  return fmt::format("{}", fmt::join(parts, " "));
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

/// The rule for an unknown name: the keys that exist at the place up to which the path is right.
std::string what_is_there(const Json& shape, std::span<const Step> steps) {
  std::size_t right = steps.size();
  while (found(shape, steps.first(right), true) == nullptr) --right;
  const Json& last = *found(shape, steps.first(right), true);
  if (last.is_array()) return "a list has entries [0], [1], ... and a size";
  if (!last.is_object()) return "the path ends before";
  std::vector<std::string> keys = keys_of(last);
  if (right == 0) {
    for (std::string& key : keys_of(shape.at("resultants"))) keys.push_back(std::move(key));
  }
  return fmt::format("keys here are {}", fmt::join(keys, ", "));
}

/// Returns the value of a name, or null, and completes the steps: for a table with a value, to that value. For
/// "load_share_error[0]" it sets `is_error` and makes the steps of "load_share[0]".
const Json* named(const Json& shape, std::vector<Step>& steps, bool& is_error) {
  if (const Json* there = found(shape, steps, true)) {
    if (is_number(*there) || !there->is_object() || !there->contains("value")) return there;
    steps.emplace_back("value");
    return &there->at("value");
  }
  constexpr std::string_view ending = "_error";
  std::vector<Step> value = steps;
  const auto last = std::ranges::find_if(value.rbegin(), value.rend(),
                                         [](const Step& step) { return std::holds_alternative<std::string>(step); });
  if (is_error || last == value.rend() || !std::get<std::string>(*last).ends_with(ending)) return nullptr;
  auto& name = std::get<std::string>(*last);
  name.erase(name.size() - ending.size());
  is_error = true;
  const Json* there = named(shape, value, is_error);
  is_error = there != nullptr && is_number(*there);
  if (!is_error) return nullptr;
  steps = std::move(value);
  return there;
}

/// If a name is that of an entry of the resultants, returns its steps from the top.
std::vector<Step> from_the_top(const Json& shape, const std::vector<Step>& steps) {
  if (steps.empty() || shape.contains(std::get<std::string>(steps.front()))) return steps;
  std::vector<Step> longer = steps;
  longer.insert(longer.begin(), "resultants");
  std::vector<Step> there = longer;
  bool is_error = false;
  return named(shape, there, is_error) != nullptr ? longer : steps;
}

/// Completes the steps of a name. Throws Failure if the name leads nowhere, or to several values. Returns true if the
/// name means an error.
bool check(const Word& name, const Json& shape, std::vector<Step>& steps) {
  const auto bad = [&](const std::string& what, const std::string& rule) {
    return Failure(ExitCode::bad_input, fmt::format("{}: {}; {}; {}", name.place, what, rule, excerpt(name.text)));
  };
  if (steps.empty()) throw bad("no path", "a column is named like contact[0].left.x");
  bool is_error = false;
  const Json* there = named(shape, steps, is_error);
  if (there == nullptr && asks_size(steps)) {
    there = found(shape, std::span(steps).first(steps.size() - 1), true);
    if (there != nullptr && there->is_array()) return false;
    there = nullptr;
  }
  if (there == nullptr) throw bad("unknown column", what_is_there(shape, steps));
  if (there->is_object() && !is_number(*there)) {
    throw bad("not one value", fmt::format("its keys are {}", fmt::join(keys_of(*there), ", ")));
  }
  if (there->is_array()) throw bad("not one value", "a list has entries [0], [1], ... and a size");
  return is_error;
}

}  // namespace

ResultColumns::ResultColumns(const std::vector<Word>& names) {
  Json whole;
  const SolutionText solution = all_keys();
  for (const char* entry : all_entries) whole[entry] = solution_entry(solution, entry);
  for (const Word& name : names) {
    std::vector<Step> steps = from_the_top(whole, steps_of(name.text));
    const char* part = check(name, whole, steps) ? "error" : "value";
    if (std::ranges::find(columns_, name.text, &Column::name) != columns_.end()) {
      throw Failure(ExitCode::bad_input,
                    fmt::format("{}: column twice; a column is named once; {}", name.place, excerpt(name.text)));
    }
    Start start{std::get<std::string>(steps.front()), std::nullopt};
    steps.erase(steps.begin());
    if (!steps.empty()) {
      start.next = std::move(steps.front());
      steps.erase(steps.begin());
    }
    const auto known = std::ranges::find(starts_, start);
    const auto index = static_cast<std::size_t>(known - starts_.begin());
    if (known == starts_.end()) starts_.push_back(std::move(start));
    columns_.push_back({name.text, index, std::move(steps), part});
  }
}

std::vector<Word> ResultColumns::usual() {
  std::vector<Word> names;
  for (const char* name :
       {"effective_friction", "effective_friction_error", "centre_of_pressure", "centre_of_pressure_error",
        "largest_pressure", "contact[0].left.x", "contact[0].right.x", "components", "method", "warnings.size"}) {
    names.push_back({name, ""});
  }
  return names;
}

std::vector<std::string> ResultColumns::names() const {
  std::vector<std::string> result;
  for (const Column& column : columns_) result.push_back(column.name);
  return result;
}

std::vector<std::string> ResultColumns::entries() const {
  std::vector<std::string> result;
  for (const Start& start : starts_) result.push_back(start.entry);
  return result;
}

std::vector<std::string> ResultColumns::cells(const SolutionText& solution) const {
  std::vector<Json> made;
  for (const auto& [entry, next] : starts_) {
    made.push_back(next ? solution_entry(solution, entry, *next) : solution_entry(solution, entry));
  }
  std::vector<std::string> result;
  for (const auto& [name, start, steps, part] : columns_) {
    const std::span<const Step> path = steps;
    const Json* there = found(made[start], path);
    if (there == nullptr && asks_size(steps)) {
      const Json* list = found(made[start], path.first(path.size() - 1));
      result.push_back(list == nullptr ? "" : std::to_string(list->size()));
    } else {
      result.push_back(there == nullptr ? "" : text_of(*there, part));
    }
  }
  return result;
}

}  // namespace steadyslide::app
