#include "numeric/solution/highest_peak.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "numeric/number/chebyshev.hpp"

namespace steadyslide::numeric {
namespace {

constexpr int nodes = 16;
/// The error allowed for an interpolant, relative to the largest value.
constexpr double resolved = 1e-10;
/// The largest number of halvings of a part.
constexpr int most_halvings = 60;

/// The coefficients c_k of sum_k c_k T_k(v), -1 <= v <= 1.
template <Real R>
using Series = std::vector<R>;

template <Real R>
Series<R> derivative(const Series<R>& c) {
  Series<R> d(nodes, R(0));
  for (std::size_t k = nodes - 1; k > 0; --k) {
    d[k - 1] = 2 * static_cast<double>(k) * c[k] + (k + 1 < nodes ? d[k + 1] : R(0));
  }
  d[0] /= 2;
  return d;
}

template <Real R>
R size_of(const Series<R>& c, std::size_t first = 0) {
  R sum = 0;
  for (std::size_t k = first; k < nodes; ++k) sum += abs(c[k]);
  return sum;
}

/// Chebyshev's points v, and (1 + v)/2 and (1 - v)/2 there.
template <Real R>
struct Nodes {
  ChebyshevPoints<R> points{nodes};
  std::vector<R> from_left, from_right;

  Nodes() {
    for (int i = 0; i < nodes; ++i) {
      const R angle = pi<R>() * (2 * i + 1) / (4 * nodes), c = cos(angle), s = sin(angle);
      from_left.push_back(c * c);
      from_right.push_back(s * s);
    }
  }
};

/// A part of a panel, with the values of the function there.
template <Real R>
struct PanelInterval {
  std::size_t panel;
  R from_left, length, from_right;
  int halvings;
  Series<R> series{};
  R bound{}, missed{};

  bool operator<(const PanelInterval& other) const { return bound < other.bound; }
};

template <Real R>
class PeakSearch {
 public:
  PeakSearch(const std::vector<R>& lengths, const PanelFunction<R>& f, const R& floor)
      : f_(f), floor_(floor), best_(floor) {
    for (std::size_t k = 0; k < lengths.size(); ++k) add({k, R(0), lengths[k], R(0), 0});
  }

  std::vector<Peak<R>> highest() {
    while (!parts_.empty()) {
      const PanelInterval<R> part = parts_.top();
      parts_.pop();
      if (part.bound <= least()) break;
      if (part.missed <= resolved * best_) {
        search(part);
      } else if (part.halvings < most_halvings) {
        const R half = part.length / 2;
        add({part.panel, part.from_left, half, part.from_right + half, part.halvings + 1});
        add({part.panel, part.from_left + half, half, part.from_right, part.halvings + 1});
      }
    }
    std::vector<Peak<R>> result;
    for (Peak<R>& peak : found_) {
      if (peak.value.value > least()) result.push_back(refined(std::move(peak)));
    }
    const auto higher = [](const Peak<R>& a, const Peak<R>& b) { return a.value.value > b.value.value; };
    std::stable_sort(result.begin(), result.end(), higher);
    if (result.empty()) return result;
    // Remove lower peaks, and the highest one if another part found it again.
    const auto is_no_other = [best = result[0]](const Peak<R>& peak) {
      return peak.value.value + peak.value.error < best.value.value - best.value.error ||
             (peak.panel == best.panel && abs(peak.from_left - best.from_left) <= peak.place_error + best.place_error);
    };
    result.erase(std::remove_if(result.begin() + 1, result.end(), is_no_other), result.end());
    return result;
  }

 private:
  /// Returns the value above which a peak may be the highest after refinement of its place.
  R least() const { return std::max(floor_, R(best_ - resolved * abs(best_))); }

  void add(PanelInterval<R> part) {
    Peak<R> node = interpolate(part);
    if (node.value.value > best_) {
      best_ = node.value.value;
      found_.push_back(std::move(node));
    }
    part.missed = 4 * (abs(part.series[nodes - 1]) + abs(part.series[nodes - 2]) + abs(part.series[nodes - 3]));
    part.bound = part.series[0] + size_of(part.series, 1) + part.missed;
    if (part.bound > least()) parts_.push(std::move(part));
  }

  /// Returns the highest of the nodes.
  Peak<R> interpolate(PanelInterval<R>& part) const {
    static const Nodes<R> at;
    std::vector<R> values;
    std::optional<Peak<R>> highest;
    for (std::size_t i = 0; i < nodes; ++i) {
      Peak<R> node = peak_at(part, at.from_left[i], at.from_right[i]);
      values.push_back(node.value.value);
      if (!highest || values[i] > highest->value.value) highest = std::move(node);
    }
    part.series = at.points.series(values);
    return *highest;
  }

  /// Returns f at a place of a part, given by its distances from the part's ends, divided by the length.
  Peak<R> peak_at(const PanelInterval<R>& part, const R& left, const R& right) const {
    const R from_left = part.from_left + left * part.length;
    const R from_right = part.from_right + right * part.length;
    return {part.panel, from_left, from_right, f_(part.panel, from_left, from_right), part.length};
  }

  /// Finds the largest value of the interpolant, if it may be the largest of all.
  void search(const PanelInterval<R>& part) {
    const Series<R> first = derivative(part.series);
    const R curvature = size_of(derivative(first));
    const R enough = resolved * best_;
    R largest = least();
    std::optional<R> place;
    const auto visit = [&](const auto& self, const R& middle, const R& half) -> void {
      const R value = chebyshev_sum(part.series, middle);
      if (value > largest) {
        largest = value;
        place = middle;
      }
      const R more = abs(chebyshev_sum(first, middle)) * half + curvature * half * half / 2;
      if (value + more <= largest || more <= enough) return;
      self(self, middle - half / 2, half / 2);
      self(self, middle + half / 2, half / 2);
    };
    visit(visit, R(0), R(1));
    if (!place) return;
    found_.push_back(peak_at(part, (1 + *place) / 2, (1 - *place) / 2));
    best_ = std::max(best_, found_.back().value.value);
  }

  /// Returns the peak at the zero of the derivative of an interpolant, on a part around the peak that is so short that
  /// the interpolant is exact. If the zero lies beyond the part, the next part is around this zero.
  Peak<R> refined(Peak<R> peak) const {
    constexpr int most_attempts = 8;
    R half = peak.place_error;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      const auto [panel, left, right, value, error] = peak;
      const R room = std::min(left, right);
      half = std::min(half, R(std::min(error, room) * pow(epsilon<R>(), R(1) / (nodes + 1)) / 2));
      PanelInterval<R> part{panel, left - half, 2 * half, right - half, 0};
      interpolate(part);
      const Series<R> first = derivative(part.series);
      const Series<R> second = derivative(first);
      R v = -chebyshev_sum(first, R(0)) / chebyshev_sum(second, R(0));
      const bool within = abs(v) < 1;
      for (int step = 0; within && step < 8; ++step) v -= chebyshev_sum(first, v) / chebyshev_sum(second, v);
      if (!(abs(v) * half < room / 2) || !(chebyshev_sum(second, R(0)) < 0)) break;
      const R noise = nodes * nodes * (value.error + epsilon<R>() * value.value) / abs(chebyshev_sum(second, R(0)));
      peak = {panel, left + v * half, right - v * half, f_(panel, left + v * half, right - v * half), error};
      if (!within) continue;
      peak.place_error = half * std::min(R(1), noise);
      break;
    }
    return peak;
  }

  const PanelFunction<R>& f_;
  R floor_;
  R best_;
  std::vector<Peak<R>> found_;
  std::priority_queue<PanelInterval<R>> parts_;
};

}  // namespace

template <Real R>
std::vector<Peak<R>> highest_peaks(const std::vector<R>& lengths, const PanelFunction<R>& f, const R& floor) {
  return PeakSearch<R>(lengths, f, floor).highest();
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template std::vector<Peak<R>> highest_peaks(const std::vector<R>&, const PanelFunction<R>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
