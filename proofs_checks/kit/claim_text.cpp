#include "proofs_checks/kit/claim_text.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/trim.hpp>
#include <ranges>
#include <stdexcept>

#include "proofs_checks/kit/registry.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// "| a | b \\| c |" has the cells "a" and "b | c".
std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] == '|') {
      cells.emplace_back();
    } else if (!cells.empty()) {
      if (row.substr(k, 2) == "\\|") ++k;
      cells.back() += row[k];
    }
  }
  if (!cells.empty()) cells.pop_back();  // behind the last bar
  for (std::string& cell : cells) boost::algorithm::trim(cell);
  return cells;
}

/// The parts between the separators.
std::vector<std::string> list_of(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (const auto part : std::views::split(text, separator)) parts.emplace_back(part.begin(), part.end());
  return parts;
}

void read_row(ClaimText& text, std::string_view row) {
  const std::vector<std::string> cells = cells_of(row);
  if (!cells.empty() && (cells[0] == "name" || cells[0] == "about" || cells[0].starts_with("---"))) return;
  if (cells.size() == 3) {
    text.decided.push_back({cells[0], list_of(cells[1], ", "), list_of(cells[2], "; ")});
  } else if (cells.size() == 4 && !cells[0].empty() && !cells[1].empty() && cells[2].empty() == cells[3].empty()) {
    text.compared.push_back({cells[0], cells[1], {}});
    if (!cells[2].empty()) text.compared.back().routes = {cells[2], cells[3]};
  } else {
    throw std::logic_error(text.id + ": not a row of a name, what it is, and both routes or none: " + std::string(row));
  }
}

}  // namespace

ClaimText parse_claim_text(std::string_view document) {
  ClaimText text;
  std::string nowhere;
  std::string* part = &nowhere;  // null: within a table
  std::string in_its_place;
  const std::array<std::pair<std::string_view, std::string*>, 8> parts{
      {{"## Statement", &text.statement},
       {"## Hypotheses", &text.hypotheses},
       {"## Derivation", &text.derivation},
       {"## Compared", nullptr},
       {"## Decided", nullptr},
       {"## Convergence", &text.convergence},
       {"## Beyond calculation", &text.beyond_calculation},
       {"## Checked in its place", &in_its_place}}};
  for (const auto characters : std::views::split(document, '\n')) {
    const std::string_view line(characters.begin(), characters.end());
    if (line.starts_with("# ")) {
      text.id = line.substr(2);
      part = &text.source;
    } else if (line.starts_with('#')) {
      const auto found = std::ranges::find(parts, line, [](const auto& p) { return p.first; });
      if (found == parts.end()) throw std::logic_error(text.id + ": no such part of a claim: " + std::string(line));
      part = found->second;
    } else if (!part && !line.empty()) {
      read_row(text, line);
    } else if (!line.empty()) {
      if (!part->empty()) *part += ' ';
      *part += line;
    }
  }
  if (!nowhere.empty() || text.id.empty() || text.source.empty() || text.statement.empty() || text.hypotheses.empty()) {
    throw std::logic_error("not the text of a claim: " + (text.id.empty() ? nowhere : text.id));
  }
  if (!in_its_place.empty()) text.checked_in_its_place = list_of(in_its_place, ", ");
  return text;
}

ClaimText claim_text(std::string_view id) {
  for (const ClaimEntry& entry : claim_list()) {
    if (entry.id == id) return parse_claim_text(entry.document);
  }
  throw std::logic_error("no text of a claim " + std::string(id));
}

}  // namespace steadyslide::proofs_checks
