#include "numeric/periodic/periodic_contact.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "numeric/number/node.hpp"
#include "numeric/periodic/zone_data.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns a root of f between two places where its signs differ: bisection, sped up by secants (the Illinois rule).
double root_between(const std::function<double(double)>& f, double a, double fa, double b, double fb) {
  for (int step = 0; step < 200 && std::abs(b - a) > 1e-14 * std::abs(a + b) && fb != 0; ++step) {
    double x = step % 3 == 2 ? (a + b) / 2 : b - fb * (b - a) / (fb - fa);
    if (!(x > std::min(a, b) && x < std::max(a, b))) x = (a + b) / 2;
    const double fx = f(x);
    if ((fx > 0) != (fb > 0)) {
      a = b;
      fa = fb;
    } else {
      fa /= 2;
    }
    b = x;
    fb = fx;
  }
  return b;
}

class ZoneSearch {
 public:
  ZoneSearch(const ContactProblem& problem, const Rational& origin)
      : data_(problem, origin), load_(to_real<double>(problem.load())) {}

  std::optional<ZoneEnds<double>> found() const {
    const ZoneEnds<double> edges{data_.left, data_.right, false, false};
    if (holds(edges)) return edges;
    if (data_.g.empty()) return std::nullopt;
    if (const auto ends = free_zone(); ends && holds(*ends)) return ends;
    for (const Side edge : {Side::left, Side::right}) {
      if (data_.whole) break;
      if (const auto ends = zone_at(edge)) return ends;
    }
    return std::nullopt;
  }

 private:
  /// True if there is neither tension nor penetration.
  bool holds(const ZoneEnds<double>& ends) const {
    constexpr int places = 512;
    constexpr double negligible = 1e-9;
    const PeriodicState<double> state = data_.state(ends);
    const PeriodicTraction<double>& traction = state.traction;
    const double width = ends.right - ends.left;
    for (int i = 0; i < places; ++i) {
      const auto [value, size] = traction.polynomial(ends.left + width * chebyshev_position<double>(i, places).first);
      if (!(value >= -negligible * size)) return false;
    }
    if (!(state.load > 0) || (!data_.whole && (ends.left < data_.left || ends.right > data_.right))) return false;
    if (!traction.has_gap()) return true;
    const double gap = data_.period - width;
    const auto is_open = [&](double length, bool at_right) {
      double height = 0, largest = 0;
      for (int i = 0; i < places && length > 0; ++i) {
        const double d = (i + 0.5) * length / places;
        const double slope = traction.value(traction.gap(), at_right ? d : gap - d, at_right ? gap - d : d);
        height += at_right ? -slope : slope;
        largest = std::max(largest, std::abs(height));
        if (height < -negligible * largest) return false;
      }
      return true;
    };
    if (data_.whole) return is_open(gap / 2, true) && is_open(gap / 2, false);
    return is_open(data_.right - ends.right, true) && is_open(ends.left - data_.left, false);
  }

  double lowest_place() const {
    const int places = 64 * static_cast<int>(data_.g.size() + 1);
    double best = data_.left, lowest = data_.height(best);
    for (int i = 1; i <= places; ++i) {
      const double x = data_.left + (data_.right - data_.left) * i / places;
      if (const double height = data_.height(x); height < lowest) {
        best = x;
        lowest = height;
      }
    }
    return best;
  }

  static ZoneEnds<double> free_ends(double middle, double half) { return {middle - half, middle + half, true, true}; }

  /// Moves the middle of a zone with this half-width so that the closure is 0; false if no such place is near.
  bool close(double& middle, double half) const {
    const auto closure = [&](double x) { return data_.state(free_ends(x, half)).closure; };
    const double start = middle, at_start = closure(start);
    for (double step = half / 16; step < data_.period / 4; step *= 2) {
      for (const double x : {start - step, start + step}) {
        const double there = closure(x);
        if ((there > 0) == (at_start > 0)) continue;
        middle = root_between(closure, start, at_start, x, there);
        return true;
      }
    }
    return false;
  }

  /// Lets a zone with free ends grow from the lowest place until it carries the load.
  std::optional<ZoneEnds<double>> free_zone() const {
    double middle = lowest_place();
    const auto load_at = [&](double half) {
      return close(middle, half) ? data_.state(free_ends(middle, half)).load : -1;
    };
    double half = data_.period / (64 * static_cast<double>(data_.g.size())), load = load_at(half);
    constexpr double shortest = 1e-9, growth = 1.25;
    for (; load > load_ && half > shortest * data_.period; load = load_at(half)) half /= 4;
    double before = half, load_before = load;
    while (load < load_) {
      before = half;
      load_before = load;
      half = std::min(growth * half, (half + data_.period / 2) / 2);
      if (half > 0.499999 * data_.period || (load = load_at(half)) < load_before) return std::nullopt;
    }
    half = root_between([&](double x) { return load_at(x) - load_; }, before, load_before - load_, half, load - load_);
    if (!close(middle, half)) return std::nullopt;
    return free_ends(middle, half);
  }

  /// Looks for a zone from one edge of the support to a free end.
  std::optional<ZoneEnds<double>> zone_at(Side edge) const {
    constexpr int places = 64;
    const double width = data_.right - data_.left;
    const auto ends = [&](double length) {
      return edge == Side::left ? ZoneEnds<double>{data_.left, data_.left + length, false, true}
                                : ZoneEnds<double>{data_.right - length, data_.right, true, false};
    };
    const auto excess = [&](double length) { return data_.state(ends(length)).load - load_; };
    double before = width / (16 * places), last = excess(before);
    for (int i = 1; i < 2 * places; ++i) {
      const double length = width * i / (2 * places), next = excess(length);
      if ((last > 0) != (next > 0)) {
        const ZoneEnds<double> found = ends(root_between(excess, before, last, length, next));
        if (holds(found)) return found;
      }
      before = length;
      last = next;
    }
    return std::nullopt;
  }

  ZoneData<double> data_;
  double load_;
};

/// Improves the free ends by Newton's method, with quotients of differences. Returns their error: the last step, and the
/// rounding of the conditions.
template <Real R>
R improve_ends(const ZoneData<R>& data, const R& load, ZoneEnds<R>& ends) {
  std::vector<R*> unknown;
  if (ends.left_is_free) unknown.push_back(&ends.left);
  if (ends.right_is_free) unknown.push_back(&ends.right);
  if (unknown.empty()) return 0;
  const auto conditions = [&] {
    const PeriodicState<R> state = data.state(ends);
    return std::array<R, 2>{state.load / load - 1, state.closure * data.period / load};
  };
  constexpr int most_steps = 20;
  R last = infinity<R>();
  for (int step = 0; step < most_steps; ++step) {
    const std::array<R, 2> now = conditions();
    std::array<std::array<R, 2>, 2> slopes{{{R(1), R(0)}, {R(0), R(1)}}};
    const R width = ends.right - ends.left, h = sqrt(epsilon<R>()) * width;
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      const R at = *unknown[i];
      *unknown[i] = at + h;
      const std::array<R, 2> there = conditions();
      *unknown[i] = at;
      for (std::size_t j = 0; j < 2; ++j) slopes[i][j] = (there[j] - now[j]) / h;
    }
    R moved, inverse;  // `inverse`: the largest sum of a row of the inverse matrix
    if (unknown.size() == 1) {
      const R change = -now[0] / slopes[0][0];
      *unknown[0] += change;
      moved = abs(change);
      inverse = abs(1 / slopes[0][0]);
    } else {
      const R determinant = slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0];
      const R left = (now[1] * slopes[1][0] - now[0] * slopes[1][1]) / determinant;
      const R right = (now[0] * slopes[0][1] - now[1] * slopes[0][0]) / determinant;
      ends.left += left;
      ends.right += right;
      moved = max(abs(left), abs(right));
      inverse = max(abs(slopes[0][0]) + abs(slopes[0][1]), abs(slopes[1][0]) + abs(slopes[1][1])) / abs(determinant);
    }
    const R rounding = 16 * epsilon<R>() * (data.period + inverse * static_cast<double>(2 + data.g.size()));
    if (moved <= rounding || !(moved < last)) return min(moved, last) + 2 * rounding;
    last = moved;
  }
  return last;
}

/// The place of the harmonics' origin that is next to the middle of the support.
Rational origin_of(const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  const Rational middle = (indenter.left() + indenter.right()) / 2;
  if (indenter.harmonics().empty()) return middle;
  const Rational periods = (middle - indenter.origin_of_harmonics()) / *problem.body().period() + Rational(1, 2);
  Integer whole = numerator(periods) / denominator(periods);
  if (periods < Rational(whole)) --whole;
  return indenter.origin_of_harmonics() + *problem.body().period() * Rational(whole);
}

}  // namespace

template <Real R>
std::variant<PeriodicContact<R>, std::string> periodic_contact(const ContactProblem& problem) {
  const Indenter& indenter = problem.indenter();
  // Each value of the traction costs a product over all jumps.
  constexpr std::size_t most = std::same_as<R, double> ? 200 : 50;
  if (const std::size_t values = problem.friction().values().size(); values > most) {
    return "too many values of friction for periodic contact; there are at most " + std::to_string(most) + "; " +
           std::to_string(values) + " values";
  }
  for (const Indenter::Piece& piece : indenter.pieces()) {
    if (piece.profile.degree() > 0 || piece.profile != indenter.pieces().front().profile)
      return std::string("with a period, a closed form is for a flat profile or for harmonics");
  }
  const Rational origin = origin_of(problem);
  const std::optional<ZoneEnds<double>> found = ZoneSearch(problem, origin).found();
  if (!found) return std::string("with a period, a closed form is for one zone of contact in each period");
  const ZoneData<R> data(problem, origin);
  if (problem.elasticity().indenter() && !data.whole && !(found->left_is_free && found->right_is_free))
    return std::string("an elastic indenter touches with its edges, where the half-plane idealisation fails");
  ZoneEnds<R> ends{found->left_is_free ? R(found->left) : data.left,
                   found->right_is_free ? R(found->right) : data.right, found->left_is_free, found->right_is_free};
  const R last = improve_ends(data, to_real<R>(problem.load()), ends);
  if (!(last <= sqrt(epsilon<R>()) * data.period)) return std::string("the ends of contact did not converge");

  std::vector<Rational> points{ends.left_is_free ? Rational(origin + Rational(ends.left)) : indenter.left()};
  std::vector<std::size_t> pieces;
  const std::size_t first = data.region(ends.left, Side::right), end = data.region(ends.right, Side::left);
  for (std::size_t k = first; k <= end; ++k) {
    pieces.push_back(data.pieces[k]);
    if (k < end) points.push_back(data.places[k]);
  }
  points.push_back(ends.right_is_free ? Rational(origin + Rational(ends.right)) : indenter.right());
  return PeriodicContact<R>{origin,
                            data.state(ends).traction,
                            data.g,
                            ends.left_is_free,
                            ends.right_is_free,
                            std::move(pieces),
                            std::move(points),
                            last};
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template std::variant<PeriodicContact<R>, std::string> periodic_contact(const ContactProblem&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
