#include "app/commands/command_line.hpp"

int main(int argc, char** argv) {
  using namespace steadyslide::app;
  return run_program({"steadyslide",
                      "Steady sliding contact of an indenter on an elastic half-plane, with a friction\n"
                      "coefficient that is a step function under the indenter: exponents of the stress\n"
                      "singularities, contact pressure, and a check of the theory's claims.",
                      {verify_command(), exponents_command(), table_command(), solve_command(), design_command(),
                       sweep_command(), figures_command(), report_command()}},
                     argc, argv);
}
