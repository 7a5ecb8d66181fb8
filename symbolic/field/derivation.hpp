#pragma once
// A derivation that a person can read: what was assumed, what was done, what came out, as text and as LaTeX. Made
// beside the computation that it tells of, from the same expressions. Without GiNaC in this header.

#include <string>
#include <utility>
#include <vector>

namespace steadyslide::symbolic {

/// A formula for both kinds of reader; either may be empty. `latex` is for math mode, without dollars.
struct Formula {
  std::string text;
  std::string latex;
};

struct DerivationStep {
  enum class Kind { assumption, action, result };
  Kind kind;
  std::string words;  ///< a sentence; formulas in it between backticks, in plain letters (docs/theory.md)
  Formula formula;
};

struct Derivation {
  std::string title;  ///< like words
  std::vector<DerivationStep> steps;

  using Kind = DerivationStep::Kind;
  void assume(std::string words, Formula formula = {}) { add(Kind::assumption, std::move(words), std::move(formula)); }
  void act(std::string words, Formula formula = {}) { add(Kind::action, std::move(words), std::move(formula)); }
  void conclude(std::string words, Formula formula = {}) { add(Kind::result, std::move(words), std::move(formula)); }

 private:
  void add(Kind kind, std::string words, Formula formula) {
    steps.push_back({kind, std::move(words), std::move(formula)});
  }
};

/// Numbered steps, wrapped at 100 columns.
std::string to_text(const Derivation& derivation);
/// A section of a LaTeX document: plain LaTeX and amsmath.
std::string to_latex(const Derivation& derivation);
/// A complete document that contains them.
std::string latex_document(const std::vector<Derivation>& derivations);

}  // namespace steadyslide::symbolic
