#include "app/command_line.hpp"
#include "app/results/solution_text.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;

namespace {

/// "1+-0.02": an estimate; infinities have no error.
numeric::Estimate<double> estimate(const std::string& text) {
  const std::size_t error = text.find("+-");
  return {std::stod(text), error == std::string::npos ? 0 : std::stod(text.substr(error + 2))};
}

/// Returns one text, or both limits; an empty text for an unknown value.
std::string shown(const LimitText& text) { return text.left.value + (text.two_sided() ? "|" + text.right.value : ""); }

}  // namespace

TEST_CASE(
    "limits become one text or two: infinite ones, unknown ones, and ones that differ by no more than their error") {
  // A function that is infinite on one side, also at an edge, has one text; infinities of different signs have two. The
  // shear without friction beside an infinite traction keeps both limits. An unknown limit does not hide the other one.
  std::vector<std::string> rows = lines(file_text(STEADYSLIDE_TESTS "/app/results/limits.csv"));
  rows.erase(rows.begin());
  for (const std::string& row : rows) {
    CAPTURE(row);
    const std::vector<std::string> cell = cells_of(row);
    const numeric::TwoSided<double> limits{estimate(cell[0]), estimate(cell[1])};
    const numeric::TwoSided<double> traction{estimate(cell[2]), estimate(cell[3])};
    CHECK(shown(limit_text(limits, traction, 16)) == cell[4]);
  }
}

TEST_CASE("two limits within their errors are two numbers in files and one in text") {
  const numeric::TwoSided<double> values{estimate("1+-0.02"), estimate("1.03+-0.02")};
  const LimitText text = limit_text(values, values, 16, true);
  CHECK(shown(text) == "1|1.03");
  CHECK(text.right.shown == text.left.shown);
}
