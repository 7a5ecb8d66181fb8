// make_wrong_lemmas FILE: writes for each decided statement the lemma of one of its wrong variants. Its cofactors leave a
// remainder.

#include <fstream>
#include <string>
#include <utility>
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
  std::vector<CoqLemma> lemmas;
  std::size_t turn = 0;
  for (const StatementFamily& family : statement_families) {
    for (const DecidedStatement& statement : family.decide()) {
      for (CoqLemma& lemma : wrong_lemma(statement, turn++)) lemmas.push_back(std::move(lemma));
    }
  }
  std::ofstream(argv[1]) << coq_file(lemmas);
}
