#include "app/results/solution_text.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;

namespace {

/// "1+-0.02": an estimate; infinities have no error.
numeric::Estimate<double> estimate(const std::string& text) {
  const std::size_t error = text.find("+-");
  return {std::stod(text), error == std::string::npos ? 0 : std::stod(text.substr(error + 2))};
}

/// "left,right".
numeric::TwoSided<double> two_sided(const std::string& text) {
  const std::size_t comma = text.find(',');
  return {estimate(text.substr(0, comma)), estimate(text.substr(comma + 1))};
}

/// One text, or both limits; of what is not known there is none.
std::string shown(const LimitText& text) { return text.left.value + (text.two_sided() ? "," + text.right.value : ""); }

}  // namespace

TEST_CASE("one text for both limits, or two: blow-ups, what is not known, and what differs by no more than its error") {
  // The limits, those of the traction, and what is written. A blow-up is one text, at an edge too; of two of different
  // sign both are written. Shear without friction beside a blow-up keeps both limits; one not known hides no other.
  const std::string rows =
      "0,-inf:0,-inf:-inf 0,inf:0,-inf:inf -inf,inf:-inf,inf:-inf,inf 0,inf:-inf,-inf:0,inf 1+-inf,2:1+-inf,2:,2 "
      "1,2:1,2:1,2 1,1:1,1:1 1+-0.02,1.03+-0.02:1+-0.02,1.03+-0.02:1 "
      "1+-0.02,1.05+-0.02:1+-0.02,1.05+-0.02:1,1.05";
  for (const std::string& row : words(rows)) {
    CAPTURE(row);
    const std::size_t traction = row.find(':') + 1, written = row.rfind(':') + 1;
    const auto limits = two_sided(row.substr(0, traction - 1));
    CHECK(shown(limit_text(limits, two_sided(row.substr(traction, written - traction - 1)), 16)) ==
          row.substr(written));
  }
}

TEST_CASE("sides that are kept apart are two in files, one to a person") {
  const auto values = two_sided("1+-0.02,1.03+-0.02");
  const LimitText text = limit_text(values, values, 16, true);
  CHECK(shown(text) == "1,1.03");
  CHECK(text.right.shown == text.left.shown);
}
