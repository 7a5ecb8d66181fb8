#include "proofs_checks/statements/paper_statements.hpp"

#include <ranges>

namespace steadyslide::proofs_checks {

namespace embedded {
extern const std::string_view paper_statements_md;
}

const std::vector<PaperStatement>& paper_statements() {
  static const std::vector<PaperStatement> all = [] {
    std::vector<PaperStatement> statements;
    for (const auto part : std::views::split(embedded::paper_statements_md, '\n')) {
      const std::string_view line(part.begin(), part.end());
      if (line.starts_with("  - ")) {
        statements.back().claims.push_back(line.substr(4));
      } else if (line.starts_with("- ")) {
        const std::size_t colon = line.find(": ");
        const std::string_view place = line.substr(2, colon - 2);
        statements.push_back({place == "beyond the paper" ? "" : place, line.substr(colon + 2), {}});
      }
    }
    return statements;
  }();
  return all;
}

}  // namespace steadyslide::proofs_checks
