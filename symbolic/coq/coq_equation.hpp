#pragma once
// An equation of the exact field in the notation of algebra.v, with the same operations as in the given expression. 1/d
// becomes an element inv_j with d * inv_j = [1]; a root becomes an element with its square; everything else is an
// independent symbol. The order of terms and factors is fixed. GiNaC may write a - b or b - a, and this may change from
// run to run. For sources of this layer and tests only.

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "symbolic/coq/cofactors.hpp"
#include "symbolic/field/written_identity.hpp"

namespace steadyslide::symbolic {

class CoqEquation {
 public:
  /// Throws std::domain_error if an expression is not in the field, or if two symbols have the same name.
  CoqEquation(const WrittenEquation& equation, const std::vector<PhaseField::Radical>& radicals);

  std::string lhs() const { return text(lhs_); }
  std::string rhs() const { return text(rhs_); }
  /// Returns lhs - rhs, expanded and not reduced.
  Polynomial difference() const { return polynomial(lhs_) - polynomial(rhs_); }

  /// Returns the names of the generators: symbols and roots in alphabetical order, then inverses.
  std::vector<std::string> names() const;
  std::vector<Root> roots() const;
  std::vector<Inverse> inverses() const;
  /// The relation left = right of a root or of an inverse; roots come first.
  struct Relation {
    std::string left;
    std::string right;
  };
  std::vector<Relation> relations() const;

 private:
  /// The divisors, ordered by the nesting depth of the divisions in them, then by text. So no divisor contains a later
  /// one.
  using Divisors = std::map<std::pair<int, std::string>, GiNaC::ex>;

  int collect(const GiNaC::ex& expression);
  std::string text(const GiNaC::ex& expression, bool named = true) const;
  std::string factor(const GiNaC::ex& expression, bool named) const;
  /// Returns the name of the divisor's inverse.
  std::string inverse_of(const GiNaC::ex& divisor) const;
  Polynomial polynomial(const GiNaC::ex& expression) const;
  Polynomial generator(const std::string& name) const;

  GiNaC::ex lhs_;
  GiNaC::ex rhs_;
  std::map<std::string, GiNaC::symbol> symbols_;  ///< and roots
  std::vector<PhaseField::Radical> radicals_;     ///< the radicals that occur
  Divisors divisors_;
};

}  // namespace steadyslide::symbolic
