// make_wrong_lemmas DIR: writes for each decided statement the lemma of one of its wrong variants, in a file of its
// own. Its cofactors leave a remainder.

#include <fstream>
#include <string>
#include <vector>

#include "symbolic/coq/coq_lemmas.hpp"
#include "symbolic/statements/statements.hpp"

using namespace steadyslide::symbolic;

namespace {

/// Returns the first false lemma of a wrong variant; `turn` chooses the variant. Empty for statements about numbers.
std::vector<CoqLemma> wrong_lemma(const DecidedStatement& statement, std::size_t turn) {
  for (std::size_t k = 0; k < statement.controls.size(); ++k) {
    const ExactIdentity& control = statement.controls[(turn + k) % statement.controls.size()];
    for (const CoqLemma& lemma : coq_lemmas(statement.id, control).lemmas) {
      if (!lemma.proved) return {lemma};
    }
  }
  return {};
}

}  // namespace

int main(int, char** argv) {
  const std::string folder = argv[1];
  std::size_t turn = 0;
  for (const StatementFamily& family : statement_families) {
    for (const DecidedStatement& statement : family.decide()) {
      const std::vector<CoqLemma> lemma = wrong_lemma(statement, turn++);
      if (lemma.empty()) continue;
      std::ofstream(folder + "/wrong_" + std::to_string(turn) + ".v") << coq_file(lemma);
    }
  }
}
