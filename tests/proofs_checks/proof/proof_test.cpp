// Checks of written proofs: valid steps are accepted; every other step is a gap with a reason.

#include "proofs_checks/proof/proof.hpp"

#include <nlohmann/json.hpp>

#include "proofs_checks/proof/markdown.hpp"
#include "support/test.hpp"

using namespace steadyslide;
using namespace steadyslide::proofs_checks;

namespace {

constexpr std::string_view facts_document = R"(# Numbers

## Words

| fact | says | follows from |
|---|---|---|
| even(N) | N is even |
| odd(N) | N is odd |
| whole(N) | N is whole |
| sum(N, A, B) | `N = A + B` |
| nonzero(E) | `E != 0` |
| positive(E) | `E > 0` |
| negative(E) | `E < 0` |
| small(N) | N is small | sum(N, A, B), even(A) |

## Things

| name | is |
|---|---|
| two | `2` |
| three | `3` |
| five | `5` |

## Definitions

| fact | means |
|---|---|
| whole(N) | sum(N, A, B), even(A), odd(B) |

## Decided

| fact | by | where |
|---|---|---|
| even(two) | identity halves | |
| odd(three) | identity thirds | nonzero("x - 1") |
| odd(two) | identity wrong | |
| odd(five) | identity unknown | |
| whole(two) | identity sixths | |
| whole(three) | identity sixths | nonzero("x - 2") |
| sum(five, two, three) | enclosure adds | x in [0, 2] |
| sum(five, two, three) | enclosure adds | x in ]2, oo[ |
| even(five) | enclosure adds | x in [0, 2] |
)";

constexpr std::string_view theorems_document = R"(# Theorems

### odd-sum
[Euclid, book 9]. An even number and an odd one
make an odd one.
Needs sum(N, A, B), even(A),
odd(B).
Gives odd(N).
)";

Theory made(std::string_view facts, std::string_view theorems) {
  const std::vector<std::string_view> documents{facts, theorems};
  return Theory{documents};
}

const Theory& numbers() {
  static const Theory theory = made(facts_document, theorems_document);
  return theory;
}

ProofText proof_text(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return parse_proof(parts_of(kept, "\n"));
}

const CheckedProof* entry(const std::string& id);

Decision identity(const std::string& id) {
  static const std::map<std::string, std::string> decides{
      {"halves", "even(two)"}, {"thirds", "odd(three)"}, {"sixths", "whole({two, three})"}};
  if (id == "unknown") return {Truth::unknown};
  const auto named = decides.find(id);
  return {id == "wrong" ? Truth::no : Truth::yes,
          {"words of " + id},
          id == "thirds" || id == "sixths" ? std::vector<std::string>{"x - 1"} : std::vector<std::string>{},
          parse_facts(named == decides.end() ? "" : named->second)};
}

const Decisions decisions{
    identity,
    [](const std::string& p, const Box&) { return p == "x + 1" || p == "-(-x - 1)" ? Truth::yes : Truth::no; },
    [](const std::string&, const Box&) { return Decision{Truth::yes}; }, entry};

CheckedProof checked(const std::string& text) { return check_proof(proof_text(text), numbers(), decisions); }

const std::string sum_is_odd =
    "For `x in [0, oo[`.\nAssumes `nonzero(\"x - 1\")`.\nConcludes `odd(five)`,\n`whole(five)`.\n\n"
    "- identity: even(two)\n- identity: odd(three)\n- enclosure: sum(five, two, three)\n"
    "- theorem odd-sum: odd(five)\n- definition: whole(five)\n";

const CheckedProof* entry(const std::string& id) {
  static const CheckedProof five = checked(sum_is_odd);
  static const CheckedProof open = checked("Concludes `odd(two)`.\n- identity: even(two)\n- identity: odd(two)\n");
  return id == "five-is-odd" ? &five : id == "open" ? &open : nullptr;
}

std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// Rows of exchanges.json: a text, its replacement, and the gap that this causes.
std::vector<std::vector<std::string>> exchanges(const char* kind) {
  return nlohmann::json::parse(file_text(STEADYSLIDE_TESTS "/proofs_checks/proof/exchanges.json")).at(kind);
}

}  // namespace

TEST_CASE("a proof: assumptions, an identity, an enclosure over two boxes, a theorem, a definition") {
  const CheckedProof proof = checked(sum_is_odd);
  CHECK(proof.gap.empty());
  REQUIRE(proof.nodes.size() == 6);
  CHECK(proof.nodes[0].by == "assumed");
  CHECK(proof.nodes[2].from == std::vector<std::size_t>{0});
  CHECK(proof.nodes[4].from == std::vector<std::size_t>{3, 1, 2});
  CHECK(proof.nodes[1].words == std::vector<std::string>{"words of halves"});
  CHECK(count_of_steps(proof) ==
        "2 identities, 1 enclosure, 1 classical theorem (odd-sum), 1 definition; rests on 2 rules in words");
  const std::vector<TreeLine> tree = tree_of(proof);
  REQUIRE(tree.size() == 9);
  CHECK(tree[0].node == 4);
  CHECK(tree[1].depth == 1);
  CHECK(std::ranges::count_if(tree, &TreeLine::again) == 3);
}

TEST_CASE("every step left out, and every fact exchanged, leaves a gap") {
  const ProofText whole = proof_text(sum_is_odd);
  for (std::size_t k = 0; k < whole.steps.size(); ++k) {
    ProofText shorter = whole;
    shorter.steps.erase(shorter.steps.begin() + static_cast<std::ptrdiff_t>(k));
    CHECK_FALSE(check_proof(shorter, numbers(), decisions).complete());
  }
  for (const auto& row : exchanges("leave a gap")) {
    CAPTURE(row[1]);
    const CheckedProof proof = checked(replaced_once(sum_is_odd, row[0], row[1]));
    CAPTURE(proof.gap);
    CHECK(holds(proof.gap, row[2]));
  }
}

TEST_CASE("an inference needs what it is said to rest on, and is counted as what it is") {
  const CheckedProof proof =
      checked(replaced_once(replaced_once(sum_is_odd, "- definition: whole(five)", "- inference: small(five)"),
                            "`whole(five)`", "`small(five)`"));
  CHECK(proof.complete());
  CHECK(count_of_steps(proof) ==
        "2 identities, 1 enclosure, 1 classical theorem (odd-sum), 1 inference; rests on 2 rules in words");
}

TEST_CASE("signs of formulas; divisors other than those that a fact is said to need") {
  for (const std::string fact :
       {"positive(\"x + 1\")", "nonzero(\"x + 1\")", "negative(\"-x - 1\")", "nonzero(\"-x - 1\")"}) {
    CHECK_MESSAGE(checked("For `x in [0, 1]`.\nConcludes `" + fact + "`.\n- sign: " + fact + "\n").complete(), fact);
  }
  const CheckedProof other =
      checked("Assumes `nonzero(\"x - 2\")`.\nConcludes `whole(three)`.\n- identity: whole(three)\n");
  CHECK(other.gap == "sixths holds where x - 1 != 0, and nothing says so");
}

TEST_CASE("an order that does not follow is a gap: a step rests on those above it alone") {
  ProofText text = proof_text(sum_is_odd);
  std::swap(text.steps[0], text.steps[3]);
  CHECK(check_proof(text, numbers(), decisions).gap == "odd(five) by odd-sum needs sum(five, A, B)");
}

TEST_CASE("an entry is cited with its conclusions, its assumptions and its parameters") {
  const std::string cites =
      "For `x in [0, 7]`.\nAssumes `nonzero(\"x - 1\")`.\nConcludes `odd(five)`.\n- entry five-is-odd: odd(five)\n";
  CHECK(checked(cites).complete());
  CHECK(holds(checked(replaced_once(cites, "[0, 7]", "[-1, 7]")).gap, "is proved for x in [0, oo[ only"));
  CHECK(holds(checked(replaced_once(cites, "Assumes `nonzero(\"x - 1\")`.\n", "")).gap, "needs nonzero"));
  CHECK(holds(checked(replaced_once(cites, "entry five-is-odd", "entry open")).gap, "has a gap: does not hold: wrong"));
  CHECK(holds(checked(replaced_once(cites, "entry five-is-odd", "entry other")).gap, "no entry with a proof: other"));
  CHECK(holds(checked(replaced_once(cites, ": odd(five)", ": odd(three)")).gap, "does not conclude odd(three)"));
}

TEST_CASE("a word, a thing or a step that is not declared is an error and no gap") {
  for (const auto& row : exchanges("not declared")) {
    CHECK_THROWS_AS_MESSAGE(checked(replaced_once(sum_is_odd, row[0], row[1])), std::logic_error, row[1]);
  }
  for (const auto& row : exchanges("no steps")) {
    CHECK_THROWS_AS_MESSAGE(proof_text(replaced_once(sum_is_odd, row[0], row[1])), std::logic_error, row[1]);
  }
}

TEST_CASE("theories: nothing twice, nothing undeclared, definitions for all things, no theorem about anything") {
  const std::string facts(facts_document), rules(theorems_document);
  CHECK_NOTHROW(made(facts, rules));
  for (const auto& row : exchanges("no theories")) {
    CHECK_THROWS_AS_MESSAGE(made(replaced_once(facts, row[0], row[1]), rules), std::logic_error, row[1]);
  }
  CHECK_THROWS_AS(made(facts, replaced_once(rules, "Gives odd(N).", "Gives odd(C).")), std::logic_error);
  CHECK_THROWS_AS(made(facts, replaced_once(rules, "Gives odd(N).", "")), std::logic_error);
  CHECK_THROWS_AS(made(facts, rules + "\n" + rules), std::logic_error);
}

TEST_CASE("an identity decides facts of one word, and those that it names alone") {
  const auto with = [](const std::string& from, const std::string& to) {
    return made(replaced_once(std::string(facts_document), from, to), theorems_document);
  };
  CHECK_THROWS_WITH(with("odd(three) | identity thirds", "odd(three) | identity halves"),
                    "one identity, two facts: halves, even(two) and odd(three)");
  for (const auto& [from, to] : {std::pair("even(two) | identity halves", "even(two) | identity fourths"),
                                 {"even(two) | identity halves | |\n", "even(three) | identity halves | |\n"}}) {
    const std::string fact = std::string(to).substr(0, std::string(to).find(' '));
    const Theory theory = with(from, to);
    CHECK(holds(check_proof(proof_text("Concludes `" + fact + "`.\n- identity: " + fact + "\n"), theory, decisions).gap,
                "does not say that it decides " + fact));
  }
}

TEST_CASE("a theorem that says several things: each from its own needs") {
  const std::string second =
      "\nAnd two even numbers make an even one.\nNeeds sum(N, A, B), even(A), even(B).\nGives even(N).\n";
  const std::string both = std::string(theorems_document) + second;
  const Theory theory = made(facts_document, both);
  REQUIRE(theory.theorems.at("odd-sum").size() == 2);
  const auto gap = [&](const std::string& fact) {
    return check_proof(proof_text(replaced_once(replaced_once(sum_is_odd, ": odd(five)", ": " + fact),
                                                "Concludes `odd(five)`,\n`whole(five)`", "Concludes `" + fact + "`")),
                       theory, decisions)
        .gap;
  };
  CHECK(gap("odd(five)").empty());
  CHECK(gap("even(five)") == "even(five) by odd-sum needs even(three)");
}

TEST_CASE("a pattern matches with one meaning of each variable, and with things that it names") {
  const Fact pattern = parse_fact("sum(N, two, N)");
  CHECK(match(pattern, parse_fact("sum(five, two, five)"), {}));
  for (const char* other : {"sum(five, two, three)", "sum(five, six, five)", "sum(five, three, five)", "whole(five)"})
    CHECK_FALSE_MESSAGE(match(pattern, parse_fact(other), {}), other);
}

TEST_CASE("facts in words") {
  CHECK(numbers().sentence(parse_fact("sum(five, two, three)")) == "`five = two + three`");
  CHECK(numbers().sentence(parse_fact("nonzero(\"s_r - s_l\")")) == "`s_r - s_l != 0`");
  CHECK(text_of(parse_facts("`sum(five, two, three)`, even(two).")) == "sum(five, two, three), even(two)");
}

TEST_CASE("braces hold alternatives, and one line holds the steps of one reason") {
  CHECK(text_of(parse_facts("sum({five, two}, two, three), `even(two)`")) ==
        "sum(five, two, three), sum(two, two, three), even(two)");
  CHECK(text_of(parse_facts("sum(five, {two, three}, {two, \"x, y\"})")) ==
        "sum(five, two, two), sum(five, two, \"x, y\"), sum(five, three, two), sum(five, three, \"x, y\")");
  CHECK_THROWS_AS(parse_facts("sum(five, {two, three)"), std::logic_error);
  const std::string in_one_line =
      replaced_once(sum_is_odd, "even(two)\n- identity: odd(three)", "even(two), odd(three)");
  CHECK(proof_text(in_one_line).steps.size() == 5);
  CHECK(checked(in_one_line).complete());
}

TEST_CASE("boxes cover a box, ends included where brackets say so") {
  const auto covered = [](std::initializer_list<const char*> texts, const char* whole) {
    std::vector<Box> boxes;
    for (const char* text : texts) boxes.push_back(parse_box(text));
    return covers(boxes, parse_box(whole));
  };
  CHECK(covered({"x in [0, 1]", "x in ]1, oo["}, "x in [0, oo["));
  CHECK_FALSE(covered({"x in [0, 1[", "x in ]1, oo["}, "x in [0, oo["));
  CHECK_FALSE(covered({"x in ]0, 1]", "x in ]1, oo["}, "x in [0, oo["));
  CHECK(covered({"x in ]0, 1]", "x in ]1, oo["}, "x in ]0, oo["));
  CHECK(covered({"x in ]-oo, 1/3]", "x in [0.25, oo["}, "y in [0, 1]"));
  CHECK_FALSE(covered({"x in [0, 1]"}, "y in [0, 1]"));
  CHECK(covered({"x in [0, 1], y in [0, 1]", "x in [1, 2], y in [0, 2]", "x in [0, 1], y in ]1, 2]"},
                "x in [0, 2], y in [0, 2]"));
  CHECK_FALSE(covered({"x in [0, 1], y in [0, 1]", "x in [1, 2], y in [0, 2]", "x in [0, 1[, y in ]1, 2]",
                       "x in [0, 1], y in ]1, 3/2]"},
                      "x in [0, 2], y in [0, 2], z in [0, 1], x in [-1, 2]"));
  CHECK(covered({""}, "x in [0, 2]"));
  CHECK(covered({"x in [0, 1]", "x in ]1, 2]", "x in ]2, 4]"}, "x in [0, 4]"));
  CHECK_FALSE(covered({"x in [0, 1]", "x in ]1, 2[", "x in ]2, 4]"}, "x in [0, 4]"));
}

TEST_CASE("boxes cover what random places of them say") {
  REQUIRE(rc::check("each random place of a covered box lies in one; where none covers, one does not", [] {
    const auto interval = [] {
      const int from = uniform(0, 5);
      const int to = uniform(from, 6);
      if (from == to) return Interval{Rational(from), Rational(to), true, true};
      return Interval{Rational(from), Rational(to), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
    };
    const Box whole{{"x", interval()}, {"y", interval()}};
    std::vector<Box> boxes;
    for (int k = uniform(1, 6); k > 0; --k) boxes.push_back({{"x", interval()}, {"y", interval()}});
    bool all = true;
    for (int x = 0; x <= 12; ++x) {
      for (int y = 0; y <= 12; ++y) {
        const auto in = [&](const Box& box) {
          return box.at("x").contains(Rational(x, 2)) && box.at("y").contains(Rational(y, 2));
        };
        all = all && (!in(whole) || std::ranges::any_of(boxes, in));
      }
    }
    RC_ASSERT(covers(boxes, whole) == all);
  }));
}

TEST_CASE("a section of a page ends at the next heading of its level or of a higher one") {
  const std::string_view page = "# Page\n\n## One\na\n### Part\nb\n\n## Two\nc\n";
  CHECK(section_of(page, "## One") == "a\n### Part\nb\n");
  CHECK(section_of(page, "### Part") == "b\n");
  CHECK(section_of(page, "## Two") == "c\n");
  CHECK_THROWS_AS(section_of(page, "## Three"), std::logic_error);
}
