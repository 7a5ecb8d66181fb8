// phi and the indicator of K_0' are conjugate. [Bal16, (16)]

#include <algorithm>
#include <optional>

#include "proofs_checks/claims/section_3/functional_parts.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/contact_forces.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// phi*(-t_hat) = -<<psi, t_hat>>, infinite unless t_hat in K_0'.
struct ConjugateSaid {
  int profile = -1;  ///< the sign of <<psi, t_hat>>
  enum class Finite { contact_forces, always, reversed } finite = Finite::contact_forces;
  bool only_load = false;  ///< finite only where t_hat >= 0 too
  Rational moved;
};

std::optional<Rational> conjugate(const ContactForces& c, const std::vector<Rational>& psi, const ConjugateSaid& said) {
  using Finite = ConjugateSaid::Finite;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (said.finite == Finite::contact_forces && c.force(i) < 0) return std::nullopt;
    if (said.finite == Finite::reversed && c.force(i) > 0) return std::nullopt;
    if (said.only_load && c.q[i] < 0) return std::nullopt;
  }
  return said.profile * dot(psi, c.q) * (1 + said.moved);
}

/// max of <<-t_hat, u_hat>> - phi(u_hat) over u_hat = psi + w, 0 <= w_i <= size: concave, and linear on every simplex
/// of ordered w, whose corners are indicators.
Rational largest(const ContactForces& c, const std::vector<Rational>& psi, const Rational& size) {
  std::optional<Rational> most;
  for (unsigned bits = 0; bits < 1U << c.size(); ++bits) {
    const std::vector<Rational> w = indicator(c.size(), bits, size);
    const Rational value = -dot(c.q, psi) - dot(c.q, w) - phi_on_nodes(c, w);
    if (!most || value > *most) most = value;
  }
  return *most;
}

std::vector<Evidence> check(const Context& context, const ConjugateSaid& said) {
  return gather([&] {
    Random random(context.seed, "eq-16-conjugate");
    Findings findings;
    const std::vector<Rational> steps{1, Rational(1, 1000), parse_rational("1e-60")};
    for (std::size_t k = 0; k < (context.quick ? 30 : 300); ++k) {
      const ContactForces c = random_forces(random, k % 2 == 0 ? k % 4 : 5, steps[k / 4 % steps.size()]);
      std::vector<Rational> psi;
      for (std::size_t i = 0; i < c.size(); ++i) psi.push_back(random.between(-2, 2));
      findings.begin_case("pair " + std::to_string(k));
      const std::optional<Rational> told = conjugate(c, psi, said);
      const Rational near = largest(c, psi, 1);
      const Rational far = largest(c, psi, 1000);
      findings.decide("the supremum is finite where (16) says so", (near == far) == told.has_value());
      if (told) {
        findings.decide("the supremum of <<-t_hat, u_hat>> - phi(u_hat) is -<<psi, t_hat>>", near == *told);
      } else {
        // Already there for w = 0, and growing with the box.
        const Rational base = -dot(c.q, psi);
        findings.decide("outside K_0' it grows with the size of u_hat", far - base == 1000 * (near - base));
      }
      // Back again: phi(u_hat) = sup <<-t_hat, u_hat>> - phi*(-t_hat), linear in t_hat on the simplex K_0', at a
      // corner.
      std::optional<Rational> back;
      for (std::size_t j = 0; j < c.size(); ++j) {
        ContactForces corner = c;
        for (std::size_t i = 0; i < c.size(); ++i) corner.q[i] = c.load * (c.tau[i] - (i == j ? 1 : 0));
        std::vector<Rational> u = c.v;
        for (std::size_t i = 0; i < c.size(); ++i) u[i] += psi[i];
        const std::optional<Rational> there = conjugate(corner, psi, said);
        if (!there) continue;
        const Rational value = -dot(corner.q, u) - *there;
        if (!back || value > *back) back = value;
      }
      findings.decide("phi is the conjugate of its conjugate", back && *back == phi_on_nodes(c, c.v));
    }
    return findings.evidence("");
  });
}

}  // namespace

Claim conjugate_functional_claim() {
  using S = ConjugateSaid;
  return make_claim(claim_text("eq-16-conjugate"), check, S(),
                    std::vector<Wrong<S>>{
                        {"+<<psi, t_hat>>", changed<S>([](S& said) { said.profile = 1; })},
                        {"without <<psi, t_hat>>", changed<S>([](S& said) { said.profile = 0; })},
                        {"without the indicator of K_0'", changed<S>([](S& said) { said.finite = S::Finite::always; })},
                        {"t_hat >= P t_0 in K_0'", changed<S>([](S& said) { said.finite = S::Finite::reversed; })},
                        {"t_hat >= 0 in K_0' as well", changed<S>([](S& said) { said.only_load = true; })},
                        {"near miss: <<psi, t_hat>> moved by 1e-60",
                         changed<S>([](S& said) { said.moved = parse_rational("1e-60"); })}});
}

}  // namespace steadyslide::proofs_checks
