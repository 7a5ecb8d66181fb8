#include "library/steadyslide/steadyslide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

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
std::string toml_text(const LayerData& layer) {
  return fmt::format("{{thickness = {}, young = {}, poisson = {}, below = {}}}", toml_text(layer.thickness),
                     toml_text(layer.young), toml_text(layer.poisson), toml_text(layer.below.value_or("bonded")));
}
std::string toml_text(const HarmonicData& wave) {
  return fmt::format("{{n = {}, cos = {}, sin = {}}}", toml_text(wave.n), toml_text(wave.cos), toml_text(wave.sin));
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
  add(text, "layers", data.layers);
  add(text, "base", data.base);
  add(text, "period", data.period);
  add(text, "symbol", data.symbol);
  text += "[friction]\n";
  add(text, "values", data.friction);
  add(text, "jumps", data.jumps);
  text += "[indenter]\n";
  add(text, "support", data.support);
  add(text, "profile", data.profile);
  add(text, "pieces", data.pieces);
  add(text, "samples", data.samples);
  add(text, "harmonics", data.harmonics);
  if (data.elastic) {
    text += fmt::format("elastic = {{poisson = {}, young = {}}}\n", toml_text(data.elastic->poisson),
                        toml_text(data.elastic->young));
  }
  if (data.wear) {
    text += "[wear]\n";
    add(text, "coefficients", data.wear->coefficients);
    add(text, "body", data.wear->body);
  }
  return text;
}

Exact exact(const Rational& value) { return library::exact_text(value); }
std::vector<Exact> exact(const std::vector<Rational>& values) {
  std::vector<Exact> result;
  for (const Rational& value : values) result.push_back(exact(value));
  return result;
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

/// Returns the length of a window of averages. Throws InvalidData if it is not positive.
Rational window_of(const Exact& over) {
  const Rational length = rational(over, "over");
  if (length > 0) return length;
  throw InvalidData("over", "over: out of range", "the length of a window is positive", over.text());
}

Rational depth_of(const Exact& z, const std::string& field) {
  const Rational depth = rational(z, field);
  if (depth >= 0) return depth;
  throw InvalidData(field, field + ": above the surface", "a depth is at least 0", to_string(depth));
}

void check_materials(const Problem& problem, const std::string& of, const std::string& what) {
  if (contact_problem(problem).elasticity().half_space()) return;
  throw InvalidData(of, of + ": " + what, "it needs the half-space's poisson in place of gamma", "gamma");
}

void check_half_plane(const Problem& problem, const std::string& of) {
  if (contact_problem(problem).body().is_half_plane()) return;
  throw InvalidData(of, of + ": body without a field", "displacements and averages inside are those of the half-plane",
                    "layers, a period or symbols");
}

/// Throws InvalidData if the body has no stresses, or none at a depth of up to `z`.
void check_stress(const Problem& problem, const std::string& of, const Rational& z = 0) {
  const Body& body = contact_problem(problem).body();
  if (body.symbols())
    throw InvalidData(of, of + ": body without a field", "given symbols do not tell the stresses inside", "symbol");
  Rational bottom = 0;
  for (const Layer& layer : body.layers()) bottom += layer.thickness;
  if (body.layers().empty() || body.base() || z <= bottom) return;
  throw InvalidData("z", "z: in the rigid base", "z is at most " + library::exact_text(bottom), library::exact_text(z));
}

template <class Ask>
std::vector<double> one_by_one(const Solution& solution, std::span<const double> x, Ask ask) {
  check_finite("x", x);
  std::vector<double> result;
  result.reserve(x.size());
  for (const double place : x) result.push_back((solution.*ask)(place).value);
  return result;
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

void check(const char* option, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw InvalidData(option, std::string(option) + ": out of range",
                    fmt::format("it is a whole number from {} to {}", least, most), fmt::format("'{}'", value));
}

Number number_of(const Exponent& exponent, int digits) {
  const auto value = static_cast<double>(numeric::to_real<numeric::Real50>(exponent));  // the nearest double
  return {value, std::abs(value) * std::pow(10, 1 - digits), library::format_exponent(exponent, digits)};
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
Exact Problem::load() const { return exact(contact_problem(*this).load()); }
std::vector<Exact> Problem::friction() const { return exact(contact_problem(*this).friction().values()); }
std::vector<Exact> Problem::jumps() const { return exact(contact_problem(*this).friction().jumps()); }
std::pair<Exact, Exact> Problem::support() const {
  const Indenter& indenter = contact_problem(*this).indenter();
  return {exact(indenter.left()), exact(indenter.right())};
}

Problem read_problem(const std::string& file) {
  try {
    return Problem::from_text(library::read_input(file, "a problem file"), file);
  } catch (const library::InvalidFile& invalid) {
    throw InvalidData(std::string(invalid.what()));
  }
}

Solution solve(const Problem& problem, const SolveOptions& options, const Solution* start) {
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
  SolveWanted wanted{method, options.digits, {}, std::nullopt};
  const auto needs_cells = [&](const char* name) {
    if (on_cells) return;
    throw InvalidData(name, std::string(name) + ": method without cells",
                      "it goes with the method variational, and with auto where that takes it",
                      library::excerpt(options.method));
  };
  const auto take = [&](const char* name, const std::optional<int>& value, int least, int most, auto& option) {
    if (!value) return;
    check(name, *value, least, most);
    needs_cells(name);
    option = static_cast<std::decay_t<decltype(option)>>(*value);
  };
  take("cells", options.cells, numeric::fewest_cells, numeric::most_cells, wanted.variational.cells);
  take("iterations", options.iterations, 1, 10000, wanted.variational.most_steps);
  if (options.accuracy) {
    if (!std::isfinite(*options.accuracy) || !library::is_accuracy(Rational(*options.accuracy))) {
      throw InvalidData("accuracy", "accuracy: out of range", library::accuracy_rule,
                        fmt::format("'{}'", *options.accuracy));
    }
    needs_cells("accuracy");
    if (options.cells) {
      throw InvalidData("cells", "cells: conflicting option", "the accuracy chooses the cells", "accuracy");
    }
    wanted.variational.accuracy = *options.accuracy;
  } else if (!options.cells) {
    wanted.variational.accuracy = library::default_accuracy(data_of(problem).problem);
  }
  if (options.over) wanted.over = window_of(*options.over);
  const Solution::State* before = start != nullptr && start->solved() ? start->state_.get() : nullptr;
  return Solution(solved_state(problem, wanted, before));
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
Residuals Solution::residuals() const { return state_->residuals(); }
EstimatedError Solution::estimated_error() const { return state_->estimated_error(); }
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
  const Rational depth = depth_of(z, "z");
  check_stress(problem(), "stress", depth);
  return state_->stress(rational(x, "x"), depth);
}

Displacement Solution::displacement(const Exact& x, const Exact& z) const {
  check_half_plane(problem(), "displacement");
  check_materials(problem(), "displacement", "no displacement below the surface");
  return state_->displacement(rational(x, "x"), depth_of(z, "z"));
}

LargestStress Solution::max_stress(const std::optional<Exact>& depth, const std::optional<Exact>& over) const {
  check_stress(problem(), "max_stress");
  if (over) check_half_plane(problem(), "max_stress");
  check_materials(problem(), "max_stress", "no von Mises stress");
  return state_->max_stress(depth ? std::optional(depth_of(*depth, "depth")) : std::nullopt,
                            over ? std::optional(window_of(*over)) : std::nullopt);
}

std::vector<Stress> Solution::stress(std::span<const double> x, std::span<const double> z) const {
  if (x.size() != z.size()) {
    throw InvalidData("z", "z: not as many as x", "each point has an x and a z",
                      fmt::format("{} and {}", x.size(), z.size()));
  }
  check_finite("x", x);
  check_finite("z", z);
  const auto wrong = std::ranges::find_if(z, [](double depth) { return depth < 0; });
  if (wrong != z.end()) depth_of(*wrong, fmt::format("z[{}]", wrong - z.begin()));
  check_stress(problem(), "stress", z.empty() ? Rational(0) : rational(*std::ranges::max_element(z), "z"));
  return state_->stress(x, z);
}

std::vector<InterfaceStress> Solution::interface_stress() const {
  check_stress(problem(), "interface_stress");
  return state_->interface_stress();
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
      told.exponent = number_of(*point.exponent, digits);
      told.symbolic = to_string(*point.exponent);
    }
    result.push_back(std::move(told));
  }
  return result;
}

std::string derivation(const Problem& problem) {
  static std::mutex deriving;  // GiNaC is not for threads
  const std::lock_guard lock(deriving);
  std::string text;
  for (const symbolic::Derivation& one : library::derivations(contact_problem(problem))) {
    text += symbolic::to_text(one) + "\n";
  }
  return text;
}

}  // namespace steadyslide
