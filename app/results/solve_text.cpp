#include <fmt/format.h>

#include "app/results/number_format.hpp"
#include "app/results/row_writer.hpp"
#include "app/results/solve_text_lines.hpp"
#include "app/results/solve_writers.hpp"

namespace steadyslide::app {
namespace {

void write_singular_points(const SolveReport& report, Output& output) {
  output.write(
      "\nsingular points (t = -intensity d^exponent; constant - intensity cos(pi alpha) d^exponent at jumps;\n"
      "constant + intensity log(d)/pi at wedges)\n");
  const auto rows =
      make_row_writer(Format::text, {{"  x"}, {"kind"}, {"exponent"}, {"intensity"}, {"constant"}, {"exact"}}, output);
  for (const SingularText& point : report.singular_points) {
    rows->row({"  " + shown(point.x), point.kind, shown(point.exponent.value), shown(point.intensity),
               shown(point.constant), point.exponent.symbolic});
  }
  rows->end();
}

void write_resultants(const Problem& problem, const SolveReport& report, Output& output) {
  output.write("\nresultants (forces per unit thickness, lengths in the problem's units)\n");
  write_line(output, "normal", report.normal);
  write_line(output, "tangential", report.tangential);
  write_line(output, "effective friction", report.effective_friction);
  write_line(output, "centre of pressure", report.centre_of_pressure);
  if (report.tilt) write_line(output, "tilt", *report.tilt);
  for (std::size_t k = 0; k < report.load_share.size(); ++k) {
    write_line(output, k == 0 ? "load share" : "",
               fmt::format("{} under f = {}", shown(report.load_share[k]),
                           exact_text(problem.contact.friction().values()[k])));
  }
}

void write_samples(const SolveReport& report, Output& output) {
  if (report.samples.empty()) return;
  output.write("\nsamples (left | right where the limits differ; traction and shear: force per area)\n");
  const auto rows = make_row_writer(Format::text, {{"  x"}, {"traction"}, {"shear"}, {"gap"}, {"slope"}}, output);
  for (const SampleText& sample : report.samples) {
    rows->row({"  " + sample.x, shown(sample.traction), shown(sample.shear), sample.gap ? shown(*sample.gap) : "-",
               shown(sample.slope)});
  }
  rows->end();
}

}  // namespace

void write_solve_text(const Problem& problem, const SolveReport& report, Output& output) {
  write_problem(problem.contact, output);
  output.write(fmt::format("method {}, {} digits\n\ncontact\n", report.method, report.digits));
  write_contact(report, output);
  write_singular_points(report, output);
  write_resultants(problem, report, output);
  write_samples(report, output);
  output.write("\nestimated relative errors\n");
  write_line(output, "ends", report.error_ends);
  write_line(output, "traction", report.error_traction);
  write_line(output, "resultants", report.error_resultants);
  output.write("\nrelative residuals, by an unrelated rule\n");
  write_line(output, "equation", report.residual_equation);
  write_line(output, "load", report.residual_load);
  write_line(output, "penetration", report.residual_penetration);
  write_line(output, "tension", report.residual_tension);
  write_uniqueness(report.uniqueness, report.shortcoming, output);
}

}  // namespace steadyslide::app
