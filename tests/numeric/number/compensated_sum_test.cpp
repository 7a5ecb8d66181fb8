#include "numeric/number/compensated_sum.hpp"

#include "support/numeric_test.hpp"

TEST_CASE("a compensated sum of equal terms is correct to the last bit, a plain one is not") {
  // The product is correct to the last bit, too.
  const double term = std::log(2.0) / 3;
  const double exact = 1400 * term;
  CompensatedSum<double> sum;
  double plain = 0;
  for (int i = 0; i < 1400; ++i) {
    sum.add(term);
    plain += term;
  }
  CHECK(sum.value() == exact);
  CHECK(std::abs(plain - exact) > 10 * epsilon<double>() * exact);
}

TEST_CASE("a compensated sum keeps a term that larger ones hide, in any order") {
  CompensatedSum<double> first, last;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) first.add(term);
  for (const double term : {1e100, 1.0, -1e100, 1.0}) last.add(term);
  CHECK(first.value() == 2);
  CHECK(last.value() == 2);
}

TEST_CASE("a sum of estimates adds the errors, and one stalled term stalls it") {
  EstimateSum<double> sum(Estimate<double>{1.0, 0.25});
  sum.add({2.0, 0.5});
  CHECK(sum.value().value == 3);
  CHECK(sum.value().error == 0.75);
  CHECK(sum.value().convergence == Convergence::reached);
  sum.add({1.0, 0.0, Convergence::stalled});
  CHECK(sum.value().convergence == Convergence::stalled);
  CHECK(EstimateSum<double>().value().value == 0);
}
