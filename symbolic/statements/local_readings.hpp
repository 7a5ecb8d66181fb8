#pragma once
// Places of the paper's text, as extracted from its open version, where the local forms say something else, or ask for
// a condition that the words leave out: what the decision procedure makes of the printed reading and of the one that
// this project uses. Both stand in the reading notes, by the same ids. Without GiNaC in this header. Not thread-safe,
// as GiNaC is not. [Bal16]

#include <string>
#include <vector>

namespace steadyslide::symbolic {

struct LocalReading {
  std::string id;
  std::string found;   ///< what the local equation makes of either, in a sentence; empty if the signs alone decide
  bool printed_holds;  ///< decided, for the printed reading taken without any further condition
  bool derived_holds;
};

std::vector<LocalReading> local_readings();

}  // namespace steadyslide::symbolic
