// The ends of contact against the load, for a contact that grows over a friction jump.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/figures/solved.hpp"
#include "app/gnuplot/figure.hpp"

namespace steadyslide::app {
namespace {

using SharedSolution = std::shared_ptr<const numeric::RiemannHilbertSolution<double>>;

/// Solves for every load, each from the solution before. The loads are squares, because the contact's length grows like
/// the square root of the load.
std::vector<SharedSolution> load_steps(const ContactProblem& problem, const Rational& last, int steps) {
  std::vector<SharedSolution> result;
  for (int i = 1; i <= steps; ++i) {
    const SharedSolution* before = result.empty() ? nullptr : &result.back();
    const Rational load = last * i * i / (steps * steps);
    result.push_back(solved_by_singular_functions(problem.with_load(load), before ? before->get() : nullptr));
  }
  return result;
}

double load_of(const SharedSolution& solution) { return solution->resultants().normal.value; }

Point at(const SharedSolution& solution, const numeric::ContactEnd<double>& end) {
  return {load_of(solution), end.x.value};
}

/// Takes a solution with two zones and one with one zone. Halves the interval of their loads until the loads agree to
/// six digits. Returns the solutions with two zones.
std::vector<SharedSolution> up_to_merging(const ContactProblem& problem, const SharedSolution& two,
                                          const SharedSolution& one) {
  std::vector<SharedSolution> result{two};
  Rational low(load_of(two));
  Rational high(load_of(one));
  while (high - low > Rational(1, 1000000) * high) {
    const Rational middle = (low + high) / 2;
    const SharedSolution solution = solved_by_singular_functions(problem.with_load(middle), result.back().get());
    if (solution->contact().size() == 2) {
      result.push_back(solution);
      low = middle;
    } else {
      high = middle;
    }
  }
  return result;
}

/// Two bumps with the friction jump between them.
Panel merging_zones() {
  const ContactProblem bumps = two_bumps();
  Panel panel{{0.59, 0.985, 0.175, 0.9},
              {"load {/:Italic P}  ({/:Italic E L})", 0, 1.2, false, 0.2},
              {"ends of contact {/:Italic x} / {/:Italic L}", -2, 2.6, false, 1}};
  std::vector<SharedSolution> solutions = load_steps(bumps, Rational(6, 5), 100);
  const auto one = std::ranges::find_if(solutions, [](const SharedSolution& s) { return s->contact().size() == 1; });
  if (one == solutions.begin() || one == solutions.end()) throw std::runtime_error("the contact zones do not meet");
  const std::vector<SharedSolution> meeting = up_to_merging(bumps, *(one - 1), *one);
  const double merged = load_of(meeting.back());
  solutions.insert(one, meeting.begin(), meeting.end());
  Series outer_left{"outer ends", Look::line, 1, {{0, -1}}};
  Series outer_right{"", Look::line, 1, {{0, 1}}};
  Series inner_left{"inner ends", Look::line, 2, {{0, -1}}};
  Series inner_right{"", Look::line, 2, {{0, 1}}};
  for (const SharedSolution& solution : solutions) {
    const auto zones = solution->contact();
    outer_left.points.push_back(at(solution, zones.front().left));
    outer_right.points.push_back(at(solution, zones.back().right));
    if (zones.size() < 2) continue;
    inner_left.points.push_back(at(solution, zones.front().right));
    inner_right.points.push_back(at(solution, zones.back().left));
  }
  panel.series = {outer_left, outer_right, inner_left, inner_right};
  panel.legend = LegendAt::top_right;
  panel.guides = {{{0, 0, true}, {1, 0, true}}, {{merged, 0, false, true}, {merged, 0.43, false, true}}};
  panel.notes = {{{0.03, 0.11, true}, "friction jump"},
                 {{merged + 0.02, 0.22, false, true}, "one zone from"},
                 {{merged + 0.02, 0.16, false, true}, "{/:Italic P} = " + decimal(merged, 4)}};
  return panel;
}

/// A parabola whose vertex lies beside the friction jump.
Panel growing_zone() {
  const Rational jump(3, 20);
  const Rational low(1, 10);
  const Rational high(2);
  Panel panel{{0.09, 0.485, 0.175, 0.9},
              {"load {/:Italic P}  ({/:Italic E L})", 0, 0.15, false, 0.05},
              {"ends of contact {/:Italic x} / {/:Italic L}", -0.6, 0.6, false, 0.2}};
  int style = 0;
  for (const auto& [left, right] : {std::pair(low, high), std::pair(high, low)}) {
    const ContactProblem problem = parabola(Rational(3, 10), {left, right}, 1, {jump});
    Series rear{
        "{/:Italic f} = " + to_string(left) + " left, " + to_string(right) + " right", Look::line, ++style, {{0, 0}}};
    Series front{"", Look::line, style, {{0, 0}}};
    for (const SharedSolution& solution : load_steps(problem, Rational(3, 20), 100)) {
      rear.points.push_back(at(solution, solution->contact().front().left));
      front.points.push_back(at(solution, solution->contact().back().right));
    }
    panel.series.push_back(std::move(rear));
    panel.series.push_back(std::move(front));
  }
  const auto c = numeric::to_real<double>(jump);
  panel.legend = LegendAt::top_left;
  panel.guides = {{{0, c, true}, {1, c, true}}};
  panel.notes = {{{0.97, c + 0.04, true}, "friction jump", Align::right}};
  return panel;
}

}  // namespace

Figure make_contact_load() {
  return {
      "contact-load",
      "Contact zones that grow over a friction jump",
      "Where the contact begins and ends as the load grows, sliding to the right, `nu = 3/10`; `L` is the unit of "
      "length, `E` Young's modulus. Left: a parabola of radius `R = L` beside a friction jump at `0.15 L`, with the "
      "rougher coating on either side. Its front end `b` moves by `db/dP = R c/(pi (1/2+alpha)(b-a))`, `c = "
      "2(1-nu^2)/E`, with the angle `alpha` of the coating at this end: where it passes the jump, the curve has a "
      "kink. Right: two bumps `psi = (x^2-1)^2/4` with `f = 0.1` on the left and 0.7 on the right of the jump at 0. "
      "Two zones become one, and from then on the jump is under contact.",
      445,
      {growing_zone(), merging_zones()}};
}

}  // namespace steadyslide::app
