#include "numeric/solution/average_pressure.hpp"

#include <algorithm>
#include <stdexcept>

#include "numeric/solution/highest_peak.hpp"

namespace steadyslide::numeric {
namespace {

/// Computes the load W(d) of the contact up to the distance d from its first end.
template <Real R>
class LoadBefore {
 public:
  explicit LoadBefore(const PiecewiseTraction<R>& traction) : traction_(traction) {
    Estimate<R> sum;
    for (const TractionPanel<R>& panel : traction.panels()) {
      starts_.push_back(panel.left - traction.panels().front().left);
      before_.push_back(sum);
      sum += load_of(panel, panel.length);
    }
    before_.push_back(sum);
  }

  R width() const { return starts_.back() + traction_.panels().back().length; }
  /// The ends of all panels, in order.
  std::vector<R> ends() const {
    std::vector<R> result;
    for (std::size_t k = 0; k < starts_.size(); ++k) {
      for (const R& end : {starts_[k], R(starts_[k] + traction_.panels()[k].length)}) {
        if (result.empty() || end > result.back()) result.push_back(end);
      }
    }
    return result;
  }

  Estimate<R> operator()(const R& d) const {
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), d);
    if (next == starts_.begin()) return {};
    const auto k = static_cast<std::size_t>(next - starts_.begin()) - 1;
    const TractionPanel<R>& panel = traction_.panels()[k];
    const R inside = d - starts_[k];
    return inside >= panel.length ? before_[k + 1] : before_[k] + load_of(panel, inside);
  }

 private:
  /// Returns the load on the left part of a panel.
  Estimate<R> load_of(const TractionPanel<R>& panel, const R& length) const {
    if (!(length > 0)) return {};
    nodes_.clear();
    const PanelPart<R> part{R(0), length, R(panel.length - length)};
    traction_.append_nodes(panel, part, nodes_);
    Estimate<R> load;
    for (std::size_t i = 0; i < nodes_.forces.size(); ++i) {
      const R error = panel.error + panel.displaced(part, nodes_.from_left[i], nodes_.from_right[i], length);
      load += Estimate<R>{-nodes_.forces[i], error * abs(nodes_.forces[i])};
    }
    return load;
  }

  const PiecewiseTraction<R>& traction_;
  std::vector<R> starts_;
  std::vector<Estimate<R>> before_;
  mutable TractionNodes<R> nodes_;
};

/// Searches the windows of one length.
template <Real R>
class WindowSearch {
 public:
  WindowSearch(const PiecewiseTraction<R>& traction, const R& length)
      : panels_(traction.panels()),
        before_(traction),
        window_(std::min(length, before_.width())),
        last_(before_.width() - window_) {}

  AveragePressure<R> best() const {
    const std::vector<Window> stops = windows_at_ends();
    AveragePressure<R> best{average(stops[0]), centre(stops[0].from, R(0))};
    for (const Window& stop : stops) {
      const Estimate<R> there = average(stop);
      if (there.value > best.value.value) best = {there, centre(stop.from, R(0))};
    }

    std::vector<R> starts, lengths;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const R bound = (before_(stops[k + 1].to).value - before_(stops[k].from).value) / window_;
      if (!(stops[k + 1].from > stops[k].from) || bound <= best.value.value) continue;
      starts.push_back(stops[k].from);
      lengths.push_back(stops[k + 1].from - stops[k].from);
    }
    const PanelFunction<R> inside = [&](std::size_t k, const R& from_left, const R&) {
      const R from = starts[k] + from_left;
      return average({from, from + window_});
    };
    const std::vector<Peak<R>> peaks = highest_peaks(lengths, inside, best.value.value);
    const auto place = [&](const Peak<R>& peak) {
      return centre(starts[peak.panel] + peak.from_left, peak.place_error);
    };
    if (peaks.empty()) return best;
    best = {peaks[0].value, place(peaks[0])};
    for (const Peak<R>& other : peaks) {
      const Estimate<R> x = place(other);
      best.x.error = std::max(best.x.error, R(abs(x.value - best.x.value) + x.error));
    }
    return best;
  }

 private:
  /// A window whose end at a singular point is exact: the load rises steeply there.
  struct Window {
    R from, to;
  };

  /// The Chebyshev series of the panels have two digits more than are served.
  Estimate<R> average(const Window& window) const {
    const Estimate<R> load = before_(window.to) - before_(window.from);
    return R(1 / window_) * load.widened(pow(R(10), R(-digits_served<R> - 2)));
  }

  Estimate<R> centre(const R& from, const R& error) const {
    const R x = panels_.front().left.moved(from + window_ / 2).high;
    return {x, error + panels_.front().end_error + epsilon<R>() * abs(x)};
  }

  /// Returns the windows one of whose ends is at an end of a panel, the first and the last window, from left to right.
  std::vector<Window> windows_at_ends() const {
    std::vector<Window> windows{{R(0), window_}, {last_, before_.width()}};
    for (const R& end : before_.ends()) {
      for (const Window& window : {Window{end, end + window_}, Window{end - window_, end}}) {
        if (window.from > 0 && window.from < last_) windows.push_back(window);
      }
    }
    std::sort(windows.begin(), windows.end(), [](const Window& a, const Window& b) { return a.from < b.from; });
    return windows;
  }

  const std::vector<TractionPanel<R>>& panels_;
  LoadBefore<R> before_;
  R window_;
  R last_;  ///< the place of the last window
};

}  // namespace

template <Real R>
AveragePressure<R> largest_average_pressure(const PiecewiseTraction<R>& traction, const R& length) {
  if (!(length > 0)) throw std::invalid_argument("length of a window");
  if (!traction.panels().empty()) return WindowSearch<R>(traction, length).best();
  const Estimate<R> unknown{R(std::numeric_limits<double>::quiet_NaN()), infinity<R>()};
  return {unknown, unknown};
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template AveragePressure<R> largest_average_pressure(const PiecewiseTraction<R>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
