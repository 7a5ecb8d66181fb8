// Estimated errors of random problems are no smaller than the true ones, and not a thousand times as large.

#include "known_limits/error_estimates.hpp"

#include "support/numeric_test.hpp"
#include "support/random_contact.hpp"

namespace {

void estimates_are_honest(int first, int last) {
  EstimateAudit audit;
  for (int i = first; i < last; ++i) audit_estimates(first_listed_seed + static_cast<std::uint64_t>(i), audit);
  MESSAGE(audit.text());
  for (const std::string& line : audit.dishonest) FAIL_CHECK(line);
  CHECK(audit.median_too_large() <= 1000);
  CHECK(audit.compared >= 9 * audit.problems / 10);
  CHECK(audit.all() >= 50 * audit.compared);
}

}  // namespace

TEST_CASE("the first eight") { estimates_are_honest(0, 8); }

TEST_CASE("slow: random problems 0 to 249" * doctest::skip()) { estimates_are_honest(0, 250); }
TEST_CASE("slow: random problems 250 to 499" * doctest::skip()) { estimates_are_honest(250, 500); }
TEST_CASE("slow: random problems 500 to 749" * doctest::skip()) { estimates_are_honest(500, 750); }
TEST_CASE("slow: random problems 750 to 999" * doctest::skip()) { estimates_are_honest(750, 1000); }

TEST_CASE("control: an end that is off by more than its estimate is seen") {
  EstimateAudit audit;
  compare_estimate("place", {1.0, 1e-16}, {Real50(1), Real50(0)}, audit);
  compare_estimate("place", {1.0, 1e-16}, {Real50(1) + Real50(0.9e-16), Real50(0)}, audit);
  CHECK(audit.dishonest.empty());
  compare_estimate("place", {1.0, 1e-16}, {Real50(1) + Real50(1.1e-16), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 1U);
  compare_estimate("place", {1.0, std::nan("")}, {Real50(1), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 2U);
  compare_estimate("place", {std::nan(""), 1.0}, {Real50(1), Real50(0)}, audit);
  CHECK(audit.dishonest.size() == 3U);
  CHECK(audit.honest() == 2U);
}
