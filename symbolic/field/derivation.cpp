#include "symbolic/field/derivation.hpp"

#include <string_view>

#include "symbolic/field/plain_formula.hpp"

namespace steadyslide::symbolic {
namespace {

constexpr std::size_t width = 100;

/// Breaks words into lines of the given width; all lines after the first are indented.
std::string wrapped(std::string_view words, std::size_t indent, std::size_t first_column) {
  std::string result;
  std::size_t column = first_column;
  while (!words.empty()) {
    const std::size_t space = words.find(' ');
    const std::string_view word = words.substr(0, space);
    if (column > indent && column + word.size() + 1 > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!result.empty()) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    words.remove_prefix(space == std::string_view::npos ? words.size() : space + 1);
  }
  return result;
}

std::string_view label(DerivationStep::Kind kind) {
  switch (kind) {
    case DerivationStep::Kind::assumption: return "assume";
    case DerivationStep::Kind::action: return "do";
    case DerivationStep::Kind::result: return "find";
  }
  return "";
}

}  // namespace

std::string to_text(const Derivation& derivation) {
  const std::string title = without_marks(derivation.title);
  std::string text = title + "\n" + std::string(title.size(), '-') + "\n";
  std::size_t number = 0;
  for (const DerivationStep& step : derivation.steps) {
    std::string head = std::to_string(++number) + ".";
    head.resize(4, ' ');
    head += label(step.kind);
    head.resize(12, ' ');
    text += head + wrapped(without_marks(step.words), 12, 12) + "\n";
    if (!step.formula.text.empty()) text += std::string(16, ' ') + wrapped(step.formula.text, 18, 16) + "\n";
  }
  return text;
}

std::string to_latex(const Derivation& derivation) {
  std::string text = "\\section*{" + latex_sentence(derivation.title) + "}\n\\begin{enumerate}\n";
  for (const DerivationStep& step : derivation.steps) {
    text += "\\item \\emph{" + std::string(label(step.kind)) + ":} " + latex_sentence(step.words) + "\n";
    if (!step.formula.latex.empty()) text += "\\[ " + step.formula.latex + " \\]\n";
  }
  return text + "\\end{enumerate}\n";
}

std::string latex_document(const std::vector<Derivation>& derivations) {
  std::string text =
      "\\documentclass{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n\\usepackage{amsmath}\n"
      "\\begin{document}\n";
  for (const Derivation& derivation : derivations) text += to_latex(derivation);
  return text + "\\end{document}\n";
}

}  // namespace steadyslide::symbolic
