// Laws of the Riemann-Hilbert form on contact sets of every kind, right or wrong.

#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/traction_representation.hpp"
#include "support/solved_contact.hpp"

namespace {

using R = double;

/// Three pieces on [-2, 2] with wedges at -1/2 and 1, a step up at 1, jumps at -1/2, 0, 3/2.
ContactProblem some_problem() {
  const Polynomial a({1, Rational(-1, 3), 1});
  const Polynomial b = a + Polynomial({0.5_r, 1}) * Polynomial({0.25_r, 0, 0.2_r});
  const Polynomial c = b + Polynomial({0.1_r}) + Polynomial({-1, 1});
  return reduced({0.3_r, 2, 0.5_r, 0}, {-0.5_r, 0, 1.5_r}, Indenter(-2, {{-0.5_r, a}, {1, b}, {2, c}}), Rational(7, 3));
}

/// One to three components, with edges at allowed places, free ends anywhere, and any q and tilt.
TractionRepresentation<R> random_form(const RoundedProblem<R>& problem, JacobiRules<R>& rules) {
  ContactSet<R> set(problem, {{-1.3, 1.7, uniform(0, 1) == 0, uniform(0, 1) == 0}});
  const auto inside = [&] {
    for (;;) {
      const auto k = static_cast<std::size_t>(uniform(0, static_cast<int>(set.segments()) - 1));
      if (set.in_contact(k)) return k;
    }
  };
  for (int gaps = uniform(0, 2); gaps > 0; --gaps) {
    const std::size_t k = inside();
    const R a = R(uniform(1, 49)) / 100, b = R(uniform(51, 99)) / 100;
    const R& length = set.length(k);
    set.open({k, a * length, (1 - a) * length}, {k, b * length, (1 - b) * length});
  }
  std::vector<R> q = ContactState<R>::initial(problem, set, R(0)).q;
  for (std::size_t k = 0; k + 1 < q.size(); ++k) q[k] = R(uniform(-100, 100)) / 30;
  return {problem, std::move(set), std::move(q), R(uniform(-100, 100)) / 100, rules};
}

SurfacePoint<R> point(const ContactSet<R>& set, std::size_t segment, const R& part) {
  return beside(set, segment, Side::right, R(part * set.length(segment)));
}

std::vector<SurfacePoint<R>> beyond_support(const ContactSet<R>& set, const R& d) {
  return {beside(set, 0, Side::left, d), beside(set, set.segments(), Side::right, d)};
}

template <class Law>
void check_on_random_forms(const char* name, const Law& law) {
  const ContactProblem p = some_problem();
  const RoundedProblem<R> problem(p, {0, 1});
  JacobiRules<R> rules;
  CHECK(rc::check(name, [&] { law(random_form(problem, rules)); }));
}

}  // namespace

TEST_CASE("eps is the sign of (s + i) cos(pi alpha) Y+, and off the contact that of Y") {
  check_on_random_forms("signs", [](const TractionRepresentation<R>& form) {
    const ContactSet<R>& set = form.set();
    int degree = 0;
    for (const auto& end : set.points()) degree += end.is_free() ? 1 : 0;
    RC_ASSERT(form.degree_at_infinity() == degree - static_cast<int>(set.components()));
    for (std::size_t k = 0; k < set.segments(); ++k) {
      const auto at = point(set, k, R(R(uniform(1, 99)) / 100));
      const Complex<R> y = form.fundamental_solution().boundary(k, at.node, BoundaryLimit::plus);
      const R modulus = form.modulus(at);
      // (s + i)(re + i im) on the contact.
      const bool contact = set.in_contact(k);
      const R s = contact ? form.problem().s(form.friction_at(k)) : R(0);
      const R cosine = contact ? form.problem().cos_alpha(form.friction_at(k)) : R(1);
      const R real = contact ? R(cosine * (s * y.re - y.im)) : y.re;
      const R imaginary = contact ? R(cosine * (s * y.im + y.re)) : y.im;
      RC_ASSERT(size_of(R(real - form.sign(at.segment) * modulus)) <= 100 * epsilon<R>() * modulus);
      RC_ASSERT(size_of(imaginary) <= 100 * epsilon<R>() * modulus);
    }
    for (const auto& at : beyond_support(set, R(0.75))) {
      const R height = 1e-10;
      const Complex<R> y = form.fundamental_solution().at({at.node.x, height});
      RC_ASSERT(size_of(R(y.re - form.sign(at.segment) * form.modulus(at))) <= 1e-8 * form.modulus(at));
    }
  });
}

TEST_CASE("u' = g_k + tilt - Y B_k off the contact is the same for every k") {
  const R tolerance = 2000 * epsilon<R>();
  check_on_random_forms("brackets", [&](const TractionRepresentation<R>& form) {
    const RoundedProblem<R>& problem = form.problem();
    const ContactSet<R>& set = form.set();
    std::vector<SurfacePoint<R>> all = beyond_support(set, R(R(uniform(1, 100)) / 50));
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (!set.in_contact(k)) all.push_back(point(set, k, R(R(uniform(1, 99)) / 100)));
    }
    for (const auto& at : all) {
      const R expected = form.surface_slope(at).value, y = form.sign(at.segment) * form.modulus(at);
      for (std::size_t slope = 0; slope < problem.slopes().size(); ++slope) {
        const Estimate<R> b = form.regular_factor(slope, at);
        const R found = problem.slope(slope, at.node.x) + form.tilt() - y * b.value;
        RC_ASSERT(size_of(R(found - expected)) <=
                  tolerance * (1 + size_of(expected)) + 8 * size_of(y) * (b.error + tolerance * size_of(b.value)));
      }
    }
  });
}

TEST_CASE("loads of segments and openings of gaps against unrelated quadratures") {
  check_on_random_forms("quadratures", [](const TractionRepresentation<R>& form) {
    const ContactSet<double>& set = form.set();
    const auto density = traction_density(form);
    const auto check = check_of(form);
    std::size_t panel = 0;
    double size = 0;
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (!set.in_contact(k)) continue;
      const double expected = tanh_sinh::panel_integral(density[panel++]).value;
      size += std::abs(expected);
      if (form.changes_polynomial(k) || form.changes_polynomial(k + 1)) continue;
      RC_ASSERT(std::abs(form.load_on(k).value - expected) <= 1e-11 * (1 + std::abs(expected)));
    }
    // Only a form without divergent moments is the Cauchy integral of its traction.
    if (form.degree_at_infinity() > 0) return;
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (set.in_contact(k)) continue;
      const auto at = point(set, k, uniform(1, 99) / 100.);
      from_ends_of_gap(form, check, at, [&](std::size_t j, End, double surface) {
        const GapIntegral<double> gap(form, j);
        const double expected = gap.profile_increment(at) - surface;
        RC_ASSERT(std::abs(gap.reduced_gap(at).value - expected) <= 1e-10 * (1 + size + std::abs(expected)));
      });
    }
  });
}

TEST_CASE("the traction next to ends, jumps and wedges is that of the same form with 50 digits") {
  const ContactProblem p = some_problem();
  const RoundedProblem<Real50> fine_problem(p, {0, 1});
  JacobiRules<Real50> fine_rules;
  check_on_random_forms("near", [&](const TractionRepresentation<R>& form) {
    const TractionRepresentation<Real50> fine(fine_problem, ContactSet<Real50>::converted(fine_problem, form.set()),
                                              {form.q().begin(), form.q().end()}, form.tilt(), fine_rules);
    const ContactSet<double>& set = form.set();
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (!set.in_contact(k)) continue;
      for (const Side side : {Side::left, Side::right}) {
        const double d = set.length(k) * std::pow(10., -uniform(4, 1000) / 10.);
        const auto at = [&]<class R>(const ContactSet<R>& s) {
          return beside(s, side == Side::left ? k : k + 1, opposite(side), R(d));
        };
        const Estimate<double> t = form.traction(at(set));
        const auto expected = static_cast<double>(fine.traction(at(fine.set())).value);
        // At a sign change of B only rounding errors remain; everywhere else the error is a few units.
        RC_ASSERT(std::abs(t.value - expected) <= std::max(4 * t.error, 1e-14 * std::abs(expected)));
        RC_ASSERT(t.error <= 1e-8 * std::abs(expected) + 1e-10);
      }
    }
  });
}
