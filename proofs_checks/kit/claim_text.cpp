#include "proofs_checks/kit/claim_text.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "proofs_checks/kit/claim_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

std::string_view next_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return line;
}

}  // namespace

ClaimText parse_claim_text(std::string_view document) {
  ClaimText text;
  std::string nowhere;
  std::string* part = &nowhere;
  const std::array<std::pair<std::string_view, std::string*>, 3> parts{
      {{"## Statement", &text.statement}, {"## Hypotheses", &text.hypotheses}, {"## Derivation", &text.derivation}}};
  while (!document.empty()) {
    const std::string_view line = next_line(document);
    if (line.starts_with("# ")) {
      text.id = line.substr(2);
      part = &text.source;
    } else if (line.starts_with('#')) {
      const auto found = std::ranges::find(parts, line, [](const auto& p) { return p.first; });
      if (found == parts.end()) throw std::logic_error(text.id + ": no such part of a claim: " + std::string(line));
      part = found->second;
    } else if (!line.empty()) {
      if (!part->empty()) *part += ' ';
      *part += line;
    }
  }
  if (!nowhere.empty() || text.id.empty() || text.source.empty() || text.statement.empty() || text.hypotheses.empty()) {
    throw std::logic_error("not the text of a claim: " + (text.id.empty() ? nowhere : text.id));
  }
  return text;
}

ClaimText claim_text(std::string_view id) {
  for (const ClaimEntry& entry : claim_list()) {
    if (entry.id == id) return parse_claim_text(entry.document);
  }
  throw std::logic_error("no text of a claim " + std::string(id));
}

}  // namespace steadyslide::proofs_checks
