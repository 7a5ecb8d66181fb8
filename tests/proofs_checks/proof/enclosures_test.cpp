// Enclosures decide a sign on the parameters of its derivation, and on no others.

#include "proofs_checks/proof/enclosures.hpp"
#include "support/test.hpp"

using namespace steadyslide;
using namespace steadyslide::proofs_checks;

TEST_CASE("the amplitude of strong friction is decided up to eps = 6/pi^2, 0.60793, from eps >= 0 on") {
  const auto decided = [](const char* box) { return enclosure("triangle-amplitude").decide(parse_box(box)).holds; };
  for (const char* box : {"eps in [0, 1/2]", "eps in [0, 0.6079]", "eps in [0.2, 0.5]"})
    CHECK_MESSAGE(decided(box) == Truth::yes, box);
  for (const char* box :
       {"eps in [0, 0.608]", "eps in [0, 0.7]", "eps in [-0.1, 1/2]", "eps in ]-oo, 1/2]", "eps in [0, oo["}) {
    CHECK_MESSAGE(decided(box) == Truth::unknown, box);
  }
}
