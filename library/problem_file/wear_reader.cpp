#include "library/problem_file/wear_reader.hpp"

#include <fmt/format.h>

#include "library/problem_file/friction_table.hpp"

namespace steadyslide::library {

std::optional<Wear> read_wear(const ProblemReader& reader, const ContactProblem& contact) {
  if (reader.find("wear") == nullptr) return std::nullopt;
  reader.check_table("wear", {"coefficients", "body"});
  reader.required("wear.coefficients", "the indenter has coefficients of wear");
  std::vector<Rational> coefficients = reader.numbers("wear.coefficients", max_friction_values);
  // The steps of a table are not counted by hand.
  if (reader.find("friction.samples") != nullptr && coefficients.size() != 1) {
    throw reader.error("wear.coefficients", "wrong number of coefficients",
                       "with friction.samples there is one for all",
                       fmt::format("{} coefficients", coefficients.size()));
  }
  Rational body = reader.number_if_any("wear.body").value_or(0);
  return reader.accepted("", [&] { return Wear(std::move(coefficients), std::move(body), contact); });
}

}  // namespace steadyslide::library
