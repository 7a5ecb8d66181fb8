#include "app/commands/command_line.hpp"

int main(int argc, char** argv) {
  using namespace steadyslide::app;
  Program program{
      "steadyslide",
      "Steady sliding contact of an indenter on an elastic half-plane or on layers, with a friction\n"
      "coefficient that is a step function under the indenter: exponents of the stress\n"
      "singularities, contact pressure, and a check of the theory's claims.",
      {exponents_command(), table_command(), solve_command(), design_command(), sweep_command(), wear_command()}};
#if STEADYSLIDE_LEDGER
  program.commands.insert(program.commands.begin(), verify_command());
  program.commands.insert(program.commands.end(), {figures_command(), report_command()});
#else
  program.absent = {"verify", "figures", "report"};
#endif
  return run_program(program, argc, argv);
}
