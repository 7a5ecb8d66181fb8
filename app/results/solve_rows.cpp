#include <algorithm>
#include <array>

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

void write_stresses(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  for (const StressText& at : solution.field.stresses) {
    rows.row(joined<Cell>(first, {at.x, at.z, at.xx, at.zz, at.xz, at.yy, at.von_mises, at.largest_shear}, {}));
  }
}

void write_displacements(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  for (const auto& [x, z, along, down] : solution.field.displacements) {
    rows.row(joined<Cell>(first, {x, z, along, down}, {}));
  }
}

void write_interfaces(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  for (const auto& [depth, shear, shear_x, tension, tension_x] : solution.field.interfaces) {
    rows.row(joined<Cell>(first, {depth, shear, shear_x, tension, tension_x}, {}));
  }
}

void write_nodal_forces(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  for (const auto& [x, normal, tangential] : solution.field.nodal_forces) {
    rows.row(joined<Cell>(first, {x, normal, tangential}, {}));
  }
}

void write_largest_stress(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows) {
  const LargestStressText& largest = *solution.field.largest_stress;
  rows.row(joined<Cell>(first, {largest.depth, largest.von_mises, largest.x, largest.z, ""}, {}));
  if (const auto& average = largest.average)
    rows.row(joined<Cell>(first, {"0", average->von_mises, average->x, average->z, average->over}, {}));
}

/// A table of a solution. Each row begins with the cells `first`.
struct Table {
  std::string heading;  ///< in text; empty if the text is not a table
  bool (*applies)(const FieldText& field);
  std::vector<Column> columns;
  void (*write)(const SolutionText& solution, const std::vector<Cell>& first, Rows& rows);
};

const std::array<Table, 6> tables{
    {{"stresses in the body (tension positive; z into the body; force per area)",
      [](const FieldText& field) { return !field.stresses.empty(); },
      {"x", "z", number("sxx"), number("szz"), number("sxz"), number("syy"), number("von_mises"),
       number("largest_shear")},
      write_stresses},
     {"displacements of the body (along x, into the body; 0 where u is 0)",
      [](const FieldText& field) { return !field.displacements.empty(); },
      {"x", "z", number("ux"), number("uz")},
      write_displacements},
     {"interfaces (the largest shear and tension along each, and their places)",
      [](const FieldText& field) { return !field.interfaces.empty(); },
      {"depth", number("shear"), number("shear_x"), number("tension"), number("tension_x")},
      write_interfaces},
     {"nodal forces on the body (normal into the body, tangential along +x)",
      [](const FieldText& field) { return !field.nodal_forces.empty(); },
      {"x", number("normal"), number("tangential")},
      write_nodal_forces},
     {"",
      [](const FieldText& field) { return field.largest_stress.has_value(); },
      {"depth", number("von_mises"), number("x"), number("z"), "over"},
      write_largest_stress},
     {"", [](const FieldText&) { return true; }, sample_columns, write_samples}}};

/// Returns the table of a CSV file: the first that was requested.
const Table& requested_table(const SolutionText& solution) {
  return *std::ranges::find_if(tables, [&](const Table& table) { return table.applies(solution.field); });
}

}  // namespace

void write_field_tables(const SolutionText& solution, Output& output) {
  for (const Table& table : tables) {
    if (table.heading.empty() || !table.applies(solution.field)) continue;
    output.write("\n" + table.heading + "\n");
    Rows rows(table.columns, output);
    table.write(solution, {}, rows);
    rows.end();
  }
}

void write_csv(const Problem&, const SolutionText& solution, Output& output) {
  const Table& table = requested_table(solution);
  Rows rows(Format::csv, table.columns, output);
  table.write(solution, {}, rows);
  rows.end();
}

void write_csv(const Problem& problem, const BothText& both, Output& output) {
  const Table& table = requested_table(both.as_given);
  Rows rows(Format::csv, joined<Column>({"sliding"}, table.columns, {}), output);
  const Sliding sliding = problem.contact.sliding();
  table.write(both.as_given, {name_of(sliding)}, rows);
  table.write(both.opposite, {name_of(opposite(sliding))}, rows);
  rows.end();
}

void write_load_steps(Format format, const std::vector<LoadStep>& steps, bool certify, Output& output) {
  std::vector<Column> last{"failed_condition"};
  if (format == Format::json) last.push_back({"warnings"});
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
