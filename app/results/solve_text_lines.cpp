#include "app/results/solve_text_lines.hpp"

#include <fmt/format.h>

#include "app/results/number_format.hpp"

namespace steadyslide::app {

std::string shown(const std::string& text) { return text.empty() ? "-" : text; }

std::string shown(const NumberText& number) { return shown(number.shown); }

std::string shown(const LimitText& limits) {
  const std::string& left = limits.left.shown;
  const std::string& right = limits.right.shown;
  return left != right ? shown(left) + " | " + shown(right) : shown(left);
}

void write_line(Output& output, const std::string& name, const std::string& value) {
  output.write(fmt::format("  {:<22}{}\n", name, shown(value)));
}

void write_line(Output& output, const std::string& name, const NumberText& value) {
  write_line(output, name, value.shown);
}

void write_problem(const ContactProblem& problem, Output& output) {
  output.write(fmt::format("load {}, indenter sliding towards {}, gamma = {}\n", exact_text(problem.load()),
                           problem.sliding() == Sliding::plus_x ? "+x" : "-x",
                           exact_text(problem.elasticity().gamma())));
}

void write_contact(const SolveReport& report, Output& output) {
  for (const auto& [left, right] : report.contact) {
    output.write(
        fmt::format("  from x = {} ({}) to x = {} ({})\n", shown(left.x), left.kind, shown(right.x), right.kind));
  }
}

void write_uniqueness(const Uniqueness& uniqueness, const std::string& shortcoming, Output& output) {
  if (!shortcoming.empty()) return;
  output.write(
      fmt::format("\n{}, {}\n", uniqueness.proved ? unique_by_theorem : "uniqueness: not covered", uniqueness.reason));
}

}  // namespace steadyslide::app
