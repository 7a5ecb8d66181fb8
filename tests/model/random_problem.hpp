#pragma once
// Random contact problems with small data, so that coincidences (a jump on a wedge, a jump of height zero, equal
// friction values, gamma = 0) are frequent.

#include <rapidcheck.h>

#include <set>
#include <utility>
#include <vector>

#include "model/contact_problem.hpp"
#include "uniform.hpp"

inline steadyslide::ContactProblem random_problem() {
  using namespace steadyslide;
  const auto whole = [](int low, int high) { return Rational(uniform(low, high)); };
  const auto places = [] {
    std::set<Rational> chosen;
    for (int k = uniform(0, 3); k > 0; --k) chosen.insert(Rational(uniform(-3, 3), 4));
    return std::vector<Rational>(chosen.begin(), chosen.end());
  };
  std::vector<Rational> jumps = places();
  std::vector<Rational> values;
  for (std::size_t k = 0; k <= jumps.size(); ++k) values.push_back(whole(0, 3) / 2);
  std::vector<Indenter::Piece> pieces;
  std::vector<Rational> ends = places();
  ends.push_back(1);
  for (const Rational& to : ends) pieces.push_back({to, Polynomial({whole(0, 1), whole(0, 1), whole(0, 1)})});
  std::optional<Rational> load_at;
  if (uniform(0, 3) == 0) load_at = whole(-1, 1) / 2;
  return ContactProblem(Elasticity::reduced(whole(-2, 2) / 3), FrictionProfile(std::move(values), std::move(jumps)),
                        Indenter(-1, std::move(pieces)), 1,
                        *rc::gen::arbitrary<bool>() ? Sliding::plus_x : Sliding::minus_x, load_at);
}
