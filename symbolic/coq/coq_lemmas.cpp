#include "symbolic/coq/coq_lemmas.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "symbolic/coq/coq_equation.hpp"
#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view algebra_v;  ///< the first part of every file
}

namespace {

constexpr std::size_t line_width = 120;

/// Returns the text as a Coq comment. There, quotes and asterisks next to parentheses have a special meaning.
std::string comment(std::string text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') text[k] = '\'';
    if (k > 0 && ((text[k - 1] == '(' && text[k] == '*') || (text[k - 1] == '*' && text[k] == ')')))
      text.insert(k, " ");
  }
  return text;
}

/// Breaks the text at spaces into lines of at most 120 characters; all lines after the first begin with `indent`.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string result;
  std::string line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > line_width) {
      result += line + "\n";
      line = indent + word;
    } else {
      line += (line.empty() ? "" : " ") + word;
    }
  }
  return result + line + "\n";
}

std::string statement_text(const CoqEquation& equation) {
  std::string text = "forall";
  for (const std::string& name : equation.names()) text += " " + name;
  text += " : Algebra,";
  for (const auto& [left, right] : equation.relations()) text += " " + left + " = " + right + " ->";
  return text + " " + equation.lhs() + " = " + equation.rhs() + ".";
}

/// cofactor * (left - right) + (... + zero)
std::string combination(const CoqEquation& equation, const Cofactors& cofactors) {
  const std::vector<std::string> names = equation.names();
  std::vector<Polynomial> all = cofactors.roots;
  all.insert(all.end(), cofactors.inverses.begin(), cofactors.inverses.end());
  const std::vector<CoqEquation::Relation> relations = equation.relations();
  std::string text;
  std::string end;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].is_zero()) continue;
    text += "(" + all[k].text(names) + ") * (" + relations[k].left + " - (" + relations[k].right + ")) + (";
    end += ")";
  }
  return text + "zero" + end;
}

CoqLemma lemma_of(const std::string& name, const std::string& words, const CoqEquation& equation) {
  const Cofactors found = cofactors(equation.difference(), equation.roots(), equation.inverses());
  return {name,
          wrapped("(* " + comment(words) + " *)", "   ") +
              wrapped("Lemma " + name + " : " + statement_text(equation), "  ") + "Proof.\n  intros.\n  " +
              wrapped("apply (by_cofactors _ _ (" + combination(equation, found) + ")).", "    ") +
              "  { ring. }\n  zero_by_hypotheses.\nQed.\n",
          found.remainder.is_zero()};
}

/// Returns why there is nothing for Coq to check (GiNaC simplified the equation on input); empty if there is something.
std::string reason_not_to(const CoqEquation& equation) {
  if (equation.names().empty()) return "both sides are numbers as soon as they are written";
  return equation.lhs() == equation.rhs() ? "both sides are one expression as soon as they are written" : "";
}

}  // namespace

CoqLemmas coq_lemmas(const std::string& id, const ExactIdentity& identity) {
  CoqLemmas result;
  std::string name = id;
  std::ranges::replace(name, '-', '_');
  std::string divisors;
  for (const std::string& divisor : identity.nonvanishing) {
    divisors += (divisors.empty() ? " Where none of these is zero: " : ", ") + divisor;
  }
  const std::vector<WrittenEquation>& equations = identity.written->equations;
  for (std::size_t k = 0; k < equations.size(); ++k) {
    const CoqEquation equation(equations[k], identity.written->radicals);
    const std::string& what = equations[k].what;
    if (const std::string reason = reason_not_to(equation); !reason.empty()) {
      result.not_exported.push_back({id, what, reason});
      continue;
    }
    const std::string words =
        id + ": " + without_marks(identity.statement) + (what.empty() ? "." : "; " + what + ".") + divisors;
    result.lemmas.push_back(
        lemma_of(equations.size() == 1 ? name : name + "_" + std::to_string(k + 1), words, equation));
  }
  return result;
}

std::string coq_file(const std::vector<CoqLemma>& lemmas) {
  std::string text(embedded::algebra_v);
  for (const CoqLemma& lemma : lemmas) text += "\n" + lemma.text;
  return text + "\nEnd Identities.\n";
}

}  // namespace steadyslide::symbolic
