#pragma once
// docs/mutants.csv: deliberate faults in the program, and what notices each.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::app {

struct Mutant {
  std::string id;
  std::string file;
  std::string change;
  std::string killer;
  std::string evidence;
};

/// Lines after the first, which names the columns id,file,change,killer,evidence. Fields may be quoted, with "" for a
/// quote and line breaks inside; a line with fewer fields leaves the rest empty.
std::vector<Mutant> read_mutants(std::string_view csv);

}  // namespace steadyslide::app
