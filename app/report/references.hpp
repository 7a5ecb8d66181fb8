#pragma once
// docs/references.md as a list of the page, and citations as links into it.

#include <string>
#include <string_view>

#include "app/report/html.hpp"

namespace steadyslide::app {

/// The paragraphs of a Markdown text that begin with **[Key]**, as <dl>: emphasis and links, no more.
std::string references_list(std::string_view markdown);

/// Section "references".
Section references_section();

/// Text with formulas, as prose() has it, with [Key, place] linked to the list.
std::string cited_prose(std::string_view text);

}  // namespace steadyslide::app
