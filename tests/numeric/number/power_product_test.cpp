// Products of powers, compared with 50 digits, on every instruction set of this machine.

#include "numeric/number/power_product.hpp"
#include "numeric/cauchy/fundamental_solution.hpp"
#include "support/numeric_test.hpp"

namespace {

struct RandomProduct {
  std::vector<PowerFactor> of_left, of_right;
  std::vector<double> left, right;

  std::vector<double> values(InstructionSet set) const {
    std::vector<double> result(left.size());
    power_products(of_left, of_right, left, right, result, set);
    return result;
  }

  Real50 logarithm(std::size_t i) const {
    Real50 sum = 0;
    for (const PowerFactor& f : of_left) sum += f.power * log(Real50(f.offset) + left[i]);
    for (const PowerFactor& f : of_right) sum += f.power * log(Real50(f.offset) + right[i]);
    return sum;
  }

  /// The bound in the header.
  double bound() const {
    std::vector<double> powers;
    for (const auto* factors : {&of_left, &of_right}) {
      for (const PowerFactor& f : *factors) powers.push_back(std::abs(f.power));
    }
    double whole = 0, most = 0;
    for (std::size_t j = 0; j < powers.size(); ++j) {
      whole += powers[j];
      double here = 0;
      for (std::size_t k = j; k < std::min(j + 8, powers.size()); ++k) here += powers[k];
      most = std::max(most, here);
    }
    return 1.7 + whole / 11 + static_cast<double>(powers.size()) * most / 60;
  }
};

double fraction() { return uniform(-1'000'000'000, 1'000'000'000) / 1e9; }

/// Distances from 1e-300 to 1e300, of ordinary size, or next to 1.
RandomProduct random_product(int most_factors) {
  RandomProduct result;
  const double decades = std::vector<double>{300, 2, 1e-6}[static_cast<std::size_t>(uniform(0, 2))];
  for (int j = uniform(1, most_factors); j > 0; --j) {
    (uniform(0, 1) == 0 ? result.of_left : result.of_right).emplace_back(0.0, fraction());
  }
  for (int i = uniform(1, 40); i > 0; --i) {
    result.left.push_back(std::pow(10, decades * fraction()));
    result.right.push_back(std::pow(10, decades * fraction()));
  }
  return result;
}

/// Returns |found - e^logarithm| in units in the last place of e^logarithm; 0 outside the range of normal numbers.
double units_wrong(double found, const Real50& logarithm) {
  const Real50 exact = exp(logarithm);
  const auto rounded = static_cast<double>(exact);
  if (!(rounded > 1e-300 && rounded < 1e300)) return 0;
  return static_cast<double>(abs(found - exact)) / (std::nextafter(rounded, infinity<double>()) - rounded);
}

}  // namespace

TEST_CASE("products of powers are right to the units in the last place that their header says") {
  for (const InstructionSet set : instruction_sets()) {
    CAPTURE(static_cast<int>(set));
    REQUIRE(rc::check([&] {
      const RandomProduct product = random_product(8);
      const std::vector<double> values = product.values(set);
      const double bound = std::min(product.bound(), 4.0);
      for (std::size_t i = 0; i < values.size(); ++i) {
        RC_ASSERT(units_wrong(values[i], product.logarithm(i)) <= bound);
      }
    }));
    REQUIRE(rc::check([&] {
      const RandomProduct product = random_product(300);
      const std::vector<double> values = product.values(set);
      RC_ASSERT(units_wrong(values[0], product.logarithm(0)) <= product.bound());
    }));
  }
}

TEST_CASE("control: logarithms summed in double miss the bound, and so does a power rounded to its high part") {
  const PowerFactor f{0, 0.7000001};
  const std::vector<PowerFactor> one{f}, none;
  const std::vector<double> at{3e200};
  const Real50 exact = f.power * log(Real50(at[0]));
  CHECK(units_wrong(std::exp(f.power * std::log(at[0])), exact) > 20);
  std::vector<double> value(1);
  power_products(std::vector<PowerFactor>{{0, f.high}}, none, at, at, value);
  CHECK(units_wrong(value[0], exact) > 1e6);
  power_products(one, none, at, at, value);
  CHECK(units_wrong(value[0], exact) <= 2);
}

TEST_CASE("a value does not depend on its place among the points") {
  const std::vector<PowerFactor> of_left{{0, -0.3}, {0.5, 0.11}}, of_right{{0, 0.7}, {2, -0.51}};
  std::vector<double> left, right;
  for (int i = 0; i < 37; ++i) {
    left.push_back((i + 0.5) / 37);
    right.push_back(1 - left.back());
  }
  for (const InstructionSet set : instruction_sets()) {
    std::vector<double> all(left.size());
    power_products(of_left, of_right, left, right, all, set);
    for (std::size_t first = 0; first < left.size(); ++first) {
      for (std::size_t count = 0; first + count <= left.size(); ++count) {
        std::vector<double> part(count + 1, -1);  // one number more, which must not change
        const auto of = [&](const std::vector<double>& all_points) {
          return std::span<const double>(all_points).subspan(first, count);
        };
        power_products(of_left, of_right, of(left), of(right), std::span<double>(part).first(count), set);
        for (std::size_t i = 0; i < count; ++i) REQUIRE(part[i] == all[first + i]);
        REQUIRE(part[count] == -1);
      }
    }
  }
}

TEST_CASE("products beyond the range of double are infinite, 0, or rounded as small numbers are") {
  const std::vector<double> large{1e300}, small{1e-300}, moderate{1e-200};
  const std::vector<PowerFactor> one{{0, 1}}, both{{0, 1}, {0, 0.6}}, inverse{{0, -1}, {0, -0.6}};
  for (const InstructionSet set : instruction_sets()) {
    std::vector<double> value(1);
    const auto at = [&](const std::vector<PowerFactor>& factors, const std::vector<double>& d) {
      power_products(factors, {}, d, d, value, set);
      return value[0];
    };
    CHECK(at(both, large) == infinity<double>());
    CHECK(at(both, small) == 0);
    CHECK(at(inverse, small) == infinity<double>());
    CHECK(std::abs(at(both, moderate) / 1e-320 - 1) < 1e-3);
    CHECK(at(one, {0x1p-1022}) == 0x1p-1022);
    CHECK(at({}, large) == 1);
  }
}

TEST_CASE_TEMPLATE("|Y| at many points is |Y| at each, however close to an end", R, double, Real50, Real100) {
  const auto power = [](double p) { return Power<R>{R(p), R(1 + p)}; };
  const FundamentalSolution<R> y(R(-1), {R(0.5), R(0.25), R(1.25)}, {power(-0.4), power(0.1), power(0), power(-0.7)});
  std::vector<R> left, right;
  for (const double d : {1e-320, 1e-300, 1e-20, 0.1, 0.125, 0.249, 0.25, 0.}) {
    left.push_back(R(d));
    right.push_back(d == 0.249 ? R(1e-310) : R(R(0.25) - left.back()));
  }
  std::vector<R> values(left.size());
  // Above double: to the promised number of digits.
  const R allowed = std::same_as<R, double> ? 8 * epsilon<R>() : R(pow(R(10), -digits_served<R>));
  R worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    y.moduli(k, left, right, values);
    for (std::size_t i = 0; i < left.size(); ++i) {
      const R one = y.modulus(k, {R(0), left[i], right[i]});
      if (values[i] != one) worst = std::max(worst, size_of(R(values[i] / one - 1)));
    }
  }
  CHECK(worst <= allowed);
  // Not by modulus() itself, which keeps all bits.
  CHECK(worst > 0);
}
