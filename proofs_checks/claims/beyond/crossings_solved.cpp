#include "proofs_checks/instruments/solutions/contact_laws.hpp"
#include "proofs_checks/instruments/solutions/falling_contacts.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::crossings_solved {
namespace {

struct TwoProfiles {
  ContactProblem one;
  ContactProblem other;
  int most;  ///< the largest number of crossings
  Method method;
};

std::string text_of(const TwoProfiles& c) {
  return proofs_checks::text_of(c.one) + " and " + proofs_checks::text_of(c.other) + ", " +
         std::string(name_of(c.method));
}

/// Returns a number between -largest and largest, at least a tenth of `largest` in modulus.
Rational change(Random& random, const Rational& largest) {
  const Rational size = largest * random.between(Rational(1, 10), 1);
  return random.below(2) == 0 ? size : Rational(-size);
}

/// Returns a problem under two loads: with a line, a parabola or a wedge added to the profile, or free to tilt.
enum class Change { line, parabola, wedge, tilt };
TwoProfiles changed(Random& random, std::size_t k, Change kind, int most) {
  const ContactProblem fixed = random_falling_contact(random, k);
  const Rational load = fixed.load() * random.between(Rational(1, 3), 3);
  const Rational slope = change(random, usual_slope(fixed));
  const Rational place = random.between(Rational(-1, 4), Rational(1, 4));
  switch (kind) {
    case Change::tilt: {
      const ContactProblem problem = with_load_at(fixed, place);
      return {problem, problem.with_load(load), most, method_of(k)};
    }
    case Change::wedge: {
      std::vector<Indenter::Piece> wedge{{place, Polynomial({slope * place, -slope})},
                                         {1, Polynomial({-slope * place, slope})}};
      const ContactProblem flat = fixed.with_indenter(Indenter(-1, {{1, Polynomial()}}));
      return {flat, flat.with_indenter(Indenter(-1, std::move(wedge))), most, method_of(k)};
    }
    default: {
      const Rational curve = kind == Change::parabola ? change(random, 4 * usual_slope(fixed)) : Rational(0);
      return {fixed, with_profile_plus(fixed.with_load(load), Polynomial({0, slope, curve})), most, method_of(k)};
    }
  }
}

CaseList<TwoProfiles> polynomials(const Context& context) {
  return random_cases(context, "crossings-solved", 120, 18, "random frictions, profiles, loads and differences",
                      [](Random& random, std::size_t k) {
                        constexpr std::array kinds{Change::line, Change::parabola, Change::tilt};
                        return changed(random, k, kinds[k % 3], k % 3 == 1 ? 2 : 1);
                      });
}

auto beyond(Change kind, int most) {
  return [=](const Context& context) {
    return random_cases(context, "crossings-solved, controls", 60, 20, "random frictions and profiles",
                        [&](Random& random, std::size_t k) { return changed(random, 2 * k, kind, most); });
  };
}

CaseList<TwoProfiles> tilting(const Context&) {
  const ContactProblem bumps = tilting_bumps();
  return {{{bumps, bumps.with_load(3 * bumps.load()), 0, Method::riemann_hilbert}}, "two bumps"};
}

}  // namespace

Claim claim() {
  return compared<TwoProfiles>("crossings-solved")
      .cases(polynomials)
      .precision(Precision::in_double)
      .measured([](const TwoProfiles& c) {
        return values_of(compared_by(
            c.method, c.one, c.other,
            [&](const SolvedContact& one, const SolvedContact& other) { return crossing_law(one, other, c.most); }));
      })
      .predicted([](const TwoProfiles&) -> Values {
        return {{"crossings", 0.0}};
      })
      .wrong_beyond("one crossing for profiles that differ by a parabola", beyond(Change::parabola, 1))
      .wrong_beyond("no crossing for an indenter that may tilt", tilting)
      .wrong_beyond("one crossing for profiles that differ by a wedge", beyond(Change::wedge, 1))
      .wrong("near miss: one crossing fewer", replaced({{"crossings", -1.0}}));
}

}  // namespace steadyslide::proofs_checks::crossings_solved
