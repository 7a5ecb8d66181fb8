#include <optional>

#include "proofs_checks/instruments/operators/contact_forces.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_16_conjugate {
namespace {

struct Pair {
  std::size_t number;
  ContactForces forces;
  std::vector<Rational> psi;
};

std::string text_of(const Pair& pair) { return "pair " + std::to_string(pair.number); }

CaseList<Pair> pairs(const Context& context) {
  const std::vector<Rational> steps{1, Rational(1, 1000), parse_rational("1e-60")};
  const auto make = [&](Random& random, std::size_t k) {
    Pair pair{k, random_forces(random, k % 2 == 0 ? k % 4 : 5, steps[k / 4 % steps.size()]), {}};
    for (std::size_t i = 0; i < pair.forces.size(); ++i) pair.psi.push_back(random.between(-2, 2));
    return pair;
  };
  return random_cases(context, "eq-16-conjugate", 300, 30, "random forces on nodes", make);
}

/// The conjugate phi^*(-t_hat), where t_hat is the q of the forces; nothing if it is infinite.
using Conjugate = std::function<std::optional<Rational>(const ContactForces&, const std::vector<Rational>& psi)>;

/// Returns the conjugate that is -<<psi, t_hat>> times a factor on the set K, and infinite elsewhere.
Conjugate pairing_on(bool (*contains)(const ContactForces&), const Rational& factor = 1) {
  return [=](const ContactForces& c, const std::vector<Rational>& psi) -> std::optional<Rational> {
    if (!contains(c)) return std::nullopt;
    return -factor * dot(psi, c.q);
  };
}

/// Returns the maximum of <<-t_hat, u_hat>> - phi(u_hat) over u_hat = psi + w, 0 <= w_i <= size. The function is
/// concave, and linear on every simplex of ordered w, whose corners are indicators.
Rational largest(const ContactForces& c, const std::vector<Rational>& psi, const Rational& size) {
  std::optional<Rational> most;
  for (unsigned bits = 0; bits < 1U << c.size(); ++bits) {
    const std::vector<Rational> w = indicator(c.size(), bits, size);
    const Rational value = -dot(c.q, psi) - dot(c.q, w) - phi_on_nodes(c, w);
    if (!most || value > *most) most = value;
  }
  return *most;
}

/// Returns sup <<-t_hat, u_hat>> - phi^*(-t_hat). It is linear in t_hat on the simplex K_0', so the maximum lies at a
/// corner.
std::optional<Rational> conjugate_of(const Conjugate& conjugate, const Pair& pair) {
  const auto& [number, c, psi] = pair;
  std::vector<Rational> u = c.v;
  for (std::size_t i = 0; i < c.size(); ++i) u[i] += psi[i];
  std::optional<Rational> most;
  for (std::size_t j = 0; j < c.size(); ++j) {
    ContactForces corner = c;
    for (std::size_t i = 0; i < c.size(); ++i) corner.q[i] = c.load * (c.tau[i] - (i == j ? 1 : 0));
    const std::optional<Rational> there = conjugate(corner, psi);
    if (!there) continue;
    const Rational value = -dot(corner.q, u) - *there;
    if (!most || value > *most) most = value;
  }
  return most;
}

void check(Findings& findings, const Conjugate& conjugate, const Pair& pair) {
  const auto& [number, c, psi] = pair;
  const std::optional<Rational> told = conjugate(c, psi);
  const Rational near = largest(c, psi, 1);
  const Rational far = largest(c, psi, 1000);
  findings.decide("the supremum is finite where (16) says so", (near == far) == told.has_value());
  if (told) {
    findings.decide("the supremum of `<<-t_hat, u_hat>> - phi(u_hat)` is `-<<psi, t_hat>>`", near == *told);
  } else {
    // The value at w = 0; the rest grows with the box.
    const Rational base = -dot(c.q, psi);
    findings.decide("outside `K_0'` it grows with the size of `u_hat`", far - base == 1000 * (near - base));
  }
  findings.decide("`phi` is the conjugate of its conjugate", conjugate_of(conjugate, pair) == phi_on_nodes(c, c.v));
}

}  // namespace

Claim claim() {
  const auto admissible = [](const ContactForces& c) { return c.is_admissible(); };
  const auto times = [=](const Rational& factor) {
    return [=](Conjugate& conjugate) { conjugate = pairing_on(admissible, factor); };
  };
  const auto on = [](auto contains) { return [=](Conjugate& conjugate) { conjugate = pairing_on(contains); }; };
  return formula_claim<Pair, Conjugate>("eq-16-conjugate")
      .cases(pairs)
      .says([=](const Pair&) { return pairing_on(admissible); })
      .checked(check)
      .wrong("+<<psi, t_hat>>", times(-1))
      .wrong("without <<psi, t_hat>>", times(0))
      .wrong("without the indicator of `K_0'`", on([](const ContactForces&) { return true; }))
      .wrong("`t_hat >= P t_0` in `K_0'`",
             on([](const ContactForces& c) { return c.all_nodes([&](std::size_t i) { return c.force(i) <= 0; }); }))
      .wrong("`t_hat >= 0` in `K_0'` as well", on([](const ContactForces& c) {
               return c.is_admissible() && c.all_nodes([&](std::size_t i) { return c.q[i] >= 0; });
             }))
      .wrong("near miss: `<<psi, t_hat>>` moved by `1e-60`", times(1 + parse_rational("1e-60")));
}

}  // namespace steadyslide::proofs_checks::eq_16_conjugate
