// steadyslide table

#include <fmt/format.h>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/results/rows.hpp"
#include "library/text/number_format.hpp"
#include "model/elasticity.hpp"
#include "model/friction_profile.hpp"
#include "model/invalid_data.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_rows = 1000000;

/// The friction at one end of the contact, as cells of a row.
struct EndCells {
  Rational s;
  std::string friction;
  Cell alpha, edge, free;
};

/// An exponent as a text; if it is to be proved, with its error.
struct ExponentCell {
  int digits;
  bool certify;

  Cell operator()(const Exponent& exponent) const {
    if (certify) return proved_exponent(exponent, digits);
    return format_exponent(exponent, digits);
  }
};

std::vector<EndCells> end_cells(End end, const Rational& gamma, const std::vector<Rational>& friction,
                                const ExponentCell& cell) {
  std::vector<EndCells> cells;
  for (const Rational& f : friction) {
    const Rational s = gamma * f;
    cells.push_back({s, format_number(f, cell.digits), cell(Exponent::angle(s)), cell(edge_exponent(end, s)),
                     cell(free_exponent(end, s))});
  }
  return cells;
}

std::vector<Column> columns(bool certify) {
  std::vector<Column> result;
  for (const char* name : {"nu", "f_rear", "f_front", "gamma"}) result.emplace_back(name, Column::Holds::decimals);
  for (const char* name : {"alpha_rear", "alpha_front", "beta", "edge_rear", "edge_front", "free_rear", "free_front"}) {
    result.emplace_back(name, certify ? Column::Holds::numbers : Column::Holds::decimals);
  }
  return result;
}

std::vector<Rational> friction_list(const Given& given, const std::string& option) {
  std::vector<Rational> list = parse_list(option, given.text(option), max_rows);
  for (const Rational& f : list) {
    if (f >= 0) continue;
    throw bad_command_line(option + ": negative friction coefficient", "a friction coefficient is at least 0",
                           to_string(f));
  }
  return list;
}

std::vector<Rational> gammas(const std::vector<Rational>& poisson) {
  std::vector<Rational> result;
  for (const Rational& nu : poisson) {
    result.push_back(checked("--poisson", [&] { return Elasticity(Solid(nu, 1)).gamma(); }));
  }
  return result;
}

ExitCode run_table(const Given& given) {
  const bool certify = given.has("--certify");
  const auto [digits, format, file] = given.common(16, all_formats, certify ? most_proved_digits : most_digits);
  const ExponentCell cell{digits, certify};
  const std::vector<Rational> poisson = parse_list("--poisson", given.text("--poisson"), max_rows);
  const std::vector<Rational> gamma = gammas(poisson);
  const std::vector<Rational> rear = friction_list(given, "--rear");
  const std::vector<Rational> front = friction_list(given, "--front");
  if (poisson.size() * rear.size() > max_rows || poisson.size() * rear.size() * front.size() > max_rows) {
    throw bad_command_line(fmt::format("table too long; there are at most {} rows; {} x {} x {}", max_rows,
                                       poisson.size(), rear.size(), front.size()));
  }

  Output output(file);
  Rows rows(format, columns(certify), output);
  for (std::size_t i = 0; i < poisson.size(); ++i) {
    const std::string nu_text = format_number(poisson[i], digits);
    const std::string gamma_text = format_number(gamma[i], digits);
    const std::vector<EndCells> in_front = end_cells(End::right, gamma[i], front, cell);
    for (const EndCells& at_rear : end_cells(End::left, gamma[i], rear, cell)) {
      for (const EndCells& at_front : in_front) {
        rows.row({nu_text, at_rear.friction, at_front.friction, gamma_text, at_rear.alpha, at_front.alpha,
                  cell(jump_exponent(at_rear.s, at_front.s)), at_rear.edge, at_front.edge, at_rear.free,
                  at_front.free});
      }
    }
  }
  rows.end();
  output.commit();
  return ExitCode::done;
}

}  // namespace

Command table_command() {
  const auto list = [](const char* option, const char* what) {
    return Option{option, "LIST", what, Option::Kind::required};
  };
  return {"table", std::string(embedded::help_table),
          with_common({list("--poisson", "Poisson's ratios"), list("--rear", "Friction coefficients at the rear"),
                       list("--front", "Friction coefficients at the front"),
                       certify_option("Exponents enclosed in ball arithmetic, with errors that are proved")},
                      "Significant digits, 1 to 100, with --certify 1000; default 16", all_formats),
          run_table};
}

}  // namespace steadyslide::app
