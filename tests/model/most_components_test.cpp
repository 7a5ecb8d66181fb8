#include "model/most_components.hpp"
#include "support/problems.hpp"
#include "support/random_problem.hpp"

namespace {

std::size_t most(const Indenter& indenter) { return most_components(reduced({0.3_r}, {}, indenter, 1)); }

}  // namespace

TEST_CASE("the largest number of gaps on a piece: degree of the slope, and its sign if that is odd") {
  struct Case {
    std::vector<Rational> profile;
    std::size_t gaps;
  };
  const Case cases[] = {{{}, 0},
                        {{1}, 0},
                        {{0, -7}, 0},
                        {{0, 0, 1}, 0},
                        {{0, 0, -1}, 1},
                        {{0, 9, 9, 1}, 1},
                        {{0, 0, 0, -1}, 1},
                        {{0, 0, -9, 0, 1}, 1},
                        {{0, 0, 9, 0, -1}, 2},
                        {{1, 0, 0, 0, 0, 1}, 2},
                        {{0, 0, 0, 0, 0, 0, 1}, 2},
                        {{0, 0, 0, 0, 0, 0, -1}, 3}};
  for (const Case& c : cases) {
    const Polynomial profile(c.profile);
    CAPTURE(to_string(profile));
    CHECK(most_gaps(profile) == c.gaps);
    // A tilt and a height do not change the bound, nor does the other direction of x.
    CHECK(most_gaps(profile + Polynomial({3, -5})) == c.gaps);
    CHECK(most_gaps(profile.composed(-1, 2)) == c.gaps);
  }
}

TEST_CASE("components: one more than the gaps of each piece") {
  const Polynomial bump({0, 0, 1}), hollow({0, 0, -1}), flat({1});
  CHECK(most(Indenter(-1, {{1, bump}})) == 1);
  CHECK(most(Indenter(-1, {{0, bump}, {1, hollow}, {2, flat}})) == 4);
  // Two pieces with the same polynomial are one piece; between them there is no corner.
  CHECK(most(Indenter(-1, {{0, bump}, {1, bump}, {2, flat}})) == 2);
  CHECK(most(Indenter(-1, {{0, bump}, {1, flat}, {2, bump}})) == 3);
}

TEST_CASE("the bound is the same for the mirrored problem; the status gives it") {
  CHECK(rc::check([] {
    const ContactProblem problem = *coincidences();
    const std::size_t bound = most_components(problem);
    RC_ASSERT(most_components(problem.mirrored()) == bound);
    RC_ASSERT(too_many_components(problem, bound) == "");
    RC_ASSERT(too_many_components(problem, bound + 1) == "the contact has " + std::to_string(bound + 1) +
                                                             " components; a solution of this problem has at most " +
                                                             std::to_string(bound));
  }));
}
