#include "proofs_checks/statements/paper_statements.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "proofs_checks/proof/markdown.hpp"

namespace steadyslide::proofs_checks {

namespace embedded {
extern const std::string_view paper_statements_md;
}

const std::vector<PaperStatement>& paper_statements() {
  static const std::vector<PaperStatement> all = [] {
    std::vector<PaperStatement> statements;
    for (const std::string_view line : parts_of(embedded::paper_statements_md, "\n")) {
      if (line.empty()) continue;
      const std::size_t colon = line.find(": ");
      const std::string_view head = line.substr(0, colon);
      const std::string_view rest = line.substr(colon + 2);
      if (line.starts_with("- ")) {
        const std::string_view place = head.substr(2);
        statements.push_back({place == "beyond the paper" ? "" : place, rest, {}, {}, {}, {}});
      } else if (head == "  scope") {
        statements.back().scope = rest;
      } else if (head == "  restriction") {
        statements.back().restriction = rest;
      } else if (head == "  words") {
        statements.back().reconstructed = rest == "reconstructed";
      } else if (head == "  claims" || head == "  instances") {
        PaperStatement& last = statements.back();
        for (const std::string_view id : parts_of(rest, ", ")) {
          (head == "  claims" ? last.claims : last.instances).push_back(id);
        }
      }
    }
    return statements;
  }();
  return all;
}

std::optional<Verdict> verdict_of(const PaperStatement& statement, std::span<const Report> reports) {
  std::optional<Verdict> weakest;
  for (const std::string_view id : statement.claims) {
    const auto report = std::ranges::find(reports, id, [](const Report& r) { return std::string_view(r.claim.id); });
    if (report == reports.end()) return std::nullopt;
    weakest = std::min(weakest.value_or(Verdict::proved), report->verdict);
  }
  return weakest;
}

constexpr std::array<std::string_view, 3> proved{"proved", "proved, restricted", "proved, as reconstructed"};

std::string_view standing(const PaperStatement& statement, Verdict verdict) {
  if (verdict != Verdict::proved) return name_of(verdict);
  return statement.reconstructed ? proved[2] : statement.restriction.empty() ? proved[0] : proved[1];
}

std::vector<std::pair<std::string_view, std::size_t>> statement_counts(std::span<const Report> reports) {
  std::map<std::string_view, std::size_t> counts;
  for (const PaperStatement& statement : paper_statements()) {
    const auto verdict = statement.place.empty() ? std::nullopt : verdict_of(statement, reports);
    if (verdict) ++counts[standing(statement, *verdict)];
  }
  std::vector<std::pair<std::string_view, std::size_t>> result;
  for (const std::string_view name : proved) result.emplace_back(name, counts[name]);
  for (const Verdict verdict : {Verdict::supported, Verdict::undecided, Verdict::refuted}) {
    result.emplace_back(name_of(verdict), counts[name_of(verdict)]);
  }
  return result;
}

std::string statements_line(std::span<const Report> reports) {
  const auto is_left_out = [&](const PaperStatement& statement) {
    return !statement.place.empty() && !verdict_of(statement, reports);
  };
  if (std::ranges::any_of(paper_statements(), is_left_out)) return "";
  std::string line;
  for (const auto& [verdict, n] : statement_counts(reports)) {
    line += (line.empty() ? "" : "; ") + std::to_string(n) + " " + std::string(verdict);
  }
  return line;
}

}  // namespace steadyslide::proofs_checks
