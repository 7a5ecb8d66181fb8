// The section "Convergence tables" of docs/cost.md has the numbers that the library computes. The last printed digit of a
// number may differ between machines.

#include "proofs_checks/instruments/convergence/convergence_table.hpp"
#include "proofs_checks/proof/markdown.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

using Row = std::vector<std::string>;
/// Tables by section. A row's key: the columns of the table and the first two cells.
using Tables = std::map<std::string, Row>;

Row cells_of(const std::string& line) {
  Row cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto from = cell.find_first_not_of(' ');
    cells.push_back(from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
  }
  return cells;
}

Tables tables_of(const std::string& document) {
  Tables tables;
  std::string section, columns;
  for (const std::string& line : lines(document)) {
    if (line.starts_with("### ")) section = line;
    if (!line.starts_with("|")) {
      columns.clear();
    } else if (columns.empty()) {
      columns = line;
    } else if (!line.starts_with("| ---")) {
      const Row cells = cells_of(line);
      // An end in cells does not identify a row.
      const bool exponents = columns.starts_with("| x ");
      tables[section + columns + cells[0] + (exponents ? cells[1] : "")] = cells;
    }
  }
  return tables;
}

/// Tolerance: two units in the last place; a factor of two for a mantissa without decimals, as error bars have it.
bool is_close(const std::string& one, const std::string& other) {
  if (one == other) return true;
  if (one.empty() || other.empty()) return false;
  const double a = std::stod(one), b = std::stod(other);
  const auto e = one.find('e');
  const auto point = one.find('.');
  if (e == std::string::npos) {
    if (point == std::string::npos) return false;
    return std::abs(a - b) <= 2.1 * std::pow(10, -static_cast<double>(one.size() - point - 1));
  }
  const double largest = std::max(std::abs(a), std::abs(b));
  return std::abs(a - b) <= (point == std::string::npos ? 0.5 : 0.12) * largest;
}

/// Returns the rows of one document that are absent or different in the other.
std::vector<std::string> differences(const Tables& some, const Tables& all) {
  std::vector<std::string> result;
  for (const auto& [name, row] : some) {
    const auto found = all.find(name);
    bool same = found != all.end() && found->second.size() == row.size();
    for (std::size_t k = 0; same && k < row.size(); ++k) {
      if (row[k] != found->second[k] && row[k].find_first_not_of("0123456789.e+-") != std::string::npos) same = false;
      same = same && is_close(row[k], found->second[k]);
    }
    if (!same) result.push_back(name);
  }
  return result;
}

std::string checked_in() {
  return std::string(section_of(file_text(STEADYSLIDE_DOCS "/cost.md"), "## Convergence tables"));
}

std::string until_first_table(const std::string& document) { return document.substr(0, document.find("\n|")); }

}  // namespace

TEST_CASE("docs/cost.md holds the rows of a quick run") {
  const std::string document = convergence_document(true);
  const Tables quick = tables_of(document);
  // Errors of eight problems, and proved bounds for the four problems in which s nowhere falls, the profile has no
  // step and the indenter may not tilt.
  CHECK(quick.size() == (8 + 4) * 4);
  CHECK(differences(quick, tables_of(checked_in())) == std::vector<std::string>{});
  CHECK(until_first_table(document) == until_first_table(checked_in()));
}

// Skipped here because it takes minutes; the slow test convergence_all_rows runs it.
TEST_CASE("docs/cost.md holds all that is computed (slow)" * doctest::skip()) {
  const Tables computed = tables_of(convergence_document(false)), held = tables_of(checked_in());
  CHECK(computed.size() == held.size());
  CHECK(differences(computed, held) == std::vector<std::string>{});
}

TEST_CASE("a changed number, a missing row and another section are noticed") {
  const std::string document = checked_in();
  const Tables held = tables_of(document);
  CHECK(differences(held, held).empty());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = document;
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return differences(held, tables_of(text.replace(at, from.size(), to))).size();
  };
  CHECK(changed("5.4e-04", "6.4e-04") == 1);
  CHECK(changed("| 1024 |", "| 1025 |") == 1);
  CHECK(changed("### wedge\n", "### wedges\n") > 10);
  CHECK(changed("0.46827", "0.46830") == 1);
}
