#include "proofs_checks/statements/reading_notes.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <map>
#include <ranges>

#include "symbolic/statements/statements.hpp"

namespace steadyslide::proofs_checks {

namespace embedded {
extern const std::string_view reading_notes_md;
}

namespace {

/// A note of the file: its name, and what stands behind "- place:", "- printed:" and so on.
struct Entry {
  std::string id;
  std::map<std::string, std::string, std::less<>> parts;

  std::string part(std::string_view name) const {
    const auto found = parts.find(name);
    return found == parts.end() ? std::string() : found->second;
  }
};

std::vector<Entry> entries() {
  std::vector<Entry> all;
  std::string* part = nullptr;
  for (const auto words : std::views::split(embedded::reading_notes_md, '\n')) {
    const std::string_view line(words.begin(), words.end());
    if (line.starts_with("## ")) {
      all.push_back({std::string(line.substr(3)), {}});
    } else if (line.starts_with("- ")) {
      const std::size_t colon = line.find(": ");
      part = &all.back().parts[std::string(line.substr(2, colon - 2))];
      *part = line.substr(colon + 2);
    } else if (line.starts_with("  ")) {
      part->append(line.substr(1));
    }
  }
  return all;
}

/// What the run says of the claim and, where it is one of its controls, of the printed reading.
std::string examined(const std::string& claim, const std::string& printed, std::span<const Report> reports) {
  const auto report = std::ranges::find(reports, claim, [](const Report& r) { return r.claim.id; });
  if (report == reports.end()) return "not examined in this run: claim " + claim;
  std::string text = "claim " + claim + " is " + std::string(name_of(report->verdict)) + " as derived";
  if (printed.empty()) return text;
  const auto control = std::ranges::find(report->controls, printed, &ControlReport::name);
  if (control == report->controls.end()) return "claim " + claim + " has no such control";
  text += control->refuted ? "; the printed reading is refuted (" : "; the printed reading was not refuted (";
  return text + control->detail + ")";
}

}  // namespace

std::vector<ReadingNote> reading_notes(std::span<const Report> reports) {
  const std::vector<symbolic::LocalReading> local = symbolic::local_readings();
  std::vector<ReadingNote> notes;
  for (const Entry& e : entries()) {
    const std::string claim = e.part("claim");
    const std::string control = e.part("control");
    std::vector<std::string> evidence;
    if (!claim.empty()) evidence.push_back(examined(claim, control, reports) + ".");
    const auto found = std::ranges::find(local, e.id, &symbolic::LocalReading::id);
    if (found != local.end()) evidence.push_back(found->found);
    for (const char* name : {"evidence", "fault"}) evidence.push_back(e.part(name));
    std::erase(evidence, std::string());
    notes.push_back({e.id, e.part("place"), e.part("printed"), e.part("derived"), boost::algorithm::join(evidence, " "),
                     e.part("at fault"), claim, control});
  }
  return notes;
}

}  // namespace steadyslide::proofs_checks
