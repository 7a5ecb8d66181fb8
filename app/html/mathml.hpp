#pragma once
// Text with formulas between backticks as HTML: formulas become presentation MathML, other text stays as it is.

#include <optional>
#include <string>
#include <string_view>

namespace steadyslide::app {

/// Returns a formula as one or more <math> elements; a line may break between them. Returns nothing if the text is no
/// formula.
std::optional<std::string> mathml(std::string_view formula);

/// Returns a text as HTML. Formulas between backticks are typeset; other text between backticks becomes <code>; a lone
/// backtick stays. A formula that may break over several lines is one <span class="f">.
std::string prose(std::string_view text);

/// Returns a text as HTML like prose(), but sets formulas in lines of plain HTML with slanted letters. A line has a
/// tenth of the size of MathML, which matters for a page with thousands of formulas.
std::string lined(std::string_view text);

}  // namespace steadyslide::app
