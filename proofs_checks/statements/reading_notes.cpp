#include "proofs_checks/statements/reading_notes.hpp"

#include <algorithm>
#include <array>

#include "proofs_checks/statements/reading_note_entries.hpp"
#include "symbolic/statements/reading_notes.hpp"

namespace steadyslide::proofs_checks {
namespace {

constexpr std::array<std::string_view, 7> weighed_above{
    "theorem-3-angle-rear", "theorem-3-angle-front", "theorem-3-limit-front", "formula-4-exponent",
    "formula-7-exponent",   "formula-8-exponent",    "formula-10-exponent"};

/// What the run says of the claim and, where it is one of its controls, of the printed reading.
std::string examined(const ReadingNoteEntry& entry, std::span<const Report> reports) {
  const std::string claim(entry.claim);
  const auto report = std::ranges::find(reports, claim, [](const Report& r) { return r.claim.id; });
  if (report == reports.end()) return "not examined in this run: claim " + claim;
  std::string text = "claim " + claim + " is " + std::string(name_of(report->verdict)) + " as derived";
  if (entry.control.empty()) return text;
  const auto control = std::ranges::find(report->controls, entry.control,
                                         [](const ControlReport& c) { return std::string_view(c.name); });
  if (control == report->controls.end()) return "claim " + claim + " has no such control";
  text += control->refuted ? "; the printed reading is refuted (" : "; the printed reading was not refuted (";
  return text + control->detail + ")";
}

std::string evidence_of(const ReadingNoteEntry& entry, std::span<const Report> reports) {
  std::string text = entry.claim.empty() ? std::string() : examined(entry, reports) + ". ";
  if (!entry.evidence.empty()) text.append(entry.evidence).append(" ");
  return text.append(entry.fault);
}

}  // namespace

std::vector<ReadingNote> reading_notes(std::span<const Report> reports) {
  std::vector<ReadingNote> notes;
  notes.reserve(reading_note_entries().size());
  for (const ReadingNoteEntry& e : reading_note_entries()) {
    notes.push_back({std::string(e.id), std::string(e.place), std::string(e.printed), std::string(e.derived),
                     evidence_of(e, reports), std::string(e.claim), std::string(e.control)});
  }
  // Those that the local equation alone decides; the places above have been weighed by calculation already.
  for (const symbolic::ReadingNote& note : symbolic::reading_notes()) {
    if (std::ranges::find(weighed_above, note.id) != weighed_above.end()) continue;
    notes.push_back({note.id, "[Bal16] " + note.place, note.printed, note.derived, note.evidence, {}});
  }
  return notes;
}

}  // namespace steadyslide::proofs_checks
