// convergence-table [--quick]: prints the section "Convergence tables" of docs/cost.md. The exit code is 2 if the
// command line is wrong or if a problem is not solved on a mesh.

#include <cstdio>
#include <exception>
#include <string_view>

#include "proofs_checks/instruments/convergence/convergence_table.hpp"

int main(int argc, char** argv) {
  const bool quick = argc == 2 && std::string_view(argv[1]) == "--quick";
  if (argc > 1 && !quick) {
    std::fprintf(stderr, "usage: %s [--quick]\n", argv[0]);
    return 2;
  }
  try {
    std::fputs(steadyslide::proofs_checks::convergence_document(quick).c_str(), stdout);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 2;
  }
}
