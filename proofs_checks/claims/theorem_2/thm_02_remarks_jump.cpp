// The second sentence in words after theorem 2: a friction jump without a wedge. [Bal16, theorem 2]

#include "numeric/cauchy/residuals.hpp"
#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_02_remarks_jump {
namespace {

struct JumpCase {
  enum class Examined { solved, touch, on_cells };

  std::string name;
  ContactProblem problem;
  Rational place = corner;
  Examined examined = Examined::solved;
  std::optional<ContactProblem> other = {};  ///< a problem with the same data close to the jump

  std::size_t piece(Side side) const { return problem.friction().piece(place, side); }
  Rational s(Side side) const { return s_of(problem, piece(side)); }
  bool rises() const { return s(Side::right) > s(Side::left); }
};
using Examined = JumpCase::Examined;

JumpCase on_cells(const std::string& name) {
  const ContactProblem problem = cell_case(name);
  return {name + ", on cells", problem, problem.friction().jumps().front(), Examined::on_cells};
}

CaseList<JumpCase> jumps(const Context& context) {
  const Rational low(1, 3);
  const Polynomial parabola({0, 0, 1});
  const Polynomial tilted({0, Rational(1, 4), 1});
  const FrictionProfile rise({low, 3}, {corner});
  const FrictionProfile fall({3, low}, {corner});
  const ContactProblem punch_on_three =
      punch(Rational(-9, 10), {Rational(1, 5), 2, Rational(1, 2)}, {Rational(-1, 3), Rational(1, 2)});
  const ContactProblem twice_the_load = flanks(rise, parabola, parabola, 12);
  return first_when_quick<JumpCase>(
      context,
      {{"parabola, f rises", flanks(rise, parabola, parabola, 6), corner, Examined::solved, twice_the_load},
       {"parabola, f rises, twice the load", twice_the_load},
       {"parabola, f falls", flanks(fall, parabola, parabola, 6)},
       {"f rises, theta = 0", punch(Rational(3, 10), {low, 3}, {Rational(1, 4)}), Rational(1, 4), Examined::touch},
       {"turned parabola, f rises", flanks(FrictionProfile({0, 2}, {corner}), tilted, tilted, 6)},
       {"flat punch, f rises, then falls: the rise", punch_on_three, Rational(-1, 3)},
       {"flat punch, f rises, then falls: the fall", punch_on_three, Rational(1, 2)},
       {"the curvature jumps as well, f falls", flanks(fall, parabola, Polynomial({0, 0, 2}), 6)},
       on_cells("jump-up"),
       on_cells("jump-down")},
      4, "problems");
}

template <Real R>
R theta_of(const ContactProblem& problem, const Rational& place) {
  for (const auto& point : solve<R>(problem)->singular_points()) {
    if (point.x.value == to_real<R>(place)) return point.intensity.value;
  }
  throw Refutation{{"x = " + to_string(place), "no singular point"}};
}

template <Real R>
Values solved_values(const JumpCase& c) {
  const R theta = theta_of<R>(c.problem, c.place);
  const auto s = [&c](Side side) { return to_real<R>(c.problem.coupled_friction(c.piece(side))); };
  const R power = jump_power<R>(s(Side::left), s(Side::right)).power;
  Values values{
      {"power", power}, {"unbounded", power < 0}, {"equation", equation_error(c.problem)}, {"theta", theta > 0}};
  if (c.other) values.add({"other theta", relative_difference<R>(theta, theta_of<R>(*c.other, c.place)) > 0.01});
  return values;
}

/// Returns the check of a punch with the pressure cos(pi alpha) |Y| (x-c)^2, for f that rises at c. A t is linear
/// there.
template <Real R>
Values touch(const JumpCase& touching) {
  const ContactProblem& problem = touching.problem;
  const Rational& c = touching.place;
  PowerProduct product = punch_traction(problem);
  product.scale(numeric::pi<Number>());
  const PowerForm<R> form = product.at<R>();
  // The polynomial part of -Y (z-c)^2 at infinity, Y = z^-1 (1 - sum p_j e_j/z + ...).
  R moment = 0;
  for (std::size_t j = 0; j < 3; ++j) moment += form.powers[j].value * form.points()[j];
  const R place = to_real<R>(c);
  PiecewiseDensity<R> density = form.traction().density();
  for (std::size_t k = 0; k < 2; ++k) {
    density[k].smooth = [smooth = density[k].smooth, k](const Node<R>& node) {
      const R d = k == 0 ? node.from_right : node.from_left;
      return R(smooth(node) * d * d);
    };
  }
  const auto& right = density[1];
  const R t = right(right.panel.node_from_left(asymptotic_distance<R>()));
  const R halfway = right(right.panel.node_from_left(R(right.panel.length / 2)));
  const numeric::SurfaceCheck<R> check(
      density, {to_real<R>(problem.coupled_friction(0)), to_real<R>(problem.coupled_friction(1))},
      [=](std::size_t, const Node<R>& node) { return R(-(node.x - moment - 2 * place)); });
  return {{"touch", check.equation()}, {"vanishes", t / halfway < 1}};
}

/// Returns the predictions with alpha = arctan(s/gamma)/pi.
Values predicted(const JumpCase& c, const Rational& gamma = 1) {
  if (c.examined == Examined::touch) return {{"touch", Number(0)}, {"vanishes", true}};
  const auto beta =
      to_real<Number>(Exponent::angle(c.s(Side::left) / gamma) - Exponent::angle(c.s(Side::right) / gamma));
  if (c.examined == Examined::on_cells) return {{"left cells", beta}, {"right cells", beta}, {"error bar", Number(0)}};
  Values values{{"power", beta}, {"unbounded", c.rises()}, {"equation", Number(0)}, {"theta", true}};
  if (c.other) values.add({"other theta", true});
  return values;
}

}  // namespace

Claim claim() {
  return compared<JumpCase>("thm-02-remarks-jump")
      .cases(jumps)
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const JumpCase& c) {
        return c.examined == Examined::touch      ? touch<R>(c)
               : c.examined == Examined::on_cells ? powers_on_cells(c.problem, SingularKind::friction_jump)
                                                  : solved_values<R>(c);
      })
      .predicted([](const JumpCase& c) { return predicted(c); })
      .wrong("infinite where `f` falls, zero where it rises: the sign of `beta`",
             scaled({"power", "left cells", "right cells"}, -1))
      .wrong("`gamma` left out of `alpha`",
             [](Values& p, const JumpCase& c) { p = predicted(c, c.problem.elasticity().gamma()); })
      .wrong("infinite wherever `f` rises, with `theta(c) = 0` as well", replaced({{"vanishes", false}}))
      .wrong("`theta` fixed by what is near `c`", replaced({{"other theta", false}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_02_remarks_jump
