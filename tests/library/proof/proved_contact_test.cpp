// The rule for repeating a proof with more digits: the same for the program and for the library.

#include "library/proof/proved_contact.hpp"

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/problems.hpp"
#include "support/test.hpp"

namespace {

using namespace steadyslide;
using library::FoundContact;

struct Tried {
  std::vector<int> digits;
  std::optional<enclosure::ContactProof> proof;
};

/// A flat punch. The solver finds the right contact from `good_from` digits on, and finds nothing with `nothing_with`.
/// From `unsolved_from` digits on it reports that a wrong contact is not a solution.
Tried tried(int first, int good_from, int nothing_with = 0, int unsolved_from = 1000) {
  const ContactProblem problem = reduced({0.1_r, 0.5_r}, {0}, one_piece(-1, 1, {}), 1);
  Tried result;
  result.proof = library::proved_contact(problem, 20, first, [&](int digits) -> std::optional<FoundContact> {
    result.digits.push_back(digits);
    if (digits == nothing_with) return std::nullopt;
    if (digits >= good_from) return FoundContact{{{{-1}, {1}}}};
    return FoundContact{{{{-1}, {0, Side::right, 0.5_r, true}}}, digits < unsolved_from};
  });
  return result;
}

}  // namespace

TEST_CASE("a proof that fails is tried again with 50 and with 100 digits") {
  for (const auto& [first, good_from, asked] : {std::tuple(16, 16, std::vector{16}),
                                                {16, 50, std::vector{16, 50}},
                                                {16, 100, std::vector{16, 50, 100}},
                                                {50, 16, std::vector{50}},
                                                {50, 100, std::vector{50, 100}},
                                                {100, 100, std::vector{100}}}) {
    const Tried all = tried(first, good_from);
    REQUIRE(all.proof);
    CHECK_MESSAGE(all.proof->proved, all.proof->reason);
    CHECK((all.digits == asked));
  }
  const Tried never = tried(16, 1000);
  CHECK(never.digits.size() == 3);
  CHECK_FALSE(never.proof.value().proved);
  CHECK(never.proof.value().reason != "");
}

TEST_CASE("a solver that finds nothing ends the attempts") {
  const Tried at_once = tried(16, 50, 16);
  CHECK_FALSE(at_once.proof);
  CHECK(at_once.digits.size() == 1);
  const Tried later = tried(16, 100, 50);
  CHECK((later.digits == std::vector{16, 50}));
  CHECK_FALSE(later.proof.value().proved);
}

TEST_CASE("what is not solved with 50 digits is not tried with 100") {
  CHECK((tried(16, 1000, 0, 50).digits == std::vector{16, 50}));
  CHECK((tried(16, 1000, 0, 16).digits == std::vector{16, 50}));
  CHECK((tried(50, 1000, 0, 50).digits == std::vector{50}));
  // If double does not solve a problem, 50 digits are tried.
  CHECK(tried(16, 50, 0, 16).proof.value().proved);
}

TEST_CASE("ends at other distances make another contact set") {
  // Contact only on the left bowl: the right one penetrates.
  const Polynomial left({0, 0, 1}), right({1.6_r, -2.4_r, 1});
  const auto bowls = [&](const Indenter& indenter) { return reduced({0.3_r}, {}, indenter, 1); };
  const ContactProblem problem = bowls(Indenter(-1, {{0.5_r, left}, {2, right}}));
  const ApproximateContact alone =
      numeric::riemann_hilbert<double>(bowls(Indenter(-1, {{0.5_r, left}}))).solution->approximate_contact();
  for (const auto& [shift, asked] :
       {std::pair(Rational(1, 10000), std::vector{16, 50}), {Rational(1, 100), std::vector{16, 50, 100}}}) {
    std::vector<int> digits;
    const auto proof =
        library::proved_contact(problem, 20, 16, [&, &shift = shift](int wanted) -> std::optional<FoundContact> {
          ApproximateContact result = alone;
          for (ApproximateContact::End& end : result.ends) end.offset *= 1 + shift * static_cast<int>(digits.size());
          digits.push_back(wanted);
          return FoundContact{result};
        });
    REQUIRE(proof);
    CHECK(proof->refuted);
    CHECK((digits == asked));
  }
}

TEST_CASE("a contact set that is refuted is not proved again with more digits, another one is") {
  // Over a concave corner the traction is tension.
  const Indenter notch(-1, {{0, Polynomial({0, 0.3_r})}, {1, Polynomial({0, -0.3_r})}});
  const ContactProblem problem = reduced({0.1_r}, {}, notch, 0.2_r);
  const ApproximateContact closed{{{-1}, {1}}};
  const ApproximateContact open = numeric::riemann_hilbert<double>(problem).solution->approximate_contact();
  for (const bool opens : {false, true}) {
    std::vector<int> digits;
    const auto proof = library::proved_contact(problem, 20, 16, [&](int wanted) -> std::optional<FoundContact> {
      digits.push_back(wanted);
      return FoundContact{opens && wanted > 16 ? open : closed};
    });
    REQUIRE(proof);
    CHECK(proof->refuted == !opens);
    CHECK(proof->proved == opens);
    CHECK((digits == std::vector{16, 50}));
  }
}
