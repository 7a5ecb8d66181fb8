#include "proofs_checks/claims/trial.hpp"

#include <algorithm>

namespace steadyslide::proofs_checks {
namespace {

using numeric::Node;
using numeric::RiemannHilbertForm;
using numeric::ZoneGuess;

double in_frame(const Rational& x) {
  return numeric::to_real<double>((x - Trial::frame().origin) / Trial::frame().unit);
}

ContactProblem problem(const Rational& nu, FrictionProfile friction, std::vector<Indenter::Piece> pieces,
                       Sliding sliding = Sliding::plus_x) {
  return {Elasticity(Solid(nu, 1)), std::move(friction), Indenter(-4, std::move(pieces)), Rational(3, 2), sliding};
}

/// `kinks`: the profile's slope changes in the contact.
Trial random_trial(Random& random, std::size_t components, bool kinks) {
  std::vector<Rational> friction{random.friction(3)};
  std::vector<Rational> jumps;
  std::vector<Indenter::Piece> pieces;
  Polynomial profile({0, random.between(-1, 1), random.between(0, 1), random.between(-1, 1), random.between(-1, 0)});
  std::vector<ZoneGuess> zones;
  const Rational width(8, static_cast<long>(components));
  // A break with a step, so that contact may end there with an edge.
  const auto step = [&](const Rational& x) {
    pieces.push_back({x, profile});
    profile = profile + Polynomial({random.between(-1, 1)});
  };
  for (std::size_t i = 0; i < components; ++i) {
    const Rational from = -4 + static_cast<long>(i) * width;
    const Rational left = from + width * random.between(Rational(1, 16), Rational(5, 16));
    const Rational inside = from + width * random.between(Rational(6, 16), Rational(10, 16));
    const Rational right = from + width * random.between(Rational(11, 16), Rational(15, 16));
    const std::size_t kind = random.below(4);
    const bool left_edge = random.below(2) == 0;
    const bool right_edge = random.below(2) == 0;
    if (left_edge) step(left);
    if (kind != 0) {
      jumps.push_back(inside);
      friction.push_back(random.friction(3));
    }
    if (kinks && kind < 2) {
      pieces.push_back({inside, profile});
      const Rational turn = random.between(-1, 1);
      const Rational bend = random.between(-1, 1);
      const Polynomial change({0, turn, bend});
      profile = profile + change - Polynomial({change(inside)});
    }
    if (right_edge) step(right);
    zones.push_back({in_frame(left), in_frame(right), left_edge, right_edge});
  }
  pieces.push_back({4, profile});
  std::vector<Rational> q;
  for (int j = 0; j < 4; ++j) q.push_back(random.between(-2, 2));
  const Rational nu = random.between(-1, Rational(1, 2));
  const Sliding sliding = random.below(2) == 0 ? Sliding::plus_x : Sliding::minus_x;
  return {"random", problem(nu, FrictionProfile(friction, jumps), std::move(pieces), sliding), zones, q,
          random.between(-1, 1)};
}

/// Which piece of the profile lies around a place.
template <Real R>
const Polynomial& piece_around(const ContactProblem& problem, const R& x) {
  const auto& pieces = problem.indenter().pieces();
  std::size_t k = 0;
  while (k + 1 < pieces.size() && x > numeric::to_real<R>(pieces[k].to)) ++k;
  return pieces[k].profile;
}

template <Real R>
R value_of(const Polynomial& p, const R& x) {
  R value = 0;
  for (int k = p.degree(); k >= 0; --k) {
    value = value * x + numeric::to_real<R>(p.coefficient(static_cast<std::size_t>(k)));
  }
  return value;
}

}  // namespace

std::vector<Trial> trials(const Context& context, std::string_view stream, std::size_t random_count, bool corners) {
  const bool cheap = context.digits == numeric::Digits::sixteen;
  const Polynomial bent({0, Rational(1, 3), Rational(1, 2), Rational(-1, 5)});
  const auto lifted = [&](const Rational& by) { return bent + Polynomial({by}); };
  const std::vector<Rational> q{Rational(3, 4), Rational(-5, 7), Rational(2, 3), Rational(-1, 9)};
  std::vector<Trial> all;
  all.push_back({"two punches and a jump",
                 problem(Rational(3, 10), FrictionProfile({1, Rational(1, 4)}, {-2}),
                         {{-1, bent}, {1, lifted(1)}, {4, lifted(Rational(1, 3))}}),
                 {{in_frame(-4), in_frame(-1), true, true}, {in_frame(1), in_frame(4), true, true}},
                 q,
                 Rational(1, 6)});
  all.push_back({"one free component",
                 problem(Rational(2, 5), FrictionProfile({1, 3}, {Rational(1, 3)}), {{4, bent}}),
                 {{-0.7, 0.9, false, false}},
                 q,
                 Rational(-1, 5)});
  if (context.quick && !corners && !cheap) return all;
  all.push_back({"wedge and jump",
                 problem(Rational(1, 5), FrictionProfile({Rational(1, 3), 2}, {Rational(1, 2)}),
                         {{Rational(1, 2), bent}, {4, Polynomial({0, Rational(4, 3), Rational(1, 4)})}}),
                 {{in_frame(-4), in_frame(2), true, false}},
                 q,
                 0});
  if (!context.quick) {
    all.push_back({"three free components",
                   problem(Rational(-1, 2), FrictionProfile({2, Rational(1, 2), 1}, {-2, 3}),
                           {{4, Polynomial({0, 0, 1, 0, Rational(-1, 6), Rational(1, 9)})}}, Sliding::minus_x),
                   {{-1.9, -0.8, false, false}, {-0.4, 0.5, false, false}, {0.9, 1.7, false, false}},
                   q,
                   Rational(-1, 4)});
    all.push_back({"wedge",
                   problem(Rational(-4, 5), FrictionProfile({5}),
                           {{0, bent}, {4, Polynomial({0, 1, Rational(-1, 6), Rational(1, 9)})}}),
                   {{-1.1, 0.8, false, false}},
                   q,
                   Rational(1, 5)});
    all.push_back({"wedges in two components, free end and edge at each",
                   problem(Rational(1, 4), FrictionProfile({Rational(1, 2), 3, 0}, {-2, 2}),
                           {{-2, bent},
                            {Rational(-1, 2), Polynomial({1, 0, Rational(1, 2)})},
                            {1, Polynomial({2, 0, Rational(1, 2)})},
                            {2, Polynomial({0, 0, Rational(1, 2)})},
                            {4, Polynomial({-4, 2, Rational(1, 2)})}}),
                   {{-1.5, in_frame(Rational(-1, 2)), false, true}, {in_frame(1), 1.6, true, false}},
                   q,
                   0});
  }
  Random random(context.seed, stream);
  if (context.quick) random_count = cheap ? 1 : 0;
  for (std::size_t k = 0; k < random_count; ++k) {
    const std::size_t components = 1 + random.below(cheap ? 3 : 2);
    all.push_back(random_trial(random, components, k % 2 == 1));
  }
  return all;
}

Trial with_ends(const std::vector<std::pair<bool, bool>>& edges) {
  std::vector<Rational> friction{1};
  std::vector<Rational> jumps;
  std::vector<Indenter::Piece> pieces;
  std::vector<ZoneGuess> zones;
  const Rational width(8, static_cast<long>(edges.size()));
  for (const auto& [left_edge, right_edge] : edges) {
    const Rational from = -4 + static_cast<long>(zones.size()) * width;
    const Rational left = from + width / 4;
    const Rational right = from + width * 3 / 4;
    if (left_edge) pieces.push_back({left, Polynomial()});
    if (right_edge) pieces.push_back({right, Polynomial()});
    jumps.push_back(from + width / 2);
    friction.push_back(Rational(1, static_cast<long>(friction.size() + 1)));
    zones.push_back({in_frame(left), in_frame(right), left_edge, right_edge});
  }
  pieces.push_back({4, Polynomial()});
  return {"all kinds of ends",
          problem(Rational(1, 3), FrictionProfile(std::move(friction), std::move(jumps)), std::move(pieces)),
          std::move(zones),
          {1, 1, 1, 1},
          0};
}

std::string detail_of(const Context& context, const std::vector<Trial>& trials) {
  return std::to_string(trials.size()) + " contact sets, the random ones of seed " + std::to_string(context.seed);
}

template <Real R>
R height(const ContactProblem& problem, const R& around, const R& x) {
  return value_of(piece_around(problem, around), x) / numeric::to_real<R>(problem.elasticity().compliance());
}

template <Real R>
R slope(const ContactProblem& problem, const R& around, const R& x) {
  return value_of(piece_around(problem, around).derivative(), x) /
         numeric::to_real<R>(problem.elasticity().compliance());
}

template <class R>
TrialForm<R>::TrialForm(const Trial& trial) : problem_(trial.problem), reduced_(problem_, Trial::frame()) {
  auto state = numeric::ContactState<R>::initial(reduced_, numeric::ContactSet<R>(reduced_, trial.zones),
                                                 numeric::to_real<R>(trial.tilt));
  for (std::size_t j = 0; j < state.q.size(); ++j) state.q[j] = numeric::to_real<R>(trial.q.at(j));
  form_.emplace(reduced_, std::move(state.set), std::move(state.q), state.tilt, rules_);
}

template <class R>
RiemannHilbertForm<R> TrialForm<R>::form_on(numeric::ContactSet<R> set, const R& tilt) const {
  return {reduced_, std::move(set), form_->q(), tilt, rules_};
}

template <Real R>
std::unique_ptr<numeric::RiemannHilbertSolution<R>> solved(const ContactProblem& problem,
                                                           const std::vector<ZoneGuess>& zones) {
  auto solution = std::make_unique<numeric::RiemannHilbertSolution<R>>(problem, Trial::frame());
  const auto& reduced = solution->problem();
  solution->set(
      search_contact(reduced, numeric::ContactState<R>::initial(reduced, {reduced, zones}, R(0)), solution->rules()));
  if (!solution->shortcoming().empty()) throw Refutation{{"a problem to be solved", solution->shortcoming()}};
  return solution;
}

template <Real R>
R coefficient_at_infinity(const RiemannHilbertForm<R>& form, int power) {
  const int top = form.degree_at_infinity() - power;
  const std::vector<R> m = form.moments(static_cast<std::size_t>(std::max(top, 0)));
  R sum = 0;
  for (int j = 0; j < top; ++j) {
    sum += m[static_cast<std::size_t>(j)] * form.series()[static_cast<std::size_t>(top - 1 - j)];
  }
  for (std::size_t l = 0; l < form.q().size(); ++l) {
    const int index = top + static_cast<int>(l);
    if (index >= 0) sum += form.q()[l] / numeric::pi<R>() * form.series()[static_cast<std::size_t>(index)];
  }
  return sum;
}

template <Real R>
std::vector<R> excess(const RiemannHilbertForm<R>& form) {
  std::vector<R> result;
  for (int power = 0; power < form.degree_at_infinity(); ++power) {
    result.push_back(coefficient_at_infinity(form, power));
  }
  return result;
}

template <Real R>
std::vector<std::size_t> segments_of(const RiemannHilbertForm<R>& form) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (form.set().in_contact(k)) result.push_back(k);
  }
  return result;
}

template <Real R>
std::vector<R> friction_of(const RiemannHilbertForm<R>& form) {
  const ContactProblem& problem = form.problem().problem();
  std::vector<R> result;
  for (const std::size_t k : segments_of(form)) {
    const R middle = (form.set().x(k) + form.set().x(k + 1)) / 2;
    const numeric::Frame& frame = form.problem().frame();
    const R x = numeric::to_real<R>(frame.origin) + numeric::to_real<R>(frame.unit) * middle;
    std::size_t piece = 0;
    for (const Rational& c : problem.friction().jumps()) piece += numeric::to_real<R>(c) < x ? 1 : 0;
    result.push_back(numeric::to_real<R>(problem.coupled_friction(piece)));
  }
  return result;
}

template <Real R>
numeric::PiecewiseDensity<R> density_of(const RiemannHilbertForm<R>& form,
                                        const numeric::FundamentalSolution<R>& weight, const Bracket<R>& bracket) {
  numeric::PiecewiseDensity<R> density;
  // At a wedge a power that vanishes lies below the constant or the logarithm.
  const auto leading = [&](std::size_t j) {
    const numeric::Power<R>& p = weight.powers()[j];
    return form.is_kinked(j) && p.value > 0 ? numeric::Power<R>{R(0), R(1)} : p;
  };
  R gap = 0;
  for (std::size_t k = 0; k < form.set().segments(); ++k) {
    if (!form.set().in_contact(k)) {
      gap += form.set().length(k);
      continue;
    }
    const bool left_kink = leading(k).value != weight.powers()[k].value;
    const bool right_kink = leading(k + 1).value != weight.powers()[k + 1].value;
    const auto smooth = [weight, bracket, k, left_kink, right_kink](const Node<R>& node) {
      using std::pow;
      R value = weight.smooth_modulus(k, node) * bracket(k, node);
      if (left_kink) value *= pow(node.from_left, weight.powers()[k].value);
      if (right_kink) value *= pow(node.from_right, weight.powers()[k + 1].value);
      return value;
    };
    density.push_back({weight.panel(k), leading(k), leading(k + 1), smooth, density.empty() ? R(0) : gap});
    gap = 0;
  }
  return density;
}

template <Real R>
numeric::PiecewiseDensity<R> density_of(const RiemannHilbertForm<R>& form) {
  return density_of<R>(form, form.weight(), [&form](std::size_t k, const Node<R>& node) {
    const auto segment = static_cast<std::ptrdiff_t>(k);
    return R(form.sign(segment) * form.problem().cos_alpha(form.friction_at(k)) *
             form.bracket(form.slope_at(k), {segment, node}).value);
  });
}

template <Real R>
void check_equation(Findings& findings, const RiemannHilbertForm<R>& solution) {
  const Quantity equation{"equation for the solution examined", {"trapezoidal rule", "psi'/c"}, tolerance<R>()};
  const std::vector<std::size_t> segments = segments_of(solution);
  const numeric::SurfaceCheck<R> check(
      density_of(solution), friction_of(solution), [&](std::size_t k, const Node<R>& node) {
        return R(solution.problem().slope(solution.slope_at(segments[k]), node.x) + solution.tilt());
      });
  findings.compare(equation, static_cast<double>(check.equation()));
}

template <Real R>
R extrapolated(const std::vector<R>& f, int to) {
  R sum = 0;
  const int n = static_cast<int>(f.size());
  for (int i = 1; i <= n; ++i) {
    R term = f[static_cast<std::size_t>(i - 1)];
    for (int k = 1; k <= n; ++k) {
      if (k != i) term *= R(to + k) / (k - i);
    }
    sum += term;
  }
  return sum;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                             \
  template R height(const ContactProblem&, const R&, const R&);                                                \
  template R slope(const ContactProblem&, const R&, const R&);                                                 \
  template class TrialForm<R>;                                                                                 \
  template std::unique_ptr<numeric::RiemannHilbertSolution<R>> solved(const ContactProblem&,                   \
                                                                      const std::vector<ZoneGuess>&);          \
  template R coefficient_at_infinity(const RiemannHilbertForm<R>&, int);                                       \
  template std::vector<R> excess(const RiemannHilbertForm<R>&);                                                \
  template std::vector<std::size_t> segments_of(const RiemannHilbertForm<R>&);                                 \
  template std::vector<R> friction_of(const RiemannHilbertForm<R>&);                                           \
  template numeric::PiecewiseDensity<R> density_of(const RiemannHilbertForm<R>&,                               \
                                                   const numeric::FundamentalSolution<R>&, const Bracket<R>&); \
  template void check_equation(Findings&, const RiemannHilbertForm<R>&);                                       \
  template R extrapolated(const std::vector<R>&, int);                                                         \
  template numeric::PiecewiseDensity<R> density_of(const RiemannHilbertForm<R>&);
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
