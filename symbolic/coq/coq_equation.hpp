#pragma once
// An equation of the exact field as Coq reads it in algebra.v, operation for operation as it was put in: 1/d is an element
// inv_j with d * inv_j = [1], a root an element with the square that it has, everything else an independent symbol. Terms
// and factors stand in one order; which of a - b and b - a GiNaC has written may change from run to run. For sources of
// this layer and tests only.

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "symbolic/coq/cofactors.hpp"
#include "symbolic/field/written_identity.hpp"

namespace steadyslide::symbolic {

class CoqEquation {
 public:
  /// Throws std::domain_error outside the field, and where two symbols have one name.
  CoqEquation(const WrittenEquation& equation, const std::vector<PhaseField::Radical>& radicals);

  std::string lhs() const { return text(lhs_); }
  std::string rhs() const { return text(rhs_); }
  /// lhs - rhs, expanded and not reduced.
  Polynomial difference() const { return polynomial(lhs_) - polynomial(rhs_); }

  /// Of the generators: symbols and roots in the order of the alphabet, then inverses.
  std::vector<std::string> names() const;
  std::vector<Root> roots() const;
  std::vector<Inverse> inverses() const;
  /// left = right for each root and then for each inverse.
  struct Relation {
    std::string left;
    std::string right;
  };
  std::vector<Relation> relations() const;

 private:
  /// Divisors by the depth of the divisions in them and by their text: none is in one that stands before it.
  using Divisors = std::map<std::pair<int, std::string>, GiNaC::ex>;

  int collect(const GiNaC::ex& expression);
  std::string text(const GiNaC::ex& expression, bool named = true) const;
  std::string factor(const GiNaC::ex& expression, bool named) const;
  /// The name of its inverse.
  std::string inverse_of(const GiNaC::ex& divisor) const;
  Polynomial polynomial(const GiNaC::ex& expression) const;
  Polynomial generator(const std::string& name) const;

  GiNaC::ex lhs_;
  GiNaC::ex rhs_;
  std::map<std::string, GiNaC::symbol> symbols_;  ///< and roots
  std::vector<PhaseField::Radical> radicals_;     ///< those that occur
  Divisors divisors_;
};

}  // namespace steadyslide::symbolic
