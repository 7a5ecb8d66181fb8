#include "model/wear.hpp"

#include <algorithm>
#include <string>

#include "model/invalid_data.hpp"

namespace steadyslide {

Wear::Wear(std::vector<Rational> coefficients, Rational body, const ContactProblem& problem)
    : coefficients_(std::move(coefficients)), body_(std::move(body)) {
  const std::size_t pieces = problem.friction().values().size();
  if (coefficients_.size() != 1 && coefficients_.size() != pieces) {
    throw InvalidData(
        "wear.coefficients", "wrong number of coefficients", "there is one for each friction value, or one for all",
        std::to_string(pieces) + " friction values, " + std::to_string(coefficients_.size()) + " coefficients");
  }
  for (std::size_t k = 0; k < coefficients_.size(); ++k) {
    if (coefficients_[k] >= 0) continue;
    throw InvalidData("wear.coefficients[" + std::to_string(k) + "]", "negative coefficient of wear",
                      "a coefficient of wear is at least 0", to_string(coefficients_[k]));
  }
  if (std::all_of(coefficients_.begin(), coefficients_.end(), [](const Rational& k) { return k == 0; })) {
    throw InvalidData("wear.coefficients", "no wear", "one coefficient is positive", "all are 0");
  }
  if (body_ < 0)
    throw InvalidData("wear.body", "negative coefficient of wear", "a coefficient of wear is at least 0",
                      to_string(body_));
  if (body_ > 0 && problem.body().period()) {
    throw InvalidData("wear.body", "a body that comes back", "wear.body is for a body that is passed once",
                      "period " + to_string(*problem.body().period()));
  }
}

}  // namespace steadyslide
