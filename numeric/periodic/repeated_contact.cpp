#include "numeric/periodic/repeated_contact.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/once.hpp"

namespace steadyslide::numeric {
namespace {

class RepeatedContact : public ContactSolution<double> {
 public:
  RepeatedContact(ContactProblem problem, Rational begin, std::shared_ptr<const ContactSolution<double>> solution)
      : problem_(std::move(problem)), begin_(std::move(begin)), solution_(std::move(solution)) {}

  std::string method() const override { return solution_->method(); }
  std::string failed_condition() const override { return solution_->failed_condition(); }
  std::optional<EqualCells> equal_cells() const override { return solution_->equal_cells(); }
  std::vector<ContactComponent<double>> contact() const override { return solution_->contact(); }
  std::vector<UnresolvedGap<double>> unresolved_gaps() const override { return solution_->unresolved_gaps(); }
  std::vector<SolvedSingularPoint<double>> singular_points() const override { return solution_->singular_points(); }
  LargestPressure<double> largest_pressure() const override { return solution_->largest_pressure(); }
  AveragePressure<double> largest_average_pressure(const double& length) const override {
    return solution_->largest_average_pressure(length);
  }
  EstimatedError<double> estimated_error() const override { return solution_->estimated_error(); }
  Residuals<double> residuals() const override { return solution_->residuals(); }
  PiecewiseTraction<double> piecewise_traction() const override { return solution_->piecewise_traction(); }
  std::vector<Sample<double>> samples(int count) const override { return solution_->samples(count); }

  Resultants<double> resultants() const override {
    Resultants<double> result = solution_->resultants();
    const FrictionProfile& friction = problem_.friction();
    const std::size_t values = friction.values().size(), first = friction.piece(on_support(begin_), Side::right);
    std::vector<Estimate<double>> shares(values);
    for (std::size_t k = 0; k < result.load_share.size(); ++k) shares[(first + k) % values] += result.load_share[k];
    result.load_share = std::move(shares);
    return result;
  }
  Sample<double> at(const Rational& x) const override {
    Sample<double> result = solution_->at(in_period(x));
    result.x = to_real<double>(x);
    return result;
  }
  void tractions(std::span<const double> x, std::span<double> normal, std::span<double> shear) const override {
    const auto begin = to_real<double>(begin_), length = to_real<double>(period());
    std::vector<double> places;
    for (const double place : x) places.push_back(place - length * std::floor((place - begin) / length));
    solution_->tractions(places, normal, shear);
  }
  DetailedSample<double> details_at(const Rational& x) const override {
    return seen(solution_->details_at(in_period(x)), x);
  }
  std::vector<DetailedSample<double>> detailed_samples(int count) const override {
    std::vector<DetailedSample<double>> result = solution_->detailed_samples(count);
    for (DetailedSample<double>& sample : result) sample = seen(sample, Rational(sample.x));
    return result;
  }

 private:
  const Rational& left() const { return problem_.indenter().left(); }
  const Rational& period() const { return *problem_.body().period(); }
  Rational in_period(const Rational& x) const { return moved_into(x, begin_, period()); }
  Rational on_support(const Rational& x) const { return moved_into(x, left(), period()); }

  /// Returns a sample of the solution with x, friction, u and T of the problem.
  DetailedSample<double> seen(DetailedSample<double> sample, const Rational& x) const {
    sample.x = to_real<double>(x);
    if (is_without_edges(problem_)) {
      const Rational place = on_support(x);
      const FrictionProfile& friction = problem_.friction();
      sample.friction = {friction.piece(place == left() ? problem_.indenter().right() : place, Side::left),
                         friction.piece(place, Side::right)};
    }
    if (begin_ == left()) return sample;
    const auto& [load, displacement] = before_([this] {
      return std::pair(solution_->details_at(in_period(left())).cumulative_load,
                       solution_->details_at(in_period(problem_.origin_of_displacement())).displacement);
    });
    sample.displacement = sample.displacement - displacement;
    sample.cumulative_load = sample.cumulative_load - load;
    if (in_period(x) < in_period(left())) sample.cumulative_load += Estimate<double>{to_real<double>(problem_.load())};
    return sample;
  }

  ContactProblem problem_;
  Rational begin_;
  std::shared_ptr<const ContactSolution<double>> solution_;
  Once<std::pair<Estimate<double>, Estimate<double>>>
      before_;  ///< T and u of the solution where those of the problem are 0
};

}  // namespace

Rational moved_into(const Rational& x, const Rational& left, const Rational& period) {
  const Rational periods = (x - left) / period;
  Integer whole = numerator(periods) / denominator(periods);
  if (periods < Rational(whole)) --whole;
  return x - Rational(whole) * period;
}

bool is_without_edges(const ContactProblem& problem) {
  return problem.body().period() == Rational(problem.indenter().right() - problem.indenter().left());
}

Rational beginning_in_gap(const ContactProblem& problem, const std::vector<std::pair<double, double>>& zones) {
  const Rational& left = problem.indenter().left();
  if (!is_without_edges(problem) || zones.empty()) return left;
  const Rational& period = *problem.body().period();
  const auto end = to_real<double>(left), length = to_real<double>(period);
  // The gap around the left end, then the widest gap.
  double from = zones.back().second - length, to = zones.front().first;
  const double margin = std::min(to - end, end - from);
  for (std::size_t k = 1; k < zones.size(); ++k) {
    if (zones[k].first - zones[k - 1].second <= to - from) continue;
    from = zones[k - 1].second;
    to = zones[k].first;
  }
  constexpr double rounding = 1e-9;  // cells are longer
  if (!(to - from > rounding * length) || 8 * margin >= to - from) return left;
  // About the middle, at the end of a cell if there are many.
  const double parts = std::exp2(std::ceil(std::log2(4 * length / (to - from))));
  const double part = std::round(((from + to) / 2 - end) / length * parts);
  return moved_into(left + period * Rational(part / parts), left - period / 2, period);
}

ContactProblem beginning_at(const Rational& begin, const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  if (begin == indenter.left()) return problem;
  // One period is cut out of two.
  const Rational& period = *problem.body().period();
  const Rational first = moved_into(begin, indenter.left(), period), last = first + period;
  const ContactProblem next = problem.moved(1, period);
  std::vector<Indenter::Piece> pieces;
  std::vector<Rational> jumps, values;
  const auto add_jump = [&](const Rational& x) {
    if (first < x && x < last) jumps.push_back(x);
  };
  for (const ContactProblem* part : {&problem, &next}) {
    Rational from = part->indenter().left();
    for (const Indenter::Piece& piece : part->indenter().pieces()) {
      if (first < piece.to && from < last) pieces.push_back({std::min(piece.to, last), piece.profile});
      from = piece.to;
    }
    if (part == &next) add_jump(indenter.right());
    for (const Rational& c : part->friction().jumps()) add_jump(c);
  }
  const FrictionProfile& friction = problem.friction();
  for (std::size_t k = friction.piece(first, Side::right); values.size() <= jumps.size(); ++k)
    values.push_back(friction.values()[k % friction.values().size()]);
  const Indenter turned =
      Indenter(first, std::move(pieces)).with_harmonics(indenter.harmonics(), indenter.origin_of_harmonics());
  const Rational back = begin - first;
  return {problem.elasticity(),  FrictionProfile(std::move(values), std::move(jumps)).moved(1, back),
          turned.moved(1, back), problem.load(),
          problem.sliding(),     std::nullopt,
          problem.body()};
}

std::shared_ptr<const ContactSolution<double>> repeated(const ContactProblem& problem, const Rational& begin,
                                                        std::shared_ptr<const ContactSolution<double>> solution) {
  if (!problem.body().period() || !solution) return solution;
  return std::make_shared<const RepeatedContact>(problem, begin, std::move(solution));
}

}  // namespace steadyslide::numeric
