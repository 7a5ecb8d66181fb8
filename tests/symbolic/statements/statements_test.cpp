// Statements that are decided exactly, with wrong variants of each.

#include "symbolic/statements/statements.hpp"
#include "support/test.hpp"
#include "symbolic/statements/polynomial_families.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;

namespace {

/// Checks that every statement holds and has its own id, and that each of its variants differs and is refuted. Checks
/// that statements of one section have this number of variants together. Returns the ids.
std::set<std::string> check_decided(const std::vector<DecidedStatement>& statements, std::size_t controls = 4) {
  std::set<std::string> ids;
  std::map<std::string, std::set<std::string>> sections;
  for (const DecidedStatement& statement : statements) {
    CAPTURE(statement.id);
    const std::string end = "-" + statement.decides.substr(0, statement.decides.find('('));
    const std::size_t length = statement.id.size() - (statement.id.ends_with(end) ? end.size() : 0);
    std::set<std::string>& section = sections[statement.id.substr(0, length)];
    CHECK(ids.insert(statement.id).second);
    CHECK(statement.identity.identical);
    CHECK(statement.identity.lhs == statement.identity.rhs);
    CHECK_FALSE(statement.controls.empty());
    std::set<std::string> variants;
    for (const ExactIdentity& control : statement.controls) {
      CAPTURE(control.statement);
      CHECK(variants.insert(control.statement).second);
      CHECK_FALSE(control.identical);
      CHECK(control.lhs != control.rhs);
    }
    section.merge(variants);
  }
  for (const auto& section : sections) CHECK_MESSAGE(section.second.size() >= controls, section.first);
  return ids;
}

/// Checks that a statement divides only by expressions that are known not to vanish.
template <class Known>
void check_divisors(const DecidedStatement& statement, const Known& is_known) {
  for (const std::string& d : statement.identity.nonvanishing) CHECK_MESSAGE(is_known(d), statement.id, " by ", d);
}

}  // namespace

TEST_CASE("every Riemann-Hilbert statement holds, and each of its wrong variants is refuted") {
  CHECK(check_decided(riemann_hilbert_statements()).size() >= 30);
}

TEST_CASE("the statements about the constants of elasticity hold, and every wrong variant is refuted") {
  const std::vector<DecidedStatement> all = elasticity_statements();
  CHECK(check_decided(all, 3).size() >= 14);
  CHECK(all[0].identity.lhs == "(2*nu - 1)/(2*nu - 2)");
}

TEST_CASE("what leaves the problem what it is: every statement holds, and each of its wrong variants is refuted") {
  CHECK(check_decided(equation_statements(), 3).size() == 37);
}

TEST_CASE("the local forms of theorems 2, 3, 9 and 10 hold, and every wrong variant is refuted") {
  const std::vector<DecidedStatement> all = local_form_statements();
  const std::set<std::string> ids = check_decided(all);
  CHECK(ids.size() == 13);
  for (const DecidedStatement& statement : all) {
    check_divisors(statement, [](const std::string& d) { return d == "s_l - s_r" || d == "s^2 + 1"; });
  }
  for (const char* theorem :
       {"theorem-2-jump", "theorem-2-wedge-and-jump", "theorem-2-wedge", "theorem-3-edge-left-end",
        "theorem-3-free-right-end", "theorem-9", "theorem-10-edge-right-end"}) {
    CHECK(ids.contains(theorem));
  }
}

TEST_CASE("the text as extracted and the derivation, side by side") {
  std::set<std::string> ids;
  for (const LocalReading& reading : local_readings()) {
    INFO(reading.id, ": ", reading.found);
    CHECK(ids.insert(reading.id).second);
    CHECK_FALSE(reading.printed_holds);
    CHECK(reading.derived_holds);
  }
  CHECK(ids.size() == 10);
  CHECK(local_readings().front().found ==
        "In the local equation the printed form leaves |x|^lambda, x > 0: s_l*theta - s_r*theta in place of 0; the "
        "derived form holds.");
}

TEST_CASE("every statement on the energy holds, and each of its wrong variants is refuted") {
  CHECK(check_decided(energy_statements(), 3).size() == 18);
}

TEST_CASE("every statement on uniqueness holds, and each of its wrong variants is refuted") {
  const std::vector<DecidedStatement> all = uniqueness_statements();
  CHECK(check_decided(all, 3).size() == 17);
  for (const DecidedStatement& statement : all) check_divisors(statement, [](const std::string&) { return false; });
}

TEST_CASE("every statement on forms with symbolic indices holds, and each of its wrong variants is refuted") {
  const std::vector<DecidedStatement> all = hilbert_statements();
  CHECK(check_decided(all, 3).size() == 28);
  // For j != k no condition remains, i + s is never 0, and the rate of wear k is positive.
  for (const DecidedStatement& statement : all) {
    check_divisors(statement, [](const std::string& d) { return d == "s^2 + 1" || d == "i + s" || d == "k"; });
  }
}

TEST_CASE("Chebyshev's polynomials and exact integrals") {
  const GiNaC::symbol x("x");
  CHECK((chebyshev_t(0, x) - 1).is_zero());
  CHECK((chebyshev_t(3, x) - (4 * x * x * x - 3 * x)).expand().is_zero());
  CHECK(chebyshev_u(-1, x).is_zero());
  CHECK((chebyshev_u(0, x) - 1).is_zero());
  CHECK((chebyshev_u(3, x) - (8 * x * x * x - 4 * x)).expand().is_zero());
  // Pell's equation.
  for (int n = 1; n < 8; ++n) {
    const ex t = chebyshev_t(n, x), u = chebyshev_u(n - 1, x);
    CHECK((t * t - (x * x - 1) * u * u - 1).expand().is_zero());
  }
  const GiNaC::symbol c("c");
  CHECK((integral(3 * x * x + 1, x, c, 2) - (10 - c * c * c - c)).expand().is_zero());
}

TEST_CASE("the steps of the structure theorem hold for all real data") {
  std::set<std::string> ids;
  for (const DecidedStatement& statement : riemann_hilbert_statements()) {
    if (!statement.id.starts_with("rh-structure-")) continue;
    ids.insert(statement.id);
    check_divisors(statement, [](const std::string& d) { return d.starts_with("i ") || d == "pi" || d == "s^2 + 1"; });
  }
  CHECK(ids.size() == 6);
}
