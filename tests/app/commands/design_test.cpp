#include "app/json_answers.hpp"

TEST_CASE("design: its rows name entries of the ledger") {
  const Json ledger = json_of(run_alone(words("verify --group beyond --list --format json")));
  std::set<std::string> ids;
  for (const Json& claim : ledger.at("claims")) ids.insert(claim.at("id"));
  CHECK(ids.contains("flat-punch-effective-friction"));
  const std::string punch = problem_text("bare_punch");
  std::size_t named = 0;
  const std::string design =
      "design - --coatings 0.1,0.5 --fractions 0.5,0.5 --digits 3 --format json --largest-jumps ";
  for (const char* jumps : {"1", "2"}) {
    for (const Json& row : json_of(run_alone(words(design + jumps), punch))) {
      for (const Json& id : row.at("by")) {
        CHECK_MESSAGE(ids.contains(id), id);
        ++named;
      }
    }
  }
  CHECK(named == 10);
}
