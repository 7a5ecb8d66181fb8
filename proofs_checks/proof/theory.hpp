#pragma once
// What proofs may use: words and things, definitions, inferences, facts that something decides, classical theorems. They
// stand in Markdown: all files of proofs_checks/facts/,
//
//   ## Words                                        each name once in all files
//
//   | fact | says | follows from |                 from facts by an inference: short ones, in words, that are read, and
//   |---|---|---|                                 not decided by the program; the column may be absent
//   | load(T) | `int T = -P` | |
//   | pressing(T) | `T < 0` | factor-sign(T), cosine(T) |
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
//   ## Decided                                      what a decision says, and where
//
//   | fact | by | where |
//   |---|---|---|
//   | kernel(flat-punch) | identity rh-flat-punch-0, rh-kernel | |
//   | kernel(two-values) | identity theorem-2-jump | nonzero("s_r - s_l") |
//   | small({gamma, alpha}) | enclosure gamma-of-nu | nu in [0, 1/2]; nu in ]-1, 0] |
//
// A row of the last table may hold several facts, and an enclosure's row several boxes.
//
// and the section "Classical theorems" of docs/proofs.md, where a theorem is
//
//   ### plemelj
//   [Mus53, section 17]. In words.
//   Needs hoelder(T), integrable-powers(T).
//   Gives plemelj(T).
//
// with further words, Needs and Gives where it says several things.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proofs_checks/proof/box.hpp"
#include "proofs_checks/proof/fact.hpp"

namespace steadyslide::proofs_checks {

/// The facts needed, with names in capitals for any thing, give all of these.
struct Rule {
  std::string name;  ///< of the theorem; the word that is defined or inferred
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
  std::vector<Fact> where;  ///< of identities: nonzero("divisor"), as the symbolic layer writes it
  Box box;                  ///< of an enclosure
};

struct Theory {
  /// Throws std::logic_error where a document does not have this form, a name is taken twice or not declared, or a word has
  /// another number of things than its declaration.
  explicit Theory(std::span<const std::string_view> documents);

  std::map<std::string, std::pair<Fact, std::string>> words;  ///< with the variables of its declaration
  std::map<std::string, std::string> things;
  std::map<std::string, Rule> definitions;  ///< by word
  std::map<std::string, Rule> inferences;   ///< by word
  std::map<std::string, std::vector<Rule>> theorems;
  std::vector<DecidedFact> decided;

  /// Throws std::logic_error where the word or a thing is not declared. Variables are allowed in rules alone.
  void require_declared(const Fact& fact, bool in_rule = false) const;
  /// In words: its declaration, with the things in the place of the variables.
  std::string sentence(const Fact& fact) const;
};

/// Of the ledger.
const Theory& theory();

}  // namespace steadyslide::proofs_checks
