// Reads the lemmas written for Coq, and multiplies them out in plain rational arithmetic. That arithmetic uses neither
// GiNaC nor the polynomials with which the cofactors were found. tests/coq runs Coq itself.

#include "symbolic/coq/coq_lemmas.hpp"

#include <cctype>
#include <random>

#include "support/test.hpp"
#include "symbolic/coq/cofactors.hpp"
#include "symbolic/field/comparison.hpp"
#include "symbolic/statements/statements.hpp"

namespace steadyslide::symbolic {

namespace {

/// Reads sums, products and powers of names and of numbers in brackets, as algebra.v writes them.
class CoqReader {
 public:
  using Values = std::map<std::string, Rational>;
  CoqReader(std::string text, const Values& values) : text_(std::move(text)), values_(values) {}

  Rational value() {
    const Rational result = sum();
    if (at_ != text_.size()) throw std::runtime_error("left over: " + text_.substr(at_));
    return result;
  }

 private:
  bool next(char c) {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  Rational sum() {
    Rational result = product();
    for (;;) {
      if (next('+')) {
        result += product();
      } else if (next('-')) {
        result -= product();
      } else {
        return result;
      }
    }
  }
  Rational product() {
    Rational result = power();
    while (next('*')) result *= power();
    return result;
  }
  Rational power() {
    const Rational base = atom();
    if (!next('^')) return base;
    Rational result = 1;
    for (int k = std::stoi(word()); k > 0; --k) result *= base;
    return result;
  }
  Rational atom() {
    if (next('(')) {
      const Rational inside = sum();
      if (!next(')')) throw std::runtime_error("no )");
      return inside;
    }
    if (!next('[')) return values_.at(word());
    const std::size_t end = text_.find(']', at_);
    std::string number = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (const std::size_t sharp = number.find('#'); sharp != number.npos) number[sharp] = '/';
    return Rational(number);
  }
  std::string word() {
    const std::size_t start = at_;
    const auto inside = [&](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\'';
    };
    while (at_ < text_.size() && inside(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  std::string text_;
  const Values& values_;
  std::size_t at_ = 0;
};

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t start = text.find(before) + before.size();
  return text.substr(start, text.find(after, start) - start);
}

/// True if lhs - rhs equals the sum of the cofactors' multiples at `places` random places. The places need not satisfy
/// the generators' relations: both sides are polynomials in all of them.
bool multiplies_out(const CoqLemma& lemma, std::mt19937& random, int places = 2) {
  const std::string statement = between(lemma.text, "Lemma " + lemma.name + " : forall ", ".\nProof.");
  const std::size_t colon = statement.find(" :");
  std::string conclusion = statement.substr(statement.find(',') + 1);
  if (const std::size_t arrow = conclusion.rfind("->"); arrow != conclusion.npos) conclusion.erase(0, arrow + 2);
  const std::size_t equals = conclusion.find(" =");
  for (int place = 0; place < places; ++place) {
    CoqReader::Values values{{"zero", 0}};
    for (const std::string& name : words(statement.substr(0, colon))) {
      // Odd, hence not 0: with a factor 0 a wrong lemma would multiply out.
      values[name] = Rational(2 * static_cast<int>(random() % 51) - 51, static_cast<int>(random() % 7) + 1);
    }
    const Rational lhs = CoqReader(conclusion.substr(0, equals), values).value();
    const Rational rhs = CoqReader(conclusion.substr(equals + 2), values).value();
    if (lhs - rhs != CoqReader(between(lemma.text, "(by_cofactors _ _ (", ")).\n"), values).value()) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the lemma of an identity, word for word") {
  const PhaseField field({GiNaC::symbol("s")});
  const GiNaC::ex s = field.friction(0).s;
  const ExactIdentity identity =
      Comparison(field).equal("it", 1 / (s + GiNaC::I), s / (1 + s * s) - GiNaC::I / (1 + s * s)).as("Quotients");
  const CoqLemmas found = coq_lemmas("a-name", identity);
  REQUIRE(found.lemmas.size() == 1);
  CHECK(found.not_exported.empty());
  CHECK(found.lemmas[0].proved);
  std::string text;
  for (const std::string& word : words(found.lemmas[0].text)) text += (text.empty() ? "" : " ") + word;
  CHECK(holds(text, "(* a-name: Quotients; it."));
  CHECK(holds(text,
              "Lemma a_name : forall i s inv_1 inv_2 : Algebra, i^2 = [-1] -> ([1] + s^2) * inv_1 = [1] -> "
              "(i + s) * inv_2 = [1] -> inv_2 = inv_1 * s - i * inv_1."));
}

TEST_CASE("equations between numbers, or with one expression on both sides, are left out with the reason") {
  const PhaseField field;
  const GiNaC::symbol a("a"), b("b");
  const ExactIdentity identity = Comparison(field)
                                     .equal("numbers", 2, 2)
                                     .equal("same", a + b, b + a)
                                     .equal("it", (a + b) * (a - b), a * a - b * b)
                                     .as("");
  const CoqLemmas found = coq_lemmas("id", identity);
  REQUIRE(found.lemmas.size() == 1);
  CHECK(found.lemmas[0].name == "id_3");
  REQUIRE(found.not_exported.size() == 2);
  CHECK(found.not_exported[0].equation == "numbers");
  CHECK(found.not_exported[1].equation == "same");
  CHECK(found.not_exported[0].reason != found.not_exported[1].reason);
}

TEST_CASE("cofactors by hand: 1/d^2 - 1/d for d = 1, and a root") {
  // Generators r, q: r^2 = 4, (r - 1) q = 1. q^2 (r^2 - 2r + 1) - 1 has no remainder, q - 1 has one.
  const Polynomial r = Polynomial::generator(0), q = Polynomial::generator(1), one(1);
  const std::vector<Root> roots{{0, Polynomial(4)}};
  const std::vector<Inverse> inverses{{1, r - one}};
  const auto sum = [&](const Polynomial& p) {
    const Cofactors c = cofactors(p, roots, inverses);
    const Polynomial all = c.roots[0] * (r * r - Polynomial(4)) + c.inverses[0] * ((r - one) * q - one) + c.remainder;
    CHECK((all - p).is_zero());
    return c.remainder;
  };
  CHECK(sum(q * q * (Polynomial(5) - r - r) - one).is_zero());
  CHECK(sum(q - (r + one) * Polynomial(Rational(1, 3))).is_zero());
  CHECK_FALSE(sum(q - one).is_zero());
  CHECK_FALSE(sum(r * r * r - r).is_zero());
}

TEST_CASE("lemmas of all decided statements multiply out; those of their wrong variants do not") {
  std::mt19937 random(7);
  std::set<std::string> names;
  std::size_t wrong = 0;
  for (const StatementFamily& family : statement_families) {
    for (const DecidedStatement& statement : family.decide()) {
      for (const CoqLemma& lemma : coq_lemmas(statement.id, statement.identity).lemmas) {
        CAPTURE(lemma.name);
        CHECK(names.insert(lemma.name).second);
        CHECK(lemma.proved);
        CHECK(multiplies_out(lemma, random));
      }
      for (const ExactIdentity& control : statement.controls) {
        CAPTURE(statement.id + ", wrongly: " + control.statement);
        const CoqLemmas found = coq_lemmas(statement.id, control);
        bool refused = found.lemmas.empty();  // a lemma between numbers has nothing to refuse
        for (const CoqLemma& lemma : found.lemmas) {
          CHECK(multiplies_out(lemma, random) == lemma.proved);
          if (lemma.proved) continue;
          refused = true;
          ++wrong;
        }
        CHECK(refused);
      }
    }
  }
  CHECK(names.size() > 300);
  CHECK(wrong > 300);
}

}  // namespace steadyslide::symbolic
