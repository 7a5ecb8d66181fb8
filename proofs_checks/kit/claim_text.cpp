#include "proofs_checks/kit/claim_text.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Reads how a quantity is compared, "tolerance 1e-8, absolute", into `how`.
void set_how(Quantity& how, const std::string& text) {
  for (const std::string& item : items_of(text)) {
    const auto number = [&item](const std::string& name, double& value) {
      if (!item.starts_with(name + " ")) return false;
      value = std::stod(item.substr(name.size()));
      return true;
    };
    if (item == "absolute") {
      how.absolute = true;
    } else if (item == "at most") {
      how.at_most = true;
    } else if (item == "no near miss") {
      how.near_miss = false;
    } else if (!number("tolerance", how.tolerance) && !number("required", how.required)) {
      throw std::logic_error("not how numbers are compared: " + item);
    }
  }
}

void read_row(ClaimText& text, std::string_view row) {
  const std::vector<std::string> cells = cells_of(row);
  if (!cells.empty() && (cells[0] == "compared" || cells[0] == "decided about" || is_rule_of_table(row))) return;
  const bool has_how = cells.size() == 5;
  if (cells.size() == 3) {
    text.decided.push_back({cells[0], list_of(cells[1], ", "), list_of(cells[2], "; ")});
  } else if ((cells.size() == 4 || has_how) && !cells[0].empty() && !cells[1].empty() &&
             cells[2].empty() == cells[3].empty()) {
    Quantity& quantity = text.compared.emplace_back(Quantity{.what = cells[1], .name = cells[0]});
    if (!cells[2].empty()) quantity.routes = {cells[2], cells[3]};
    if (has_how) set_how(quantity, cells[4]);
  } else {
    throw std::logic_error(text.id + ": not a row of a name, what it is, and both routes or none: " + std::string(row));
  }
}

}  // namespace

ClaimText parse_claim_text(std::string_view document) {
  ClaimText text;
  std::string nowhere;
  std::string* part = &nowhere;  // null: inside a proof. After a table no words are allowed.
  std::string in_its_place;
  std::vector<std::string_view> proof;
  const std::array<std::pair<std::string_view, std::string*>, 7> parts{
      {{"Statement", &text.statement},
       {"Hypotheses", &text.hypotheses},
       {"Derivation", &text.derivation},
       {"Proof", nullptr},
       {"Convergence", &text.convergence},
       {"Beyond calculation", &text.beyond_calculation},
       {"Checked in its place", &in_its_place}}};
  for (std::string_view line : parts_of(document, "\n")) {
    if (line.starts_with("# ") && line.find(": ") != std::string_view::npos) {
      text.id = line.substr(2, line.find(": ") - 2);
      text.source = line.substr(line.find(": ") + 2);
      continue;
    }
    // A part begins with its title: "**Statement.** Words".
    if (const std::size_t end = line.find(".** "); line.starts_with("**") && end != std::string_view::npos) {
      const auto found = std::ranges::find(parts, line.substr(2, end - 2), [](const auto& p) { return p.first; });
      if (found == parts.end()) throw std::logic_error(text.id + ": no such part of a claim: " + std::string(line));
      part = found->second;
      line.remove_prefix(end + 4);
    }
    if (!part) {
      proof.push_back(line);
    } else if (line.starts_with("| ") || is_rule_of_table(line)) {
      read_row(text, line);
      part = &nowhere;
    } else if (!line.empty()) {
      if (!part->empty()) *part += ' ';
      *part += line;
    }
  }
  if (!nowhere.empty() || text.id.empty() || text.source.empty() || text.statement.empty() || text.hypotheses.empty()) {
    throw std::logic_error("not the text of a claim: " + (text.id.empty() ? nowhere : text.id));
  }
  if (!proof.empty()) text.proof = parse_proof(proof);
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
