#include "symbolic/field/phase_field.hpp"
#include "support/test.hpp"

using namespace steadyslide::symbolic;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

bool zero(const PhaseField& field, const ex& e) { return field.is_identically_zero(e).holds; }

/// Returns a random element: sums, products and quotients of s, r, i, a free symbol and numbers.
rc::Gen<ex> element(const PhaseField& field, const GiNaC::symbol& x, int depth) {
  return rc::gen::exec([&field, x, depth]() -> ex {
    const int kind = *rc::gen::inRange(0, depth == 0 ? 4 : 7);
    const auto k = *rc::gen::inRange<std::size_t>(0, field.size());
    if (kind == 0) return *rc::gen::inRange(-3, 4);
    if (kind == 1) return field.friction(k).s;
    if (kind == 2) return field.friction(k).r;
    if (kind == 3) return *rc::gen::element(ex(field.i()), ex(x));
    const ex a = *element(field, x, depth - 1), b = *element(field, x, depth - 1);
    if (kind == 4) return a + b;
    if (kind == 5) return a * b;
    return a / (b * b + field.friction(k).r + 7);
  });
}

}  // namespace

TEST_CASE("cos^2 + sin^2 = 1, which normal() does not know") {
  const GiNaC::symbol s("s");
  const PhaseField field({s});
  const auto& f = field.friction(0);
  CHECK(zero(field, f.cos * f.cos + f.sin * f.sin - 1));
  CHECK(!zero(field, f.cos * f.cos - f.sin * f.sin - 1));
  CHECK(zero(field, field.phase({1, {{0, 2}}}) - GiNaC::I * (1 - s * s + 2 * GiNaC::I * s) / (1 + s * s)));
  CHECK(zero(field, field.phase({3, {{0, -1}}}) * field.phase({1, {{0, 1}}}) - 1));
}

TEST_CASE("radicals of numbers: perfect squares, common factors, and a near miss") {
  const PhaseField field({numeric(3, 4), numeric(1), numeric(7), numeric(2), numeric(-2), numeric(0)});
  CHECK(zero(field, field.friction(0).r - numeric(5, 4)));
  CHECK(zero(field, field.friction(2).r - 5 * field.friction(1).r));
  CHECK(!zero(field, field.friction(2).r - 5 * field.friction(1).r - numeric(1, 1000000)));
  CHECK(zero(field, field.friction(3).r - field.friction(4).r));
  CHECK(zero(field, field.friction(5).r - 1));
  CHECK(!zero(field, field.friction(3).r - field.friction(1).r));
  // sqrt 2 sqrt 5 - sqrt 10: s = 3 has r = sqrt 10.
  const PhaseField ten({numeric(1), numeric(2), numeric(3)});
  CHECK(zero(ten, ten.friction(0).r * ten.friction(1).r - ten.friction(2).r));
  CHECK(!zero(ten, ten.friction(0).r + ten.friction(1).r - ten.friction(2).r));
}

TEST_CASE("the coprime base is coprime and generates") {
  CHECK(rc::check("random integers", [] {
    std::vector<Integer> numbers;
    for (const int n : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 3000))) numbers.emplace_back(n);
    const std::vector<Integer> base = coprime_base(numbers);
    for (std::size_t a = 0; a < base.size(); ++a) {
      RC_ASSERT(base[a] > 1);
      for (std::size_t b = 0; b < a; ++b) RC_ASSERT(boost::multiprecision::gcd(base[a], base[b]) == 1);
    }
    for (Integer n : numbers) {
      for (const Integer& b : base) {
        while (n % b == 0) n /= b;
      }
      RC_ASSERT(n == 1);
    }
  }));
}

TEST_CASE("what is not of the field is refused, and so is a hidden division by zero") {
  const GiNaC::symbol s("s");
  const PhaseField field({s});
  const ex r = field.friction(0).r;
  CHECK_THROWS_AS(field.is_identically_zero(sin(s)), std::domain_error);
  CHECK_THROWS_AS(field.is_identically_zero(sqrt(ex(1) + s * s)), std::domain_error);
  CHECK_THROWS_AS(field.is_identically_zero(sqrt(ex(2))), std::domain_error);
  CHECK_THROWS_AS(field.is_identically_zero(s + numeric(0.5)), std::domain_error);
  CHECK_THROWS_AS(field.is_identically_zero(GiNaC::Pi * s), std::domain_error);
  CHECK_THROWS_AS(field.is_identically_zero(1 / (r * r - 1 - s * s)), std::domain_error);
  CHECK_THROWS_AS(PhaseField({s * s}), std::domain_error);
  CHECK_THROWS_AS(PhaseField({s, GiNaC::symbol("s")}), std::domain_error);
  const auto decision = field.is_identically_zero((s * s - 4) / (s - 2) - s - 2);
  CHECK(decision.holds);
  CHECK(decision.nonvanishing == std::set<std::string>{"s - 2"});
}

TEST_CASE("random identities are true, and almost true ones are not") {
  const GiNaC::symbol s("s"), t("t"), x("x");
  const std::vector<PhaseField> fields{PhaseField({s, t, -s}), PhaseField({numeric(1), numeric(7), numeric(1, 2)})};
  for (const PhaseField& field : fields) {
    CHECK(rc::check("(a+b)^2 - (a-b)^2 = 4ab, a/b b = a, canonical(a) = a", [&] {
      const ex a = *element(field, x, 3), b = *element(field, x, 2);
      RC_ASSERT(zero(field, GiNaC::pow(a + b, 2) - GiNaC::pow(a - b, 2) - 4 * a * b));
      RC_ASSERT(!zero(field, GiNaC::pow(a + b, 2) - GiNaC::pow(a - b, 2) - 4 * a * b + numeric(1, 1000000007)));
      RC_ASSERT(field.are_equal(field.canonical(a), a).holds);
      RC_PRE(!zero(field, b));
      RC_ASSERT(field.are_equal(a / b * b, a).holds);
      RC_ASSERT(!field.are_equal(a / b * b, a + field.friction(0).r).holds);
    }));
    CHECK(rc::check("equal elements have equal texts", [&] {
      const ex a = *element(field, x, 2), b = *element(field, x, 2), r = field.friction(0).r;
      RC_ASSERT(field.text(a + b * r * r) == field.text(a + b * (1 + GiNaC::pow(field.friction(0).s, 2))));
    }));
  }
}
