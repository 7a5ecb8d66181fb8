// In place of friction_table.cpp, profile_trace.cpp and symbol_table.cpp: the Explorer reads no files beside a problem.

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/friction_table.hpp"
#include "library/problem_file/profile_trace.hpp"
#include "library/problem_file/symbol_table.hpp"

namespace steadyslide::library {

FrictionProfile parse_friction_table(std::string_view, const std::string& name, const Support&, const Rational&) {
  throw InvalidFile(name + ": measured friction; the Explorer reads no files beside a problem; samples");
}

ProfileTrace parse_trace(std::string_view, const std::string& name, const std::optional<Support>&, const Heights&) {
  throw InvalidFile(name + ": measured profile; the Explorer reads no files beside a problem; samples");
}

std::vector<SymbolRow> parse_symbols(std::string_view, const std::string& name) {
  throw InvalidFile(name + ": symbols of a body; the Explorer reads no files beside a problem; symbol");
}

}  // namespace steadyslide::library
