// beta = alpha_- - alpha_+ over the friction on both sides of a jump, with the regions of infinite and of zero
// pressure.

#include "app/figures/solved.hpp"

namespace steadyslide::app {

Figure make_jump_exponent() {
  constexpr int steps = 100;
  constexpr double most = 2;
  const Rational nu(1, 5);
  // Friction at the middle of a pixel.
  const auto friction = [&](int i) { return Rational(2 * i + 1, steps); };
  // Equal values on both sides are not a jump: the exponent is then 0.
  const auto beta = [&](const Rational& left, const Rational& right) {
    const ContactProblem problem = flat_punch(nu, {left, right}, {0});
    return numeric::to_real<double>(Exponent::angle(problem.coupled_friction(0)) -
                                    Exponent::angle(problem.coupled_friction(1)));
  };
  HeatMap map{{},
              {},
              {},
              -0.2,
              0.2,
              "exponent β of the pressure at the jump",
              {-0.15, -0.1, -0.05, -0.02, 0, 0.02, 0.05, 0.1, 0.15}};
  for (int i = 0; i < steps; ++i) {
    map.x.push_back(numeric::to_real<double>(friction(i)));
    map.y.push_back(map.x.back());
  }
  for (int j = 0; j < steps; ++j) {
    for (int i = 0; i < steps; ++i) map.values.push_back(beta(friction(i), friction(j)));
  }
  Panel panel{{0.19, 0.79, 0.125, 0.925},
              {"friction on the left {/:Italic f}_{−}", 0, most, false, 0.5},
              {"friction on the right {/:Italic f}_{+}", 0, most, false, 0.5}};
  panel.legend = LegendAt::none;
  panel.notes = {{{0.06, 0.95, true, true}, "rougher in front, β negative:", Align::left, 14, true},
                 {{0.06, 0.9, true, true}, "pressure infinite", Align::left, 14, true},
                 {{0.94, 0.085, true, true}, "rougher at the rear, β positive:", Align::right, 14, true},
                 {{0.94, 0.035, true, true}, "pressure 0", Align::right, 14, true}};
  panel.map = std::move(map);
  return {
      "jump-exponent",
      "The exponent at a friction jump",
      "Sliding to the right over a jump from `f_-` to `f_+`, `nu = 1/5`, the pressure goes like `|x-c|^beta`, `beta = "
      "alpha_- - alpha_+`. Where friction rises towards the front it is infinite, where it falls it is 0; along the "
      "white diagonal there is no jump. Lines every 0.05, and at 0 and 0.02 on both sides of it.",
      600,
      {panel}};
}

}  // namespace steadyslide::app
