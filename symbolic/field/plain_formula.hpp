#pragma once
// Formulas in the plain letters of docs/theory.md, as they stand between backticks in sentences, and their LaTeX.

#include <string>
#include <string_view>

namespace steadyslide::symbolic {

/// For math mode: "psi_bar' <= 2 d^lambda" to "\bar\psi' \le 2 d^{\lambda}". The sides l and r are - and + below, and a
/// sign that touches its name on the left alone is above: A_l is A_-, Phi+ is \Phi^+. A name of several letters that
/// the notation does not have is upright.
std::string latex_of_plain(std::string_view formula);

/// The sentence without its backticks.
std::string without_marks(std::string_view sentence);

/// The sentence with `formula` as $latex$, and everything else escaped.
std::string latex_sentence(std::string_view sentence);

}  // namespace steadyslide::symbolic
