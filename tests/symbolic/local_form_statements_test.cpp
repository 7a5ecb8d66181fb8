#include "symbolic/statements/local_form_statements.hpp"

#include <doctest/doctest.h>

#include "support/decided_statements.hpp"
#include "symbolic/statements/local_readings.hpp"

using namespace steadyslide::symbolic;

TEST_CASE("the local forms of theorems 2, 3, 9 and 10 hold, and every wrong variant is refuted") {
  const std::vector<DecidedStatement> all = local_form_statements();
  const std::set<std::string> ids = steadyslide::testing::check_decided(all);
  CHECK(ids.size() == 13);
  for (const DecidedStatement& statement : all) {
    for (const std::string& divisor : statement.identity.nonvanishing) {
      CHECK((divisor == "s_l - s_r" || divisor == "s^2 + 1"));
    }
  }
  for (const char* theorem :
       {"theorem-2-jump", "theorem-2-wedge-and-jump", "theorem-2-wedge", "theorem-3-edge-left-end",
        "theorem-3-free-right-end", "theorem-9", "theorem-10-edge-right-end"}) {
    CHECK(ids.contains(theorem));
  }
}

TEST_CASE("the text as extracted and the derivation, side by side") {
  std::set<std::string> ids;
  for (const LocalReading& reading : local_readings()) {
    CAPTURE(reading.id);
    CAPTURE(reading.found);
    CHECK(ids.insert(reading.id).second);
    CHECK_FALSE(reading.printed_holds);
    CHECK(reading.derived_holds);
  }
  CHECK(ids.size() == 14);
  CHECK(local_readings().front().found ==
        "In the local equation the printed form leaves |x|^lambda, x > 0: s_l*theta - s_r*theta in place of 0; the "
        "derived form holds.");
}
