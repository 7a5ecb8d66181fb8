#pragma once
/// \file
/// Steady sliding contact of an indenter on an elastic half-plane, with a friction coefficient that jumps along the
/// surface. A program needs only this header.
///
///     const auto problem = steadyslide::read_problem("two_coatings.toml");
///     const auto solution = steadyslide::solve(problem);              // or solve(problem, {.digits = 50})
///     std::cout << solution.effective_friction().value << ' ' << solution.traction("1/2").value << '\n';
///
/// Signs and units: x is along the surface, z > 0 is the depth. The traction is t <= 0, the shear is along +x, the gap
/// is >= 0, the slope is u'. Stresses are positive in tension. All numbers are in the user's units; forces are per unit
/// of thickness (docs/results.md).
///
/// Errors: data that break a rule throw InvalidData, with the message of the command line. A file that cannot be read
/// throws std::system_error. A solve that does not converge throws nothing: check Solution::solved() and
/// failed_condition().
///
/// Threads: any number of threads may copy and read every class here at the same time, and may call all functions.

#include <cstddef>
#include <functional>
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
#include "numeric/wear/wear_row.hpp"

#define STEADYSLIDE_API __attribute__((visibility("default")))

namespace steadyslide {

/// The library's version, "x.y.z".
STEADYSLIDE_API const char* version();

/// A number as input, exactly as it is written: "0.1", "1/3", "2.5e-3". A double becomes the shortest decimal that
/// rounds to it: 0.1 becomes 1/10. The text is not checked here; a function that uses it throws InvalidData if it is
/// not a number.
class STEADYSLIDE_API Exact {
 public:
  Exact(std::string text) : text_(std::move(text)) {}
  Exact(std::string_view text) : text_(text) {}
  Exact(const char* text) : text_(text) {}
  Exact(double value);
  template <class Integer, std::enable_if_t<std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>, int> = 0>
  Exact(Integer value) : text_(std::to_string(value)) {}

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A result: the double nearest to it, its estimated absolute error, and all requested digits. The error includes the
/// rounding of `digits`, or of `value` where `digits` is empty. For an unknown result, `value` is NaN, `error` is infinite
/// and `digits` is empty.
struct Number {
  double value = 0;
  double error = 0;
  std::string digits;
};

/// The limits from both sides. They are equal where the function is continuous, and infinite where it is unbounded.
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

/// A layer of the body (docs/problem-file.md).
struct LayerData {
  Exact thickness;
  Exact young;
  Exact poisson;
  std::optional<std::string> below{};  ///< "bonded" or "slip"
};

/// A wave of the profile, cos cos(2 pi n x/period) + sin sin(2 pi n x/period).
struct HarmonicData {
  Exact n;
  Exact cos = 0;
  Exact sin = 0;
};

/// Archard's coefficients of wear: depth per pressure and sliding distance.
struct WearData {
  std::vector<Exact> coefficients;  ///< of the indenter, one for each friction value, or one for all
  std::optional<Exact> body{};      ///< of the body, which is passed once
};

/// The data of a problem file, with its defaults (docs/problem-file.md).
struct ProblemData {
  Exact load;                      ///< P > 0
  std::vector<Exact> friction;     ///< one value more than there are jumps
  std::vector<Exact> jumps = {};   ///< the places at which the friction jumps
  std::optional<Exact> poisson{};  ///< give either `poisson` or `gamma`
  std::optional<Exact> young{};
  std::optional<std::string> plane{};  ///< "strain" or "stress"
  std::optional<Exact> gamma{};
  std::vector<LayerData> layers{};       ///< from the surface down; `poisson` and `young` are those of the base
  std::optional<std::string> base{};     ///< under layers: "elastic" or "rigid"
  std::optional<Exact> period{};         ///< of indenters that repeat
  std::optional<std::string> symbol{};   ///< the file of the body's symbols
  std::optional<std::string> sliding{};  ///< "+x" or "-x"
  std::optional<Exact> load_at{};        ///< the place of the load, for an indenter that may tilt
  std::vector<Exact> support{};          ///< left and right end; empty for -1 and 1
  std::optional<std::string> profile{};  ///< a polynomial of x, "x^2/2"; or give `pieces`, `samples` or `harmonics`
  std::vector<ProfilePiece> pieces{};
  std::optional<std::string> samples{};   ///< the file of a measured profile
  std::vector<HarmonicData> harmonics{};  ///< of a profile with a period
  std::optional<ElasticBody> elastic{};   ///< the materials of the indenter
  std::optional<WearData> wear{};
};

/// An exact contact problem. It cannot be changed.
class STEADYSLIDE_API Problem {
 public:
  /// Throws InvalidData "friction.jumps[0]: what is wrong; the rule; the value". Fields have the names of the problem
  /// file.
  Problem(const ProblemData& data);

  /// Reads the text of a problem file. Throws InvalidData; its message has no file name if `name` is empty. A measured
  /// profile is looked for in the folder of `name`.
  static Problem from_text(std::string_view text, const std::string& name = "");

  /// Returns the problem file of this problem.
  const std::string& text() const;
  /// Returns the name of the file that the problem was read from; empty without a file.
  const std::string& name() const;
  /// Return the exact data, with the defaults of the problem file: the load, the friction values, the places of their
  /// jumps, and the left and the right end of the support.
  Exact load() const;
  std::vector<Exact> friction() const;
  std::vector<Exact> jumps() const;
  std::pair<Exact, Exact> support() const;

  struct Data;

 private:
  friend const Data& data_of(const Problem& problem);
  explicit Problem(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// Reads a problem file. Throws InvalidData "FILE:LINE: what is wrong; the rule; the value"; throws std::system_error
/// if the file cannot be read.
STEADYSLIDE_API Problem read_problem(const std::string& file);

struct ContactEnd {
  Number x;
  std::string kind;  ///< edge, free, step, ...
  Number exponent;   ///< t ~ -intensity d^exponent, d the distance from the end
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
  std::optional<Number> exponent;  ///< absent for a logarithm
  std::string symbolic;            ///< the exact exponent: "-1/2 - arctan(3/35)/pi"
  Number intensity;
  Number constant;
  std::optional<Number> stress_intensity_left;  ///< K in p ~ K (2 pi d)^exponent; absent off the contact
  std::optional<Number> stress_intensity_right;
};

/// A place where the traction can be singular, for any contact set.
struct PossiblePoint {
  std::string x;  ///< exact; empty for any place
  std::string kind;
  std::string side;  ///< the side of x with contact: left, right, both
  std::optional<Number> exponent;
  std::string symbolic;
};

/// A gap over a notch of the profile. It is too short to contain a number of the precision. The solution shows contact
/// there.
struct UnresolvedGap {
  Number x;
  double log10_length = 0;  ///< decimal logarithm of its length, an order of magnitude
};

/// The quantities of the whole contact: normal, friction_force, mean_pressure, ... (library/answer/quantities.hpp). The
/// largest pressure has an exponent only if it is infinite. `tilt` exists if the indenter may tilt, `core` if the punch
/// is rigid and flat. Without contact, widths and pressures are NaN.
using Resultants = answer::ResultantsOf<Number, std::optional<Number>>;
using LargestPressure = Resultants::Largest;
/// From the left end to the right end.
using Interval = answer::IntervalOf<Number>;

/// The relative residuals of a solution, measured by a rule that is independent of the one that found it
/// (docs/results.md, "Residuals").
struct Residuals {
  double equation = 0;
  double load = 0;
  double penetration = 0;
  double tension = 0;
};

/// The largest relative errors, as the method estimates them.
struct EstimatedError {
  double ends = 0;
  double traction = 0;
  double resultants = 0;
};

/// All quantities at one place of the surface.
struct SurfaceSample {
  Limits traction;
  Limits shear;
  std::optional<Number> gap;  ///< absent outside the support
  Limits slope;
  Number displacement;     ///< u, zero at x = 0, or at the left end of the support if x = 0 lies outside of it
  Limits shear_slope;      ///< u_t'
  Number cumulative_load;  ///< the load left of x
};

/// The displacement of a point of the body, u_x along +x and u_z along +z, into the body. No load determines the two
/// constants of a half-plane: they are 0 at the point of the surface where SurfaceSample::displacement is 0.
struct Displacement {
  Number x;
  Number z;
};

/// The largest von Mises stress at depths of at least `depth`, and its place.
struct LargestStress {
  Number depth;
  Number von_mises;
  Number x;
  Number z;
  std::vector<Number> unbounded_at;  ///< places of the surface next to which stresses have no bound
};

/// The largest shear and tension along an interface of layers, and their places; without tension 0, at an unknown place.
struct InterfaceStress {
  Number depth, shear, shear_x, tension, tension_x;
};

/// Stresses at a point of the body. With `gamma` instead of materials, yy, mean, von_mises and the gradient are absent.
struct Stress {
  Number xx, zz, xz, largest_shear;
  std::optional<Number> yy, mean, von_mises;
  std::optional<Number> ux_x, ux_z, uz_x, uz_z;  ///< d u_x/dx, ..., u_x and u_z along +x and +z
};

/// The forces -int t N along +z, into the body, and int t_t N along +x, N the shape function.
struct NodalForce {
  Number normal;
  Number tangential;
};

/// Elements of the surface. Order 1: linear elements between nodes. Order 2: quadratic elements; every second node is
/// in the middle of its element, to 12 digits, because nodes are often computed in double.
struct Mesh {
  std::vector<Exact> nodes;
  int order = 1;
};

/// The result of a proof in ball arithmetic. The program steadyslide-check reads the certificate (docs/certified.md).
struct Proof {
  bool proved = false;
  std::string reason;       ///< the reason why it is not proved; empty if proved
  std::string certificate;  ///< JSON; empty if nothing is proved
  /// The unresolved gaps of the certified solution, from left to right. That solution may have more digits than the one
  /// you called certify() on.
  std::vector<UnresolvedGap> unresolved_gaps{};

  /// Writes the certificate to a file. Throws std::runtime_error if there is none, or if the file cannot be written.
  STEADYSLIDE_API void save(const std::string& file) const;
};

struct SolveOptions {
  int digits = 16;                  ///< 1 to 100
  std::string method = "auto";      ///< or closed-form, riemann-hilbert, variational
  std::optional<int> cells{};       ///< number of cells of the variational method, 16 to 4194304
  std::optional<int> iterations{};  ///< most steps of its active sets on each mesh, 1 to 10000
  /// The relative error of ends and resultants for which it takes more and more cells on the contact, 1e-9 to 1; for a
  /// measured profile without `cells` 1e-3.
  std::optional<double> accuracy{};
  std::optional<Exact> over{};  ///< the length of the window of largest_average
};

/// A solved problem, or the best state that the method reached.
class STEADYSLIDE_API Solution {
 public:
  bool solved() const { return failed_condition().empty(); }
  /// The violated condition in words; empty if solved.
  const std::string& failed_condition() const;
  /// Returns closed-form, riemann-hilbert or variational.
  const std::string& method() const;
  int digits() const;
  const Problem& problem() const;
  /// Returns the warnings of the command `solve`, one line each. Read them before you use the solution.
  std::vector<std::string> warnings() const;

  std::vector<ContactComponent> contact() const;
  std::vector<SolvedPoint> singular_points() const;
  /// From left to right.
  std::vector<UnresolvedGap> unresolved_gaps() const;
  Residuals residuals() const;
  EstimatedError estimated_error() const;
  Resultants resultants() const;
  // One function for each quantity: effective_friction(), largest_pressure(), ... Each call computes all of them. If you
  // need several, call resultants() once.
#define STEADYSLIDE_QUANTITY(type, key, ...) \
  Resultants::type key() const { return resultants().key; }
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY

  /// Returns all quantities at one place. Throws InvalidData "x: ..." if x is not a number.
  SurfaceSample at(const Exact& x) const;
  /// Return the value at one place; where the two limits differ, the one of larger size. The gap is unknown outside the
  /// support. Throw InvalidData like at().
  Number traction(const Exact& x) const;
  Number shear(const Exact& x) const;
  Number gap(const Exact& x) const;
  Number slope(const Exact& x) const;
  /// Return the values at many places in double, without errors. Tractions are faster than one by one. Throw
  /// InvalidData if a place is not finite.
  std::vector<double> traction(std::span<const double> x) const;
  std::vector<double> shear(std::span<const double> x) const;
  std::vector<double> gap(std::span<const double> x) const;
  std::vector<double> slope(std::span<const double> x) const;

  /// Returns the stress at the depth z >= 0. At z = 0 it is that on the side of the larger pressure, and unknown where it
  /// has no bound. On an interface of layers it is that of the layer above. Throws InvalidData if x or z is not a number,
  /// if z < 0, if z is in a rigid base, if z > 0 is too small for 16 digits, or if the body has given symbols.
  Stress stress(const Exact& x, const Exact& z) const;
  /// Returns the stresses at many points in double; `digits` of the numbers are empty. Both spans have the same length.
  /// Throws InvalidData as above.
  std::vector<Stress> stress(std::span<const double> x, std::span<const double> z) const;
  /// Returns the displacement at the depth z >= 0. Throws InvalidData if x or z is not a number, if z < 0, or if the
  /// problem gives gamma instead of materials.
  Displacement displacement(const Exact& x, const Exact& z) const;
  /// Searches the largest von Mises stress at depths of at least `depth`; if it is absent, at all depths, or from a
  /// hundredth of the contact's width on if stresses have no bound or friction jumps in the contact. A search proves
  /// nothing. With a length `over` the stresses are averaged over a window of this length along x; they have a bound at all
  /// depths. Throws InvalidData if the depth is not a number or negative, if the length is not positive, or if the problem
  /// gives gamma.
  LargestStress max_stress(const std::optional<Exact>& depth = std::nullopt,
                           const std::optional<Exact>& over = std::nullopt) const;
  /// Returns the largest stresses along each interface, from the surface down; none on the half-plane.
  std::vector<InterfaceStress> interface_stress() const;
  /// Returns one force for each node. Throws InvalidData if the mesh is invalid, or if the contact reaches beyond the
  /// mesh.
  std::vector<NodalForce> nodal_forces(const Mesh& mesh) const;

  /// Tries to prove the solution. This takes about ten times as long as a solve.
  Proof certify() const;

  struct State;

 private:
  friend const State& data_of(const Solution& solution);
  friend STEADYSLIDE_API Solution solve(const Problem& problem, const SolveOptions& options, const Solution* start);
  explicit Solution(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Solves a problem. For 16 digits it computes in double, and with 50 digits if double is not enough. `start`: null, or
/// the solution of a neighbouring problem, from which the Riemann-Hilbert method starts; then it is faster. Throws
/// InvalidData if an option is out of range, or if the chosen method does not apply.
STEADYSLIDE_API Solution solve(const Problem& problem, const SolveOptions& options = {},
                               const Solution* start = nullptr);

/// Returns the places where the traction can be singular, with the exponents. Throws InvalidData unless `digits` is 1
/// to 100.
STEADYSLIDE_API std::vector<PossiblePoint> exponents(const Problem& problem, int digits = 16);

/// Returns the derivation of the exponents, step by step, and of the closed form if there is one.
STEADYSLIDE_API std::string derivation(const Problem& problem);

struct WearOptions {
  Exact distance;                    ///< the sliding distance
  std::optional<int> steps{};        ///< so many equal steps; absent: automatic steps
  std::optional<double> accuracy{};  ///< the largest error of an automatic step, 1e-6 to 1; default 1e-3
  std::optional<double> until{};     ///< ends earlier if so small a part of the load differs from the run-in pressure
  std::optional<int> cells{};        ///< cells on the support; default 4096
};

/// A contact after a sliding distance: distance, left, right, zones, effective_friction, ... (docs/problem-file.md, "Wear").
using WearRow = numeric::wear::WearRow;

struct WearHistory {
  std::vector<WearRow> rows;            ///< first that before any wear
  std::vector<double> edges;            ///< the ends of the cells
  std::vector<double> pressure;         ///< of each cell, at the end
  std::vector<double> depth;            ///< worn off each cell, at the end
  std::vector<double> run_in_pressure;  ///< with which nothing changes any more; empty if it is not known
  std::string failed_condition;         ///< the reason why the run ended early; empty if it did not fail
};

/// Wears the indenter of a problem with `wear`. Calls after_step(row, pressure, depth) first for the contact before any
/// wear, then after each step; it may throw to stop. Throws InvalidData if an option is out of range.
STEADYSLIDE_API WearHistory wear(const Problem& problem, const WearOptions& options,
                                 const std::function<void(const WearRow&, const std::vector<double>& pressure,
                                                          const std::vector<double>& depth)>& after_step = {});

}  // namespace steadyslide
