#include <fmt/format.h>

#include "app/report/references.hpp"
#include "app/report/sections.hpp"

namespace steadyslide::app {

Section notes_section(const VerifyResult& result) {
  Section section{"notes", "Reading notes", ""};
  if (result.notes.empty() && result.notes_left_out == 0) return section;
  section.html = element("p",
                         "Places where the text of the paper at hand and the mathematics disagree. That text was "
                         "extracted from a PDF: each note says whether that may have made the difference, or whether "
                         "it is more likely <em>the print's</em>, a slip in the paper itself.") +
                 "\n";
  if (result.notes_left_out > 0) {
    section.html += element("p", fmt::format("Left out are {} notes on statements that were not examined in this run.",
                                             result.notes_left_out)) +
                    "\n";
  }
  std::vector<std::vector<std::string>> rows;
  for (const proofs_checks::ReadingNote& note : result.notes) {
    std::string place = element("code", escaped(note.id), {{"id", "note-" + note.id}});
    place.append("<br>").append(cited_prose(note.place));
    if (!note.claim.empty()) place.append("<br>").append(element("a", "the statement", {{"href", "#" + note.claim}}));
    rows.push_back({place, cited_prose(note.printed), cited_prose(note.derived), cited_prose(note.evidence)});
  }
  if (!rows.empty()) {
    section.html +=
        table_element("Reading notes", {"place", "printed", "derived", "evidence, and the likely origin"}, rows);
  }
  return section;
}

}  // namespace steadyslide::app
