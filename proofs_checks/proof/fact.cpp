#include "proofs_checks/proof/fact.hpp"

#include <algorithm>
#include <stdexcept>

#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {
namespace {

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

bool is_formula(std::string_view text) { return text.size() > 2 && text.front() == '"' && text.back() == '"'; }

/// Adds the fact. If it has braces, adds one fact for each alternative in the first braces, and so on.
void add_facts(std::vector<Fact>& facts, const std::string& text) {
  const std::size_t opening = text.find('{');
  const std::size_t closing = text.find('}');
  if (opening == std::string::npos || closing == std::string::npos) return facts.push_back(parse_fact(text));
  for (const std::string& thing : items_of(text.substr(opening + 1, closing - opening - 1))) {
    add_facts(facts, text.substr(0, opening) + thing + text.substr(closing + 1));
  }
}

}  // namespace

Fact parse_fact(std::string_view text) {
  const std::size_t opening = text.find('(');
  Fact fact{std::string(text.substr(0, opening)), {}};
  bool good = is_name(fact.word) && !is_variable(fact.word);
  if (opening != std::string_view::npos) {
    good = good && text.ends_with(')');
    fact.things = items_of(text.substr(opening + 1, text.size() - opening - 2));
    good = good && !fact.things.empty() &&
           std::ranges::all_of(fact.things, [](const std::string& t) { return is_name(t) || is_formula(t); });
  }
  if (!good) throw std::logic_error("not a fact, word(thing, ...): " + std::string(text));
  return fact;
}

std::vector<Fact> parse_facts(std::string_view list) {
  std::vector<Fact> facts;
  for (const std::string& item : items_of(list)) add_facts(facts, item);
  return facts;
}

std::string text_of(const Fact& fact) {
  std::string text = fact.word;
  for (std::size_t k = 0; k < fact.things.size(); ++k) text += (k == 0 ? "(" : ", ") + fact.things[k];
  return fact.things.empty() ? text : text + ")";
}

std::string text_of(const std::vector<Fact>& facts) {
  std::string text;
  for (const Fact& fact : facts) text += (text.empty() ? "" : ", ") + text_of(fact);
  return text;
}

bool is_variable(std::string_view thing) { return !thing.empty() && thing.front() >= 'A' && thing.front() <= 'Z'; }

std::optional<Bindings> match(const Fact& pattern, const Fact& fact, Bindings bindings) {
  if (pattern.word != fact.word || pattern.things.size() != fact.things.size()) return std::nullopt;
  for (std::size_t k = 0; k < pattern.things.size(); ++k) {
    const std::string& wanted = pattern.things[k];
    if (is_variable(wanted)) {
      if (bindings.try_emplace(wanted, fact.things[k]).first->second != fact.things[k]) return std::nullopt;
    } else if (wanted != fact.things[k]) {
      return std::nullopt;
    }
  }
  return bindings;
}

Fact replaced(const Fact& pattern, const Bindings& bindings) {
  Fact fact = pattern;
  for (std::string& thing : fact.things) {
    if (const auto found = bindings.find(thing); found != bindings.end()) thing = found->second;
  }
  return fact;
}

}  // namespace steadyslide::proofs_checks
