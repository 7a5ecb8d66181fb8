#include "app/results/verify_writers.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "app/commands/verify_command.hpp"
#include "app/process.hpp"

using namespace steadyslide;
using namespace steadyslide::app;
using namespace steadyslide::proofs_checks;

namespace {

/// One claim refuted, one undecided because a control survives.
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
  result.notes.push_back({"note-1", "(4)", "(1+x)^{1/2}", "(1+x)^{1/2+alpha}", "refuted", "a-claim"});
  return result;
}

std::string written(Format format, const VerifyResult& result) {
  const testing::TemporaryFolder folder;
  Output output((folder.path() / "out").string());
  write_verify(format, result, output);
  output.commit();
  return folder.read("out");
}

}  // namespace

TEST_CASE("text shows why a claim is not settled") {
  const std::string text = written(Format::text, bad_result());
  CHECK(text.find("2 claims at 100 digits, seed 42\n") != std::string::npos);
  CHECK(text.find("refuted    1/1       0.25     a-claim") != std::string::npos);
  CHECK(text.find("undecided  0/1       1.00     b-claim") != std::string::npos);
  CHECK(text.find("counterexample: ") != std::string::npos);
  CHECK(text.find("1 is not 2") != std::string::npos);
  CHECK(text.find("the control survives") != std::string::npos);
  CHECK(text.find("0 proved, 0 supported, 1 undecided, 1 refuted") != std::string::npos);
  CHECK(text.find("printed   (1+x)^{1/2}\n") != std::string::npos);
}

TEST_CASE("JSON, whole") {
  const std::string text = written(Format::json, bad_result());
  std::string compact;
  for (const char c : text) {
    if (c != '\n' && c != ' ') compact += c;
  }
  CHECK(compact.find(
            "{\"schema\":1,\"version\":\"" STEADYSLIDE_VERSION
            "\",\"digits\":100,\"seed\":42,\"counts\":{\"proved\":0,\"supported\":0,\"undecided\":1,\"refuted\":1},"
            "\"claims\":[{\"id\":\"a-claim\",\"source\":") == 0);
  CHECK(compact.find("\"controls\":{\"total\":1,\"refuted\":0},\"seconds\":1.0}],\"reading_notes\":[{\"id\":\"note-1\","
                     "\"place\":\"(4)\",\"printed\":") != std::string::npos);
  CHECK(compact.find("{\"kind\":\"note\",\"detail\":\"thecontrolsurvives\"}") != std::string::npos);
}

TEST_CASE("Markdown escapes what would end a cell") {
  const std::string text = written(Format::markdown, bad_result());
  CHECK(text.find("| a-claim | [Bal16, (1)] | x \\| y\\_1 \\< 2 | always | refuted | 1/1 | counterexample: ") !=
        std::string::npos);
}

TEST_CASE("one claim is one claim") {
  VerifyResult result = bad_result();
  CHECK(written(Format::text, result).find(": 2 claims at ") != std::string::npos);
  result.reports.pop_back();
  CHECK(written(Format::text, result).find(": 1 claim at ") != std::string::npos);
}

TEST_CASE("notes of other claims are counted, not shown") {
  VerifyResult result = bad_result();
  leave_out_other_notes(result);
  CHECK(result.notes.size() == 1);
  CHECK(written(Format::text, result).find("left out") == std::string::npos);

  // One of a claim that was not asked for, and one that belongs to no claim.
  result.notes.push_back({"note-2", "(5)", "x", "y", "refuted", "c-claim"});
  result.notes.push_back({"note-3", "theorem 3", "x", "y", "leaves x", ""});
  leave_out_other_notes(result);
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes.front().id == "note-1");
  CHECK(result.notes_left_out == 2);
  for (const Format format : {Format::text, Format::markdown}) {
    const std::string text = written(format, result);
    CHECK(text.find("\n2 reading notes left out: ") != std::string::npos);
    CHECK(text.find("note-1") != std::string::npos);
    CHECK(text.find("note-2") == std::string::npos);
  }
  CHECK(written(Format::json, result).find("\"reading_notes_left_out\": 2\n") != std::string::npos);
}

TEST_CASE("only a ledger without refuted and undecided claims ends well, but for what is beyond calculation") {
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
