#pragma once
// Contact problems made from another: the coordinate changed, load and profile scaled, friction refined.

#include <algorithm>
#include <utility>
#include <vector>

#include "model/contact_problem.hpp"

namespace steadyslide::testing {

/// p(a x + b).
inline Polynomial substitute(const Polynomial& p, const Rational& a, const Rational& b) {
  Polynomial result;
  const Polynomial line({b, a});
  for (int k = p.degree(); k >= 0; --k) {
    result = result * line + Polynomial::constant(p.coefficient(static_cast<std::size_t>(k)));
  }
  return result;
}

/// The same heights and load in the coordinate y = scale x + shift, scale != 0. A negative scale mirrors: the friction
/// values are reversed and, unless `keep_sliding`, the sliding direction turns.
inline ContactProblem moved(const ContactProblem& p, const Rational& scale, const Rational& shift,
                            bool keep_sliding = false) {
  const auto image = [&](const Rational& x) { return Rational(scale * x + shift); };
  std::vector<Rational> values = p.friction().values();
  std::vector<Rational> jumps;
  for (const Rational& c : p.friction().jumps()) jumps.push_back(image(c));
  std::vector<Rational> ends{image(p.indenter().left())};
  std::vector<Polynomial> profiles;
  for (const Indenter::Piece& piece : p.indenter().pieces()) {
    ends.push_back(image(piece.to));
    profiles.push_back(substitute(piece.profile, 1 / scale, -shift / scale));
  }
  if (scale < 0) {
    std::reverse(values.begin(), values.end());
    std::reverse(jumps.begin(), jumps.end());
    std::reverse(ends.begin(), ends.end());
    std::reverse(profiles.begin(), profiles.end());
  }
  std::vector<Indenter::Piece> pieces;
  for (std::size_t k = 0; k < profiles.size(); ++k) pieces.push_back({ends[k + 1], profiles[k]});
  std::optional<Rational> load_at;
  if (p.load_at()) load_at = image(*p.load_at());
  const bool turned = (scale < 0 && !keep_sliding) != (p.sliding() == Sliding::minus_x);
  return {p.elasticity(),
          FrictionProfile(values, jumps),
          Indenter(ends.front(), pieces),
          p.load(),
          turned ? Sliding::minus_x : Sliding::plus_x,
          load_at};
}

/// psi times `profile_factor`, the load times `load_factor`.
inline ContactProblem scaled(const ContactProblem& p, const Rational& profile_factor, const Rational& load_factor) {
  std::vector<Indenter::Piece> pieces;
  for (const Indenter::Piece& piece : p.indenter().pieces()) {
    pieces.push_back({piece.to, Polynomial::constant(profile_factor) * piece.profile});
  }
  return {p.elasticity(),         p.friction(), Indenter(p.indenter().left(), pieces),
          load_factor * p.load(), p.sliding(),  p.load_at()};
}

/// psi + height.
inline ContactProblem raised(const ContactProblem& p, const Rational& height) {
  std::vector<Indenter::Piece> pieces;
  for (const Indenter::Piece& piece : p.indenter().pieces()) {
    pieces.push_back({piece.to, piece.profile + Polynomial::constant(height)});
  }
  return {p.elasticity(), p.friction(), Indenter(p.indenter().left(), pieces), p.load(), p.sliding(), p.load_at()};
}

/// A further jump at c, where there is none: friction to the right of it larger by `height`, up to the next jump.
inline ContactProblem with_jump(const ContactProblem& p, const Rational& c, const Rational& height) {
  std::vector<Rational> values = p.friction().values();
  std::vector<Rational> jumps = p.friction().jumps();
  const std::size_t piece = p.friction().piece(c, Side::left);
  const auto at = static_cast<std::ptrdiff_t>(piece);
  values.insert(values.begin() + at + 1, values[piece] + height);
  jumps.insert(jumps.begin() + at, c);
  return {p.elasticity(), FrictionProfile(values, jumps), p.indenter(), p.load(), p.sliding(), p.load_at()};
}

}  // namespace steadyslide::testing
