#include "app/commands/table_command.hpp"

#include <fmt/format.h>

#include <map>

#include "app/problem_file/list_parser.hpp"
#include "app/results/exponent_text.hpp"
#include "app/results/number_format.hpp"
#include "app/results/row_writer.hpp"
#include "app/terminal/output.hpp"
#include "model/elasticity.hpp"
#include "model/friction_profile.hpp"
#include "model/invalid_data.hpp"
#include "model/singular_point.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_rows = 1000000;

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

std::vector<Rational> friction_list(const std::string& option, const std::string& text) {
  std::vector<Rational> list = parse_list(option, text, max_rows);
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

}  // namespace

ExitCode run(const TableOptions& options) {
  const int digits = options.common.digits;
  const std::vector<Rational> poisson = parse_list("--poisson", options.poisson, max_rows);
  const std::vector<Elasticity> bodies = elasticities(poisson);
  const std::vector<Rational> rear = friction_list("--rear", options.rear);
  const std::vector<Rational> front = friction_list("--front", options.front);
  if (poisson.size() * rear.size() > max_rows || poisson.size() * rear.size() * front.size() > max_rows) {
    throw bad_command_line(fmt::format("table too long; there are at most {} rows; {} x {} x {}", max_rows,
                                       poisson.size(), rear.size(), front.size()));
  }

  Output output(options.common.output);
  const auto rows = make_row_writer(options.common.format,
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
        rows->row({nu_text, rear_texts[j], front_texts[k], gamma_text, at_rear.alpha, at_front.alpha,
                   format_exponent(jump_exponent(s_rear, s_front), digits), at_rear.edge_left, at_front.edge_right,
                   at_rear.free_left, at_front.free_right});
      }
    }
  }
  rows->end();
  output.commit();
  return ExitCode::done;
}

}  // namespace steadyslide::app
