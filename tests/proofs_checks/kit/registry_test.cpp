#include "proofs_checks/kit/registry.hpp"

#include <boost/algorithm/string/split.hpp>

#include "proofs_checks/statements/paper_statements.hpp"
#include "proofs_checks/statements/reading_notes.hpp"
#include "support/test.hpp"

using namespace steadyslide::proofs_checks;

namespace {

Context quick(std::uint64_t seed, numeric::Digits digits = numeric::Digits::sixteen) { return {digits, seed, true}; }

std::vector<std::string> texts(const std::vector<Report>& reports) {
  std::vector<std::string> all;
  for (const Report& report : reports) {
    for (const Evidence& e : report.evidence) all.push_back(describe(e));
    for (const ControlReport& control : report.controls) all.push_back(control.name + ": " + control.detail);
  }
  return all;
}

/// The expected ledger, tests/proofs_checks/ledger.csv: claims with their verdict and the number of their controls, and
/// reading notes. No entry may be lost or weakened. A claim that is not listed may change.
struct ExpectedLedger {
  std::map<std::string, std::pair<std::string, std::size_t>> claims;  ///< verdict, number of controls
  std::set<std::string> notes;
};

ExpectedLedger expected_ledger() {
  ExpectedLedger ledger;
  for (const std::string& line : lines(file_text(STEADYSLIDE_TESTS "/proofs_checks/ledger.csv"))) {
    CAPTURE(line);
    std::vector<std::string> part;
    boost::algorithm::split(part, line, [](char c) { return c == ','; });
    REQUIRE(part.size() == 4);
    if (part[0] == "claim") {
      REQUIRE(ledger.claims.emplace(part[1], std::pair(part[2], std::stoul(part[3]))).second);
    } else if (part[0] == "note") {
      REQUIRE(ledger.notes.insert(part[1]).second);
    } else {
      REQUIRE(line == "kind,id,verdict,controls");
    }
  }
  return ledger;
}

/// Returns the number of cases of every agreement of a claim, by its name.
std::map<std::string, std::size_t> cases_of(const Report& report) {
  std::map<std::string, std::size_t> cases;
  for (const Evidence& e : report.evidence) {
    if (const auto* agreement = std::get_if<Agreement>(&e)) cases[agreement->what] = agreement->cases;
  }
  return cases;
}

/// Returns new claims in the registry's order. Claims of the registry keep their measurements and would return them.
std::vector<Claim> claims_made_anew() {
  std::map<std::string_view, Claim> anew;
  for (const ClaimEntry& entry : claim_list()) anew.emplace(entry.id, made(entry));
  std::vector<Claim> all;
  for (const Claim& claim : registry()) all.push_back(anew.at(claim.id));
  return all;
}

/// The reports of a quick run in double. They are kept, because several tests use the same run.
const std::vector<Report>& quick_run(std::uint64_t seed) {
  static std::map<std::uint64_t, std::vector<Report>> runs;
  if (!runs.contains(seed)) runs[seed] = run_all(registry(), quick(seed));
  return runs.at(seed);
}

const std::vector<Report>& full_run() {
  static const std::vector<Report> reports = run_all(registry(), {numeric::Digits::sixteen, 1, false});
  return reports;
}

/// Checks that the verdicts are those of the list, for any number of digits and parameters.
void check_all_hold(const std::vector<Report>& reports) {
  const ExpectedLedger expected = expected_ledger();
  for (const Report& report : reports) {
    INFO("report.claim.id = ", report.claim.id, ", report.note = ", report.note);
    CHECK((report.verdict == Verdict::supported || report.verdict == Verdict::proved || report.beyond_calculation()));
    if (const auto listed = expected.claims.find(report.claim.id); listed != expected.claims.end()) {
      CHECK(name_of(report.verdict) == listed->second.first);
    }
    CHECK(report.controls_refuted() == report.controls.size());
    for (const Evidence& e : report.evidence) {
      if (std::holds_alternative<Counterexample>(e)) MESSAGE(describe(e));
    }
  }
}

}  // namespace

TEST_CASE("every claim is complete") {
  std::set<std::string> ids;
  for (const Claim& claim : registry()) {
    CAPTURE(claim.id);
    CHECK(ids.insert(claim.id).second);
    CHECK_FALSE(claim.source.empty());
    CHECK_FALSE(claim.statement.empty());
    CHECK_FALSE(claim.hypotheses.empty());
    // A claim beyond calculation; claim_texts_test.cpp tests it.
    if (claim.controls.empty()) continue;
    CHECK(claim.controls.size() >= 3);
    std::set<std::string> names;
    for (const Control& control : claim.controls) CHECK(names.insert(control.name).second);
  }
}

TEST_CASE("every claim has a near miss among its controls, unless it is decided exactly") {
  for (const Report& report : quick_run(1)) {
    CAPTURE(report.claim.id);
    const bool near_miss =
        std::ranges::any_of(report.controls, [](const auto& c) { return c.name.starts_with("near miss"); });
    const bool exact = std::ranges::all_of(report.evidence, [](const Evidence& e) {
      return std::holds_alternative<ExactIdentity>(e) || std::holds_alternative<CheckedProof>(e);
    });
    CHECK((near_miss || (exact && !report.evidence.empty()) || report.beyond_calculation()));
  }
}

// A new claim need not be in the list: the paper's statements name it, so it is examined.
TEST_CASE("the ledger has lost nothing that its list says, and has what the paper's statements name") {
  const ExpectedLedger expected = expected_ledger();
  std::map<std::string, std::size_t> controls;
  for (const Claim& claim : registry()) controls[claim.id] = claim.controls.size();
  for (const auto& claim : expected.claims) {
    CAPTURE(claim.first);
    REQUIRE(controls.contains(claim.first));
    CHECK(controls[claim.first] >= claim.second.second);
  }
  std::set<std::string> ids, stated;
  for (const auto& [id, count] : controls) ids.insert(id);
  for (const PaperStatement& statement : paper_statements()) {
    CHECK_MESSAGE(!statement.claims.empty(), statement.what);
    CHECK_MESSAGE(statement.scope.empty() == statement.place.empty(), statement.what);
    stated.insert(statement.claims.begin(), statement.claims.end());
    stated.insert(statement.instances.begin(), statement.instances.end());
  }
  CHECK(stated == ids);
  std::set<std::string> notes;
  for (const ReadingNote& note : reading_notes({})) notes.insert(note.id);
  CHECK(notes == expected.notes);
}

// The tests verify-* use a further seed.
TEST_CASE("all claims hold in double, for two seeds, and every control is refuted") {
  for (const std::uint64_t seed : {1U, 2U}) {
    CAPTURE(seed);
    check_all_hold(quick_run(seed));
  }
}

TEST_CASE("slow: all claims hold in double for another seed, and at all parameters" * doctest::skip()) {
  check_all_hold(quick_run(123456));
  check_all_hold(full_run());
}

TEST_CASE("slow: a full run looks at all that a quick one looks at, in no fewer cases" * doctest::skip()) {
  const std::vector<Report>& few = quick_run(1);
  REQUIRE(few.size() == full_run().size());
  for (std::size_t k = 0; k < few.size(); ++k) {
    CAPTURE(few[k].claim.id);
    const std::map<std::string, std::size_t> all = cases_of(full_run()[k]);
    for (const auto& looked_at : cases_of(few[k])) {
      CAPTURE(looked_at.first);
      REQUIRE(all.contains(looked_at.first));
      CHECK(all.at(looked_at.first) >= looked_at.second);
    }
  }
}

TEST_CASE("one seed, one result; another seed, other parameters") {
  CHECK(texts(quick_run(1)) == texts(run_all(claims_made_anew(), quick(1))));
  CHECK(texts(quick_run(1)) != texts(quick_run(2)));
}

TEST_CASE("at 50 digits the differences are those of 50 digits") {
  const std::vector<std::string> patterns{"eq-04-flat-*", "published-*", "plemelj"};
  const std::vector<Report> reports = run_all(select(registry(), patterns), quick(1, numeric::Digits::fifty));
  REQUIRE(reports.size() == 3);
  check_all_hold(reports);
}

TEST_CASE("every reading note with a claim names one that exists, and a control of it that is refuted") {
  const std::vector<ReadingNote> notes = reading_notes(quick_run(1));
  std::set<std::string> ids;
  for (const ReadingNote& note : notes) {
    INFO("note.id = ", note.id, ", note.claim = ", note.claim, ", note.control = ", note.control);
    CHECK(ids.insert(note.id).second);
    CHECK_FALSE(note.evidence.empty());
    CHECK(note.printed != note.derived);
    // The local equation decides these notes, independently of the run. They have their own test in tests/symbolic.
    if (note.claim.empty()) continue;
    const auto claim = std::ranges::find(registry(), note.claim, &Claim::id);
    REQUIRE(claim != registry().end());
    CHECK(note.evidence.starts_with("claim " + note.claim + " is "));
    CHECK(holds(note.evidence, " as derived"));
    if (note.control.empty()) continue;
    CHECK(std::ranges::count(claim->controls, note.control, &Control::name) == 1);
    CHECK(holds(note.evidence, " as derived; the printed reading is refuted ("));
  }
  for (const ReadingNote& note : reading_notes({})) {
    CHECK((note.claim.empty() || holds(note.evidence, "not examined in this run")));
  }
}

TEST_CASE("the evidence of a reading note has its formulas between backticks") {
  Report report;
  report.claim.id = "eq-04-flat-punch";
  report.controls = {{"the printed `(1+x)^{1/2}` instead of `(1+x)^{1/2+alpha}`", true,
                      "A t = u'/c at points: relative difference 2.9e-01 at nu = 0.3, f = 0.5, 2, psi = 0.5*x + 1"}};
  const std::string evidence = reading_notes(std::vector{report}).front().evidence;
  for (const char* part : {"(`A t = u'/c` at points: relative difference `2.9e-01` at `nu = 0.3`, `f = 0.5, 2`, "
                           "`psi = 0.5 x + 1`).",
                           "`|x|^lambda`, `x > 0`: `-s_r theta` in place of `0`; the derived form holds."}) {
    CHECK_MESSAGE(holds(evidence, part), evidence);
  }
}

TEST_CASE("every reading note weighs print against extraction, with its formulas between backticks") {
  for (const ReadingNote& note : reading_notes({})) {
    CAPTURE(note.id);
    CHECK((holds(note.evidence, "xtraction") || holds(note.evidence, "the print's")));
    // The note's words and its column agree. Only formulas can be faults of the print.
    const bool of_words = note.fault == "hypothesis" || note.fault == "wording";
    CHECK((note.fault == "print" || note.fault == "extraction" || note.fault == "undecided" || of_words));
    CHECK(holds(note.evidence, "extraction's") == (note.fault == "extraction"));
    if (holds(note.evidence, "the print's")) CHECK(note.fault == "print");
    if (holds(note.evidence, "the paper's")) CHECK(of_words);
    CHECK_FALSE((note.fault == "print" && holds(note.evidence, "Words")));
    if (note.fault == "print") CHECK(std::ranges::count(note.printed + note.derived, '`') > 0);
    if (holds(note.evidence, "extraction may well have")) CHECK(note.fault == "undecided");
    for (const std::string* text : {&note.place, &note.printed, &note.derived, &note.evidence}) {
      CHECK(std::ranges::count(*text, '`') % 2 == 0);
    }
  }
}
