#include "app/report/mutants.hpp"

namespace steadyslide::app {
namespace {

/// Takes one line off the front.
std::vector<std::string> take_line(std::string_view& csv) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  while (!csv.empty()) {
    const char c = csv.front();
    csv.remove_prefix(1);
    if (quoted && c == '"' && csv.starts_with('"')) {
      fields.back() += '"';
      csv.remove_prefix(1);
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      fields.emplace_back();
    } else if (!quoted && c == '\n') {
      break;
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

}  // namespace

std::vector<Mutant> read_mutants(std::string_view csv) {
  std::vector<Mutant> mutants;
  take_line(csv);
  while (!csv.empty()) {
    std::vector<std::string> fields = take_line(csv);
    if (fields.size() == 1 && fields.front().empty()) continue;
    fields.resize(5);
    mutants.push_back({fields[0], fields[1], fields[2], fields[3], fields[4]});
  }
  return mutants;
}

}  // namespace steadyslide::app
