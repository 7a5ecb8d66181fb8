#pragma once
// A fact: a word said of things, "coercive(log-form)", the atom of which proofs are made. What words and things mean stands
// in proofs_checks/facts/. A thing may also be a quoted formula: nonzero("s_r - s_l"). In a rule, names that begin with a
// capital letter stand for any thing.

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::proofs_checks {

struct Fact {
  std::string word;
  std::vector<std::string> things;

  auto operator<=>(const Fact&) const = default;
};

/// Throws std::logic_error where the text is none.
Fact parse_fact(std::string_view text);
/// Of a list, where braces hold alternatives: "word(a, {b, c})" is word(a, b) and word(a, c).
std::vector<Fact> parse_facts(std::string_view list);
std::string text_of(const Fact& fact);
std::string text_of(const std::vector<Fact>& facts);

/// What the variables of a rule stand for.
using Bindings = std::map<std::string, std::string>;

bool is_variable(std::string_view thing);
/// The bindings with which the pattern becomes this fact, these included; none where it cannot.
std::optional<Bindings> match(const Fact& pattern, const Fact& fact, Bindings bindings = {});
Fact replaced(const Fact& pattern, const Bindings& bindings);

}  // namespace steadyslide::proofs_checks
