#include "library/sweep/path.hpp"

#include "support/test.hpp"

using steadyslide::library::Step;
using steadyslide::library::steps_of;

TEST_CASE("paths: keys and indices; what is none has no steps") {
  CHECK(steps_of("load") == std::vector<Step>{"load"});
  CHECK(steps_of("a[2].b") == std::vector<Step>{"a", std::size_t{2}, "b"});
  CHECK(steps_of("a[0][10]") == std::vector<Step>{"a", std::size_t{0}, std::size_t{10}});
  for (const char* none : {"", ".", "a.", ".a", "a..b", "[0]", "a[", "a[]", "a[x]", "a[1", "a[1]b", "a]", "a[-1]",
                           "a[1].", "a.[1]", "a[99999999999999999999]"}) {
    CHECK_MESSAGE(steps_of(none).empty(), none);
  }
}
