#include "app/sweep/sweep_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <new>

#include "app/results/rows.hpp"
#include "app/terminal/failure.hpp"
#include "library/problem_file/file_error.hpp"
#include "library/sweep/random_decimals.hpp"
#include "library/text/version.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::app {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() && &cell == &cells.front() ? "" : ",") + csv_field(cell);
  return line + "\n";
}

/// Removes line ends: a row is one line.
std::string without_line_ends(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// A number with as many digits as the results, words unchanged, the entries of an array separated by blanks.
std::string text_of(const Value& value, int digits) {
  if (value.kind == Value::Kind::list) {
    std::vector<std::string> parts;
    for (const Value& item : value.items) parts.push_back(text_of(item, digits));
    return fmt::format("{}", fmt::join(parts, " "));
  }
  try {
    // "+x" is not a number.
    return full_number(parse_rational(value.text), digits);
  } catch (const InvalidData&) {
    return without_line_ends(value.text);
  }
}

Solver::Wanted wanted_by(const SweepFile& sweep) {
  Solver::Wanted wanted;
  if (sweep.method) {
    try {
      wanted.method = method_named(sweep.method->text);
    } catch (const InvalidData& invalid) {
      throw Failure(ExitCode::bad_input, fmt::format("{}: {}", sweep.method->place, invalid.what()));
    }
  }
  wanted.solution.digits = sweep.digits.value_or(16);
  wanted.solution.over = sweep.over;
  wanted.solution.field.depth = sweep.depth;
  if (sweep.cells) wanted.variational.cells = static_cast<std::size_t>(*sweep.cells);
  wanted.cells_chosen = sweep.cells || sweep.accuracy;
  if (sweep.accuracy) wanted.variational.accuracy = sweep.accuracy->convert_to<double>();
  if (sweep.iterations) wanted.variational.most_steps = *sweep.iterations;
  return wanted;
}

}  // namespace

SweepTable::SweepTable(SweepFile sweep)
    : sweep_(std::move(sweep)),
      wanted_(wanted_by(sweep_)),
      columns_(sweep_.columns.empty() ? ResultColumns::usual() : sweep_.columns) {
  wanted_.solution.entries = columns_.entries();
  wanted_.solution.field.largest_stress = std::ranges::count(wanted_.solution.entries, "largest_stress") > 0;
  for (const VariedDatum& datum : sweep_.problems.data()) {
    std::vector<std::string>& texts = values_.emplace_back();
    for (const Value& value : datum.values) texts.push_back(text_of(value, wanted_.solution.digits));
  }
}

std::string SweepTable::header() const {
  std::vector<std::string> names;
  for (const VariedDatum& datum : sweep_.problems.data()) names.push_back(datum.path);
  for (std::string& name : columns_.names()) names.push_back(std::move(name));
  names.emplace_back("failed_condition");
  return line_of(names);
}

SolutionText SweepTable::solved(std::size_t n) const {
  SolutionText failed;
  try {
    const Problem problem = sweep_.problems.problem(n);
    if (wanted_.solution.digits > 16 &&
        takes_variational(wanted_.method, problem.contact, false, wanted_.solution.digits)) {
      failed.reason = digits_on_cells;
      return failed;
    }
    const Body& body = problem.contact.body();
    if (wanted_.solution.field.is_inside() && (body.symbols() || (!body.is_half_plane() && wanted_.solution.over))) {
      failed.reason = "given symbols do not tell the stresses inside, and averages are those of the half-plane";
      return failed;
    }
    return Solver(wanted_).solve(problem);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InvalidFile& invalid) {
    failed.reason = invalid.complaint();
  } catch (const std::exception& error) {
    failed.reason = fmt::format("internal failure: {}", error.what());
  }
  return failed;
}

std::vector<std::string> SweepTable::data(std::size_t n) const {
  std::vector<std::string> cells;
  const std::vector<std::size_t> chosen = sweep_.problems.chosen(n);
  for (std::size_t k = 0; k < chosen.size(); ++k) cells.push_back(values_[k][chosen[k]]);
  return cells;
}

std::string SweepTable::beginning(std::size_t n) const {
  std::string line = line_of(data(n));
  line.back() = ',';
  return line;
}

std::string SweepTable::row(std::size_t n) const {
  std::vector<std::string> cells = data(n);
  const SolutionText solution = solved(n);
  if (solution.reason.empty()) {
    for (std::string& cell : columns_.cells(solution)) cells.push_back(std::move(cell));
  } else {
    cells.resize(cells.size() + columns_.names().size());
  }
  cells.push_back(without_line_ends(solution.reason.empty() ? solution.failed_condition : solution.reason));
  return line_of(cells);
}

std::uint64_t SweepTable::fingerprint() const { return fnv1a(version, sweep_.fingerprint); }

}  // namespace steadyslide::app
