// Random decimals agree with those of the header's formula, computed in another language with whole numbers.

#include "library/sweep/random_decimals.hpp"

#include "support/test.hpp"

using namespace steadyslide::library;

TEST_CASE("FNV-1a of its authors' test strings") {
  CHECK(fnv1a("") == 0xcbf29ce484222325U);
  CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cU);
  CHECK(fnv1a("foobar") == 0x85944171f73967e8U);
  CHECK(fnv1a("bar", fnv1a("foo")) == fnv1a("foobar"));
}
