#include "library/problem_file/profile_trace.hpp"

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {

ProfileTrace parse_trace(std::string_view, const std::string& name, const std::optional<Support>&, const Heights&) {
  throw InvalidFile(name + ": measured profile; the Explorer reads no files beside a problem; samples");
}

}  // namespace steadyslide::library
