#pragma once
// Runs facts and rules on instances. A fact has a meaning if its word has a formula and its things have instances that
// give a value to all names in it. A rule has a meaning if its premises and its conclusions have formulas, and if the
// fact that it gives has a row of general instances.
//
//   fact   it must not fail on an instance, and must hold on one
//   rule   the conclusion must hold wherever all premises hold, and they must hold somewhere. For each premise there
//          must be an instance on which the others hold, and this one and the conclusion fail: otherwise the premise is
//          idle
//
// All other rules are "in words": only a reader can judge them.

#include <map>
#include <string>
#include <vector>

#include "proofs_checks/proof/instances.hpp"
#include "proofs_checks/proof/theory.hpp"

namespace steadyslide::proofs_checks {

/// The result of a run on instances.
struct Run {
  std::size_t instances = 0;      ///< on which the fact holds, or all premises of the rule; 0 if it has no meaning
  std::string counterexample;     ///< the instance on which it fails
  std::vector<std::string> idle;  ///< premises that the row does not name and that no instance shows to be needed
};

class Meaning {
 public:
  explicit Meaning(const Theory& theory);

  /// Throws std::logic_error if the fact has a meaning and no instance decides it.
  const Run& of(const Fact& fact) const;
  /// Throws std::logic_error if the rule has a meaning and its premises never hold.
  const Run& of(const Rule& rule) const;
  /// True if the word of the fact has a formula.
  bool has_formula(const Fact& fact) const;

 private:
  std::vector<Formula> formulas_of(const Fact& fact) const;
  const std::vector<Instance>& instances(const std::string& of, std::size_t count) const;
  Run run(const Fact& fact) const;
  Run run(const Rule& rule) const;

  const Theory& theory_;
  std::map<std::string, InstanceFamily> families_;
  mutable std::map<std::string, std::vector<Instance>> instances_;
  mutable std::map<Fact, Run> facts_;
  mutable std::map<std::string, Run> rules_;
};

/// Returns the meaning of the ledger's theory.
const Meaning& meaning();

}  // namespace steadyslide::proofs_checks
