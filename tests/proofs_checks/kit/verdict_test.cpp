#include "proofs_checks/kit/verdict.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

const ExactIdentity whole{"", {"a = a"}, ExactIdentity::Covers::claim};
const ExactIdentity part{"", {"a = a"}, ExactIdentity::Covers::part};
const ExactIdentity empty_identity{"", {}, ExactIdentity::Covers::claim};
const Agreement agreement{"load", {"one", "other"}, "1e-50", "1e-45", 10, 8, 5, ""};
const Agreement too_few{"load", {"one", "other"}, "1e-50", "1e-45", 10, 4, 5, ""};
const Agreement no_case{"load", {"one", "other"}, "0", "1e-45", 0, 0, 0, ""};
const ConvergenceRate rate{"error", 1.99, 0.02, 2, 0.1, ""};
const ConvergenceRate other_rate{"error", 1.85, 0.02, 2, 0.1, ""};
const ConvergenceRate wide_rate{"error", 1.85, 0.2, 2, 0.1, ""};
const ConvergenceRate no_rate{"error", std::nan(""), std::nan(""), 2, 0.1, ""};
const Counterexample counterexample{"f = 1", "load"};

Verdict verdict_of(std::vector<Evidence> evidence) { return weigh(evidence); }

}  // namespace

TEST_CASE("weigh: the truth table") {
  CHECK(verdict_of({}) == Verdict::undecided);
  CHECK(verdict_of({whole}) == Verdict::proved);
  CHECK(verdict_of({part}) == Verdict::supported);
  CHECK(verdict_of({empty_identity}) == Verdict::undecided);
  CHECK(verdict_of({agreement}) == Verdict::supported);
  CHECK(verdict_of({rate}) == Verdict::supported);
  CHECK(verdict_of({other_rate}) == Verdict::refuted);
  CHECK(verdict_of({wide_rate}) == Verdict::undecided);
  CHECK(verdict_of({no_rate}) == Verdict::undecided);
  CHECK(verdict_of({too_few}) == Verdict::undecided);
  CHECK(verdict_of({no_case}) == Verdict::undecided);
  CHECK(verdict_of({counterexample}) == Verdict::refuted);
}

TEST_CASE("weigh: what stands beside") {
  CHECK(verdict_of({whole, agreement, rate}) == Verdict::proved);
  CHECK(verdict_of({agreement, whole}) == Verdict::proved);
  CHECK(verdict_of({part, agreement, rate}) == Verdict::supported);
  CHECK(verdict_of({agreement, too_few}) == Verdict::undecided);
  CHECK(verdict_of({rate, wide_rate}) == Verdict::undecided);
  CHECK(verdict_of({whole, rate, other_rate}) == Verdict::refuted);
  CHECK(verdict_of({part, no_case}) == Verdict::undecided);
  for (const Evidence& e : std::vector<Evidence>{whole, part, agreement, too_few, rate}) {
    CHECK(verdict_of({e, counterexample}) == Verdict::refuted);
    CHECK(verdict_of({counterexample, e}) == Verdict::refuted);
  }
}

TEST_CASE("weigh: a claim with a surviving control was not checked") {
  const std::vector<Evidence> proof{whole};
  const std::vector<Evidence> support{agreement};
  const std::vector<Evidence> against{counterexample};
  CHECK(weigh(proof, true) == Verdict::proved);
  CHECK(weigh(proof, false) == Verdict::undecided);
  CHECK(weigh(support, false) == Verdict::undecided);
  CHECK(weigh(against, false) == Verdict::refuted);
  CHECK(weigh({}, true) == Verdict::undecided);
}

TEST_CASE("evidence says its kind and its numbers") {
  CHECK(kind_of(whole) == "exact-identity");
  CHECK(kind_of(agreement) == "agreement");
  CHECK(kind_of(rate) == "convergence-rate");
  CHECK(kind_of(counterexample) == "counterexample");
  CHECK(describe(agreement) ==
        "load (one against other): largest relative difference 1e-50, tolerance 1e-45, 8 of 10 cases effective");
  CHECK(describe(too_few).find("(5 required)") != std::string::npos);
  CHECK(describe(counterexample) == "load at f = 1");
  CHECK(describe(rate) == "error: rate 1.99 +- 0.02, expected 2 +- 0.1");
}
