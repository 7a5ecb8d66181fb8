#include "app/solve_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/list_parser.hpp"
#include "app/solve_report.hpp"
#include "app/solve_writers.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_places = 100000;
constexpr int csv_samples = 101;

/// Zero, or in a range where squares and quotients of doubles neither overflow nor vanish.
bool is_comfortable(const Rational& value) {
  static const Rational limit = parse_rational("1e150");
  const Rational size = abs(value);
  return size == 0 || (size < limit && size * limit > 1);
}

bool fits_double(const ContactProblem& problem, const std::vector<Rational>& at) {
  std::vector<Rational> data{problem.load(), problem.elasticity().compliance(), problem.elasticity().gamma(),
                             problem.indenter().left()};
  for (const Rational& f : problem.friction().values()) data.push_back(f);
  for (const Rational& x : problem.friction().jumps()) data.push_back(x);
  for (const Indenter::Piece& piece : problem.indenter().pieces()) {
    data.push_back(piece.to);
    for (const Rational& c : piece.profile.coefficients()) data.push_back(c);
  }
  data.insert(data.end(), at.begin(), at.end());
  return std::all_of(data.begin(), data.end(), is_comfortable);
}

class Solve {
 public:
  Solve(const SolveOptions& options, Problem problem) : options_(options), problem_(std::move(problem)) {
    if (!options.at.empty()) at_ = parse_list("--at", options.at, max_places);
    samples_ = options.samples;
    if (options.common.format == Format::csv && at_.empty() && samples_ == 0) samples_ = csv_samples;
  }

  SolveReport report() const {
    const numeric::Digits digits = numeric::precision_for(options_.common.digits);
    if (digits == numeric::Digits::sixteen) {
      if (fits_double(problem_.contact, at_)) {
        SolveReport report = report_at<double>();
        if (report.in_range) return report;
      }
      return report_at<numeric::Real50>();
    }
    return numeric::at_precision(digits, [this]<numeric::Real R>() { return report_at<R>(); });
  }

  void write(const SolveReport& report) const {
    Output output(options_.common.output);
    switch (options_.common.format) {
      case Format::json: write_solve_json(problem_, report, output); break;
      case Format::csv: write_solve_csv(report, output); break;
      default: write_solve_text(problem_, report, output); break;
    }
    output.commit();
  }

 private:
  template <numeric::Real R>
  SolveReport report_at() const {
    const numeric::Attempt<R> attempt = numeric::closed_form<R>(problem_.contact);
    if (!attempt.solution) {
      throw bad_command_line(
          fmt::format("--method {}: no closed form applies; {}; other methods are not available in "
                      "this version",
                      options_.method, attempt.why_not));
    }
    return make_report(problem_, *attempt.solution, options_.common.digits, at_, samples_);
  }

  const SolveOptions& options_;
  Problem problem_;
  std::vector<Rational> at_;
  int samples_ = 0;
};

}  // namespace

ExitCode run(const SolveOptions& options) {
  Problem problem = read_problem(options.problem);
  if (problem.contact.load_at()) {
    throw Failure(ExitCode::bad_input,
                  fmt::format("{}:{}: load_at: solving with a tilting indenter is not available in this version",
                              problem.file, problem.load_at_line));
  }
  const Solve solve(options, std::move(problem));
  const SolveReport report = solve.report();
  solve.write(report);
  if (!report.converged) {
    throw Failure(ExitCode::refuted, options.problem + ": the solve did not converge; what was reached is printed");
  }
  return ExitCode::done;
}

}  // namespace steadyslide::app
