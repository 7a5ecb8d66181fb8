#include "library/problem_file/symbol_table.hpp"

#include <fmt/format.h>

#include "library/problem_file/table_reader.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {

std::vector<SymbolRow> parse_symbols(std::string_view text, const std::string& name) {
  TableReader lines(name, {"a table of symbols", "k,W,gamma V", {"k", "W", "gamma V"}, 3});
  std::vector<SymbolRow> rows;
  lines.read(text, [&](std::vector<Rational>& row) {
    if (rows.size() == max_symbol_rows)
      throw lines.error("too many rows", fmt::format("a table of symbols has at most {}", max_symbol_rows), "more");
    rows.push_back({row[0], row[1], row[2]});
    try {
      check_symbols(rows.back(), rows.size() > 1 ? &rows[rows.size() - 2] : nullptr);
    } catch (const InvalidData& invalid) {
      throw lines.error(invalid.what());
    }
  });
  return rows;
}

}  // namespace steadyslide::library
