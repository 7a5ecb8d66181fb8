#include "proofs_checks/kit/problem_text.hpp"

#include <vector>

namespace steadyslide::proofs_checks {
namespace {

std::string list(const std::vector<Rational>& values) {
  std::string text;
  for (const Rational& value : values) text += (text.empty() ? "" : ", ") + to_string(value);
  return text;
}

}  // namespace

std::string text_of(const ContactProblem& problem) {
  const Elasticity& elasticity = problem.elasticity();
  std::string text = elasticity.half_space() ? "nu = " + to_string(elasticity.half_space()->poisson())
                                             : "gamma = " + to_string(elasticity.gamma());
  text += ", f = " + list(problem.friction().values());
  if (!problem.friction().jumps().empty()) text += ", jumps at " + list(problem.friction().jumps());
  text += ", load " + to_string(problem.load());
  const Indenter& indenter = problem.indenter();
  text += ", psi = " + to_string(indenter.pieces().front().profile);
  text += " on [" + to_string(indenter.left()) + ", " + to_string(indenter.right()) + "]";
  const Body& body = problem.body();
  if (body.period()) text += ", period " + to_string(*body.period());
  for (const Layer& layer : body.layers()) {
    text += std::string(", layer h = ") + to_string(layer.thickness) + ", nu = " + to_string(layer.solid.poisson()) +
            (layer.below == Interface::slip ? ", slipping" : "");
  }
  if (!body.layers().empty() && !body.base()) text += ", rigid base";
  return problem.sliding() == Sliding::plus_x ? text : text + ", sliding to -x";
}

}  // namespace steadyslide::proofs_checks
