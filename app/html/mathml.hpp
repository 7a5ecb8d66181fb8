#pragma once
// Text with formulas between backticks, for a page: formulas as presentation MathML, all else as it is.

#include <optional>
#include <string>
#include <string_view>

namespace steadyslide::app {

/// A formula as one or more <math> elements; a line may break between them. Nothing for what is no formula.
std::optional<std::string> mathml(std::string_view formula);

/// HTML: formulas typeset, what looks like none of them as <code>, a lone backtick as itself. What of one formula may stand
/// in several lines is one <span class="f">.
std::string prose(std::string_view text);

/// The same with formulas in a line of HTML where that does, else as MathML: a tenth of the size, for the words of which a
/// page has thousands.
std::string lined(std::string_view text);

}  // namespace steadyslide::app
