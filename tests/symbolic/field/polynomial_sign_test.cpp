#include "symbolic/field/polynomial_sign.hpp"

#include "model/polynomial.hpp"
#include "support/test.hpp"

using steadyslide::Rational;
using steadyslide::Truth;
using steadyslide::symbolic::is_positive;
using steadyslide::symbolic::ParameterRange;

namespace {

ParameterRange closed(const Rational& from, const Rational& to) { return {from, to, true, true}; }
ParameterRange open(const Rational& from, const Rational& to) { return {from, to, false, false}; }
const ParameterRange from_zero{Rational(0), std::nullopt, true, false};
const ParameterRange above_zero{Rational(0), std::nullopt, false, false};
const ParameterRange any{};

}  // namespace

TEST_CASE("signs over intervals, their ends in or out") {
  const Rational half(1, 2);
  CHECK(is_positive("1 - 4*x^2", {{"x", open(-half, half)}}) == Truth::yes);
  CHECK(is_positive("1 - 4*x^2", {{"x", closed(-half, half)}}) == Truth::no);
  CHECK(is_positive("x", {{"x", above_zero}}) == Truth::yes);
  CHECK(is_positive("x", {{"x", from_zero}}) == Truth::no);
  CHECK(is_positive("x^2 + 1", {{"x", any}}) == Truth::yes);
  CHECK(is_positive("x^2 - 2*x + 1.0001", {{"x", any}}) == Truth::yes);
  CHECK(is_positive("x^2 - 2*x + 1", {{"x", any}}) != Truth::yes);
  CHECK(is_positive("x^2 - 2*x + 999/1000", {{"x", any}}) == Truth::no);
  CHECK(is_positive("1 + s*t + x^2 - x", {{"s", from_zero}, {"t", from_zero}, {"x", any}}) == Truth::yes);
  CHECK(is_positive("s - t", {{"s", from_zero}, {"t", from_zero}}) == Truth::no);
  // Only the constant is negative, at an end outside the range: no half decides it.
  CHECK(is_positive("x - 1", {{"x", above_zero}}) == Truth::unknown);
  CHECK(is_positive("(1-nu)*(1+nu)", {{"nu", open(-1, half)}}) == Truth::yes);
  CHECK(is_positive("-(nu - 1)", {{"nu", open(-1, half)}}) == Truth::yes);
  CHECK(is_positive("7/3", {}) == Truth::yes);
  CHECK(is_positive("-7/3", {}) == Truth::no);
  CHECK(is_positive("x - 1", {{"x", closed(2, 2)}}) == Truth::yes);
}

TEST_CASE("a double zero that no halving hits is undecided, after thousands of halvings") {
  CHECK(is_positive("(3*x - 1)^2", {{"x", closed(0, 1)}}) == Truth::unknown);
  CHECK(is_positive("(3*x - 1)^2 + 1/10^40", {{"x", closed(0, 1)}}) == Truth::yes);
  CHECK(is_positive("(3*x - 1)^2 - 1/10^40", {{"x", closed(0, 1)}}) == Truth::no);
}

TEST_CASE("what is no polynomial in parameters with ranges is refused") {
  for (const std::string text : {"1/x", "sqrt(x)", "y", "x +", "sin(x)", ""})
    CHECK_THROWS_AS_MESSAGE(is_positive(text, {{"x", from_zero}}), std::domain_error, text);
}

TEST_CASE("random polynomials: the sign that is decided is the sign at places") {
  REQUIRE(rc::check("yes: positive at all places of a grid; no: not at one of a fine grid or the polynomial falls to 0",
                    [] {
                      const auto coefficient = rc::gen::inRange(-6, 7);
                      const std::vector<int> c = *rc::gen::container<std::vector<int>>(4, coefficient);
                      const int from = *rc::gen::inRange(-3, 3);
                      const int to = *rc::gen::inRange(from + 1, 5);
                      const bool ends = *rc::gen::arbitrary<bool>();
                      std::string text = "0";
                      for (std::size_t k = 0; k < c.size(); ++k)
                        text += " + (" + std::to_string(c[k]) + ")*x^" + std::to_string(k);
                      const Truth truth = is_positive(text, {{"x", {Rational(from), Rational(to), ends, ends}}});
                      const steadyslide::Polynomial polynomial({c[0], c[1], c[2], c[3]});
                      bool positive = true;
                      for (int k = ends ? 0 : 1; k < 400 + (ends ? 1 : 0); ++k) {
                        positive = positive && polynomial(Rational(from + Rational(k * (to - from), 400))) > 0;
                      }
                      if (truth == Truth::yes) RC_ASSERT(positive);
                      if (positive) RC_ASSERT(truth != Truth::no || !ends);
                      if (!positive) RC_ASSERT(truth != Truth::yes);
                    }));
}
