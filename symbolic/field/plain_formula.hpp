#pragma once
// Formulas in the notation of docs/theory.md, which sentences have between backticks, and their LaTeX.

#include <string>
#include <string_view>

namespace steadyslide::symbolic {

/// Returns LaTeX for math mode: "psi_bar' <= 2 d^lambda" gives "\bar\psi' \le 2 d^{\lambda}". The sides l and r become
/// the subscripts - and +: A_l gives A_-. A sign without a space between it and the name on its left becomes a
/// superscript: Phi+ gives \Phi^+. A name of several letters that is not in the notation is set upright.
std::string latex_of_plain(std::string_view formula);

/// Returns the sentence without its backticks.
std::string without_marks(std::string_view sentence);

/// Returns the sentence with `formula` as $latex$ and all other text escaped.
std::string latex_sentence(std::string_view sentence);

}  // namespace steadyslide::symbolic
