#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"
#include "model/singular_point.hpp"
#include "support/test.hpp"
#include "symbolic/field/expression.hpp"
#include "symbolic/local/polynomial_slope.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;

TEST_CASE("the derived exponents are the model's, for any frictions") {
  const std::vector<Rational> values{0, 0.75_r, -1, 7, -0.001_r};
  for (const Rational& l : values) {
    for (const Rational& r : values) {
      const auto value = [&](PointKind kind) { return derived_exponent(kind).exponent({l, r}); };
      CHECK(value(PointKind::left_edge) == edge_exponent(End::left, r));
      CHECK(value(PointKind::right_edge) == edge_exponent(End::right, l));
      CHECK(value(PointKind::left_free) == free_exponent(End::left, r));
      CHECK(value(PointKind::right_free) == free_exponent(End::right, l));
      CHECK(value(PointKind::jump) == jump_exponent(l, r));
    }
  }
}

TEST_CASE("contacts of up to three components: order, signs, as many conditions as unknowns") {
  const std::vector<EndKind> kinds{EndKind::edge, EndKind::free};
  for (int mask = 0; mask < 64; ++mask) {
    for (std::size_t n = 1; n <= 3; ++n) {
      if (mask >= 1 << (2 * n)) continue;
      std::vector<Component> components;
      for (std::size_t c = 0; c < n; ++c) {
        components.push_back({kinds[static_cast<std::size_t>(mask >> (2 * c) & 1)],
                              kinds[static_cast<std::size_t>(mask >> (2 * c + 1) & 1)], 1 + (c + n) % 2});
      }
      const FundamentalSolution y(components);
      CHECK(y.order() == y.free_ends() - static_cast<int>(n));
      std::vector<ex> frictions;
      for (std::size_t k = 0; k < y.panels(); ++k)
        frictions.push_back(to_expression(Rational(1 + 2 * static_cast<int>(k), 7)));
      const PhaseField field(frictions);
      // epsilon has one sign on a component: the sign of its right end, times (-1)^S of the components to its right.
      int order_right = 0;
      for (std::size_t c = n; c-- > 0;) {
        const bool is_free = components[c].right == EndKind::free;
        const int expected = (is_free ? -1 : 1) * (order_right % 2 == 0 ? 1 : -1);
        for (const auto& region : y.regions()) {
          if (region.friction && region.component == c) CHECK(y.sign_on(field, region) == expected);
        }
        order_right += (components[c].left == EndKind::free) + is_free - 1;
      }
      const std::vector<ex> slope{ex(0), ex(1)};
      const PolynomialSlope solution(y.order(), slope,
                                     power_sum_symbols(PolynomialSlope::sums_needed(y.order(), slope.size())), 1);
      const std::size_t load_in_q = y.order() < 0 ? 1 : 0;
      const std::size_t unknowns =
          static_cast<std::size_t>(y.free_ends()) + load_in_q + solution.free_coefficients().size();
      CHECK(unknowns == solution.conditions().size() + load_in_q + (n - 1));
    }
  }
}

TEST_CASE("what is no contact or no exponent is refused") {
  CHECK_THROWS_AS(FundamentalSolution({}), std::domain_error);
  CHECK_THROWS_AS(FundamentalSolution({{EndKind::edge, EndKind::edge, 0}}), std::domain_error);
  const FundamentalSolution y(EndKind::edge, EndKind::edge, 0);
  CHECK_THROWS_AS(y.with_powers({AngleForm(-1), AngleForm(-1, {{0, 1}})}).order(), std::domain_error);
  const FundamentalSolution wrong = y.with_powers({AngleForm(-1), AngleForm(-1)});
  CHECK_THROWS_AS(wrong.sign_on(PhaseField(symbols("s", y.panels())), wrong.regions()[1]), std::domain_error);
}
