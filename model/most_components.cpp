#include "model/most_components.hpp"

#include <string>

namespace steadyslide {

std::size_t most_gaps(const Polynomial& profile) {
  if (profile.degree() < 2) return 0;
  const auto degree = static_cast<std::size_t>(profile.degree()) - 1;  // of the slope
  if (degree % 2 == 0) return degree / 2;
  return profile.coefficients().back() > 0 ? (degree - 1) / 2 : (degree + 1) / 2;
}

std::size_t most_components(const ContactProblem& problem) {
  const std::vector<Indenter::Piece>& pieces = problem.indenter().pieces();
  std::size_t sum = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool goes_on = k > 0 && pieces[k].profile == pieces[k - 1].profile;
    if (!goes_on) sum += most_gaps(pieces[k].profile) + 1;
  }
  return sum;
}

std::string too_many_components(const ContactProblem& problem, std::size_t components) {
  const std::size_t most = most_components(problem);
  if (components <= most) return "";
  return "the contact has " + std::to_string(components) + " components; a solution of this problem has at most " +
         std::to_string(most);
}

}  // namespace steadyslide
