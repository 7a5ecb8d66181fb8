#include "proofs_checks/kit/run.hpp"

#include <unistd.h>

#include <csignal>

#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/processes.hpp"
#include "proofs_checks/kit/transport.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

/// Names and numbers of the wrong variants of a claim about a number.
using Numbers = std::vector<std::pair<std::string, double>>;
Claim claim_about(double value, const Numbers& wrong, std::vector<Evidence> (*check)(double)) {
  Claim claim{{"one", "", "", ""}, [=](const Context&) { return check(value); }, {}};
  for (const auto& [name, number] : wrong) {
    claim.controls.push_back({name, [check, number = number](const Context&) { return check(number); }});
  }
  return claim;
}

/// The claim that `value` is 1 to within 1/2.
Claim claim_about(double value, const Numbers& wrong) {
  return claim_about(value, wrong, [](double number) {
    return gather([&] {
      Findings findings;
      findings.begin_case("the only case");
      findings.compare({"value", {"given", "1"}, 0.5}, number > 1 ? number - 1 : 1 - number);
      return findings.evidence("");
    });
  });
}

}  // namespace

TEST_CASE("run: right formula, refuted controls") {
  const Report report = run(claim_about(1, {{"two", 2.0}, {"nothing", 0.0}}), {});
  CHECK(report.verdict == Verdict::supported);
  CHECK(report.controls_refuted() == 2);
  CHECK(report.note.empty());
  CHECK(holds(report.controls[0].detail, "exceeds the tolerance"));
}

TEST_CASE("run: a surviving control leaves the claim undecided") {
  const Report report = run(claim_about(1, {{"two", 2.0}, {"a little more", 1.25}}), {});
  CHECK(report.verdict == Verdict::undecided);
  CHECK(report.controls_refuted() == 1);
  CHECK(report.note == "not checked: the control survives: a little more");
}

TEST_CASE("run: no controls, no check; a wrong claim is refuted, NaN included") {
  CHECK(run(claim_about(1, {}), {}).verdict == Verdict::undecided);
  for (const double wrong : {3.0, std::nan("")}) {
    CHECK(run(claim_about(wrong, {{"two", 2.0}}), {}).verdict == Verdict::refuted);
  }
}

TEST_CASE("run: a rate off the expected one refutes, and one too vague does not") {
  const auto claim = [](double rate, double wrong) {
    return claim_about(rate, {{"wrong", wrong}}, [](double found) {
      return gather([&] {
        Findings findings;
        findings.begin_case("all levels");
        findings.measure({"error", found, 0.05, 1, 0.1, ""});
        return findings.evidence("");
      });
    });
  };
  const Report report = run(claim(1.05, 2), {});
  CHECK(report.verdict == Verdict::supported);
  CHECK(report.controls[0].detail == "error: rate 2 +- 0.05, expected 1 +- 0.1 at all levels");
  CHECK(run(claim(1.2, 2), {}).verdict == Verdict::refuted);
  CHECK(run(claim(1.05, 0.95), {}).verdict == Verdict::undecided);

  // Evidence that is returned, not thrown.
  for (const auto& [bar, verdict] : {std::pair(1.5, Verdict::undecided), {0.5, Verdict::supported}}) {
    Claim vague = claim(1, 2);
    vague.controls[0].examine = [bar = bar](const Context&) -> std::vector<Evidence> {
      return {ConvergenceRate{"error", 2, bar, 1, 0.1, ""}};
    };
    CHECK(run(vague, {}).verdict == verdict);
  }
}

TEST_CASE("run: exceptions decide nothing") {
  Claim claim = claim_about(1, {{"two", 2.0}});
  claim.examine = [](const Context&) -> std::vector<Evidence> { throw std::runtime_error("out of luck"); };
  const Report report = run(claim, {});
  CHECK(report.verdict == Verdict::undecided);
  CHECK(holds(report.note, "out of luck"));

  Claim with_bad_control = claim_about(1, {{"two", 2.0}});
  with_bad_control.controls[0].examine = [](const Context&) -> std::vector<Evidence> { throw 1; };
  const Report other = run(with_bad_control, {});
  CHECK(other.verdict == Verdict::undecided);
  CHECK(other.controls_refuted() == 0);
}

TEST_CASE("findings: effective cases") {
  const Quantity quantity{"value", {}, 1.0};
  const auto verdict_with = [&](int effective, int cases, int skipped) {
    Findings findings;
    for (int k = 0; k < cases; ++k) {
      findings.begin_case("", k < effective);
      findings.compare(quantity, 0);
      findings.compare(quantity, 0.25);
    }
    for (int k = 0; k < skipped; ++k) {
      findings.begin_case("");
      findings.skip(quantity);
    }
    return weigh(findings.evidence(""));
  };
  CHECK(verdict_with(4, 4, 0) == Verdict::supported);
  CHECK(verdict_with(2, 4, 0) == Verdict::supported);
  CHECK(verdict_with(1, 4, 0) == Verdict::undecided);
  CHECK(verdict_with(2, 2, 2) == Verdict::supported);
  CHECK(verdict_with(2, 2, 3) == Verdict::undecided);
  CHECK(verdict_with(0, 0, 0) == Verdict::undecided);
}

TEST_CASE("glob") {
  for (const char* pattern : {"eq-04-flat-punch", "eq-*", "*punch", "*-0?-*-*"}) {
    CHECK(matches_glob("eq-04-flat-punch", pattern));
  }
  CHECK(matches_glob("aXbXc", "a*X*c"));
  for (const char* pattern : {"*", ""}) CHECK(matches_glob("", pattern));
  for (const char* pattern : {"eq", "*-punc", "eq-05-flat-punch"})
    CHECK_FALSE(matches_glob("eq-04-flat-punch", pattern));
  CHECK_FALSE(matches_glob("", "?"));
}

TEST_CASE("select, run_all, count") {
  std::vector<Claim> claims;
  for (const char* id : {"a-1", "b-1", "a-2"}) {
    claims.push_back(claim_about(1, {{"two", 2.0}}));
    claims.back().id = id;
  }
  claims[1].examine = [](const Context&) -> std::vector<Evidence> { return {}; };
  const std::vector<std::string> patterns{"a-*", "nothing"};
  const std::vector<Claim> some = select(claims, patterns);
  REQUIRE(some.size() == 2);
  CHECK(some[0].id == "a-1");
  CHECK(some[1].id == "a-2");
  CHECK(select(claims, {}).size() == 3);

  std::vector<std::string> seen;
  const auto progress = [&](std::size_t index, std::size_t total, const Claim& claim) {
    CHECK(index == seen.size());
    CHECK(total == 3);
    seen.push_back(claim.id);
  };
  CHECK(counts_line(run_all(claims, {}, progress)) == "0 proved, 2 supported, 1 undecided, 0 refuted");
  CHECK(seen == std::vector<std::string>{"a-1", "b-1", "a-2"});
}

TEST_CASE("a report goes through bytes unchanged, whatever its evidence; bytes that are none are refused") {
  Claim claim = claim_about(1, {{"two", 2.0}});
  claim.proof = ProofText{};
  claim.examine = [](const Context&) -> std::vector<Evidence> {
    CheckedProof proof;
    proof.nodes = {{{"coercive", {"log-form"}}, "assumed"}, {{"unique", {}}, "theorem plemelj", {"words"}, {0}}};
    proof.gap = "a step is missing";
    return {ExactIdentity{"d", {"a = b", ""}},
            Agreement{"value", {"one", "other"}, "1e-3", "1e-2", 7, 5, 3, "seed 1"},
            ConvergenceRate{"error", 0.1, 1e-300, -0.0, std::nan(""), "levels"},
            Counterexample{"here", std::string("with a \0 byte", 13)},
            BeyondCalculation{"abstract", {"a-1"}},
            proof};
  };
  const Report sent = run(claim, {});
  const std::string bytes = to_bytes(sent);
  const Report received = report_from(bytes, claim);
  CHECK(to_bytes(received) == bytes);
  CHECK(received.claim.id == "one");
  REQUIRE(received.evidence.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) CHECK(describe(received.evidence[k]) == describe(sent.evidence[k]));
  REQUIRE(received.proof() != nullptr);
  CHECK(received.proof()->nodes[1].from == std::vector<std::size_t>{0});
  CHECK(received.proof()->nodes[0].fact == Fact{"coercive", {"log-form"}});
  CHECK(received.controls[0].detail == sent.controls[0].detail);
  CHECK_THROWS(report_from(bytes.substr(0, bytes.size() - 1), claim));
  CHECK_THROWS(report_from(bytes + "x", claim));
}

TEST_CASE("in processes: the same reports in the same order, and a process that ends leaves one claim undecided") {
  std::vector<Claim> claims;
  for (int k = 0; k < 20; ++k) {
    claims.push_back(claim_about(k % 3 == 0 ? 3 : 1, {{"two", 2.0}}));
    claims.back().id = "claim-" + std::to_string(k);
  }
  const std::vector<Report> one_by_one = run_all(claims, {});
  claims[7].examine = [](const Context&) -> std::vector<Evidence> {
    std::raise(SIGKILL);
    return {};
  };
  claims[19].examine = [](const Context&) -> std::vector<Evidence> { _exit(3); };
  for (const unsigned processes : {1U, 3U, 50U}) {
    std::vector<std::string> seen;
    const std::vector<Report> reports = run_in_processes(
        claims, {}, processes, [&](std::size_t, std::size_t, const Claim& claim) { seen.push_back(claim.id); });
    CHECK(seen.size() == 20);
    REQUIRE(reports.size() == 20);
    for (std::size_t k = 0; k < 20; ++k) {
      CHECK(reports[k].claim.id == claims[k].id);
      if (k == 7 || k == 19) {
        CHECK(reports[k].verdict == Verdict::undecided);
        CHECK(holds(reports[k].note, k == 7 ? "the check ended its process by signal 9" : "with exit code 3"));
      } else {
        CHECK(reports[k].verdict == one_by_one[k].verdict);
        CHECK(reports[k].evidence.size() == one_by_one[k].evidence.size());
      }
    }
  }
  CHECK(run_in_processes({}, {}, 2).empty());
  CHECK(available_processes() >= 1);
}

TEST_CASE("tasks in processes: all bytes of each, in order") {
  const auto made = [](std::size_t k) { return std::string(100000 * (k % 4), '\0') + std::to_string(k); };
  for (const unsigned processes : {1U, 3U, 50U}) {
    std::vector<std::size_t> begun;
    const std::vector<TaskEnd> ends = do_in_processes(20, processes, made, [&](std::size_t k) { begun.push_back(k); });
    REQUIRE(ends.size() == 20);
    for (std::size_t k = 0; k < 20; ++k) {
      CHECK(begun[k] == k);
      CHECK((ends[k].bytes == made(k)));
      CHECK(ends[k].how.empty());
    }
  }
}
