#pragma once
/// \file
/// Steady sliding contact of an indenter on an elastic half-plane whose friction coefficient jumps: this header is all that
/// a program needs.
///
///     const auto problem = steadyslide::read_problem("two_coatings.toml");
///     const auto solution = steadyslide::solve(problem);              // or solve(problem, {.digits = 50})
///     std::cout << solution.effective_friction().value << ' ' << solution.traction("1/2").value << '\n';
///
/// Signs and units: x along the surface, z > 0 the depth; traction t <= 0, shear along +x, gap >= 0, slope = u'; stresses are
/// positive in tension; all in the user's units, forces per unit of thickness (docs/conventions.md).
///
/// Errors: data that break a rule throw InvalidData with what the command line says of them; a file that cannot be read
/// throws std::system_error. A solve that does not converge throws nothing: Solution::solved(), failed_condition().
///
/// Threads: every class here may be copied and read by any number of threads at a time, and all functions may be called
/// from several.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "library/answer/quantities.hpp"
#include "model/invalid_data.hpp"

#define STEADYSLIDE_API __attribute__((visibility("default")))

namespace steadyslide {

/// The library's version, "0.1.0".
STEADYSLIDE_API const char* version();

/// A number as data are given: exactly what is written, "0.1", "1/3", "2.5e-3". A double is the shortest decimal that gives
/// it back: 0.1 is 1/10. That a text is no number is said where it is used.
class STEADYSLIDE_API Exact {
 public:
  Exact(std::string text) : text_(std::move(text)) {}
  Exact(std::string_view text) : text_(text) {}
  Exact(const char* text) : text_(text) {}
  Exact(double value);
  template <class Whole, std::enable_if_t<std::is_integral_v<Whole> && !std::is_same_v<Whole, bool>, int> = 0>
  Exact(Whole value) : text_(std::to_string(value)) {}

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A result: the double nearest to it, its estimated absolute error, and all digits that were asked for. Not known: no
/// number, and no digits.
struct Number {
  double value = 0;
  double error = 0;
  std::string digits;
};

/// The limits from both sides; equal where the function is continuous, infinite where it blows up.
struct Limits {
  Number left;
  Number right;
};

struct ElasticBody {
  Exact poisson;
  Exact young = 1;
};

struct ProfilePiece {
  Exact to;
  std::string profile;
};

/// A problem file's data (docs/problem-file.md), with its defaults.
struct ProblemData {
  Exact load;                      ///< P > 0
  std::vector<Exact> friction;     ///< one value more than jumps
  std::vector<Exact> jumps = {};   ///< where the friction jumps
  std::optional<Exact> poisson{};  ///< this, or gamma
  std::optional<Exact> young{};
  std::optional<std::string> plane{};  ///< "strain" or "stress"
  std::optional<Exact> gamma{};
  std::optional<std::string> sliding{};  ///< "+x" or "-x"
  std::optional<Exact> load_at{};        ///< where the load acts on an indenter that may tilt
  std::vector<Exact> support{};          ///< left and right, or none for -1, 1
  std::optional<std::string> profile{};  ///< a polynomial of x, "x^2/2"; or pieces, or samples
  std::vector<ProfilePiece> pieces{};
  std::optional<std::string> samples{};  ///< a trace's file
  std::optional<ElasticBody> elastic{};  ///< the indenter
};

/// A contact problem, exact. It cannot be changed.
class STEADYSLIDE_API Problem {
 public:
  /// Throws InvalidData "friction.jumps[0]: what is wrong; the rule; the value", fields named as in problem files.
  Problem(const ProblemData& data);

  /// The text of a problem file; empty, there is no file in what InvalidData says. Samples are looked for beside `name`.
  static Problem from_text(std::string_view text, const std::string& name = "");

  /// The problem file that says the same.
  const std::string& text() const;
  /// Of the file that it was read from; empty without one.
  const std::string& name() const;

  struct Data;

 private:
  friend const Data& data_of(const Problem& problem);
  explicit Problem(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// Throws InvalidData "FILE:LINE: what is wrong; the rule; the value", std::system_error for a file that cannot be
/// read.
STEADYSLIDE_API Problem read_problem(const std::string& file);

struct ContactEnd {
  Number x;
  std::string kind;  ///< edge, free, step, ...
  Number exponent;   ///< t ~ -intensity d^exponent, d the distance
  Number intensity;
};

struct ContactComponent {
  ContactEnd left;
  ContactEnd right;
  Number width;
  Number load;
};

struct SolvedPoint {
  Number x;
  std::string kind;
  std::optional<Number> exponent;  ///< absent: a logarithm
  std::string symbolic;            ///< the exponent, exact: "-1/2 - arctan(3/35)/pi"
  Number intensity;
  Number constant;
  std::optional<Number> stress_intensity_left;  ///< K in p ~ K (2 pi d)^exponent where there is contact
  std::optional<Number> stress_intensity_right;
};

/// A place where the traction can be singular, whatever the contact turns out to be.
struct PossiblePoint {
  std::string x;  ///< exact; empty: anywhere
  std::string kind;
  std::string side;  ///< of x on which there is contact: left, right, both
  std::optional<Number> exponent;
  std::string symbolic;
};

/// A gap over a notch of the profile that is too short for any place in it to have a number: a solution has contact there.
struct UnresolvedGap {
  Number x;
  double log10_length = 0;  ///< by order of magnitude
};

/// The numbers of the whole contact, by name: normal, friction_force, mean_pressure, ... (library/answer/quantities.hpp).
/// A finite largest pressure has no exponent. `tilt` exists if the indenter may tilt, `core` if the punch is rigid and flat.
/// Without contact, widths and pressures are NaN.
using Resultants = answer::ResultantsOf<Number, std::optional<Number>>;
using LargestPressure = Resultants::Largest;
/// From left to right.
using Interval = answer::IntervalOf<Number>;

/// All that is known of a place of the surface.
struct SurfaceSample {
  Limits traction;
  Limits shear;
  std::optional<Number> gap;  ///< absent outside the support
  Limits slope;
  Number displacement;     ///< u, zero at x = 0, or at the support's left end if x = 0 lies outside of it
  Limits shear_slope;      ///< u_t'
  Number cumulative_load;  ///< the load left of x
};

/// At a point of the body; yy, the invariants with it and the gradient are absent with gamma instead of materials.
struct Stress {
  Number xx, zz, xz, largest_shear;
  std::optional<Number> yy, mean, von_mises;
  std::optional<Number> ux_x, ux_z, uz_x, uz_z;  ///< d u_x/dx, ..., u_x and u_z along +x and +z
};

/// int t N and int t_t N on the body, N the shape function: along +z, into the body, and along +x.
struct NodalForce {
  Number normal;
  Number tangential;
};

/// Elements of the surface: linear ones between nodes, or quadratic ones with every second node in the middle of one (to
/// 12 digits, since nodes are often computed in double).
struct Mesh {
  std::vector<Exact> nodes;
  int order = 1;
};

/// What is proved of a solution in ball arithmetic. Its certificate is for steadyslide-check (docs/certificate.md).
struct Proof {
  bool proved = false;
  std::string reason;       ///< why not
  std::string certificate;  ///< JSON; empty if nothing is proved
  /// Gaps of the certified solution, which may have been found with more digits. Left to right.
  std::vector<UnresolvedGap> unresolved_gaps{};

  /// Writes the certificate. Throws std::runtime_error if there is none, or the file cannot be written.
  STEADYSLIDE_API void save(const std::string& file) const;
};

struct SolveOptions {
  int digits = 16;              ///< 1 to 100
  std::string method = "auto";  ///< or closed-form, riemann-hilbert, variational
  std::optional<int> cells{};   ///< of the variational method, 16 to 4194304
};

/// A solved problem, or the best state that was reached.
class STEADYSLIDE_API Solution {
 public:
  bool solved() const { return failed_condition().empty(); }
  /// What is violated, in words; empty where solved.
  const std::string& failed_condition() const;
  /// closed-form, riemann-hilbert or variational.
  const std::string& method() const;
  int digits() const;
  const Problem& problem() const;
  /// What a person should know before it is used: the warnings of the command solve, one line each.
  std::vector<std::string> warnings() const;

  std::vector<ContactComponent> contact() const;
  std::vector<SolvedPoint> singular_points() const;
  /// Left to right.
  std::vector<UnresolvedGap> unresolved_gaps() const;
  Resultants resultants() const;
  // One function for each quantity: effective_friction(), largest_pressure(), ... Each call computes all of them; if you need
  // several, call resultants() once.
#define STEADYSLIDE_QUANTITY(type, key, ...) \
  Resultants::type key() const { return resultants().key; }
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY

  /// Everything at one place. Throws InvalidData "x: ..." for what is no number.
  SurfaceSample at(const Exact& x) const;
  /// At one place; where the limits differ, that of the larger size. The gap is not known outside the support.
  Number traction(const Exact& x) const;
  Number shear(const Exact& x) const;
  Number gap(const Exact& x) const;
  Number slope(const Exact& x) const;
  /// At many places, in double and without errors, tractions faster than one by one.
  std::vector<double> traction(std::span<const double> x) const;
  std::vector<double> shear(std::span<const double> x) const;
  std::vector<double> gap(std::span<const double> x) const;
  std::vector<double> slope(std::span<const double> x) const;

  /// Below the surface, z > 0. Throws InvalidData.
  Stress stress(const Exact& x, const Exact& z) const;
  /// At many points, in double without further digits; spans of one length.
  std::vector<Stress> stress(std::span<const double> x, std::span<const double> z) const;
  /// One for each node. Throws InvalidData of a mesh that is none, or that contact reaches beyond.
  std::vector<NodalForce> nodal_forces(const Mesh& mesh) const;

  /// Proves it. Takes some ten times as long as a solve.
  Proof certify() const;

  struct State;

 private:
  friend STEADYSLIDE_API Solution solve(const Problem& problem, const SolveOptions& options);
  explicit Solution(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// 16 digits are found in double, and where double is not enough with 50. Throws InvalidData for options out of range, and
/// for a method that does not apply.
STEADYSLIDE_API Solution solve(const Problem& problem, const SolveOptions& options = {});

/// Where the traction can be singular, and with which exponent.
STEADYSLIDE_API std::vector<PossiblePoint> exponents(const Problem& problem, int digits = 16);

/// How the exponents come about, step by step, and the closed form where there is one.
STEADYSLIDE_API std::string derivation(const Problem& problem);

}  // namespace steadyslide
