// Pressure under a flat punch with one friction coefficient. [Bal16, (4) and figure 3]

#include "app/figures/figure.hpp"
#include "app/figures/solved.hpp"

namespace steadyslide::app {

Figure make_flat_punch() {
  Panel panel = empty_panel({0.085, 0.98, 0.165, 0.91}, {"{/:Italic x} / {/:Italic L}", -1.05, 1.05, false, 0.5},
                            {"pressure −{/:Italic t}_n  ({/:Italic P}/{/:Italic L})", 0, 1.4, false, 0.2});
  int style = 0;
  for (const Rational& f : {Rational(0), Rational(3, 10), Rational(1)}) {
    const ContactProblem problem = flat_punch(Rational(1, 5), {f});
    const std::string value = "{/:Italic f} = " + to_string(f);
    panel.series.push_back({value, Look::line, ++style, pressure_curve(*solved(problem), 401)});
    panel.series.push_back({"", Look::marks, style, pressure_of_cells(*solved_on_cells(problem, 800), 40)});
  }
  panel.legend = LegendAt::top_centre;
  panel.notes = {{{0.05, 0.2, true, true}, "rear"},
                 {{0.95, 0.2, true, true}, "front", Align::right},
                 {{0.5, 0.105, true, true}, "sliding", Align::centre}};
  panel.guides = {{{0.42, 0.06, true, true}, {0.58, 0.06, true, true}, true}};
  return {
      "flat-punch",
      "Flat punch with one friction coefficient",
      "Normal traction under a rigid flat punch of half-width `L` that slides to the right under the load `P`, "
      "`nu = 1/5`: lines by the closed form `t_n = -P cos(pi alpha)/pi (1+x)^{-(1/2+alpha)} (1-x)^{-(1/2-alpha)}` "
      "(`L = 1`), marks by the solver on 800 cells, which knows no exponents. With friction the rear is loaded more "
      "than the front, and its singularity is the stronger one.",
      430,
      {panel}};
}

}  // namespace steadyslide::app
