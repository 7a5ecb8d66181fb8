// Formulas, instances, and facts and rules that are run on them: those of the ledger hold, and wrong ones are refuted.

#include "proofs_checks/proof/meaning.hpp"

#include <boost/algorithm/string/join.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "proofs_checks/kit/registry.hpp"
#include "proofs_checks/proof/markdown.hpp"
#include "support/test.hpp"
#include "symbolic/statements/statements.hpp"

using namespace steadyslide::proofs_checks;

namespace {

Truth decided(const char* formula, const Instance& instance = {}) { return Formula(formula).holds(instance); }

using Facts = std::map<std::string, std::string>;  ///< the texts by the name of their file

const Facts& fact_files() {
  static const Facts files = [] {
    Facts all;
    for (const auto& entry : std::filesystem::directory_iterator(STEADYSLIDE_FACTS)) {
      all[entry.path().filename()] = file_text(entry.path());
    }
    return all;
  }();
  return files;
}

Theory theory_of(const Facts& files) {
  static const std::string proofs = file_text(STEADYSLIDE_PROOFS);
  std::vector<std::string_view> documents{section_of(proofs, "## Classical theorems")};
  for (const auto& [name, text] : files) documents.emplace_back(text);
  return Theory(documents);
}

/// Returns all rules of a theory.
std::vector<Rule> rules_of(const Theory& theory) {
  std::vector<Rule> all;
  for (const auto& [word, rule] : theory.definitions) all.push_back(rule);
  for (const auto& [word, rule] : theory.inferences) all.push_back(rule);
  for (const auto& [name, rules] : theory.theorems) std::ranges::copy(rules, std::back_inserter(all));
  return all;
}

/// Returns the facts that are decided, and those that are steps of the ledger's proofs.
std::set<Fact> facts_of(const Theory& theory) {
  std::set<Fact> all;
  for (const DecidedFact& one : theory.decided) all.insert(one.fact);
  for (const Claim& claim : registry()) {
    for (const ProofStep& step : claim.proof.steps) all.insert(step.fact);
  }
  return all;
}

using Decided = std::set<std::pair<std::string, Fact>>;  ///< an identity and a fact

/// Returns what the tables say that identities decide.
Decided decided_in_tables(const Theory& theory) {
  Decided all;
  for (const DecidedFact& one : theory.decided) {
    if (one.by != DecidedFact::By::identity) continue;
    for (const std::string& id : one.ids) all.emplace(id, one.fact);
  }
  return all;
}

/// Returns what the statements say that they decide.
const Decided& decided_in_statements() {
  static const Decided all = [] {
    Decided named;
    for (const auto& family : steadyslide::symbolic::statement_families) {
      for (const auto& statement : family.decide()) {
        for (const Fact& fact : parse_facts(statement.decides)) named.emplace(statement.id, fact);
      }
    }
    return named;
  }();
  return all;
}

/// Returns what refutes the changed theory, among the facts and rules that are not as in the ledger, or the identity
/// that does not name its fact; empty if nothing.
std::string refuted_by(const Theory& changed) {
  const Meaning meaning(changed);
  const Theory& before = theory();
  const auto is_same = [](const auto& one, const auto& other, const std::string& key) {
    const auto here = one.find(key);
    const auto there = other.find(key);
    if (here == one.end() || there == other.end()) return (here == one.end()) == (there == other.end());
    return here->second == there->second;
  };
  const auto is_said = [&](const Fact& fact) {
    bool same = is_same(changed.formulas, before.formulas, fact.word);
    std::string key;
    for (const std::string& thing : fact.things) {
      same = same && is_same(changed.formulas, before.formulas, thing) &&
             is_same(changed.instances, before.instances, thing);
      key += (key.empty() ? "" : ", ") + thing;
    }
    return same && is_same(changed.instances, before.instances, key);
  };
  const std::set<Fact> known = facts_of(before);
  for (const Fact& fact : facts_of(changed)) {
    if (is_said(fact) && known.contains(fact)) continue;
    if (!meaning.of(fact).counterexample.empty()) return text_of(fact);
  }
  const std::vector<Rule> old = rules_of(before);
  for (const Rule& rule : rules_of(changed)) {
    const auto as_before = [&](const Rule& other) { return other.needs == rule.needs && other.gives == rule.gives; };
    if (std::ranges::all_of(rule.needs, is_said) && std::ranges::all_of(rule.gives, is_said) &&
        std::ranges::any_of(old, as_before)) {
      continue;
    }
    const Run& run = meaning.of(rule);
    if (!run.counterexample.empty()) return rule.name + " gives " + text_of(rule.gives);
    if (!run.idle.empty()) return rule.name + " has an idle premise: " + run.idle.front();
  }
  for (const auto& [id, fact] : decided_in_tables(changed)) {
    if (!decided_in_statements().contains({id, fact})) return id + " does not decide " + text_of(fact);
  }
  return "";
}

std::string cell_of_csv(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

constexpr std::string_view made_facts = R"(# Numbers

## Words

| fact | says | follows from |
|---|---|---|
| even(N) | N is even: **`floor(n/2) = n/2`** | |
| positive(E) | **`E > 0`** | |
| grows(N) | N and its successor: **`next > n`** | successor(N), positive(D) |
| successor(N) | **`next = n + D`** | |

## Things

| name | is |
|---|---|
| two | `2` |
| whole | a whole number |

## Instances

| of | quantities |
|---|---|
| two | `n = 2`, `next = 3` |
| whole | `n in {0, 1, 2}`, `next = n + 1`, `D = 1` |
| grows(N) | `n in [0, 1]`, `D in {-1, 1}`, `next in {n + D, n, n + 3}` |
)";

Theory sentences(const std::string& from = "", const std::string& to = "") {
  static std::string kept;
  kept = made_facts;
  if (!from.empty()) {
    REQUIRE(times(kept, from) == 1);
    kept.replace(kept.find(from), from.size(), to);
  }
  const std::vector<std::string_view> documents{kept};
  return Theory(documents);
}

}  // namespace

TEST_CASE("formulas: powers, products by a space, comparisons in a row, intervals, words between them") {
  const Instance two{{{"x", 2}, {"y'", 3}}};
  for (const char* formula :
       {"1 + 2 3 = 7", "-x^2 = -4", "2^-1 = 1/2", "2^3^2 = 512", "x < y' <= 3", "x in [2, 3[", "not x in ]2, 3]",
        "x = 0 or y' = 3 and x = 2", "x = 3 if y' = 4", "pi/4 = arctan(1)", "max(x, y', 1) = 3",
        "sum(k, 1, 3, k x) = 12", "all(k, 1, 3, k > 0)", "int(r, 0, 1, r^(-1/2)) = x", "int(r, 0, pi, sin(r)) = 2",
        "x (y' - 1) = 4", "gamma(1/2)^2 = pi", "1 < 2 if (x < 3 and 2 < y')"}) {
    CHECK_MESSAGE(decided(formula, two) == Truth::yes, formula);
  }
  for (const char* formula :
       {"x = 3 if y' = 3", "x in ]2, 3[", "x > 2", "x != 2", "all(k, 0, 3, k > 0)", "not x = 2"}) {
    CHECK_MESSAGE(decided(formula, two) == Truth::no, formula);
  }
  CHECK(decided("log(0) < 1") == Truth::unknown);
  for (const char* text : {"", "1 +", "x in 2", "(1", "int(1, 0, 1, 2)", "sin(1, 2)", "x = = y", "1 2)", "x ^"}) {
    CHECK_THROWS_AS_MESSAGE(Formula{text}, std::logic_error, text);
  }
  for (const char* text : {"z = 1", "x + 1", "f(1) = 1", "(x = 1) + 1 = 2"}) {
    CHECK_THROWS_AS_MESSAGE(decided(text, two), std::logic_error, text);
  }
}

TEST_CASE("measured numbers have an accuracy: those closer together are equal, and their order is unknown") {
  const Instance measured{{{"x", Real50("1.0001")}}, {}, Real50("1e-3")};
  CHECK(decided("x = 1", measured) == Truth::yes);
  CHECK(decided("x > 1", measured) == Truth::unknown);
  CHECK(decided("x <= 1", measured) == Truth::unknown);
  CHECK(decided("x < 1.1", measured) == Truth::yes);
  CHECK(decided("x > 1.1", measured) == Truth::no);
}

TEST_CASE("a fact holds on all instances of its thing, or it is refuted by one") {
  const Theory theory = sentences();
  const Meaning meaning(theory);
  CHECK(meaning.of(parse_fact("even(two)")).instances > 0);
  CHECK(meaning.of(parse_fact("even(two)")).counterexample.empty());
  CHECK(holds(meaning.of(parse_fact("even(whole)")).counterexample, "even(whole) fails for an instance of whole: "));
  CHECK(meaning.of(parse_fact("successor(two)")).instances == 0);  // two has no D
  CHECK(theory.sentence(parse_fact("even(two)")) == "two is even: `floor(n/2) = n/2`");
}

TEST_CASE("a rule holds on general instances, and each of its premises is needed there") {
  const auto run_of = [](const Theory& theory) { return Meaning(theory).of(theory.inferences.at("grows")); };
  const Run whole = run_of(sentences());
  CHECK(whole.instances > 0);
  CHECK(whole.counterexample.empty());
  CHECK(whole.idle.empty());
  const std::string needs = "successor(N), positive(D)";
  CHECK(holds(run_of(sentences(needs, "successor(N)")).counterexample, "grows(N) does not follow, by grows"));
  CHECK(holds(run_of(sentences("`next > n`", "`next < n`")).counterexample, "does not follow"));
  CHECK(run_of(sentences(needs, needs + ", even(N)")).idle == std::vector<std::string>{"even(N)"});
  CHECK(run_of(sentences("n + 3}`", "n + 3}`, idle even(N)")).idle.empty());
  CHECK(run_of(sentences("| grows(N) | `n in", "| even(N) | `n in")).instances == 0);
}

TEST_CASE("instances that are not as described are errors") {
  for (const auto& change :
       std::vector<std::pair<std::string, std::string>>{{"n in {0, 1, 2}", "n in 0, 1"},
                                                        {"n in {0, 1, 2}", "n"},
                                                        {"n in {0, 1, 2}", "n in {0, 1, }}"},
                                                        {"`n = 2`", "by no-solver"},
                                                        {"`n = 2`", "like three"},
                                                        {"| two | `n", "| three | `n"},
                                                        {"`n = 2`", "`n = 2`, `n = 3`"},
                                                        {"| grows(N) | `n in", "| shrinks(N) | `n in"},
                                                        {"floor(n/2)", "floor(m/2)"},
                                                        {"floor(n/2)", "floor(n/2"}}) {
    CHECK_THROWS_AS_MESSAGE(Meaning(sentences(change.first, change.second)), std::logic_error, change.second);
  }
  const Theory none = sentences("`D = 1`", "`D = 1`, where `D = 2`");
  CHECK_THROWS_AS(Meaning(none).of(parse_fact("even(whole)")), std::logic_error);
  const Theory never = sentences("D in {-1, 1}", "D = -1");
  CHECK_THROWS_AS(Meaning(never).of(never.inferences.at("grows")), std::logic_error);
}

TEST_CASE("every fact and every rule of the ledger that has a meaning holds on its instances") {
  std::size_t run = 0;
  for (const Fact& fact : facts_of(theory())) {
    CAPTURE(text_of(fact));
    const Run& one = meaning().of(fact);
    CHECK(one.counterexample == "");
    run += one.instances > 0 ? 1 : 0;
  }
  for (const Rule& rule : rules_of(theory())) {
    CAPTURE(rule.name);
    const Run& one = meaning().of(rule);
    CHECK(one.counterexample == "");
    CHECK(boost::algorithm::join(one.idle, ", ") == "");
  }
  MESSAGE(run, " facts run");
}

// So each exchange of two identities, or of two facts, is noticed.
TEST_CASE("the tables and the statements say the same of each identity") {
  const Decided tables = decided_in_tables(theory());
  for (const auto& one : tables) {
    CHECK_MESSAGE(decided_in_statements().contains(one), one.first, " does not name ", text_of(one.second));
  }
  for (const auto& one : decided_in_statements()) {
    CHECK_MESSAGE(tables.contains(one), text_of(one.second), " without ", one.first);
  }
}

TEST_CASE("wrong sentences, rules and decisions: each refutes something, as the table in docs says") {
  std::string table = "change,file,what,refuted by\n";
  for (const auto& change :
       nlohmann::json::parse(file_text(STEADYSLIDE_TESTS "/proofs_checks/proof/changed_words.json"))) {
    const std::string id = change.at("id"), file = change.at("file"), old = change.at("old"), wrong = change.at("new");
    CAPTURE(id);
    Facts files = fact_files();
    REQUIRE(times(files.at(file), old) == 1);
    files[file].replace(files[file].find(old), old.size(), wrong);
    const std::string noticed = [&]() -> std::string {
      try {
        return refuted_by(theory_of(files));
      } catch (const std::logic_error& refused) {
        return refused.what();
      }
    }();
    CHECK(noticed != "");
    table += id + "," + file + "," + cell_of_csv(change.at("what")) + "," + cell_of_csv(noticed) + "\n";
  }
  CHECK(table == file_text(STEADYSLIDE_DOCS "/words.csv"));
}
