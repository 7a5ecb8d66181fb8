#pragma once
// Tests of error bounds where they are sharp. Each case has a true error, known by another route, that is as close to
// the bound as we could make it. docs/bounds.csv lists all bounds with this ratio. A ratio above 1 is a wrong bound. A
// ratio below 1/10 needs a reason in the table.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace steadyslide::testing {

struct SharpCase {
  std::string bound;                ///< the name in docs/bounds.csv
  std::function<double()> measure;  ///< returns the true error divided by the bound
};

/// A row of the table: bound,test,source,formula,case,sharpness,reason. A field in quotes may contain commas.
struct BoundRow {
  std::string bound;
  std::string test;
  double sharpness;
  std::string reason;
};

inline std::vector<BoundRow> bound_rows() {
  std::ifstream stream(STEADYSLIDE_BOUNDS);
  REQUIRE_MESSAGE(stream, STEADYSLIDE_BOUNDS);
  std::vector<BoundRow> result;
  std::string line;
  std::getline(stream, line);
  REQUIRE(line == "bound,test,source,formula,case,sharpness,reason");
  while (std::getline(stream, line)) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    REQUIRE_MESSAGE(fields.size() == 7, line);
    result.push_back({fields[0], fields[1], fields[5].empty() ? 0 : std::stod(fields[5]), fields[6]});
  }
  return result;
}

/// Measures all cases and compares them with the rows of this test in docs/bounds.csv. A row without sharpness has no
/// case.
inline void check_sharp_bounds(const std::string& test, const std::vector<SharpCase>& cases) {
  std::vector<std::string> listed, measured;
  const std::vector<BoundRow> rows = bound_rows();
  for (const BoundRow& row : rows) {
    if (row.test == test && row.sharpness > 0) listed.push_back(row.bound);
  }
  for (const SharpCase& c : cases) {
    const double ratio = c.measure();
    INFO(c.bound, ": the true error is ", ratio, " of the bound");
    measured.push_back(c.bound);
    CHECK(ratio <= 1);
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const BoundRow& r) { return r.bound == c.bound; });
    if (row == rows.end()) {
      FAIL_CHECK("docs/bounds.csv does not list it");
      continue;
    }
    CHECK((ratio >= 0.1 || !row->reason.empty()));
    CHECK(std::abs(ratio - row->sharpness) <= 0.1 * row->sharpness);
  }
  CHECK(measured == listed);
}

}  // namespace steadyslide::testing
