#include "app/results/solve_writers.hpp"

namespace steadyslide::app {
namespace {

using Ends = std::pair<EndText, EndText>;

Column number(const char* name) { return {name, Column::Holds::numbers}; }

template <class T>
std::vector<T> joined(std::vector<T> first, const std::vector<T>& second, const std::vector<T>& third) {
  first.insert(first.end(), second.begin(), second.end());
  first.insert(first.end(), third.begin(), third.end());
  return first;
}

/// Columns for a contact component, and for the contact that it belongs to.
const std::vector<Column> component_columns = joined<Column>(
    {number("left"), "left_kind", number("left_intensity")}, {number("right"), "right_kind", number("right_intensity")},
    {number("effective_friction"), number("centre_of_pressure"), number("load_share"), number("tilt")});

std::vector<Cell> component_cells(const SolutionText& whole, const Ends& component) {
  const auto& [left, right] = component;
  const ResultantsText& of = whole.resultants;
  return joined<Cell>({left.x, left.kind, left.intensity}, {right.x, right.kind, right.intensity},
                      {of.effective_friction, of.centre_of_pressure, of.load_share, of.tilt.value_or(NumberText())});
}

/// First the values, then columns without an error; the errors follow.
const std::vector<Column> sample_columns{
    "x",         number("traction"),    number("shear"),           number("gap"), number("slope"),
    number("u"), number("shear_slope"), number("cumulative_load"), "friction",    "side"};

/// Each row begins with the cells `first`.
void write_samples(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  for (const SampleText& at : solution.samples) {
    const bool two = at.two_sided();
    const auto row = [&](NumberText LimitText::*limit, const std::string& friction, const char* side) {
      rows.row(joined<Cell>(first, {at.x, at.traction.*limit, at.shear.*limit, at.gap, at.slope.*limit},
                            {at.displacement, at.shear_slope.*limit, at.cumulative_load, friction, two ? side : ""}));
    };
    row(&LimitText::left, at.friction.first, "left");
    if (two) row(&LimitText::right, at.friction.second, "right");
  }
}

const std::vector<Column> largest_stress_columns{"depth", number("von_mises"), number("x"), number("z"), "over"};

void write_largest_stress(const LargestStressText& largest, const std::vector<Cell>& first, Rows& rows) {
  rows.row(joined<Cell>(first, {largest.depth, largest.von_mises, largest.x, largest.z, ""}, {}));
  if (const auto& average = largest.average)
    rows.row(joined<Cell>(first, {"0", average->von_mises, average->x, average->z, average->over}, {}));
}

/// Returns the columns of a CSV file: those of the first table that was requested.
const std::vector<Column>& csv_columns(const FieldText& field) {
  if (!field.tables.empty()) return field.tables.front().columns;
  return field.largest_stress ? largest_stress_columns : sample_columns;
}

/// Each row begins with the cells `first`.
void write_csv_rows(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  const FieldText& field = solution.field;
  if (!field.tables.empty()) {
    for (const std::vector<Cell>& row : field.tables.front().rows) rows.row(joined<Cell>(first, row, {}));
  } else if (field.largest_stress) {
    write_largest_stress(*field.largest_stress, first, rows);
  } else {
    write_samples(solution, first, rows);
  }
}

}  // namespace

void write_csv(const Problem&, const SolutionText& solution, Output& output) {
  Rows rows(Format::csv, csv_columns(solution.field), output);
  write_csv_rows(solution, {}, rows);
  rows.end();
}

void write_csv(const Problem& problem, const BothText& both, Output& output) {
  Rows rows(Format::csv, joined<Column>({"sliding"}, csv_columns(both.as_given.field), {}), output);
  const Sliding sliding = problem.contact.sliding();
  write_csv_rows(both.as_given, {name_of(sliding)}, rows);
  write_csv_rows(both.opposite, {name_of(opposite(sliding))}, rows);
  rows.end();
}

void write_load_steps(Format format, const std::vector<LoadStep>& steps, bool certify, Output& output) {
  std::vector<Column> last{"failed_condition"};
  if (format == Format::json) last.emplace_back("warnings");
  if (certify) last.insert(last.end(), {{"until_load", Column::Holds::decimals}, {"status"}, {"event"}});
  Rows rows(
      format,
      joined({{"load", Column::Holds::decimals}, {"component", Column::Holds::decimals}}, component_columns, last),
      output);
  for (const auto& [load, solution, until] : steps) {
    for (const StretchText& stretch : until) {
      std::vector<Cell> told{stretch.is_open() ? stretch.words : ""};
      if (format == Format::json) told.emplace_back(std::vector<std::string>());
      told.insert(told.end(), {stretch.to, stretch.status, stretch.is_open() ? "" : stretch.words});
      rows.row(joined({stretch.from, ""}, component_cells({}, {}), told));
    }
    std::vector<Cell> notes{solution.reason.empty() ? solution.failed_condition : solution.reason};
    if (format == Format::json) notes.emplace_back(solution.warnings);
    if (certify) notes.insert(notes.end(), {"", solution.is_solved() ? "proved" : "open", ""});
    int component = 0;
    for (const Ends& ends : solution.contact) {
      rows.row(joined({load, std::to_string(++component)}, component_cells(solution, ends), notes));
    }
    if (component == 0) rows.row(joined({load, ""}, component_cells({}, {}), notes));
  }
  rows.end();
}

}  // namespace steadyslide::app
