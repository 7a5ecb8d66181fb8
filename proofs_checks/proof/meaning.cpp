#include "proofs_checks/proof/meaning.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {
namespace {

constexpr std::size_t instances_of_things = 100;
constexpr std::size_t instances_of_rules = 1500;

/// Decides all formulas on an instance.
Truth holds(const std::vector<Formula>& formulas, const Instance& instance) {
  Truth all = Truth::yes;
  for (const Formula& formula : formulas) {
    const Truth one = formula.holds(instance);
    if (one == Truth::no) return one;
    if (one == Truth::unknown) all = one;
  }
  return all;
}

std::string key_of(const Rule& rule) {
  return rule.name + ": " + text_of(rule.needs) + " gives " + text_of(rule.gives);
}

/// Returns the names of a rule's variables and things, "T, P", as a row of general instances writes them.
std::string key_of(const std::vector<std::string>& things) {
  std::string key;
  for (const std::string& thing : things) key += (key.empty() ? "" : ", ") + thing;
  return key;
}

}  // namespace

Meaning::Meaning(const Theory& theory) : theory_(theory) {
  const auto row_of = [&](const std::string& of) -> const InstanceRow& {
    const auto row = theory.instances.find(of);
    if (row == theory.instances.end()) throw std::logic_error("no instances of " + of);
    return row->second;
  };
  std::set<std::string> given;
  for (const auto& [of, row] : theory.instances) {
    given.merge(std::set(families_.emplace(of, InstanceFamily(row, row_of)).first->second.names()));
  }
  for (const auto& [word, texts] : theory.formulas) {
    const auto declared = theory.words.find(word);
    for (const std::string& text : texts) {
      const Formula formula(text);
      for (const std::string& name : formula.names()) {
        if (given.contains(name)) continue;
        if (declared != theory.words.end() && std::ranges::count(declared->second.first.things, name) > 0) continue;
        throw std::logic_error("no instance has a quantity " + name + ", in the sentence of " + word);
      }
    }
  }
}

bool Meaning::has_formula(const Fact& fact) const { return theory_.formulas.contains(fact.word); }

std::vector<Formula> Meaning::formulas_of(const Fact& fact) const {
  std::vector<Formula> formulas;
  const auto texts = theory_.formulas.find(fact.word);
  if (texts == theory_.formulas.end()) return formulas;
  for (const std::string& text : texts->second) formulas.emplace_back(theory_.formula(fact, text));
  return formulas;
}

const std::vector<Instance>& Meaning::instances(const std::string& of, std::size_t count) const {
  const auto found = instances_.find(of);
  return found != instances_.end() ? found->second : instances_[of] = families_.at(of).instances(count);
}

const Run& Meaning::of(const Fact& fact) const {
  const auto found = facts_.find(fact);
  return found != facts_.end() ? found->second : facts_[fact] = run(fact);
}

const Run& Meaning::of(const Rule& rule) const {
  const std::string key = key_of(rule);
  const auto found = rules_.find(key);
  return found != rules_.end() ? found->second : rules_[key] = run(rule);
}

Run Meaning::run(const Fact& fact) const {
  Run result;
  std::vector<std::string> things = fact.things;
  std::erase_if(things, [](const std::string& thing) { return thing.starts_with('"'); });
  const std::string key = key_of(things);
  const auto family = families_.find(key);
  const std::vector<Formula> formulas = formulas_of(fact);
  if (family == families_.end() || formulas.empty()) return result;
  for (const Formula& formula : formulas) {
    if (!std::ranges::includes(family->second.names(), formula.names())) return result;
  }
  for (const Instance& instance : instances(key, instances_of_things)) {
    const Truth truth = holds(formulas, instance);
    if (truth == Truth::yes) ++result.instances;
    if (truth != Truth::no || !result.counterexample.empty()) continue;
    result.counterexample = text_of(fact) + " fails for an instance of " + key + ": " + text_of(instance);
  }
  if (result.instances == 0 && result.counterexample.empty()) {
    throw std::logic_error("no instance decides " + text_of(fact));
  }
  return result;
}

Run Meaning::run(const Rule& rule) const {
  Run result;
  const std::string key = text_of(rule.gives.front());
  const auto family = families_.find(key);
  if (family == families_.end()) return result;
  std::vector<std::vector<Formula>> needs, gives;
  for (const auto& [facts, all] : {std::pair(&rule.needs, &needs), {&rule.gives, &gives}}) {
    for (const Fact& fact : *facts) {
      all->push_back(formulas_of(fact));
      if (all->back().empty()) return result;  // another rule that gives the same fact has the instances
      for (const Formula& formula : all->back()) {
        for (const std::string& name : formula.names()) {
          if (!family->second.names().contains(name))
            throw std::logic_error("the instances of " + key + " lack " + name);
        }
      }
    }
  }
  std::vector<bool> needed(needs.size());
  for (const Instance& instance : instances(key, instances_of_rules)) {
    std::size_t fails = 0, failing = 0;
    bool known = true;
    for (std::size_t k = 0; k < needs.size() && fails < 2 && known; ++k) {
      const Truth truth = holds(needs[k], instance);
      known = truth != Truth::unknown;
      if (truth == Truth::no) ++fails, failing = k;
    }
    if (fails > 1 || !known) continue;
    const bool concluded =
        std::ranges::none_of(gives, [&](const auto& all) { return holds(all, instance) == Truth::no; });
    if (fails == 0) ++result.instances;
    if (fails == 0 && !concluded && result.counterexample.empty()) {
      result.counterexample = key + " does not follow, by " + rule.name + ", for an instance: " + text_of(instance);
    }
    if (fails == 1 && !concluded) needed[failing] = true;
  }
  if (result.instances == 0) throw std::logic_error("in no instance all premises hold: " + key_of(rule));
  for (std::size_t k = 0; k < needs.size(); ++k) {
    const std::string premise = text_of(rule.needs[k]);
    if (!needed[k] && std::ranges::count(family->second.idle(), premise) == 0) result.idle.push_back(premise);
  }
  return result;
}

const Meaning& meaning() {
  static const Meaning all(theory());
  return all;
}

}  // namespace steadyslide::proofs_checks
