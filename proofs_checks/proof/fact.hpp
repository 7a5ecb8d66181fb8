#pragma once
// A fact: a word applied to things, "coercive(log-form)". Proofs consist of facts. proofs_checks/facts/ explains the
// words and the things. A thing may also be a quoted formula: nonzero("s_r - s_l"). In a rule, names that begin with a
// capital letter are variables: they stand for any thing.

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

/// Returns the fact. Throws std::logic_error if the text is not a fact.
Fact parse_fact(std::string_view text);
/// Returns the facts of a list. Braces hold alternatives: "word(a, {b, c})" gives word(a, b) and word(a, c).
std::vector<Fact> parse_facts(std::string_view list);
std::string text_of(const Fact& fact);
std::string text_of(const std::vector<Fact>& facts);

/// The things that the variables of a rule stand for.
using Bindings = std::map<std::string, std::string>;

bool is_variable(std::string_view thing);
/// Returns `bindings`, extended so that the pattern becomes this fact. Returns nothing if that is impossible.
std::optional<Bindings> match(const Fact& pattern, const Fact& fact, Bindings bindings = {});
Fact replaced(const Fact& pattern, const Bindings& bindings);

}  // namespace steadyslide::proofs_checks
