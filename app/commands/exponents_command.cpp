#include "app/commands/exponents_command.hpp"

#include "app/problem_file/problem_file.hpp"
#include "app/results/derivation_writer.hpp"
#include "app/results/exponent_text.hpp"
#include "app/results/number_format.hpp"
#include "app/results/row_writer.hpp"
#include "app/terminal/output.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {

ExitCode run(const ExponentsOptions& options) {
  const Problem problem = read_problem(options.problem);
  if (options.derivation) return write_derivations(options.common, problem.contact);
  const int digits = options.common.digits;
  Output output(options.common.output);
  const auto rows =
      make_row_writer(options.common.format,
                      {{"x"}, {"kind"}, {"side"}, {"friction"}, {"exponent"}, {"symbolic"}, {"latex", true}}, output);
  for (const SingularPoint& point : possible_singular_points(problem.contact)) {
    std::vector<std::string> friction;
    for (const Rational& f : point.friction) friction.push_back(format_number(f, digits));
    const ExponentText exponent = exponent_text(point.exponent, digits);
    rows->row({point.x ? format_number(*point.x, digits) : std::string("anywhere"), std::string(name_of(point.kind)),
               std::string(name_of(point.contact)), friction, exponent.value, exponent.symbolic, exponent.latex});
  }
  rows->end();
  output.commit();
  return ExitCode::done;
}

}  // namespace steadyslide::app
