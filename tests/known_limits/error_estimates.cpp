#include "known_limits/error_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/random_contact.hpp"

namespace steadyslide::testing {
namespace {

using namespace numeric;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Compares one solution in double with one with 50 digits.
class Comparison {
 public:
  Comparison(std::string name, bool detailed, const ContactProblem& problem, const ContactSolution<double>& found,
             const ContactSolution<Real50>& truth, EstimateAudit& audit)
      : name_(std::move(name)), detailed_(detailed), problem_(problem), found_(found), truth_(truth), audit_(audit) {}

  void run() {
    points_ = found_.singular_points();
    true_points_ = truth_.singular_points();
    if (std::string what = difference(); !what.empty()) {
      audit_.different.push_back(name_ + ' ' + what);
      return;
    }
    ++audit_.compared;
    compare_points();
    compare_resultants();
    compare_places();
    for (const Rational& jump : problem_.friction().jumps()) compare_both_sides(jump);
    for (const Indenter::Break& b : problem_.indenter().breaks()) compare_both_sides(b.x);
  }

 private:
  std::string difference() const {
    if (found_.contact().size() != truth_.contact().size()) return "number of components";
    if (points_.size() != true_points_.size()) return "number of singular points";
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (points_[k].kind != true_points_[k].kind) return "kind of a singular point";
    }
    return "";
  }

  void look(const std::string& kind, const std::string& where, const Estimate<double>& value,
            const Estimate<Real50>& truth) {
    compare_estimate(kind, value, truth, audit_, name_ + ": " + kind + ' ' + where);
  }

  void compare_points() {
    double worst = 0;
    Real50 worst_true = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const std::string where = "of point " + std::to_string(k);
      look("place", where, points_[k].x, true_points_[k].x);
      look("intensity", where, points_[k].intensity, true_points_[k].intensity);
      look("constant", where, points_[k].constant, true_points_[k].constant);
      const auto& [left, right] = points_[k].stress_intensity;
      if (left) look("stress intensity", where, *left, *true_points_[k].stress_intensity.left);
      if (right) look("stress intensity", where, *right, *true_points_[k].stress_intensity.right);
      if (points_[k].kind == SingularKind::free) {
        worst = std::max(worst, points_[k].x.error);
        worst_true = std::max(worst_true, Real50(abs(Real50(points_[k].x.value) - true_points_[k].x.value)));
      }
    }
  }

  void compare_resultants() {
    const Resultants<double> r = found_.resultants();
    const Resultants<Real50> t = truth_.resultants();
    look("normal force", "", r.normal, t.normal);
    look("tangential force", "", r.tangential, t.tangential);
    look("centre of pressure", "", r.centre_of_pressure, t.centre_of_pressure);
    look("effective friction", "", r.effective_friction, t.effective_friction);
    for (std::size_t k = 0; k < r.load_share.size(); ++k) {
      look("load share", std::to_string(k), r.load_share[k], t.load_share[k]);
    }
    for (std::size_t k = 0; k < r.component_load.size(); ++k) {
      const std::string where = "of component " + std::to_string(k);
      look("load", where, r.component_load[k], t.component_load[k]);
      look("width", where, found_.contact()[k].width, truth_.contact()[k].width);
    }
    const LargestPressure<double> p = found_.largest_pressure();
    const LargestPressure<Real50> true_p = truth_.largest_pressure();
    look("largest pressure", "", p.value, true_p.value);
    // If several peaks have the same height, the place of each of them is correct.
    const bool tied = true_p.x.error > Real50(1e-15);
    look("place of it", "", p.x, {true_p.x.value, tied ? Real50(0) : true_p.x.error});
    if (const auto tilt = found_.tilt()) look("tilt", "", *tilt, *truth_.tilt());
    const Real50 load_off = abs(Real50(r.normal.value) / t.normal.value - 1);
    look("printed: resultants", "", {static_cast<double>(load_off), found_.estimated_error().resultants}, {});
  }

  /// Compares between singular points and in gaps, from the middle to a millionth of the length from their ends, and
  /// beside the contact. With many points it takes one place between two points, and each kind of place in turn.
  void compare_places() {
    std::vector<Rational> x;
    for (const auto& point : points_) x.push_back(Rational(point.x.value));
    const Rational length = x.back() - x.front();
    x.insert(x.begin(), Rational(x.front() - length * 3 / 10));
    x.push_back(x.back() + length * 3 / 10);
    double printed = 0;
    const double expected = found_.estimated_error().traction;
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      const char* const parts[] = {"0.000001", "0.013", "0.27", "0.5", "0.83", "0.991", "0.999999"};
      for (const char* const& part : parts) {
        const bool in_turn = &part == &parts[(x.size() + k) % std::size(parts)];
        if (x.size() > many_points && !in_turn) continue;
        const Rational place = x[k] + (x[k + 1] - x[k]) * parse_rational(part);
        const Sample<double> here = found_.at(place);
        const Sample<Real50> there = truth_.at(place);
        const std::string where = "at " + std::to_string(static_cast<double>(place));
        look("traction", where, here.traction.left, there.traction.left);
        look("shear", where, here.shear.left, there.shear.left);
        look("slope", where, here.slope.left, there.slope.left);
        if (here.gap && there.gap) look("gap", where, *here.gap, *there.gap);
        if (detailed_ && in_turn && k % (1 + x.size() / many_points) == 0) compare_details(place, where);
        if (std::string_view(part) == "0.5" && there.traction.left.value != 0) {
          const Real50 off = abs(Real50(here.traction.left.value) / there.traction.left.value - 1);
          printed = std::max(printed, static_cast<double>(off));
        }
      }
    }
    look("printed: traction", "", {printed, expected}, {});
  }

  /// Compares at a place of the data, where the two limits may differ.
  void compare_both_sides(const Rational& place) {
    const Sample<double> here = found_.at(place);
    const Sample<Real50> there = truth_.at(place);
    const std::string where = "at " + std::to_string(static_cast<double>(place));
    look_at_sides("traction", where, here.traction, there.traction);
    look_at_sides("shear", where, here.shear, there.shear);
    look_at_sides("slope", where, here.slope, there.slope);
    if (here.gap && there.gap) look("gap", where, *here.gap, *there.gap);
    if (detailed_ && points_.size() <= many_points) compare_details(place, where);
  }

  void look_at_sides(const std::string& kind, const std::string& where, const TwoSided<double>& value,
                     const TwoSided<Real50>& truth) {
    look(kind, "on the left, " + where, value.left, truth.left);
    look(kind, "on the right, " + where, value.right, truth.right);
  }

  /// Each comparison costs integrals with 50 digits.
  void compare_details(const Rational& place, const std::string& where) {
    const DetailedSample<double> here = found_.details_at(place);
    const DetailedSample<Real50> there = truth_.details_at(place);
    look("displacement", where, here.displacement, there.displacement);
    look_at_sides("shear slope", where, here.shear_slope, there.shear_slope);
    look("load before", where, here.cumulative_load, there.cumulative_load);
  }

  static constexpr std::size_t many_points = 20;
  std::string name_;
  bool detailed_;  ///< true: compares also the integrals of the traction (details_at)
  const ContactProblem& problem_;
  const ContactSolution<double>& found_;
  const ContactSolution<Real50>& truth_;
  EstimateAudit& audit_;
  std::vector<SolvedSingularPoint<double>> points_;
  std::vector<SolvedSingularPoint<Real50>> true_points_;
};

}  // namespace

double EstimatedNumbers::median_too_large() const { return median(too_large); }

std::size_t EstimateAudit::sum_of(std::size_t EstimatedNumbers::*part) const {
  std::size_t sum = 0;
  for (const auto& [kind, of_kind] : numbers) sum += of_kind.*part;
  return sum;
}

double EstimateAudit::median_too_large() const {
  std::vector<double> ratios;
  for (const auto& [kind, of_kind] : numbers) {
    ratios.insert(ratios.end(), of_kind.too_large.begin(), of_kind.too_large.end());
  }
  return median(std::move(ratios));
}

std::string EstimateAudit::text() const {
  std::ostringstream out;
  out << compared << " solutions of " << problems << " problems compared, " << different.size()
      << " with contacts of another kind; " << honest() << " of " << all() << " estimates honest, in the median "
      << median_too_large() << " times the true error\n";
  char line[160];
  std::snprintf(line, sizeof line, "%-20s %9s %9s %12s %12s\n", "kind", "numbers", "honest", "worst", "median");
  out << line;
  for (const auto& [kind, of_kind] : numbers) {
    std::snprintf(line, sizeof line, "%-20s %9zu %9zu %12.3g %12.3g\n", kind.c_str(), of_kind.count, of_kind.honest,
                  of_kind.worst, of_kind.median_too_large());
    out << line;
  }
  return out.str();
}

double largest_median(ContactFamily family) { return family == ContactFamily::many_wedges ? 20'000 : 1000; }

std::string EstimateAudit::failure(double largest_median) const {
  if (!dishonest.empty()) return std::to_string(dishonest.size()) + " estimates are not honest";
  if (!(median_too_large() <= largest_median)) return "estimates are too large";
  if (compared < 9 * problems / 10 || all() < 50 * compared) return "too little was compared";
  return "";
}

void compare_estimate(const std::string& kind, const Estimate<double>& value, const Estimate<Real50>& truth,
                      EstimateAudit& audit, const std::string& what) {
  if (std::isinf(value.value) && Real50(value.value) == truth.value) return;
  const auto off = static_cast<double>(Real50(abs(Real50(value.value) - truth.value)));
  if (off == 0 && value.error == 0) return;  // an exact number
  EstimatedNumbers& numbers = audit.numbers[kind];
  ++numbers.count;
  if (off > 0) {
    numbers.too_large.push_back(value.error / off);
    numbers.worst = std::max(numbers.worst, off / value.error);
  }
  // If 50 digits do not give the value either, the estimate counts as not honest.
  const bool known = truth.error <= Real50(1e-3 * value.error);
  if (off <= value.error && known) {
    ++numbers.honest;
    return;
  }
  std::ostringstream line;
  line.precision(3);
  line << what << ": " << value.value << " is off by " << off << ", " << off / value.error << " times its estimate";
  if (!known) line << "; 50 digits are off by " << static_cast<double>(truth.error);
  audit.dishonest.push_back(line.str());
}

void audit_solution(const std::string& name, const ContactProblem& problem, const ContactSolution<double>& found,
                    const ContactSolution<Real50>& truth, bool detailed, EstimateAudit& audit) {
  Comparison(name, detailed, problem, found, truth, audit).run();
}

void audit_solutions(const std::string& name, const ContactProblem& problem, bool detailed, EstimateAudit& audit) {
  ++audit.problems;
  const auto rough = riemann_hilbert<double>(problem).solution;
  if (!rough || !rough->failed_condition().empty()) return;
  const auto fine = riemann_hilbert<Real50>(problem).solution;
  if (!fine || !fine->failed_condition().empty()) {
    audit.different.push_back(name + " not solved with 50 digits");
    return;
  }
  audit_solution(name, problem, *rough, *fine, detailed, audit);
  if (const auto exact = closed_form<double>(problem).solution) {
    audit_solution(name + " closed form", problem, *exact, *closed_form<Real50>(problem).solution, detailed, audit);
  }
}

void audit_estimates(std::uint64_t seed, EstimateAudit& audit, ContactFamily family) {
  // In the usual list every fourth problem has details: they cost more than all the rest.
  const bool detailed = seed % 4 == 0 || family != ContactFamily::usual;
  audit_solutions(std::to_string(seed), random_contact(seed, family), detailed, audit);
}

}  // namespace steadyslide::testing
