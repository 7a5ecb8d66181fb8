#pragma once
// The command line of `steadyslide solve`, read and checked.

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
  std::string at;  ///< a list; empty: none
  std::optional<std::string> at_file;
  bool both_directions;
  int samples;             ///< 0: none
  std::string load_steps;  ///< a list; empty: the file's load
  unsigned jobs;           ///< threads that certify
  int search_starts;       ///< of a search for several solutions; 0: one solve
  std::optional<int> cells;
  std::optional<int> iterations;
  bool certify;
  std::optional<std::string> certificate;  ///< a file
  std::optional<std::string> plot;         ///< a file
  FieldWanted field;

  numeric::VariationalOptions variational() const {
    numeric::VariationalOptions result;
    if (cells) result.cells = static_cast<std::size_t>(*cells);
    if (iterations) result.most_steps = *iterations;
    return result;
  }
};

/// What the command takes.
std::vector<Option> solve_option_list();

/// Throws Failure (exit code 2) for what is no value of an option, and for options that exclude each other.
SolveOptions solve_options(const Given& given);

/// Refuses options that the method does not take for this problem.
void check_method(const SolveOptions& options, const Problem& problem);

/// The places of --at, then those of --at-file; stresses and forces. Reads files.
SolutionWanted solution_wanted(const SolveOptions& options);

/// Those of --load-steps.
std::vector<Rational> load_list(const std::string& text);

/// As the file's name ends.
Picture picture_of(const std::string& file);

}  // namespace steadyslide::app
