// The logarithmic form of the weak problem, and where it is positive. [Bal16, section 3.1]

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/claims/section_3/form_parts.hpp"
#include "proofs_checks/instruments/angle_forms.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// -<<t * log|x|, t>> of t dx = sum c_k cos(k theta) dtheta: pi^2 log(critical/L) c_0^2 + sum_k>=1 first pi^2/k^power
/// c_k^2.
struct LogSaid {
  Rational critical = 4;
  Rational first{1, 2};
  int power = 1;
  bool near_miss = false;
  bool zero_mean = true;  ///< asked for beyond the critical length
};

/// Quadratures do not depend on what is said.
template <class R>
using LogForms = std::map<Rational, FormMatrix<R>>;
using AllLogForms = std::tuple<LogForms<double>, LogForms<Real50>, LogForms<Real100>>;

constexpr int highest = 4;

template <Real R>
void check_expansion(Findings& findings, const Rational& length, const LogSaid& said, Random& random,
                     AllLogForms& forms) {
  using std::abs, std::log;
  const Quantity expansion{
      "-<<t * log|x|, t>>", {"quadrature in both angles", "sum over the coefficients"}, tolerance<R>()};
  const Quantity symmetry{"both arguments exchanged", {"quadrature in both angles", "the same"}, tolerance<R>()};
  auto& known = std::get<LogForms<R>>(forms);
  auto found = known.find(length);
  if (found == known.end()) {
    found = known.emplace(length, log_form_by_quadrature<R>(highest, numeric::to_real<R>(length))).first;
  }
  const FormMatrix<R>& form = found->second;
  std::vector<R> c;
  std::vector<R> d;
  for (int k = 0; k <= highest; ++k) {
    c.push_back(numeric::to_real<R>(random.between(Rational(1, 2), 2)));
    d.push_back(numeric::to_real<R>(random.between(Rational(1, 2), 2)));
  }
  const R pi = numeric::pi<R>();
  R value = pi * pi * log(numeric::to_real<R>(said.critical / length)) * c[0] * d[0];
  R scale = abs(value);
  for (int k = 1; k <= highest; ++k) {
    const auto i = static_cast<std::size_t>(k);
    R term = pi * pi * numeric::to_real<R>(said.first) * c[i] * d[i];
    for (int m = 0; m < said.power; ++m) term /= k;
    value += term;
    scale += abs(term);
  }
  if (said.near_miss) value *= 1 + near_miss<R>();
  findings.compare(expansion, static_cast<double>(R(abs(value_of(form, c, d) - value) / scale)));
  findings.compare(symmetry, static_cast<double>(R(abs(value_of(form, c, d) - value_of(form, d, c)) / scale)));
}

/// -<<t * log|x|, t>> on forces of N equal cells of the length 1, which is the unit of the logarithm.
Eigen::MatrixXd form_on_cells(std::size_t cells) {
  const CellFrictionSteps none{{0, 0}, {0}};
  const numeric::variational::CellMesh mesh(cell_problem(none), cells);
  return std::numbers::pi * symmetric_part(mesh, operator_of(none, mesh), false);
}

/// min of the form over t with int t = 1, on an interval of length 1: log(critical) in the limit.
double least_energy(const Eigen::MatrixXd& form) {
  return 1 / form.ldlt().solve(Eigen::VectorXd::Ones(form.rows())).sum();
}

void check_on_cells(Findings& findings, const Rational& length, const LogSaid& said, bool with_rate) {
  const double log_length = std::log(numeric::to_real<double>(length));
  const double log_critical = std::log(numeric::to_real<double>(said.critical));
  std::vector<Level> levels;
  for (const std::size_t cells : {16U, 24U, 32U, 48U, 64U}) {
    const Eigen::MatrixXd form = form_on_cells(cells);
    levels.push_back({static_cast<double>(cells), std::abs(least_energy(form) - log_critical)});
    const Eigen::MatrixXd here = form - Eigen::MatrixXd::Constant(form.rows(), form.cols(), log_length);
    const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(here).eigenvalues();
    const bool beyond = log_length >= log_critical;
    findings.require((all(0) > 0) != beyond,
                     "on cells, the smallest eigenvalue for L = " + to_string(length) + " is " + short_text(all(0)));
    findings.require(all(1) > 0, "on cells, a second eigenvalue is not positive");
    const Eigen::MatrixXd asked = said.zero_mean ? on_zero_mean(here) : here;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(asked);
    findings.require(solver.eigenvalues()(0) > 0, "on cells, not positive where it is said to be");
  }
  if (!with_rate) return;
  const Rate rate = fitted_rate(levels);
  findings.measure({"least energy of a unit force on cells of a unit interval, to log " + to_string(said.critical),
                    rate.value, rate.error_bar, 1, 0.05, "16 to 64 equal cells"});
}

std::vector<Evidence> check(const Context& context, const LogSaid& said, const std::vector<Rational>& lengths,
                            AllLogForms& forms) {
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "sec-31-log-form");
    Findings findings;
    for (const Rational& length : lengths) {
      findings.begin_case("L = " + to_string(length));
      for (int k = 0; k < 4; ++k) check_expansion<R>(findings, length, said, random, forms);
      check_on_cells(findings, length, said, length == lengths.front());
      if (context.quick) break;
    }
    return findings.evidence("random coefficients, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

auto check_with(const std::vector<Rational>& lengths) {
  return [lengths, forms = std::make_shared<AllLogForms>()](const Context& context, const LogSaid& said) {
    return check(context, said, lengths, *forms);
  };
}

template <class Change>
Wrong<LogSaid> wrong(std::string name, Change change) {
  return {std::move(name), changed<LogSaid>(change)};
}

Claim log_form_claim() {
  return make_claim(
      claim_text("sec-31-log-form"), check_with({2}), LogSaid{},
      std::vector<Wrong<LogSaid>>{
          wrong("log 2 missing", [](LogSaid& s) { s.critical = 2; }), wrong("pi^2/k", [](LogSaid& s) { s.first = 1; }),
          wrong("pi^2/2 for all k", [](LogSaid& s) { s.power = 0; }),
          wrong("the other sign", [](LogSaid& s) { s.first = Rational(-1, 2); }),
          wrong("near miss: the form moved by ten times the tolerance", [](LogSaid& s) { s.near_miss = true; })});
}

Claim length_claim() {
  return make_claim(
      claim_text("sec-31-log-form-length"), check_with({5, Rational(7, 2), Rational(1, 2), Rational(9, 2), 20}),
      LogSaid{},
      std::vector<Wrong<LogSaid>>{
          wrong("positive up to length 8", [](LogSaid& s) { s.critical = 8; }),
          wrong("positive up to length 2", [](LogSaid& s) { s.critical = 2; }),
          wrong("beyond length 4 on all tractions", [](LogSaid& s) { s.zero_mean = false; }),
          wrong("pi^2/k", [](LogSaid& s) { s.first = 1; }),
          wrong("near miss: the form moved by ten times the tolerance", [](LogSaid& s) { s.near_miss = true; })});
}

}  // namespace

std::vector<Claim> bilinear_form_claims() {
  std::vector<Claim> claims{log_form_claim(), length_claim()};
  for (Claim& claim : sign_form_claims()) claims.push_back(std::move(claim));
  for (Claim& claim : constant_friction_claims()) claims.push_back(std::move(claim));
  return claims;
}

}  // namespace steadyslide::proofs_checks
