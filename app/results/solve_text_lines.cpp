#include "app/results/solve_text_lines.hpp"

#include <fmt/format.h>

#include "app/results/number_format.hpp"

namespace steadyslide::app {

std::string shown(const std::string& text) { return text.empty() ? "-" : text; }

std::string shown(const LimitText& limits) {
  return limits.two_sided() ? shown(limits.left) + " | " + shown(limits.right) : shown(limits.left);
}

void write_line(Output& output, const std::string& name, const std::string& value) {
  output.write(fmt::format("  {:<22}{}\n", name, shown(value)));
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

}  // namespace steadyslide::app
