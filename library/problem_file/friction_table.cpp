#include "library/problem_file/friction_table.hpp"

#include <fmt/format.h>

#include "library/problem_file/table_reader.hpp"

namespace steadyslide::library {

FrictionProfile parse_friction_table(std::string_view text, const std::string& name, const Support& support,
                                     const Rational& unit) {
  TableReader reader(name, {"a friction table", "x,f", {"x", "f"}, 2});
  std::vector<Rational> values, jumps;
  std::size_t rows = 0;
  Rational before;
  reader.read(text, [&](std::vector<Rational>& row) {
    const Rational x = unit * row[0];
    if (rows == max_friction_values) {
      throw reader.error("too many rows", fmt::format("a friction table has at most {}", max_friction_values), "more");
    }
    if (rows == 0 && x > support.left) {
      throw reader.error("x: friction begins inside the support",
                         "the first x is at most the left end, " + to_string(support.left), to_string(x));
    }
    if (rows > 0 && x <= before) {
      throw reader.error("x: not increasing", "x increases from line to line",
                         to_string(x) + " after " + to_string(before));
    }
    if (row[1] < 0) {
      throw reader.error("f: negative friction coefficient", "a friction coefficient is at least 0", to_string(row[1]));
    }
    ++rows;
    before = x;
    if (x >= support.right) return;
    if (x > support.left) {
      jumps.push_back(x);
    } else {
      values.clear();
    }
    values.push_back(std::move(row[1]));
  });
  if (rows == 0) throw reader.error("no friction value", "there is at least one line x,f", "0 lines");
  return FrictionProfile(std::move(values), std::move(jumps));
}

}  // namespace steadyslide::library
