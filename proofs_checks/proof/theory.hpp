#pragma once
// Everything that proofs may use: words and things, definitions, inferences, decided facts, classical theorems, and
// instances of things. They stand in Markdown, in all files of proofs_checks/facts/,
//
//   ## Words                                        each name once in all files
//
//   | fact | says | follows from |                 the third column may be absent: a short inference from facts
//   |---|---|---|
//   | load(T) | `int T = -P` | |
//   | pressing(T) | `T < 0` | factor-sign(T), cosine(T) |
//   | infinite-power(P) | the power is in **`p in ]-1, 0[`** | |
//
//   Formulas in bold are run on instances (meaning.hpp).
//
//   ## Things
//
//   | name | is |
//   |---|---|
//   | flat-punch | `t = -(P cos(pi alpha)/pi) |Y|` |
//   ## Definitions                                  of a word, for all things: its arguments are variables
//
//   | fact | means |
//   |---|---|
//   | solves(T) | kernel(T), load(T) |
//   ## Decided                                      facts, what decides them, and for which parameters
//
//   | fact | by | where |
//   |---|---|---|
//   | kernel(flat-punch) | identity rh-flat-punch-0, rh-kernel | |
//   | kernel(two-values) | identity theorem-2-jump | nonzero("s_r - s_l") |
//   | small({gamma, alpha}) | enclosure gamma-of-nu | nu in [0, 1/2]; nu in ]-1, 0] |
//
// A row of the last table may hold several facts, and an enclosure's row several boxes. The table "Instances" is
// described in instances.hpp.
//
// Theorems stand in the section "Classical theorems" of docs/proofs.md:
//
//   ### plemelj
//   [Mus53, section 17]. In words.
//   Needs hoelder(T), integrable-powers(T).
//   Gives plemelj(T).
//
// A theorem with several conclusions has further words, Needs and Gives.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/box.hpp"
#include "proofs_checks/proof/fact.hpp"

namespace steadyslide::proofs_checks {

/// A rule: the facts in `needs` imply all facts in `gives`. Names that begin with a capital letter stand for any thing.
struct Rule {
  std::string name;  ///< the name of the theorem, or the defined or inferred word
  std::string words;
  std::vector<Fact> needs;
  std::vector<Fact> gives;
};

/// A fact that identities of the symbolic layer decide, or an enclosure over a box.
struct DecidedFact {
  enum class By { identity, enclosure };

  Fact fact;
  By by;
  std::vector<std::string> ids;
  /// Conditions of identities: nonzero("divisor"), the divisor as the symbolic layer writes it.
  std::vector<Fact> where;
  Box box;  ///< the box of an enclosure
};

/// A row of the table "Instances", as written.
struct InstanceRow {
  std::string of;
  std::vector<std::string> items;
  bool operator==(const InstanceRow&) const = default;
};

struct Theory {
  /// Reads the documents. Throws std::logic_error if one does not have this form, if a name is declared twice or not at
  /// all, if the number of a word's things differs from its declaration, or if an identity decides facts of two words.
  explicit Theory(std::span<const std::string_view> documents);

  std::map<std::string, std::pair<Fact, std::string>> words;  ///< each with the variables of its declaration
  std::map<std::string, std::string> things;
  std::map<std::string, Rule> definitions;  ///< by word
  std::map<std::string, Rule> inferences;   ///< by word
  std::map<std::string, std::vector<Rule>> theorems;
  std::vector<DecidedFact> decided;
  std::map<std::string, std::vector<std::string>> formulas;  ///< by word or thing: those that are run
  std::map<std::string, InstanceRow> instances;              ///< by things, "traction, wedge", or by the fact of a rule

  /// Throws std::logic_error if the word or a thing is not declared. Variables are allowed in rules only.
  void require_declared(const Fact& fact, bool in_rule = false) const;
  /// Returns the fact in words: the declaration with the things in place of the variables.
  std::string sentence(const Fact& fact) const;
  /// Returns the formula with quoted things, the formulas of things and other variables in place of the variables.
  std::string formula(const Fact& fact, const std::string& formula) const;
};

/// Returns the theory of the ledger's proofs.
const Theory& theory();

}  // namespace steadyslide::proofs_checks
