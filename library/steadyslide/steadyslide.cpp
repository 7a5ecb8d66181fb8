#include "library/steadyslide/steadyslide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "library/problem_file/file_error.hpp"
#include "library/problem_file/input_file.hpp"
#include "library/solve/derivations.hpp"
#include "library/steadyslide/solution_state.hpp"
#include "library/text/number_format.hpp"
#include "library/text/one_line.hpp"
#include "library/text/version.hpp"
#include "model/singular_point.hpp"

namespace steadyslide {
namespace {

/// A text as a TOML string.
std::string toml_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    } else {
      result += c;
    }
  }
  return result + '"';
}
std::string toml_text(const Exact& number) { return toml_text(number.text()); }
std::string toml_text(const ProfilePiece& piece) {
  return fmt::format("{{to = {}, profile = {}}}", toml_text(piece.to), toml_text(piece.profile));
}

template <class T>
void add(std::string& text, const char* key, const std::vector<T>& list) {
  if (list.empty()) return;
  text += fmt::format("{} = [", key);
  for (const T& one : list) text += toml_text(one) + ", ";
  text += "]\n";
}
template <class T>
void add(std::string& text, const char* key, const std::optional<T>& value) {
  if (value) text += fmt::format("{} = {}\n", key, toml_text(*value));
}

std::string problem_text(const ProblemData& data) {
  std::string text = fmt::format("load = {}\n", toml_text(data.load));
  add(text, "load_at", data.load_at);
  add(text, "sliding", data.sliding);
  text += "[half_space]\n";
  add(text, "poisson", data.poisson);
  add(text, "young", data.young);
  add(text, "plane", data.plane);
  add(text, "gamma", data.gamma);
  text += "[friction]\n";
  add(text, "values", data.friction);
  add(text, "jumps", data.jumps);
  text += "[indenter]\n";
  add(text, "support", data.support);
  add(text, "profile", data.profile);
  add(text, "pieces", data.pieces);
  add(text, "samples", data.samples);
  if (data.elastic) {
    text += fmt::format("elastic = {{poisson = {}, young = {}}}\n", toml_text(data.elastic->poisson),
                        toml_text(data.elastic->young));
  }
  return text;
}

/// Returns the limit of the larger size.
const Number& larger(const Limits& limits) {
  return std::abs(limits.right.value) > std::abs(limits.left.value) ? limits.right : limits.left;
}

Number gap_of(const SurfaceSample& sample) {
  return sample.gap.value_or(Number{std::nan(""), std::numeric_limits<double>::infinity(), ""});
}

void check_finite(const char* field, std::span<const double> values) {
  const auto wrong = std::ranges::find_if_not(values, [](double value) { return std::isfinite(value); });
  if (wrong != values.end()) rational(*wrong, fmt::format("{}[{}]", field, wrong - values.begin()));
}

template <class Ask>
std::vector<double> one_by_one(const Solution& solution, std::span<const double> x, Ask ask) {
  check_finite("x", x);
  std::vector<double> result;
  result.reserve(x.size());
  for (const double place : x) result.push_back((solution.*ask)(place).value);
  return result;
}

void check(const char* option, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw InvalidData(option, std::string(option) + ": out of range",
                    fmt::format("it is a whole number from {} to {}", least, most), fmt::format("'{}'", value));
}

}  // namespace

const char* version() { return library::version; }

Exact::Exact(double value) : text_(fmt::format("{}", value)) {}

Rational rational(const Exact& number, const std::string& field) {
  try {
    return parse_rational(number.text());
  } catch (const InvalidData& invalid) {
    throw InvalidData(field + ": " + invalid.what());
  }
}

Problem::Problem(const ProblemData& data) : Problem(from_text(problem_text(data))) {}

Problem Problem::from_text(std::string_view text, const std::string& name) {
  try {
    return Problem(std::make_shared<Data>(Data{library::parse_problem(text, name), std::string(text)}));
  } catch (const library::InvalidFile& invalid) {
    throw InvalidData(name.empty() ? invalid.complaint() : invalid.what());
  }
}

const std::string& Problem::text() const { return data_->text; }
const std::string& Problem::name() const { return data_->problem.file; }

Problem read_problem(const std::string& file) {
  try {
    return Problem::from_text(library::read_input(file, "a problem file"), file);
  } catch (const library::InvalidFile& invalid) {
    throw InvalidData(std::string(invalid.what()));
  }
}

Solution solve(const Problem& problem, const SolveOptions& options) {
  library::Method method{};
  try {
    method = library::method_named(options.method);
  } catch (const InvalidData& invalid) {
    throw InvalidData(std::string("method: ") + invalid.what());
  }
  check("digits", options.digits, 1, 100);
  const bool on_cells = library::takes_variational(method, contact_problem(problem), false, options.digits);
  if (on_cells && options.digits > 16) {
    throw InvalidData("digits", "digits: out of range", library::digits_on_cells, fmt::format("'{}'", options.digits));
  }
  numeric::VariationalOptions variational;
  if (options.cells) {
    check("cells", *options.cells, numeric::fewest_cells, numeric::most_cells);
    if (!on_cells) {
      throw InvalidData("cells", "cells: method without cells",
                        "it goes with the method variational, and with auto where that takes it",
                        library::excerpt(options.method));
    }
    variational.cells = static_cast<std::size_t>(*options.cells);
  }
  return Solution(solved_state(problem, method, options.digits, variational));
}

const std::string& Solution::failed_condition() const { return state_->failed_condition; }
const std::string& Solution::method() const { return state_->method; }
int Solution::digits() const { return state_->digits; }
const Problem& Solution::problem() const { return state_->problem; }
std::vector<std::string> Solution::warnings() const {
  std::vector<std::string> all = state_->warnings();
  if (!state_->instead.empty()) all.insert(all.begin(), state_->instead);
  return all;
}

std::vector<ContactComponent> Solution::contact() const { return state_->contact(); }
std::vector<SolvedPoint> Solution::singular_points() const { return state_->singular_points(); }
std::vector<UnresolvedGap> Solution::unresolved_gaps() const { return state_->unresolved_gaps(); }
Resultants Solution::resultants() const { return state_->resultants(); }

SurfaceSample Solution::at(const Exact& x) const { return state_->at(rational(x, "x"), true); }
Number Solution::traction(const Exact& x) const { return larger(state_->at(rational(x, "x"), false).traction); }
Number Solution::shear(const Exact& x) const { return larger(state_->at(rational(x, "x"), false).shear); }
Number Solution::gap(const Exact& x) const { return gap_of(state_->at(rational(x, "x"), false)); }
Number Solution::slope(const Exact& x) const { return larger(state_->at(rational(x, "x"), false).slope); }

std::vector<double> Solution::traction(std::span<const double> x) const {
  check_finite("x", x);
  return state_->tractions(x).first;
}

std::vector<double> Solution::shear(std::span<const double> x) const {
  check_finite("x", x);
  return state_->tractions(x).second;
}

std::vector<double> Solution::gap(std::span<const double> x) const {
  return one_by_one(*this, x, static_cast<Number (Solution::*)(const Exact&) const>(&Solution::gap));
}

std::vector<double> Solution::slope(std::span<const double> x) const {
  return one_by_one(*this, x, static_cast<Number (Solution::*)(const Exact&) const>(&Solution::slope));
}

Stress Solution::stress(const Exact& x, const Exact& z) const {
  const Rational depth = rational(z, "z");
  if (depth <= 0) throw InvalidData("z", "z: not below the surface", "a depth is positive", to_string(depth));
  return state_->stress(rational(x, "x"), depth);
}

std::vector<Stress> Solution::stress(std::span<const double> x, std::span<const double> z) const {
  if (x.size() != z.size()) {
    throw InvalidData("z", "z: not as many as x", "each point has an x and a z",
                      fmt::format("{} and {}", x.size(), z.size()));
  }
  check_finite("x", x);
  check_finite("z", z);
  const auto wrong = std::ranges::find_if(z, [](double depth) { return depth <= 0; });
  if (wrong != z.end()) {
    throw InvalidData("z", fmt::format("z[{}]: not below the surface", wrong - z.begin()), "a depth is positive",
                      Exact(*wrong).text());
  }
  return state_->stress(x, z);
}

std::vector<NodalForce> Solution::nodal_forces(const Mesh& mesh) const {
  try {
    return state_->nodal_forces(mesh);
  } catch (const InvalidData& invalid) {
    throw InvalidData((invalid.field().empty() ? "" : invalid.field() + ": ") + invalid.what());
  }
}

std::vector<PossiblePoint> exponents(const Problem& problem, int digits) {
  check("digits", digits, 1, 100);
  std::vector<PossiblePoint> result;
  for (const SingularPoint& point : possible_singular_points(contact_problem(problem))) {
    PossiblePoint told{point.x ? library::exact_text(*point.x) : "", std::string(name_of(point.kind)),
                       std::string(name_of(point.contact)), std::nullopt, ""};
    if (point.exponent) {
      const std::string text = library::format_exponent(*point.exponent, digits);
      const auto value = numeric::to_real<double>(*point.exponent);
      told.exponent = Number{value, std::abs(value) * 1e-16, text};
      told.symbolic = to_string(*point.exponent);
    }
    result.push_back(std::move(told));
  }
  return result;
}

std::string derivation(const Problem& problem) {
  std::string text;
  for (const symbolic::Derivation& one : library::derivations(contact_problem(problem))) {
    text += symbolic::to_text(one) + "\n";
  }
  return text;
}

}  // namespace steadyslide
