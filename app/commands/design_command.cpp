// steadyslide design

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "app/commands/command_line.hpp"
#include "app/embedded.hpp"
#include "app/results/rows.hpp"
#include "library/problem_file/problem_file.hpp"
#include "library/text/number_format.hpp"
#include "numeric/flat_punch/flat_punch.hpp"

namespace steadyslide::app {
namespace {

using numeric::Estimate;
using numeric::Real;

/// A coefficient of friction and its fraction of the contact.
struct Coating {
  Rational friction;
  Rational fraction;
};

struct Coatings {
  Coating smooth;
  Coating rough;
};

Coatings in_order(const Coating& a, const Coating& b) {
  return a.friction < b.friction ? Coatings{a, b} : Coatings{b, a};
}

Coatings coatings_of_options(const Given& given) {
  for (const auto& [option, other] : {std::pair("--coatings", "--fractions"), {"--fractions", "--coatings"}}) {
    if (given.has(option)) continue;
    throw bad_command_line(std::string(option) + ": missing", "coatings and their fractions go together", other);
  }
  const auto two = [&](const char* option) {
    const std::vector<Rational> list = parse_list(option, given.text(option), 10000);
    if (list.size() == 2) return list;
    throw bad_command_line(std::string(option) + ": not two", "layouts are found for two coatings", given.text(option));
  };
  const std::vector<Rational> friction = two("--coatings");
  const std::vector<Rational> fractions = two("--fractions");
  for (std::size_t k = 0; k < 2; ++k) {
    if (friction[k] < 0) {
      throw bad_command_line("--coatings: negative friction coefficient", "a friction coefficient is at least 0",
                             to_string(friction[k]));
    }
    if (fractions[k] <= 0) {
      throw bad_command_line("--fractions: out of range", "a fraction is larger than 0", to_string(fractions[k]));
    }
  }
  if (fractions[0] + fractions[1] != 1) {
    throw bad_command_line("--fractions: not the whole contact", "their sum is 1",
                           to_string(fractions[0] + fractions[1]));
  }
  if (friction[0] == friction[1]) {
    throw bad_command_line("--coatings: one friction", "two coatings differ", given.text("--coatings"));
  }
  return in_order({friction[0], fractions[0]}, {friction[1], fractions[1]});
}

Failure refused(const Problem& problem, const std::string& what, const std::string& rule, const std::string& value) {
  return {ExitCode::bad_input, fmt::format("{}: {}; {}; {}", problem.file, what, rule, value)};
}

/// Each fraction is the length with this coefficient over the whole length.
Coatings coatings_of_file(const Problem& problem) {
  const Indenter& punch = problem.contact.indenter();
  std::vector<Coating> coatings;
  for (const ContactProblem::Piece& piece : problem.contact.pieces()) {
    const Rational& friction = problem.contact.friction().values()[piece.friction];
    const auto same = std::ranges::find(coatings, friction, &Coating::friction);
    Coating& coating = same == coatings.end() ? coatings.emplace_back(Coating{friction, 0}) : *same;
    coating.fraction += (piece.right - piece.left) / (punch.right() - punch.left());
  }
  if (coatings.size() != 2) {
    throw refused(problem, "friction.values: not two coatings", "layouts are found for two",
                  fmt::format("{} of different friction", coatings.size()));
  }
  return in_order(coatings[0], coatings[1]);
}

void check_punch(const Problem& problem) {
  if (!problem.contact.body().is_half_plane()) {
    throw refused(problem, "half_space: another body", "layouts are found for a punch on a half-plane",
                  "layers, a period or symbols");
  }
  if (!numeric::punch_core<double>(problem.contact)) {
    throw refused(problem, "indenter: not a flat punch", "layouts are found for a rigid one with a constant profile",
                  "another");
  }
  if (problem.contact.load_at()) {
    throw refused(problem, "load_at: the punch may tilt", "layouts are found for a punch that keeps its attitude",
                  to_string(*problem.contact.load_at()));
  }
  if (problem.contact.elasticity().gamma() == 0) {
    throw refused(problem, "half_space.gamma: no coupling", "without it friction does not move the pressure", "0");
  }
}

struct Wanted {
  int digits;
  int jumps;  ///< at most this many
  bool largest;
  bool smallest;
};

/// The ids of two entries of the ledger behind a row: the layout is extreme; its friction.
using Entries = std::vector<std::string>;
Entries by_friction() { return {"flat-punch-effective-friction"}; }
Entries by_extreme() { return {"flat-punch-extreme-layouts", "flat-punch-effective-friction"}; }

/// Computes the rows in R.
template <Real R>
class Designer {
 public:
  Designer(const Wanted& wanted, const ContactProblem& problem, const Coatings& coatings, Rows& rows)
      : wanted_(wanted),
        problem_(problem),
        coatings_(coatings),
        coupling_(problem.with_friction(FrictionProfile({1})).coupled_friction(0)),
        rows_(rows) {}

  void extremes() {
    if (wanted_.largest) extreme("largest", coatings_.rough, coatings_.smooth);
    if (wanted_.smallest) extreme("smallest", coatings_.smooth, coatings_.rough);
  }

  void given() {
    std::vector<NumberText> jumps;
    for (const Rational& jump : problem_.friction().jumps()) jumps.push_back(exactly(jump));
    const auto layout = numeric::FrictionLayout<R>::of(problem_);
    row("given", problem_.friction().values(), jumps, numeric::EffectiveFriction<R>(layout), by_friction());
  }

  void mixtures() {
    const auto& [smooth, rough] = coatings_;
    const auto fine = numeric::fine_mixture<R>({smooth.fraction, rough.fraction},
                                               {coupling_ * smooth.friction, coupling_ * rough.friction});
    const NumberText limit = number(fine.s_eff / numeric::to_real<R>(coupling_));
    mixture("fine_mixture", limit, "flat-punch-fine-mixture-limit");
    const NumberText mean = exactly(smooth.fraction * smooth.friction + rough.fraction * rough.friction);
    mixture("mean", mean, "flat-punch-mixture-below-mean");
  }

 private:
  NumberText number(const Estimate<R>& estimate) const { return number_text(estimate, wanted_.digits); }
  NumberText exactly(const Rational& value) const {
    return number(Estimate<R>{numeric::to_real<R>(value), R(0)}.widened(numeric::epsilon<R>()));
  }

  void mixture(const std::string& name, const NumberText& friction, const std::string& entry) {
    rows_.row({name, std::vector<std::string>{}, std::vector<NumberText>{}, friction, friction, Entries{entry}});
  }

  void row(const std::string& name, const std::vector<Rational>& friction, const std::vector<NumberText>& jumps,
           const numeric::EffectiveFriction<R>& effective, const Entries& by) {
    std::vector<std::string> values;
    for (const Rational& f : friction) values.push_back(format_number(f, wanted_.digits));
    const R coupling = numeric::to_real<R>(coupling_);
    const Estimate<R> forth = effective.value();
    // s_eff(-alpha) = difference - s_eff(alpha). For the other direction of sliding the coupling changes its sign.
    const Estimate<R> back = forth - effective.direction_difference();
    rows_.row({name, values, jumps, number(forth / coupling), number(back / coupling), by});
  }

  void extreme(const std::string& name, const Coating& outer, const Coating& inner) {
    if (wanted_.jumps == 1) return one_jump(name);
    const auto found =
        numeric::extreme_layout<R>(coupling_ * outer.friction, coupling_ * inner.friction, inner.fraction);
    const Indenter& punch = problem_.indenter();
    const auto at = [&](const Rational& end, const Rational& length, const Estimate<R>& part) {
      using std::abs;
      const R from = numeric::to_real<R>(end);
      const Estimate<R> way = numeric::to_real<R>(length) * part;
      return number({from + way.value, way.error + 2 * numeric::epsilon<R>() * (abs(from) + abs(way.value))});
    };
    const Rational length = punch.right() - punch.left();
    row(name, {outer.friction, inner.friction, outer.friction},
        {at(punch.left(), length, found.left), at(punch.right(), -length, found.right)},
        numeric::EffectiveFriction<R>(found.layout), by_extreme());
  }

  /// The better one of the layouts rough | smooth and smooth | rough.
  void one_jump(const std::string& name) {
    const auto layout = [&](const Coating& left, const Coating& right) {
      return numeric::EffectiveFriction<R>(
          numeric::FrictionLayout<R>({numeric::to_real<R>(left.fraction), numeric::to_real<R>(right.fraction)},
                                     {coupling_ * left.friction, coupling_ * right.friction}));
    };
    using std::abs;
    const auto& [smooth, rough] = coatings_;
    const bool is_rougher = abs(layout(rough, smooth).value().value) > abs(layout(smooth, rough).value().value);
    const bool rough_is_left = is_rougher == (name == "largest");
    const Coating& left = rough_is_left ? rough : smooth;
    const Coating& right = rough_is_left ? smooth : rough;
    const Indenter& punch = problem_.indenter();
    row(name, {left.friction, right.friction}, {exactly(punch.left() + left.fraction * (punch.right() - punch.left()))},
        layout(left, right), by_friction());
  }

  const Wanted& wanted_;
  const ContactProblem& problem_;
  const Coatings& coatings_;
  Rational coupling_;  ///< s/f: +-gamma
  Rows& rows_;
};

ExitCode run_design(const Given& given) {
  const CommonOptions options = given.common(16, all_formats);
  if (given.has("--maximise") && given.has("--minimise")) {
    throw bad_command_line("--maximise: conflicting option", "without both, both are found", "--minimise");
  }
  const Wanted wanted{options.digits, given.count("--largest-jumps", 1, 10000).value_or(2), !given.has("--minimise"),
                      !given.has("--maximise")};
  const bool by_options = given.has("--coatings") || given.has("--fractions");
  std::optional<Coatings> coatings;
  if (by_options) coatings = coatings_of_options(given);
  const auto [problem, has_friction] = read_punch(given.text("PROBLEM"));
  check_punch(problem);
  if (!by_options && !has_friction) {
    throw refused(problem, "friction: no coatings", "they are given by [friction], or by --coatings and --fractions",
                  "absent");
  }
  if (!by_options) coatings = coatings_of_file(problem);

  Output output(options.output);
  const Column::Holds numbers = Column::Holds::numbers;
  Rows rows(options.format,
            {"layout",
             "friction",
             {"jumps", numbers},
             {"effective_friction", numbers},
             {"effective_friction_reversed", numbers},
             "by"},
            output);
  // Always with 50 digits or more: double loses its last digits to rounding.
  const numeric::Digits digits = std::max(numeric::precision_for(options.digits), numeric::Digits::fifty);
  try {
    numeric::at_precision(digits, [&, &problem = problem]<Real R>() {
      Designer<R> designer(wanted, problem.contact, *coatings, rows);
      designer.extremes();
      if (!by_options) designer.given();
      designer.mixtures();
    });
  } catch (const std::range_error& error) {
    throw refused(problem, "coatings: friction too large", error.what(), to_string(coatings->rough.friction));
  }
  rows.end();
  output.commit();
  return ExitCode::done;
}

}  // namespace

Command design_command() {
  return {"design", std::string(embedded::help_design).append(embedded::help_problem),
          with_common({problem_argument(),
                       {"--coatings", "LIST", "Two coefficients of friction, in the place of the problem's"},
                       {"--fractions", "LIST", "The part of the contact of each, together 1"},
                       {"--maximise", "", "The layout of largest friction alone", Option::Kind::flag},
                       {"--minimise", "", "The layout of smallest friction alone", Option::Kind::flag},
                       {"--largest-jumps", "N", "At most so many friction jumps; default 2, more change nothing"}},
                      "Significant digits, 1 to 100; default 16", all_formats),
          run_design};
}

}  // namespace steadyslide::app
