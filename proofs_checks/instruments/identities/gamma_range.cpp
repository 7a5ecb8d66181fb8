#include "proofs_checks/instruments/identities/gamma_range.hpp"

#include "proofs_checks/instruments/identities/derived.hpp"

namespace steadyslide::proofs_checks {
namespace {

using Where = PoissonRatio::Where;

CaseList<PoissonRatio> all_ratios(const Context& context) {
  // The ends of the interval are approached within this step, so that no smaller interval agrees.
  const Rational step = tiny() / 100;
  std::vector<PoissonRatio> all{{Rational(-1) + step, Where::next_to_minus_one},
                                {Rational(1, 2) - step, Where::next_to_one_half}};
  for (const Rational& nu : poisson_ratios(context, "range")) all.push_back({nu});
  return {std::move(all), "29 values of `nu` and random ones with seed " + std::to_string(context.seed)};
}

/// Adds the end of the interval that belongs to a Poisson's ratio close to -1 or to 1/2.
void add_end(Values& values, Where where, const Rational& at_minus_one, const Rational& at_one_half) {
  if (where == Where::next_to_minus_one) values.add({"supremum", to_real<Number>(at_minus_one)});
  if (where == Where::next_to_one_half) values.add({"infimum", to_real<Number>(at_one_half)});
}

}  // namespace

std::string text_of(const PoissonRatio& c) {
  switch (c.where) {
    case Where::next_to_minus_one: return "nu -> -1";
    case Where::next_to_one_half: return "nu -> 1/2";
    default: return "nu = " + to_string(c.nu);
  }
}

std::vector<Rational> poisson_ratios(const Context& context, std::string_view stream) {
  std::vector<Rational> ratios;
  for (int k = -19; k < 10; ++k) ratios.emplace_back(k, 20);
  Random random(context.seed, stream);
  for (int k = 0; k < (context.quick ? 20 : 200); ++k) ratios.push_back(random.poisson());
  return ratios;
}

ComparedClaim<PoissonRatio> gamma_claim(std::string id, Plane plane, GammaFormula gamma, const Rational& infimum,
                                        const Rational& supremum) {
  return compared<PoissonRatio>(std::move(id))
      .cases(all_ratios)
      .measured([plane](const PoissonRatio& c) {
        const auto at = [&](const Rational& nu) { return Elasticity(Solid(nu, 1), plane).gamma(); };
        const Rational further = c.nu + (Rational(1, 2) - c.nu) / 1000;
        Values values{{"gamma", at(c.nu)}, {"decreases", at(further) < at(c.nu)}};
        add_end(values, c.where, at(c.nu), at(c.nu));
        return values;
      })
      .predicted([gamma = std::move(gamma), infimum, supremum](const PoissonRatio& c) {
        Values values{{"gamma", gamma(c.nu)}, {"decreases", true}};
        add_end(values, c.where, supremum, infimum);
        return values;
      });
}

std::function<void(Values&, const PoissonRatio&)> with_gamma(GammaFormula gamma) {
  return [gamma = std::move(gamma)](Values& p, const PoissonRatio& c) { p.set("gamma", gamma(c.nu)); };
}

std::function<void(Values&, const PoissonRatio&)> with_range(const Rational& infimum, const Rational& supremum) {
  return [infimum, supremum](Values& p, const PoissonRatio& c) {
    if (c.where == Where::next_to_minus_one) p["supremum"] = to_real<Number>(supremum);
    if (c.where == Where::next_to_one_half) p["infimum"] = to_real<Number>(infimum);
  };
}

}  // namespace steadyslide::proofs_checks
