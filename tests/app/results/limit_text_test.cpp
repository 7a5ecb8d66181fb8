#include "app/results/solution_text.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;
using steadyslide::numeric::Estimate;
using steadyslide::numeric::infinity;
using TwoSided = steadyslide::numeric::TwoSided<double>;

namespace {

const Estimate<double> blow_up{-infinity<double>(), 0};
const Estimate<double> up{infinity<double>(), 0};
const Estimate<double> zero{};

}  // namespace

TEST_CASE("a blow-up is one text, also at an edge") {
  const LimitText edge = limit_text(TwoSided{zero, blow_up}, TwoSided{zero, blow_up}, 16);
  CHECK(edge.left.value == "-inf");
  CHECK_FALSE(edge.two_sided());
  const LimitText shear = limit_text(TwoSided{zero, up}, TwoSided{zero, blow_up}, 16);
  CHECK(shear.left.value == "inf");
  CHECK_FALSE(shear.two_sided());
}

TEST_CASE("shear without friction beside a blow-up keeps both limits") {
  const LimitText shear = limit_text(TwoSided{zero, up}, TwoSided{blow_up, blow_up}, 16);
  CHECK(shear.left.value == "0");
  CHECK(shear.right.value == "inf");
}

TEST_CASE("infinities of both signs are two texts") {
  const LimitText slope = limit_text(TwoSided{blow_up, up}, TwoSided{blow_up, up}, 16);
  CHECK(slope.left.value == "-inf");
  CHECK(slope.right.value == "inf");
}

TEST_CASE("a limit that is not known does not hide the other one") {
  const TwoSided values{{1, infinity<double>()}, {2, 0}};
  const LimitText text = limit_text(values, values, 16);
  CHECK(text.left.value == "");
  CHECK(text.right.value == "2");
}

TEST_CASE("finite limits are two texts only if they differ by more than their errors") {
  const auto limits = [](double a, double b, double error) {
    const TwoSided values{{a, error}, {b, error}};
    return limit_text(values, values, 16);
  };
  CHECK(limits(1, 2, 0).left.value == "1");
  CHECK(limits(1, 2, 0).right.value == "2");
  CHECK_FALSE(limits(1, 1, 0).two_sided());
  CHECK_FALSE(limits(1, 1.03, 0.02).two_sided());
  CHECK(limits(1, 1.05, 0.02).two_sided());
}

TEST_CASE("sides that are kept apart are two in files, one to a person") {
  const TwoSided values{{1, 0.02}, {1.03, 0.02}};
  const LimitText text = limit_text(values, values, 16, true);
  CHECK(text.two_sided());
  CHECK(text.right.value == "1.03");
  CHECK(text.right.shown == text.left.shown);
}
