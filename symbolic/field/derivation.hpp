#pragma once
// A derivation for readers: assumptions, steps and result, as text and as LaTeX. It is written during the computation
// that it describes, from the same expressions. This header does not include GiNaC.

#include <string>
#include <utility>
#include <vector>

namespace steadyslide::symbolic {

/// A formula as text and as LaTeX; either may be empty. `latex` is for math mode, without dollar signs.
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
  std::string title;  ///< in the format of `words`
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

/// Returns numbered steps, wrapped at 100 columns.
std::string to_text(const Derivation& derivation);
/// Returns a section of a LaTeX document; it needs only LaTeX and amsmath.
std::string to_latex(const Derivation& derivation);
/// Returns a complete document with these derivations.
std::string latex_document(const std::vector<Derivation>& derivations);

}  // namespace steadyslide::symbolic
