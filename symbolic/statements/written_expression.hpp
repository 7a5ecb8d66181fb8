#pragma once
// Expressions in the texts of statements: + - * / ^, parentheses, numbers, names, name_{index}, calls, [lists],
// list[index].

#include <ginac/ginac.h>

#include <string>
#include <vector>

namespace steadyslide::symbolic {

/// Returns the values of the names, calls and lists in an expression.
class ExpressionMeaning {
 public:
  virtual ~ExpressionMeaning() = default;

  virtual GiNaC::ex named(const std::string& name) = 0;
  virtual GiNaC::ex call(const std::string& function, const std::vector<GiNaC::ex>& arguments) = 0;
  /// Returns the values of the text between the brackets of a list.
  virtual std::vector<GiNaC::ex> items(const std::string& text) = 0;
};

/// Evaluates an expression from left to right. Throws UnreadableStatement.
GiNaC::ex value_of(const std::string& text, ExpressionMeaning& meaning);

}  // namespace steadyslide::symbolic
