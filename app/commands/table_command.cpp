// steadyslide table

#include <fmt/format.h>

#include <map>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/problem_file/list_parser.hpp"
#include "app/results/number_format.hpp"
#include "app/results/rows.hpp"
#include "model/elasticity.hpp"
#include "model/friction_profile.hpp"
#include "model/invalid_data.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_rows = 1000000;
constexpr std::initializer_list<Format> formats{Format::text, Format::json, Format::csv, Format::markdown,
                                                Format::latex};

/// What depends on one s = gamma f, at either end.
struct AngleCells {
  std::string alpha;
  std::string edge_left;
  std::string edge_right;
  std::string free_left;
  std::string free_right;
};

class Angles {
 public:
  explicit Angles(int digits) : digits_(digits) {}

  const AngleCells& of(const Rational& s) {
    const auto known = cells_.find(s);
    if (known != cells_.end()) return known->second;
    const auto text = [this](const Exponent& exponent) { return format_exponent(exponent, digits_); };
    return cells_
        .emplace(s, AngleCells{text(Exponent::angle(s)), text(edge_exponent(End::left, s)),
                               text(edge_exponent(End::right, s)), text(free_exponent(End::left, s)),
                               text(free_exponent(End::right, s))})
        .first->second;
  }

 private:
  int digits_;
  std::map<Rational, AngleCells> cells_;
};

std::vector<Rational> friction_list(const Given& given, const std::string& option) {
  std::vector<Rational> list = parse_list(option, given.text(option), max_rows);
  for (const Rational& f : list) {
    if (f < 0) {
      throw bad_command_line(option + ": negative friction coefficient", "a friction coefficient is at least 0",
                             to_string(f));
    }
  }
  return list;
}

std::vector<Elasticity> elasticities(const std::vector<Rational>& poisson) {
  std::vector<Elasticity> result;
  for (const Rational& nu : poisson) {
    try {
      result.emplace_back(Solid(nu, 1));
    } catch (const InvalidData& invalid) {
      throw bad_command_line(std::string("--poisson: ") + invalid.what());
    }
  }
  return result;
}

std::vector<std::string> formatted(const std::vector<Rational>& list, int digits) {
  std::vector<std::string> texts;
  texts.reserve(list.size());
  for (const Rational& value : list) texts.push_back(format_number(value, digits));
  return texts;
}

ExitCode run(const Given& given) {
  const auto [digits, format, file] = given.common(16, formats);
  const std::vector<Rational> poisson = parse_list("--poisson", given.text("--poisson"), max_rows);
  const std::vector<Elasticity> bodies = elasticities(poisson);
  const std::vector<Rational> rear = friction_list(given, "--rear");
  const std::vector<Rational> front = friction_list(given, "--front");
  if (poisson.size() * rear.size() > max_rows || poisson.size() * rear.size() * front.size() > max_rows) {
    throw bad_command_line(fmt::format("table too long; there are at most {} rows; {} x {} x {}", max_rows,
                                       poisson.size(), rear.size(), front.size()));
  }

  Output output(file);
  Rows rows(format,
            {{"nu"},
             {"f_rear"},
             {"f_front"},
             {"gamma"},
             {"alpha_rear"},
             {"alpha_front"},
             {"beta"},
             {"edge_rear"},
             {"edge_front"},
             {"free_rear"},
             {"free_front"}},
            output);
  const std::vector<std::string> rear_texts = formatted(rear, digits);
  const std::vector<std::string> front_texts = formatted(front, digits);
  for (std::size_t i = 0; i < poisson.size(); ++i) {
    const Rational& gamma = bodies[i].gamma();
    const std::string nu_text = format_number(poisson[i], digits);
    const std::string gamma_text = format_number(gamma, digits);
    // The angles of one gamma: those of the next are others.
    Angles angles(digits);
    for (std::size_t j = 0; j < rear.size(); ++j) {
      const Rational s_rear = gamma * rear[j];
      const AngleCells at_rear = angles.of(s_rear);
      for (std::size_t k = 0; k < front.size(); ++k) {
        const Rational s_front = gamma * front[k];
        const AngleCells& at_front = angles.of(s_front);
        rows.row({nu_text, rear_texts[j], front_texts[k], gamma_text, at_rear.alpha, at_front.alpha,
                  format_exponent(jump_exponent(s_rear, s_front), digits), at_rear.edge_left, at_front.edge_right,
                  at_rear.free_left, at_front.free_right});
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
                       list("--front", "Friction coefficients at the front")},
                      "Significant digits, 1 to 100; default 16", formats),
          run};
}

}  // namespace steadyslide::app
