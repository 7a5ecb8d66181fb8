#include "proofs_checks/instruments/identities/derived.hpp"
#include "proofs_checks/instruments/identities/gamma_range.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "symbolic/cln/cln_evaluation.hpp"

namespace steadyslide::proofs_checks::alpha_range {
namespace {

struct RigidContact {
  Rational nu;
  Rational f;

  Rational gamma() const { return Elasticity(Solid(nu, 1)).gamma(); }
};

std::string text_of(const RigidContact& c) { return "nu = " + to_string(c.nu) + ", f = " + to_string(c.f); }

CaseList<RigidContact> contacts(const Context& context) {
  CaseList<RigidContact> list{
      {}, "29 values of `nu` and random ones, random `f`, with seed " + std::to_string(context.seed)};
  Random random(context.seed, "alpha, friction");
  for (const Rational& nu : poisson_ratios(context, "alpha")) {
    const std::size_t k = list.cases.size();
    list.cases.push_back({nu, k % 10 == 9 ? Rational(0) : random.between(0, k % 2 == 0 ? 2 : 50)});
  }
  return list;
}

/// alpha as an exact number, and the interval [0, supremum[ of its values.
struct Angle {
  bool coupled = true;  ///< angle of gamma f; if false, of f
  int times = 1;        ///< factor: -1, 1 or 2
  Exponent moved;       ///< a near miss adds this
  Exponent supremum = half;

  Exponent of(const Rational& gamma, const Rational& f) const {
    const Exponent angle = Exponent::angle(coupled ? Rational(gamma * f) : f);
    return moved + (times == 2 ? angle + angle : times == 1 ? angle : -angle);
  }
};

}  // namespace

Claim claim() {
  return formula_claim<RigidContact, Angle>("alpha-range")
      .cases(contacts)
      .effective_where([](const RigidContact& c) { return c.f != 0; })
      .checked([]<Real R>(Findings& findings, const Angle& angle, const RigidContact& c) {
        using std::abs, std::cos;
        const Rational gamma = c.gamma();
        const Exponent alpha = angle.of(gamma, c.f);
        findings.decide("`alpha >= 0`, and `alpha = 0` only for `f = 0`", alpha.sign() == (c.f == 0 ? 0 : 1));
        findings.decide("`alpha` lies below the upper end", (angle.supremum - alpha).sign() > 0);
        findings.decide("`alpha` increases with `f`", (angle.of(gamma, c.f + tiny()) - alpha).sign() > 0);
        const Exponent gap = angle.supremum - angle.of(gamma, 1 / (gamma * tiny()));
        findings.decide("`alpha` comes within `1e-94` of the upper end",
                        gap.sign() > 0 && (Exponent::angle(tiny()) - gap).sign() >= 0);
        const R value = to_real<R>(alpha);
        const auto cln = symbolic::cln_alpha(c.nu, c.f, Plane::strain, numeric::digits_served<R> + 5);
        findings.compare<R>("by cln", value, to_real<R>(cln.value));
        // For large f the cosine is small, and its relative error is correspondingly large.
        const R root = cos_pi_alpha<R>(gamma * c.f);
        findings.compare("cosine", R(abs(cos(R(numeric::pi<R>() * value)) - root)));
      })
      .wrong("the interval [0, 1/4[", &Angle::supremum, Exponent(Rational(1, 4)))
      .wrong("the interval [0, 1[", &Angle::supremum, Exponent(1))
      .wrong("`alpha = arctan(f)/pi`, `gamma` missing", &Angle::coupled, false)
      .wrong("`alpha = -arctan(gamma f)/pi`", &Angle::times, -1)
      .wrong("`alpha = 2 arctan(gamma f)/pi`", &Angle::times, 2)
      .wrong("near miss: `alpha` moved by `1e-94`", &Angle::moved, Exponent::angle(tiny()));
}

}  // namespace steadyslide::proofs_checks::alpha_range
