#include "library/problem_file/friction_table.hpp"

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {

FrictionProfile parse_friction_table(std::string_view, const std::string& name, const Support&, const Rational&) {
  throw InvalidFile(name + ": measured friction; the Explorer reads no files beside a problem; samples");
}

}  // namespace steadyslide::library
