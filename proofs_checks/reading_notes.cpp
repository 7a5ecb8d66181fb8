#include "proofs_checks/reading_notes.hpp"

#include <algorithm>
#include <array>

#include "symbolic/reading_notes.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A note without its evidence, and the control that is the printed reading.
struct Entry {
  std::string_view id;
  std::string_view place;
  std::string_view printed;
  std::string_view derived;
  std::string_view claim;
  std::string_view control;
  std::string_view fault;  ///< print or extraction
};

constexpr std::string_view lost_superscript =
    "The text has lost other superscripts (f and alpha of (5) without their minus), so extraction may well have "
    "dropped "
    "`+alpha` here; the printed page was not seen.";

constexpr std::array<Entry, 7> entries{{
    {"eq-04-exponent", "[Bal16, (4)]", "t_n = -(P cos(pi alpha)/pi) / ((1+x)^{1/2} (1-x)^{1/2-alpha})",
     "the exponent of 1+x is 1/2+alpha", "eq-04-flat-punch", "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}",
     lost_superscript},
    {"eq-05-exponent", "[Bal16], the formula above (5)", "the denominator (1+x)^{1/2} (1-x)^{1/2-alpha_+}",
     "the exponent of 1+x is 1/2+alpha_-", "eq-05-07-friction-jump",
     "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha_-}", lost_superscript},
    {"eq-08-exponent", "[Bal16, (8)]", "t_0 = (cos(pi alpha)/pi) / ((1+x)^{1/2} (1-x)^{1/2-alpha})",
     "the exponent of 1+x is 1/2+alpha", "eq-08-unit-solution", "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}",
     lost_superscript},
    {"eq-10-exponents", "[Bal16, (10)]", "the kernel (1+x')^{1/2} (1-x')^{1/2-alpha} / ((1+x)^{1/2} (1-x)^{1/2-alpha})",
     "the exponent of 1+x' and of 1+x is 1/2+alpha", "eq-10-inverse",
     "the printed (1+x)^{1/2} instead of (1+x)^{1/2+alpha}, in both places", lost_superscript},
    {"thm-03-angle-rear", "[Bal16, theorem 3], contact on the right of c",
     "the power -(1/2+alpha) with alpha of (5), the angle of the friction on the left of c",
     "the angle of the friction on the contact side, the right", "thm-03-contact-side",
     "the printed angle (5), of the friction behind c, for contact in front of c",
     "The reference to (5) is plain text, which extraction does not turn from (6); but a lost superscript makes this "
     "half "
     "doubtful. At the rear edge of a punch with two coatings, for which (5) was introduced, both readings coincide."},
    {"thm-03-angle-front", "[Bal16, theorem 3], contact on the left of c",
     "the power -(1/2-alpha_+) with alpha_+ of (6), the angle of the friction on the right of c",
     "the angle of the friction on the contact side, the left", "thm-03-contact-side",
     "the printed angle (6), of the friction in front of c, for contact behind c",
     "The plus signs have survived extraction, so that this reading is the print's. At the front edge of a punch with "
     "two "
     "coatings, for which (6) was introduced, both readings coincide."},
    {"thm-03-front-limit", "[Bal16, theorem 3], the estimate of u' next to a front end of contact", "as x -> c-",
     "as x -> c+: outside of the contact; inside of it u' is the indenter's slope", "thm-03-outside-slope",
     "the printed x -> c- at the front: the estimate read inside of the contact",
     "A plus turned into a minus is not what extraction does elsewhere (it loses signs): more likely the print's, "
     "copied "
     "from the rear end."},
}};

constexpr std::array<std::string_view, 7> weighed_above{
    "theorem-3-angle-rear", "theorem-3-angle-front", "theorem-3-limit-front", "formula-4-exponent",
    "formula-7-exponent",   "formula-8-exponent",    "formula-10-exponent"};

std::string evidence_of(const Entry& entry, std::span<const Report> reports) {
  const auto report =
      std::ranges::find(reports, entry.claim, [](const Report& r) { return std::string_view(r.claim.id); });
  if (report == reports.end()) return "not examined in this run: claim " + std::string(entry.claim);
  const auto control = std::ranges::find(report->controls, entry.control,
                                         [](const ControlReport& c) { return std::string_view(c.name); });
  if (control == report->controls.end()) return "claim " + std::string(entry.claim) + " has no such control";
  const std::string printed =
      control->refuted ? "the printed reading is refuted (" : "the printed reading was not refuted (";
  return "claim " + std::string(entry.claim) + " is " + std::string(name_of(report->verdict)) + " as derived; " +
         printed + control->detail + ")";
}

}  // namespace

std::vector<ReadingNote> reading_notes(std::span<const Report> reports) {
  std::vector<ReadingNote> notes;
  notes.reserve(entries.size());
  for (const Entry& e : entries) {
    notes.push_back({std::string(e.id), std::string(e.place), std::string(e.printed), std::string(e.derived),
                     evidence_of(e, reports) + ". " + std::string(e.fault), std::string(e.claim)});
  }
  // Those that the local equation alone decides; the places above have been weighed by calculation already.
  for (const symbolic::ReadingNote& note : symbolic::reading_notes()) {
    if (std::ranges::find(weighed_above, note.id) != weighed_above.end()) continue;
    notes.push_back({note.id, "[Bal16] " + note.place, note.printed, note.derived, note.evidence, {}});
  }
  return notes;
}

}  // namespace steadyslide::proofs_checks
