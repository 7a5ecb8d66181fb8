#include <regex>

#include "proofs_checks/kit/verdict.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

const std::map<std::string, Evidence> evidence{
    {"whole", CheckedProof{{}, {}, ""}},
    {"gap", CheckedProof{{}, {}, "nothing gives it"}},
    {"part", ExactIdentity{"", {"a = a"}}},
    {"empty_identity", ExactIdentity{"", {}}},
    {"agreement", Agreement{"load", {"one", "other"}, "1e-50", "1e-45", 10, 8, 5, ""}},
    {"too_few", Agreement{"load", {"one", "other"}, "1e-50", "1e-45", 10, 4, 5, ""}},
    {"no_case", Agreement{"load", {"one", "other"}, "0", "1e-45", 0, 0, 0, ""}},
    {"rate", ConvergenceRate{"error", 1.99, 0.02, 2, 0.1, ""}},
    {"other_rate", ConvergenceRate{"error", 1.85, 0.02, 2, 0.1, ""}},
    {"wide_rate", ConvergenceRate{"error", 1.85, 0.2, 2, 0.1, ""}},
    {"no_rate", ConvergenceRate{"error", std::nan(""), std::nan(""), 2, 0.1, ""}},
    {"counterexample", Counterexample{"f = 1", "load"}},
};

/// Returns the verdict of pieces of evidence by name, "whole+rate".
Verdict verdict_of(const std::string& names) {
  std::vector<Evidence> all;
  for (const std::string& name : words(std::regex_replace(names, std::regex("\\+"), " ")))
    all.push_back(evidence.at(name));
  return weigh(all);
}

}  // namespace

TEST_CASE("weigh: the truth table, and what stands beside") {
  for (
      const std::string& row : words(
          ":undecided whole:proved gap:undecided gap+agreement:undecided part:supported empty_identity:undecided agreement:supported rate:supported "
          "other_rate:refuted wide_rate:undecided no_rate:undecided too_few:undecided no_case:undecided "
          "counterexample:refuted whole+agreement+rate:proved agreement+whole:proved part+agreement+rate:supported "
          "agreement+too_few:undecided rate+wide_rate:undecided whole+rate+other_rate:refuted "
          "part+no_case:undecided")) {
    CAPTURE(row);
    const std::size_t colon = row.find(':');
    CHECK(name_of(verdict_of(row.substr(0, colon))) == row.substr(colon + 1));
  }
  for (const std::string name : {"whole", "part", "agreement", "too_few", "rate"}) {
    CHECK(verdict_of(name + "+counterexample") == Verdict::refuted);
    CHECK(verdict_of("counterexample+" + name) == Verdict::refuted);
  }
}

TEST_CASE("weigh: a claim with a surviving control was not checked") {
  const std::vector<Evidence> proof{evidence.at("whole")};
  CHECK(weigh(proof, true) == Verdict::proved);
  CHECK(weigh(proof, false) == Verdict::undecided);
  CHECK(weigh(std::vector{evidence.at("agreement")}, false) == Verdict::undecided);
  CHECK(weigh(std::vector{evidence.at("counterexample")}, false) == Verdict::refuted);
  CHECK(weigh({}, true) == Verdict::undecided);
}

TEST_CASE("evidence says its kind and its numbers") {
  CHECK(kind_of(evidence.at("whole")) == "proof");
  CHECK(kind_of(evidence.at("part")) == "exact-identity");
  CHECK(kind_of(evidence.at("agreement")) == "agreement");
  CHECK(kind_of(evidence.at("rate")) == "convergence-rate");
  CHECK(kind_of(evidence.at("counterexample")) == "counterexample");
  CHECK(describe(evidence.at("agreement")) ==
        "load (one against other): largest relative difference 1e-50, tolerance 1e-45, 8 of 10 cases effective");
  CHECK(describe(evidence.at("too_few")).find("(5 required)") != std::string::npos);
  CHECK(describe(evidence.at("counterexample")) == "load at f = 1");
  CHECK(describe(evidence.at("rate")) == "error: rate 1.99 +- 0.02, expected 2 +- 0.1");
}
