#include "library/sweep/combinations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t most_tried = 10000;

void stands_in(Value& value, const std::string& file) {
  value.file = &file;
  for (Value& item : value.items) stands_in(item, file);
}

/// Returns the value at the end of the steps; null if there is none. Missing keys are made, with the line and the file
/// of `like`.
Value* place(Value& root, const std::vector<Step>& steps, const Value& like) {
  Value* found = steps.empty() ? nullptr : &root;
  for (const Step& step : steps) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      if (*index >= found->items.size()) return nullptr;
      found = &found->items[*index];
      continue;
    }
    if (found->kind != Value::Kind::table) return nullptr;
    const auto& key = std::get<std::string>(step);
    const auto entry = std::ranges::find(found->entries, key, &Entry::key);
    if (entry != found->entries.end()) {
      found = &entry->value;
      continue;
    }
    Value table;
    table.line = like.line;
    table.file = like.file;
    found->entries.push_back({key, like.line, 0, std::move(table)});
    found = &found->entries.back().value;
  }
  return found;
}

/// True if one of the paths leads through the other.
bool overlap(const std::vector<Step>& a, const std::vector<Step>& b) {
  const std::size_t both = std::min(a.size(), b.size());
  return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(both), b.begin());
}

}  // namespace

Combinations::Combinations(Value base, std::string file, std::vector<Axis> axes, const std::string& axes_file)
    : base_(std::move(base)), file_(std::move(file)), axes_file_(std::make_shared<const std::string>(axes_file)) {
  for (Axis& axis : axes) add(std::move(axis));
  // A mistake in the base is in every combination. The sweep is then refused with the message of the first combination.
  std::optional<InvalidFile> first;
  for (std::size_t n = 0; n < std::min(size_, most_tried) && !known_; ++n) {
    try {
      known_ = problem(n);
    } catch (const InvalidFile& invalid) {
      if (!first) first = invalid;
    }
  }
  if (!known_) throw *first;
  if (std::ranges::any_of(data_, [](const VariedDatum& datum) { return datum.path.starts_with("indenter"); }))
    known_.reset();
}

void Combinations::add(Axis axis) {
  const auto bad = [&](const VariedDatum& datum, const std::string& what) {
    return InvalidFile(fmt::format("{}:{}", *axes_file_, datum.line), datum.path + ": " + what);
  };
  const std::size_t length = axis.front().values.size();
  if (length > max_combinations / size_) {
    throw bad(axis.front(), fmt::format("too many problems; a sweep has at most {}; more", max_combinations));
  }
  size_ *= length;
  lengths_.push_back(length);
  for (VariedDatum& datum : axis) {
    std::vector<Step> steps = steps_of(datum.path);
    for (Value& value : datum.values) stands_in(value, *axes_file_);
    Value trial = base_;
    if (place(trial, steps, datum.values.front()) == nullptr) {
      throw bad(datum, "no such datum; a path leads to a datum of the problem, like friction.values[0]; absent");
    }
    for (std::size_t k = 0; k < data_.size(); ++k) {
      if (overlap(steps, steps_[k])) throw bad(datum, "varied twice; a datum is varied once; " + data_[k].path);
    }
    axes_.push_back(lengths_.size() - 1);
    steps_.push_back(std::move(steps));
    data_.push_back(std::move(datum));
  }
}

std::vector<std::size_t> Combinations::chosen(std::size_t n) const {
  std::vector<std::size_t> of_axis(lengths_.size());
  for (std::size_t k = lengths_.size(); k-- > 0; n /= lengths_[k]) of_axis[k] = n % lengths_[k];
  std::vector<std::size_t> result;
  for (const std::size_t axis : axes_) result.push_back(of_axis[axis]);
  return result;
}

Problem Combinations::problem(std::size_t n) const {
  Value document = base_;
  const std::vector<std::size_t> choice = chosen(n);
  for (std::size_t k = 0; k < data_.size(); ++k) {
    const Value& value = data_[k].values[choice[k]];
    *place(document, steps_[k], value) = value;
  }
  return problem_of(document, file_, known_ ? &*known_ : nullptr);
}

}  // namespace steadyslide::library
