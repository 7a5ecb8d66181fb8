#pragma once
// Lines that the texts of `steadyslide solve` share.

#include <string>

#include "app/results/solve_report.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {

/// What is not known, or no number, must not look like nothing: "-".
std::string shown(const std::string& text);
std::string shown(const NumberText& number);
std::string shown(const LimitText& limits);

void write_line(Output& output, const std::string& name, const std::string& value);
void write_line(Output& output, const std::string& name, const NumberText& value);
/// Load, direction and coupling constant.
void write_problem(const ContactProblem& problem, Output& output);
/// One line for each contact component.
void write_contact(const SolveReport& report, Output& output);
/// Is it the only solution? Nothing where there is no solution.
void write_uniqueness(const Uniqueness& uniqueness, const std::string& shortcoming, Output& output);

}  // namespace steadyslide::app
