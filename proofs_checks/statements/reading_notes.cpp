#include "proofs_checks/statements/reading_notes.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <map>
#include <regex>

#include "proofs_checks/proof/markdown.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::proofs_checks {

namespace embedded {
extern const std::string_view reading_notes_md;
}

namespace {

/// A note of the file, "## eq-04-exponent: [Bal16, (4)]", with the text after "- printed:", "- derived:" and so on.
struct Entry {
  std::string id;
  std::string place;
  std::map<std::string, std::string, std::less<>> parts;

  std::string part(std::string_view name) const {
    const auto found = parts.find(name);
    return found == parts.end() ? std::string() : found->second;
  }
};

/// Returns the text before the separator and the text after it, which is empty if there is no separator.
std::pair<std::string, std::string> divided(const std::string& text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return {text, ""};
  return {text.substr(0, at), text.substr(at + separator.size())};
}

std::vector<Entry> entries() {
  std::vector<Entry> all;
  std::string* part = nullptr;
  for (const std::string_view line : parts_of(embedded::reading_notes_md, "\n")) {
    if (line.starts_with("## ")) {
      const auto [id, place] = divided(std::string(line.substr(3)), ": ");
      all.push_back({id, place, {}});
    } else if (line.starts_with("- ")) {
      const auto [name, said] = divided(std::string(line.substr(2)), ": ");
      part = &all.back().parts[name];
      *part = said;
    } else if (line.starts_with("  ")) {
      part->append(line.substr(1));
    }
  }
  return all;
}

/// Returns the text with `pattern` between backticks, and blanks for the signs of products in it. What stands between
/// backticks already does not change.
std::string with_marks(const std::string& text, const std::regex& pattern) {
  std::string result;
  for (std::size_t at = 0, part = 0; at <= text.size(); ++part) {
    const std::size_t end = std::min(text.find('`', at), text.size());
    std::string piece = text.substr(at, end - at);
    if (part % 2 == 0) {
      std::string marked;
      std::sregex_iterator match(piece.begin(), piece.end(), pattern), last;
      std::size_t done = 0;
      for (; match != last; ++match) {
        const auto begin = static_cast<std::size_t>(match->position(1));
        marked += piece.substr(done, begin - done) + "`" + boost::replace_all_copy(match->str(1), "*", " ") + "`";
        done = begin + match->str(1).size();
      }
      piece = marked + piece.substr(done);
    }
    result += piece + (end < text.size() ? "`" : "");
    at = end + 1;
  }
  return result;
}

/// Returns what a check found, "A t = u'/c: relative difference 2.9e-01 ... at nu = 0.3, f = 1", with its formulas
/// between backticks.
std::string with_formulas(std::string text) {
  static const std::array patterns{
      std::regex(R"((?:: | in place of )([-\w*+() ^/]+?)(?= in place of |;))"),
      std::regex(
          R"((A t = u'/c|\|x\|\^lambda|\bx [<>] 0|u'(?= over theta)|theta(?= d\^p)|d\^p|d\^lambda|u_bar'|\b(?:L|phi)\(\w+\)))"),
      std::regex(R"(((?:\b(?:nu|psi|gamma|[fsEP])|u') !?= -?[\w.*^/]+(?: [-+] [\w.*^/]+)*(?:, -?\d[\d./]*)*))"),
      std::regex(R"((\b\d\.\de[-+]\d+\b))")};
  for (const std::regex& pattern : patterns) text = with_marks(text, pattern);
  return text;
}

/// Returns the run's verdict on the claim. If the printed reading is one of its controls, also the result of this
/// control.
std::string examined(const std::string& claim, const std::string& printed, std::span<const Report> reports) {
  const auto report = std::ranges::find(reports, claim, [](const Report& r) { return r.claim.id; });
  if (report == reports.end()) return "not examined in this run: claim " + claim;
  std::string text = "claim " + claim + " is " + std::string(name_of(report->verdict)) + " as derived";
  if (printed.empty()) return text;
  const auto control = std::ranges::find(report->controls, printed, &ControlReport::name);
  if (control == report->controls.end()) return "claim " + claim + " has no such control";
  text += control->refuted ? "; the printed reading is refuted (" : "; the printed reading was not refuted (";
  return text + with_formulas(control->detail) + ")";
}

}  // namespace

std::vector<ReadingNote> reading_notes(std::span<const Report> reports) {
  const std::vector<symbolic::LocalReading> local = symbolic::local_readings();
  std::vector<ReadingNote> notes;
  for (const Entry& e : entries()) {
    const auto [claim, control] = divided(e.part("claim"), "; control: ");
    const auto [fault, reason] = divided(e.part("at fault"), ". ");
    std::vector<std::string> evidence;
    if (!claim.empty()) evidence.push_back(examined(claim, control, reports) + ".");
    const auto found = std::ranges::find(local, e.id, &symbolic::LocalReading::id);
    if (found != local.end()) evidence.push_back(with_formulas(found->found));
    evidence.insert(evidence.end(), {e.part("evidence"), reason});
    std::erase(evidence, std::string());
    notes.push_back({e.id, e.place, e.part("printed"), e.part("derived"), boost::algorithm::join(evidence, " "), fault,
                     claim, control});
  }
  return notes;
}

}  // namespace steadyslide::proofs_checks
