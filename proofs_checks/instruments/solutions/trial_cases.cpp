#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

ContactProblem problem(const Rational& nu, FrictionProfile friction, std::vector<Indenter::Piece> pieces,
                       Sliding sliding = Sliding::plus_x) {
  return {Elasticity(Solid(nu, 1)), std::move(friction), Indenter(-4, std::move(pieces)), Rational(3, 2), sliding};
}

/// Returns a random trial. With `kinks` the profile's slope may change in the contact.
Trial random_trial(Random& random, std::size_t components, bool kinks) {
  std::vector<Rational> friction{random.friction(3)};
  std::vector<Rational> jumps;
  std::vector<Indenter::Piece> pieces;
  Polynomial profile({0, random.between(-1, 1), random.between(0, Rational(1, 4)),
                      random.between(Rational(-1, 16), Rational(1, 16)), random.between(Rational(-1, 64), 0)});
  std::vector<ContactInterval> zones;
  const Rational width(8, static_cast<long>(components));
  // Adds a break with a step to the profile, so that the contact may end there with an edge.
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
    zones.push_back({Trial::in_frame(left), Trial::in_frame(right), left_edge, right_edge});
  }
  pieces.push_back({4, profile});
  const std::vector<Rational> q = random.between(Rational(1, 4), 2, 4);
  const Rational nu = random.between(-1, Rational(1, 2));
  const Sliding sliding = random.below(2) == 0 ? Sliding::plus_x : Sliding::minus_x;
  return {"random", problem(nu, FrictionProfile(friction, jumps), std::move(pieces), sliding), zones, q,
          random.between(-1, 1)};
}

}  // namespace

std::string text_of(const Trial& trial) { return trial.name + ": " + text_of(trial.problem); }

std::function<CaseList<Trial>(const Context&)> trials(std::string stream, const CountByDigits& random_ones,
                                                      bool corners) {
  return [=](const Context& context) {
    const bool cheap = context.digits == numeric::Digits::sixteen;
    const Polynomial bent({0, Rational(1, 3), Rational(1, 2), Rational(-1, 5)});
    const auto lifted = [&](const Rational& by) { return bent + Polynomial({by}); };
    const std::vector<Rational> q{Rational(3, 4), Rational(-5, 7), Rational(2, 3), Rational(-1, 9)};
    CaseList<Trial> list{{}, "contact sets, the random ones of seed " + std::to_string(context.seed)};
    std::vector<Trial>& all = list.cases;
    all.push_back({"one free component",
                   problem(Rational(2, 5), FrictionProfile({1, 3}, {Rational(1, 3)}), {{-3, lifted(1)}, {4, bent}}),
                   {{-0.7, 0.9, false, false}},
                   q,
                   Rational(-1, 5)});
    const bool short_run = context.quick && !cheap;
    if (!short_run || !corners) {
      all.push_back({"two punches",
                     problem(Rational(3, 10), FrictionProfile({1, Rational(1, 4)}, {0}),
                             {{-1, bent}, {1, lifted(1)}, {4, lifted(Rational(1, 3))}}),
                     {{Trial::in_frame(-4), Trial::in_frame(-1), true, true},
                      {Trial::in_frame(1), Trial::in_frame(4), true, true}},
                     q,
                     Rational(1, 6)});
    }
    if (short_run && !corners) return list;
    all.push_back({"wedge and jump",
                   problem(Rational(1, 5), FrictionProfile({Rational(1, 3), 2}, {Rational(1, 2)}),
                           {{Rational(1, 2), bent}, {4, Polynomial({0, Rational(4, 3), Rational(1, 4)})}}),
                   {{Trial::in_frame(-4), Trial::in_frame(2), true, false}},
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
                     {{-1.5, Trial::in_frame(Rational(-1, 2)), false, true}, {Trial::in_frame(1), 1.6, true, false}},
                     q,
                     0});
    }
    Random random(context.seed, stream);
    const std::size_t random_count = !context.quick ? count_for(context, random_ones) : cheap ? 1 : 0;
    for (std::size_t k = 0; k < random_count; ++k) {
      const std::size_t components = 1 + random.below(cheap ? 3 : 2);
      all.push_back(random_trial(random, components, k % 2 == 1));
    }
    return list;
  };
}

Trial with_ends(const std::vector<std::pair<bool, bool>>& edges) {
  std::vector<Rational> friction{1};
  std::vector<Rational> jumps;
  std::vector<Indenter::Piece> pieces;
  std::vector<ContactInterval> zones;
  const Rational width(8, static_cast<long>(edges.size()));
  for (const auto& [left_edge, right_edge] : edges) {
    const Rational from = -4 + static_cast<long>(zones.size()) * width;
    const Rational left = from + width / 4;
    const Rational right = from + width * 3 / 4;
    if (left_edge) pieces.push_back({left, Polynomial()});
    if (right_edge) pieces.push_back({right, Polynomial()});
    jumps.push_back(from + width / 2);
    friction.emplace_back(1, static_cast<long>(friction.size() + 1));
    zones.push_back({Trial::in_frame(left), Trial::in_frame(right), left_edge, right_edge});
  }
  pieces.push_back({4, Polynomial()});
  return {"all kinds of ends",
          problem(Rational(1, 3), FrictionProfile(std::move(friction), std::move(jumps)), std::move(pieces)),
          std::move(zones),
          {1, 1, 1, 1},
          0};
}

}  // namespace steadyslide::proofs_checks
