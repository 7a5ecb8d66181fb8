#pragma once
// Reads and checks the command line of `steadyslide solve`.

#include <optional>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/gnuplot/gnuplot.hpp"
#include "app/results/solution_text.hpp"
#include "library/solve/method.hpp"
#include "numeric/variational/variational_inequality.hpp"

namespace steadyslide::app {

struct SolveOptions {
  CommonOptions common;
  std::string method_name;
  Method method;
  std::string at;  ///< a list; empty if absent
  std::optional<std::string> at_file;
  bool both_directions;
  bool verbose;
  int samples;             ///< 0 for none
  std::string load_steps;  ///< a list; empty for the load of the file
  unsigned jobs;           ///< number of threads of a proof
  std::optional<int> cells;
  std::optional<int> iterations;
  std::optional<double> accuracy;
  bool certify;
  std::optional<std::string> certificate;  ///< the file to write
  std::optional<std::string> plot;         ///< the file to write
  FieldWanted field;
  std::optional<Rational> over;  ///< the length of the window of average pressures
  std::optional<Tolerance> tolerance;

  numeric::VariationalOptions variational() const {
    numeric::VariationalOptions result;
    if (cells) result.cells = static_cast<std::size_t>(*cells);
    if (iterations) result.most_steps = *iterations;
    result.accuracy = accuracy.value_or(0);
    return result;
  }
};

/// The options of the command.
std::vector<Option> solve_option_list();

/// Throws Failure (exit code 2) if an option has an invalid value, and if options exclude each other.
SolveOptions solve_options(const Given& given);

/// Throws Failure for options that the method does not take for this problem.
void check_method(const SolveOptions& options, const Problem& problem);

/// Returns the places of --at, then those of --at-file, and the points and meshes of the options for stresses and
/// forces. Reads files.
SolutionWanted solution_wanted(const SolveOptions& options);

/// Returns the loads of --load-steps.
std::vector<Rational> load_list(const std::string& text);

/// Chooses the format by the ending of the file's name.
Picture picture_of(const std::string& file);

}  // namespace steadyslide::app
