#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rem_01_front_rear {
namespace {

/// A contact with given friction coefficients at its ends. If they differ, there is one friction jump between them.
struct SlidingContact {
  Rational gamma;  ///< given directly, because gamma does not vanish for a rigid indenter
  Rational f_rear;
  Rational f_front;
  std::optional<Polynomial> profile = std::nullopt;  ///< if absent, only the exponents are compared
  Sliding direction = Sliding::plus_x;

  bool has_jump() const { return f_rear != f_front; }
  bool is_flat() const { return profile->degree() < 1; }
  bool rear_is_left() const { return direction == Sliding::plus_x; }
  ContactProblem problem() const {
    const auto friction = !has_jump()      ? FrictionProfile({f_rear})
                          : rear_is_left() ? FrictionProfile({f_rear, f_front}, {Rational(-1, 8)})
                                           : FrictionProfile({f_front, f_rear}, {Rational(-1, 8)});
    return {Elasticity::reduced(gamma), friction, Indenter(-1, {{1, profile.value_or(Polynomial())}}), 1, direction};
  }
};

std::string text_of(const SlidingContact& c) {
  return (!c.profile    ? ""
          : c.is_flat() ? "flat punch, "
                        : "parabola, ") +
         ("gamma = " + to_string(c.gamma)) + ", f = " + to_string(c.f_rear) +
         (c.has_jump() ? " and " + to_string(c.f_front) : "") + (c.rear_is_left() ? "" : ", towards -x");
}

CaseList<SlidingContact> contacts(const Context& context) {
  const Rational gamma(2, 7);
  const Polynomial flat;
  const Polynomial parabola({0, 0, 1});
  std::vector<SlidingContact> all{{gamma, Rational(3, 2), Rational(3, 2), flat},
                                  {0, Rational(3, 2), Rational(3, 2), flat},
                                  {gamma, 0, 0, flat},
                                  {gamma, Rational(1, 2), 3, parabola},
                                  {0, Rational(1, 2), 3, parabola},
                                  {gamma, Rational(1, 2), 3, flat, Sliding::minus_x}};
  if (!context.quick) {
    all.insert(all.end(), {{gamma, 2, 2, parabola}, {0, 2, 2, parabola}, {-gamma, 2, 2, flat}});
  }
  const std::size_t solved = all.size();
  Random random(context.seed, "rem-01-front-rear");
  const std::size_t count = context.quick ? 10 : 100;
  for (std::size_t k = 0; k < count; ++k) {
    const Rational any_gamma = random.between(-1, 1);
    const Rational f = random.friction(50);
    const Sliding direction = k % 2 == 0 ? Sliding::minus_x : Sliding::plus_x;
    all.push_back({any_gamma, f, random.friction(50), {}, direction});
  }
  return {all, std::to_string(solved) + " solved problems and their powers, " + std::to_string(count) +
                   " random exponents with seed " + std::to_string(context.seed)};
}

/// Returns the measurements, with s from the model's problem.
template <Real R>
Values measured(const SlidingContact& c) {
  const ContactProblem problem = c.problem();
  const Rational s_left = problem.coupled_friction(0);
  const Rational s_right = problem.coupled_friction(problem.friction().values().size() - 1);
  const Rational& rear_s = c.rear_is_left() ? s_left : s_right;
  const End rear = c.rear_is_left() ? End::left : End::right;
  const End front = c.rear_is_left() ? End::right : End::left;
  const Exponent edges = edge_exponent(front, rear_s) - edge_exponent(rear, rear_s);
  const Exponent frees = free_exponent(front, rear_s) - free_exponent(rear, rear_s);
  const Exponent beta = jump_exponent(s_left, s_right);
  Values values{{"edges", edges},
                {"free ends", frees},
                {"ends differ", edges.sign() != 0},
                {"rear is stronger", edges.sign() > 0},
                {"jump is singular", beta.sign() != 0}};
  if (!c.profile) return values;
  const EndTraction power = c.is_flat() ? EndTraction::unbounded : EndTraction::vanishing;
  const R left_to_right =
      end_power<R>(Side::left, power, to_real<R>(s_right)) - end_power<R>(Side::right, power, to_real<R>(s_left));
  values.add({"ends", c.rear_is_left() ? left_to_right : R(-left_to_right)});
  if (c.has_jump()) values.add({"jump", jump_power<R>(to_real<R>(s_left), to_real<R>(s_right)).power});
  values.add({"equation", equation_error(problem)});
  return values;
}

/// Returns the predictions from alpha(gamma f) at the rear and at the front, for both directions of sliding.
Values predicted(const SlidingContact& c) {
  const Exponent rear = Exponent::angle(c.gamma * c.f_rear);
  const Exponent front = Exponent::angle(c.gamma * c.f_front);
  Values values{{"edges", rear + rear},
                {"free ends", rear + rear},
                {"ends differ", c.gamma * c.f_rear != 0},
                {"rear is stronger", c.gamma * c.f_rear > 0},
                {"jump is singular", c.gamma != 0 && c.has_jump()}};
  if (!c.profile) return values;
  values.add({"ends", to_real<Number>(rear + front)});
  if (c.has_jump()) values.add({"jump", to_real<Number>(rear - front)});
  values.add({"equation", Number(0)});
  return values;
}

}  // namespace

Claim claim() {
  return compared<SlidingContact>("rem-01-front-rear")
      .cases(contacts)
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const SlidingContact& c) { return measured<R>(c); })
      .predicted(predicted)
      .wrong("they differ whenever there is friction, `gamma = 0` included",
             [](Values& p, const SlidingContact& c) {
               p.set({{"ends differ", c.f_rear != 0}, {"jump is singular", c.has_jump()}});
             })
      .wrong("they differ without friction",
             [](Values& p, const SlidingContact& c) {
               p.set({{"ends differ", c.gamma != 0}, {"jump is singular", c.gamma != 0}});
             })
      .wrong("they never differ", replaced({{"ends differ", false}, {"jump is singular", false}}))
      .wrong("the front is the stronger one for `gamma f > 0`",
             [](Values& p, const SlidingContact& c) { p.set("rear is stronger", c.gamma * c.f_rear < 0); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rem_01_front_rear
