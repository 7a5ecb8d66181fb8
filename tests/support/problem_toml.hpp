#pragma once
// Writes a contact problem as a problem file, exactly. For rigid indenters on a solid half-space.

#include <string>

#include "model/contact_problem.hpp"

namespace steadyslide::testing {

inline std::string quoted(const Rational& value) { return '"' + to_string(value) + '"'; }

inline std::string quoted(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) text += (text.empty() ? "" : ", ") + quoted(value);
  return '[' + text + ']';
}

inline std::string problem_toml(const ContactProblem& p) {
  const Solid& solid = p.elasticity().half_space().value();
  std::string text = "load = " + quoted(p.load()) + '\n';
  if (p.load_at()) text += "load_at = " + quoted(*p.load_at()) + '\n';
  text += std::string("sliding = \"") + (p.sliding() == Sliding::plus_x ? "+x" : "-x") + "\"\n";
  text += "\n[half_space]\npoisson = " + quoted(solid.poisson()) + "\nyoung = " + quoted(solid.young()) + '\n';
  text += std::string("plane = \"") + (p.elasticity().plane() == Plane::strain ? "strain" : "stress") + "\"\n";
  text +=
      "\n[friction]\nvalues = " + quoted(p.friction().values()) + "\njumps = " + quoted(p.friction().jumps()) + '\n';
  const Indenter& indenter = p.indenter();
  text += "\n[indenter]\nsupport = " + quoted(std::vector{indenter.left(), indenter.right()}) + "\npieces = [\n";
  for (const Indenter::Piece& piece : indenter.pieces()) {
    text += "  {to = " + quoted(piece.to) + ", profile = \"" + to_string(piece.profile) + "\"},\n";
  }
  return text + "]\n";
}

}  // namespace steadyslide::testing
