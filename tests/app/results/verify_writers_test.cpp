#include "app/verify/verify_writers.hpp"
#include "app/command_line.hpp"
#include "app/embedded.hpp"
#include "proofs_checks/kit/proofs.hpp"
#include "proofs_checks/statements/paper_statements.hpp"

using namespace steadyslide::app;
using namespace steadyslide::proofs_checks;

namespace {

/// Returns a result with one claim refuted, and one undecided because a control survives.
VerifyResult bad_result() {
  VerifyResult result;
  result.context.digits = numeric::Digits::hundred;
  result.context.seed = 42;
  result.reports.push_back({{"a-claim", "[Bal16, (1)]", "x | y_1 < 2", "always"},
                            Verdict::refuted,
                            {Counterexample{"nu = 0", "1 is not 2"}},
                            "",
                            {{"wrong sign", true, ""}},
                            0.25});
  result.reports.push_back({{"b-claim", "[Bal16, (2)]", "y", "never"},
                            Verdict::undecided,
                            {},
                            "the control survives",
                            {{"swap", false, ""}},
                            1});
  result.notes.push_back({"note-1", "(4)", "(1+x)^{1/2}", "(1+x)^{1/2+alpha}", "refuted", "undecided", "a-claim"});
  return result;
}

std::string written(Format format, const VerifyResult& result) {
  const TemporaryFolder folder;
  Output output((folder.path() / "out").string());
  write_verify(format, result, output);
  output.commit();
  return folder.read("out");
}

}  // namespace

TEST_CASE("text gives the reason why a claim is not settled") {
  check_holds(written(Format::text, bad_result()),
              {"2 claims at 100 digits, seed 42\n", "refuted    1/1       0.25     a-claim",
               "undecided  0/1       1.00     b-claim", "counterexample: ", "1 is not 2", "the control survives",
               "0 proved, 0 supported, 1 undecided, 1 refuted", "printed   (1+x)^{1/2}\n"});
}

TEST_CASE("JSON of a whole result") {
  const std::string expected = file_text(STEADYSLIDE_TESTS "/app/results/verify.json");
  CHECK(written(Format::json, bad_result()) ==
        replaced(replaced(expected, "VERSION", STEADYSLIDE_VERSION), "COMMIT", app::commit()));
}

TEST_CASE("text has a proof as a tree if requested, JSON always has it") {
  VerifyResult result = bad_result();
  result.reports.front().evidence = {*proof_of("gamma-range")};
  CHECK_FALSE(holds(written(Format::text, result), "theorem monotone"));
  result.with_proofs = true;
  check_holds(written(Format::text, result),
              {"  for nu in ]-1, 0.5[\n",
               "\n  fills(gamma-plane-strain, range-of-plane-strain)  [theorem intermediate-values]\n",
               "\n    decreases(gamma-plane-strain)  [theorem monotone], see above\n", "nonzero(\"nu - 1\")  [sign]"});
  check_holds(written(Format::json, result), {"\"complete\": true", "\"rests_on\": []", "\"concludes\": [",
                                              "\"fact\": \"nonzero(\\\"nu - 1\\\")\"", "\"from\": ["});
}

TEST_CASE("the verdict on a statement of the paper is that of its weakest claim") {
  const auto reported = [](const char* id, Verdict verdict) {
    return Report{{id, "", "", ""}, verdict, {}, "", {}, 0};
  };
  const PaperStatement statement{"(1)", "", "", {"a", "b"}, {"c"}, "", false};
  std::vector<Report> reports{reported("a", Verdict::proved), reported("c", Verdict::undecided)};
  CHECK_FALSE(verdict_of(statement, reports));
  reports.push_back(reported("b", Verdict::supported));
  CHECK(verdict_of(statement, reports) == Verdict::supported);
  reports.back().verdict = Verdict::refuted;
  CHECK(verdict_of(statement, reports) == Verdict::refuted);
  CHECK(statements_line(reports).empty());
  // Statements of the paper are counted only if all their claims were examined.
  const auto refuted = [](std::span<const Report> some) { return statement_counts(some).back(); };
  reports.push_back(reported("eq-01-surface-displacement", Verdict::refuted));
  CHECK(refuted(reports) == std::pair<std::string_view, std::size_t>("refuted", 1));
  reports.back().claim.id = "gamma-range";
  CHECK(refuted(reports).second == 0);
  PaperStatement part = statement;
  CHECK(standing(part, Verdict::proved) == "proved");
  part.restriction = "without bounded bodies";
  CHECK(standing(part, Verdict::proved) == "proved, restricted");
  CHECK(standing(part, Verdict::supported) == "supported");
  part.reconstructed = true;
  CHECK(standing(part, Verdict::proved) == "proved, as reconstructed");
}

TEST_CASE("Markdown escapes characters that would end a cell") {
  CHECK(holds(written(Format::markdown, bad_result()),
              "| a-claim | [Bal16, (1)] | x \\| y\\_1 \\< 2 | always | refuted | 1/1 | counterexample: "));
}

TEST_CASE("one claim is counted in the singular") {
  VerifyResult result = bad_result();
  CHECK(holds(written(Format::text, result), ": 2 claims at "));
  result.reports.pop_back();
  CHECK(holds(written(Format::text, result), ": 1 claim at "));
}

TEST_CASE("notes of other claims are counted, not shown") {
  VerifyResult result = bad_result();
  leave_out_other_notes(result);
  CHECK(result.notes.size() == 1);
  CHECK_FALSE(holds(written(Format::text, result), "left out"));

  // One note belongs to a claim that was not requested, one belongs to no claim.
  result.notes.push_back({"note-2", "(5)", "x", "y", "refuted", "print", "c-claim"});
  result.notes.push_back({"note-3", "theorem 3", "x", "y", "leaves x", "extraction", ""});
  leave_out_other_notes(result);
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes.front().id == "note-1");
  CHECK(result.notes_left_out == 2);
  for (const Format format : {Format::text, Format::markdown}) {
    const std::string text = written(format, result);
    check_holds(text, {"\n2 reading notes left out: ", "note-1", "\n1 reading note"});
    // It stands beside both numbers.
    std::size_t told = 0;
    for (const std::string& line : lines(text))
      told += holds(line, "reading note") && holds(line, "The printed page was not seen.");
    CHECK(told == 2);
    CHECK_FALSE(holds(text, "note-2"));
  }
  CHECK(holds(written(Format::json, result), "\"reading_notes_left_out\": 2\n"));
}

TEST_CASE("the exit code is 0 if no claim is refuted or undecided, except for claims beyond calculation") {
  const auto reported = [](Verdict verdict, std::vector<Evidence> evidence) {
    return Report{{"an-id", "", "", ""}, verdict, std::move(evidence), "", {}, 0};
  };
  std::vector<Report> reports{reported(Verdict::proved, {}), reported(Verdict::supported, {}),
                              reported(Verdict::undecided, {BeyondCalculation{"not in the text", {}}})};
  CHECK(exit_code_of(reports) == ExitCode::done);
  reports.push_back(reported(Verdict::undecided, {}));
  CHECK(exit_code_of(reports) == ExitCode::refuted);
  reports.back() = reported(Verdict::refuted, {BeyondCalculation{"not in the text", {}}});
  CHECK(exit_code_of(reports) == ExitCode::refuted);
}
