#pragma once
// The mirror x -> -x of a contact problem: the same bodies seen from behind the page, sliding the other way.

#include <utility>
#include <vector>

#include "model/contact_problem.hpp"

inline steadyslide::ContactProblem mirrored(const steadyslide::ContactProblem& problem) {
  using namespace steadyslide;
  const auto reversed = [](const Polynomial& p) {
    std::vector<Rational> c = p.coefficients();
    for (std::size_t k = 1; k < c.size(); k += 2) c[k] = -c[k];
    return Polynomial(std::move(c));
  };
  const std::vector<Rational>& f = problem.friction().values();
  std::vector<Rational> jumps;
  for (auto c = problem.friction().jumps().rbegin(); c != problem.friction().jumps().rend(); ++c) jumps.push_back(-*c);
  const std::vector<Indenter::Piece>& pieces = problem.indenter().pieces();
  std::vector<Indenter::Piece> mirrored_pieces;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    const Rational& from = k == 0 ? problem.indenter().left() : pieces[k - 1].to;
    mirrored_pieces.push_back({-from, reversed(pieces[k].profile)});
  }
  std::optional<Rational> load_at;
  if (problem.load_at()) load_at = -*problem.load_at();
  return ContactProblem(problem.elasticity(), FrictionProfile({f.rbegin(), f.rend()}, std::move(jumps)),
                        Indenter(-problem.indenter().right(), std::move(mirrored_pieces)), problem.load(),
                        problem.sliding() == Sliding::plus_x ? Sliding::minus_x : Sliding::plus_x, load_at);
}
