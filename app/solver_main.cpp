#include "app/commands/command_line.hpp"

int main(int argc, char** argv) {
  using namespace steadyslide::app;
  return run_program({"steadyslide-solver",
                      "Steady sliding contact of an indenter on an elastic half-plane, with a friction\n"
                      "coefficient that is a step function under the indenter: exponents of the stress\n"
                      "singularities and contact pressure. The commands of steadyslide that need no ledger.",
                      {exponents_command(), table_command(), solve_command(), design_command(), sweep_command()}},
                     argc, argv);
}
