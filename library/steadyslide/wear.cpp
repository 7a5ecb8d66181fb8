#include "library/steadyslide/solution_state.hpp"
#include "numeric/wear/wear_run.hpp"

namespace steadyslide {

WearHistory wear(const Problem& problem, const WearOptions& options,
                 const std::function<void(const WearRow&, const std::vector<double>& pressure,
                                          const std::vector<double>& depth)>& after_step) {
  const std::optional<Wear>& coefficients = data_of(problem).problem.wear;
  if (!coefficients) throw InvalidData("wear", "wear: missing", "the problem has coefficients of wear", "absent");
  if (options.steps && options.accuracy)
    throw InvalidData("steps", "steps: conflicting option", "the accuracy chooses the steps", "accuracy");
  numeric::wear::WearWanted wanted;
  wanted.distance = rational(options.distance, "distance").convert_to<double>();
  if (options.steps) {
    check("steps", *options.steps, 1, 1000000);
    wanted.steps = *options.steps;
  }
  wanted.accuracy = options.accuracy.value_or(wanted.accuracy);
  wanted.until = options.until.value_or(0);
  if (options.cells) {
    check("cells", *options.cells, numeric::fewest_cells, numeric::most_cells);
    wanted.cells = static_cast<std::size_t>(*options.cells);
  }
  std::optional<numeric::wear::WearRun> run;
  try {
    run.emplace(contact_problem(problem), *coefficients, wanted);
  } catch (const InvalidData& invalid) {
    throw InvalidData((invalid.field().empty() ? "" : invalid.field() + ": ") + invalid.what());
  }
  const numeric::wear::WearProcess& process = run->process();
  WearHistory history;
  while (true) {
    history.rows.push_back(run->row());
    history.pressure = process.pressures(run->state());
    history.depth = process.depths(run->state());
    if (after_step) after_step(run->row(), history.pressure, history.depth);
    if (run->is_over()) break;
    run->advance();
  }
  history.edges = process.edges();
  history.run_in_pressure = process.run_in_pressures();
  history.failed_condition = run->row().failed_condition;
  return history;
}

}  // namespace steadyslide
