// steadyslide exponents

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/algorithm/string/replace.hpp>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/results/rows.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/solve/derivations.hpp"
#include "library/text/number_format.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {
namespace {

/// Writes the derivation of each exponent and of the closed form if there is one: as text, or as a LaTeX document.
void write_derivations(const ContactProblem& problem, Format format, Output& output) {
  const std::vector<symbolic::Derivation> all = derivations(problem);
  if (format == Format::latex) return output.write(symbolic::latex_document(all));
  for (const symbolic::Derivation& derivation : all) output.write(symbolic::to_text(derivation) + "\n");
}

void write_exponents(const ContactProblem& problem, const CommonOptions& options, bool certify, Output& output) {
  constexpr auto decimals = Column::Holds::decimals;
  Rows rows(options.format,
            {{"x", decimals},
             "kind",
             "side",
             {"friction", decimals},
             {"exponent", certify ? Column::Holds::numbers : decimals},
             "symbolic",
             {"latex", Column::Holds::formulas}},
            output);
  for (const SingularPoint& point : possible_singular_points(problem)) {
    std::vector<std::string> friction;
    for (const Rational& f : point.friction) friction.push_back(format_number(f, options.digits));
    const ExponentText exponent = exponent_text(point.exponent, options.digits);
    rows.row({point.x ? format_number(*point.x, options.digits) : std::string("anywhere"),
              std::string(name_of(point.kind)), std::string(name_of(point.contact)), friction,
              certify ? Cell(proved_exponent(point.exponent, options.digits)) : Cell(exponent.value), exponent.symbolic,
              exponent.latex});
  }
  rows.end();
}

/// Returns the help with the names of all kinds.
std::string help() {
  std::vector<std::string_view> names;
  for (const LocalTerms& kind : all_local_terms()) names.push_back(kind.name);
  return boost::replace_all_copy(std::string(embedded::help_exponents), "{kinds}",
                                 fmt::format("{}", fmt::join(names, ", ")));
}

ExitCode run_exponents(const Given& given) {
  const bool certify = given.has("--certify");
  const CommonOptions options = given.common(16, all_formats, certify ? most_proved_digits : most_digits);
  const bool derivation = given.has("--derivation");
  if (derivation && certify) {
    throw bad_command_line("--derivation: conflicting option", "a derivation is exact", "--certify");
  }
  if (derivation && options.format != Format::text && options.format != Format::latex) {
    throw bad_command_line("--derivation: wrong format", "a derivation is text or latex", format_name(options.format));
  }
  const Problem problem = read_problem(given.text("PROBLEM"));
  Output output(options.output);
  if (derivation) {
    write_derivations(problem.contact, options.format, output);
  } else {
    write_exponents(problem.contact, options, certify, output);
  }
  output.commit();
  return ExitCode::done;
}

}  // namespace

Command exponents_command() {
  return {"exponents", help().append(embedded::help_problem),
          with_common({problem_argument(),
                       {"--derivation", "", "How they are derived, step by step: text or latex", Option::Kind::flag},
                       certify_option("Enclosed in ball arithmetic, with an error that is proved")},
                      "Significant digits, 1 to 100, with --certify 1000; default 16", all_formats),
          run_exponents};
}

}  // namespace steadyslide::app
