#pragma once
// Places of the paper's text, as extracted from its open version, where the local forms say something else, or ask for
// a condition that the words leave out. Both readings stand side by side with what the decision procedure makes of
// them. Without GiNaC in this header. Not thread-safe, as GiNaC is not. [Bal16]

#include <string>
#include <vector>

namespace steadyslide::symbolic {

struct ReadingNote {
  std::string id;
  std::string place;
  std::string printed;   ///< as the extracted text has it
  std::string derived;   ///< what this project uses
  std::string evidence;  ///< what the local equation, or the signs, make of either; and whose fault it may be
  bool printed_holds;    ///< decided, for the printed reading taken without any further condition
  bool derived_holds;
};

std::vector<ReadingNote> reading_notes();

}  // namespace steadyslide::symbolic
