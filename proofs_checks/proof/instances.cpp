#include "proofs_checks/proof/instances.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

#include "proofs_checks/proof/markdown.hpp"
#include "proofs_checks/proof/theory.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Numbers that are the same on every machine: the C++ standard prescribes the engine, not the distributions.
class Draw {
 public:
  explicit Draw(std::string_view stream) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : stream) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    engine_.seed(hash + 2016);
  }

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

  Real50 between(const Real50& from, const Real50& to, bool with_from, bool with_to) {
    constexpr std::array<std::size_t, 4> denominators{7, 64, 1000, 9973};
    switch (below(8)) {
      case 0:
        if (with_from) return from;
        break;
      case 1:
        if (with_to) return to;
        break;
      case 2:
        if (from < 0 && to > 0) return 0;
        break;
      default: break;
    }
    const std::size_t q = denominators[below(denominators.size())];
    return from + (to - from) * Real50(1 + below(q - 1)) / Real50(q);
  }

 private:
  std::mt19937_64 engine_;
};

constexpr auto is_defined = [](const std::string& name, std::set<std::string>& known) {
  if (!known.insert(name).second) throw std::logic_error("a quantity that has two definitions: " + name);
};

}  // namespace

InstanceFamily::InstanceFamily(const InstanceRow& row, const RowOf& row_of) : of_(row.of) { add(row, row_of); }

void InstanceFamily::add(const InstanceRow& row, const RowOf& row_of) {
  for (const std::string& item : row.items) {
    const std::size_t space = item.find(' ');
    const std::string first = item.substr(0, space);
    const std::string rest = space == std::string::npos ? "" : item.substr(space + 1);
    if (first == "like") {
      add(row_of(rest), row_of);
    } else if (first == "idle") {
      idle_.push_back(rest);
    } else if (first == "count") {
      count_ = std::stoul(rest);
    } else if (first == "where") {
      quantities_.push_back({Quantity::Kind::condition, item, {Formula(rest)}});
    } else if (first == "by") {
      solver_ = rest;
      const auto source = std::ranges::find(instance_sources(), rest, &InstanceSource::name);
      if (source == instance_sources().end()) throw std::logic_error("no instances of this name: " + rest);
      for (const std::string& name : items_of(source->quantities)) is_defined(name, names_);
    } else {
      add_quantity(item);
    }
  }
}

void InstanceFamily::add_quantity(const std::string& item) {
  const std::size_t in = item.find(" in ");
  const std::size_t equals = item.find(" = ");
  if (in != std::string::npos && in < equals) {
    const std::string name = item.substr(0, in);
    const std::string range = item.substr(in + 4);
    const char opens = range.front();
    const char closes = range.back();
    std::vector<Formula> formulas;
    for (const std::string& part : items_of(range.substr(1, range.size() - 2))) formulas.emplace_back(part);
    is_defined(name, names_);
    if (opens == '{' && closes == '}' && !formulas.empty()) {
      quantities_.push_back({Quantity::Kind::choice, name, std::move(formulas)});
      return;
    }
    if ((opens == '[' || opens == ']') && (closes == '[' || closes == ']') && formulas.size() == 2) {
      quantities_.push_back({Quantity::Kind::interval, name, std::move(formulas), opens == '[', closes == ']'});
      return;
    }
  } else if (equals != std::string::npos) {
    const std::string left = item.substr(0, equals);
    Formula right(item.substr(equals + 3));
    const std::size_t bracket = left.find('(');
    const std::string name = left.substr(0, bracket);
    is_defined(bracket == std::string::npos ? name : name + "(", names_);
    if (bracket == std::string::npos) {
      quantities_.push_back({Quantity::Kind::value, name, {std::move(right)}});
    } else {
      std::vector<std::string> parameters = items_of(left.substr(bracket + 1, left.size() - bracket - 2));
      functions_.emplace(name, Instance::Function{std::move(parameters), std::move(right)});
    }
    return;
  }
  throw std::logic_error("not a quantity of instances of " + of_ + ": " + item);
}

std::vector<Instance> InstanceFamily::instances(std::size_t count) const {
  count = count_.value_or(count);
  std::vector<Instance> given;
  if (!solver_.empty()) {
    given = std::ranges::find(instance_sources(), solver_, &InstanceSource::name)->instances();
    count = given.size();
  }
  const auto functions = std::make_shared<const std::map<std::string, Instance::Function>>(functions_);
  Draw draw(of_);
  std::vector<Instance> all;
  std::size_t drawn = 0;
  while (all.size() < count && drawn < (given.empty() ? 200 * count : count)) {
    Instance instance = given.empty() ? Instance{} : given[drawn];
    ++drawn;
    instance.functions = functions;
    bool kept = true;
    for (const auto& [kind, name, formulas, with_from, with_to] : quantities_) {
      const auto value = [&, &formulas = formulas](std::size_t k) { return formulas[k].value(instance); };
      switch (kind) {
        case Quantity::Kind::value: instance.numbers[name] = value(0); break;
        case Quantity::Kind::choice: instance.numbers[name] = value(draw.below(formulas.size())); break;
        case Quantity::Kind::interval:
          instance.numbers[name] = draw.between(value(0), value(1), with_from, with_to);
          break;
        case Quantity::Kind::condition: kept = kept && formulas[0].holds(instance) == Truth::yes; break;
      }
      if (!kept) break;
    }
    if (const auto at = instance.numbers.find("accuracy"); at != instance.numbers.end()) instance.accuracy = at->second;
    if (kept) all.push_back(std::move(instance));
  }
  if (all.empty() || (given.empty() && all.size() < count)) {
    throw std::logic_error("nearly no instance of " + of_ + " is as its row says");
  }
  return all;
}

}  // namespace steadyslide::proofs_checks
