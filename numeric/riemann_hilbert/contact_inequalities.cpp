#include "numeric/riemann_hilbert/contact_inequalities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "numeric/riemann_hilbert/local_signs.hpp"

namespace steadyslide::numeric {
namespace {

/// Places in ]0, 1[, as numerators over 10^9 of the distance from the nearer end: next to both ends, and between them.
constexpr std::array<int, 8> near_end{1, 1000, 300'000, 3'000'000, 20'000'000, 70'000'000, 150'000'000, 250'000'000};

template <Real R>
std::vector<SurfacePoint<R>> places(const ContactSet<R>& set, std::size_t segment) {
  constexpr int between = 5;
  const R& length = set.length(segment);
  std::vector<SurfacePoint<R>> result;
  const auto add = [&](const R& from_left) {
    result.push_back(surface_point(set, segment, from_left, length - from_left));
  };
  for (const int part : near_end) add(length * R(part) / 1'000'000'000);
  for (int i = 0; i < between; ++i) add(length * (R(0.35) + R(0.3) * i / (between - 1)));
  for (std::size_t i = near_end.size(); i-- > 0;) {
    const R d = length * R(near_end[i]) / 1'000'000'000;
    result.push_back(surface_point(set, segment, length - d, d));
  }
  return result;
}

/// The same form in double. A gap that is open in double needs no higher precision.
template <Real R>
class RoughGaps {
 public:
  explicit RoughGaps(const TractionRepresentation<R>& form)
      : problem_(form.problem().problem(), form.problem().frame(), form.problem().most_coupled()),
        form_(problem_, ContactSet<double>::converted(problem_, form.set()), rounded(form.q()),
              static_cast<double>(form.tilt()), rules_) {}

  /// True if the gap at a place, measured from point `end`, is much larger than its rounding error.
  bool is_open(std::size_t end, const SurfacePoint<R>& at) {
    const std::vector<double> node = rounded({at.node.x, at.node.from_left, at.node.from_right});
    const Estimate<double> gap =
        gaps_.try_emplace(end, form_, end).first->second.reduced_gap({at.segment, {node[0], node[1], node[2]}});
    return gap.value > 1e6 * gap.error;
  }

 private:
  static std::vector<double> rounded(const std::vector<R>& values) {
    std::vector<double> result;
    for (const R& v : values) result.push_back(static_cast<double>(v));
    return result;
  }

  RoundedProblem<double> problem_;
  JacobiRules<double> rules_;
  TractionRepresentation<double> form_;
  std::map<std::size_t, GapIntegral<double>> gaps_;
};

template <Real R>
class Inspection {
 public:
  Inspection(const TractionRepresentation<R>& form, const R& end_error)
      : form_(form), set_(form.set()), end_error_(end_error) {}

  std::vector<Violation<R>> run() {
    for (const auto& [first, end] : set_.runs()) {
      set_.in_contact(first) ? inspect_contact(first, end) : inspect_gap(first, end);
    }
    return std::move(found_);
  }

 private:
  using What = typename Violation<R>::What;

  /// Collects neighbouring places that fail.
  void note(What what, bool fails, const SurfacePoint<R>& at) {
    if (fails) {
      if (!open_) found_.push_back({what, previous_, at});
      open_ = true;
    }
    if (open_) found_.back().to = at;
    open_ = fails;
    previous_ = at;
  }

  void begin(std::size_t segment) {
    previous_ = {static_cast<std::ptrdiff_t>(segment), {set_.x(segment), R(0), set_.length(segment)}};
    open_ = false;
  }

  void end(std::size_t segment) {
    if (open_) {
      found_.back().to = {static_cast<std::ptrdiff_t>(segment), {set_.x(segment + 1), set_.length(segment), R(0)}};
    }
    open_ = false;
  }

  struct Value {
    SurfacePoint<R> at;
    Estimate<R> b;
  };

  /// Returns the peak of tension between three places of one segment, by parabolas through the highest values. The peak
  /// may be arbitrarily narrow where contact is about to separate.
  std::optional<Value> peak_beside(Value left, Value middle, Value right) const {
    const auto k = static_cast<std::size_t>(middle.at.segment);
    const auto height = [&](const Value& v) { return form_.sign(v.at.segment) * v.b.value; };
    for (int i = 0; i < 8; ++i) {
      const R top = height(middle);
      if (top > 4 * middle.b.error) return i > 0 ? std::optional<Value>(middle) : std::nullopt;
      if (height(left) > top || height(right) > top) return std::nullopt;
      const R h = middle.at.node.from_left - left.at.node.from_left;
      const R w = right.at.node.from_left - middle.at.node.from_left;
      const R down = (top - height(left)) / h;
      const R up = (top - height(right)) / w;
      const R curvature = (down + up) / (h + w);
      if (!(curvature > 0)) return std::nullopt;
      const R slope = (down * w - up * h) / (h + w);
      // The peak is far below zero.
      if (top + slope * slope / (4 * curvature) < top / 2) return std::nullopt;
      const R d = middle.at.node.from_left + slope / (2 * curvature);
      Value next{{middle.at.segment, {set_.x(k) + d, d, set_.length(k) - d}}, {}};
      next.b = form_.regular_factor(form_.slope_at(k), next.at);
      const bool rightwards = d > middle.at.node.from_left;
      if (height(next) < top) return std::nullopt;
      (rightwards ? left : right) = middle;
      middle = next;
    }
    return std::nullopt;
  }

  void inspect_contact(std::size_t first, std::size_t end) {
    begin(first);
    // t has the sign of eps B. B is cheap if there is only one polynomial.
    const auto inspect = [&](const SurfacePoint<R>& at, const Estimate<R>& b) {
      const R value = form_.sign(at.segment) * b.value;
      note(What::tension, value > 4 * b.error, at);
    };
    // An edge with any tension must become a free end before it. An anchor with tension lies in a gap.
    const auto decide = [&](std::size_t j) {
      const bool pulls = numeric::pulls(form_, j, leading_term(form_, j, end_error_));
      // A stretch ends at a sampled place, not at the anchor itself.
      if (!pulls && !set_.point(j).is_end()) return;
      const bool ends = j == end;
      const std::size_t k = ends ? j - 1 : j;
      const R& length = set_.length(k);
      note(What::tension, pulls,
           {static_cast<std::ptrdiff_t>(k), {set_.x(j), ends ? length : R(0), ends ? R(0) : length}});
      if (pulls && !set_.point(j).is_end()) {
        found_.back().anchor = set_.point(j).anchor;
        found_.back().log_reach = log_reach(form_, j);
      }
    };
    for (std::size_t k = first; k < end; ++k) {
      decide(k);
      if (k > first && set_.is_at_step(k)) {
        // Slopes do not show a step: the surface would have to jump.
        const SurfacePoint<R> at{static_cast<std::ptrdiff_t>(k), {set_.x(k), R(0), set_.length(k)}};
        found_.push_back({What::step, at, at, set_.point(k).anchor});
        open_ = false;
      }
      std::vector<Value> values;
      for (const SurfacePoint<R>& at : places(set_, k))
        values.push_back({at, form_.regular_factor(form_.slope_at(k), at)});
      for (std::size_t i = 0; i < values.size(); ++i) {
        const bool between = 0 < i && i + 1 < values.size();
        const std::optional<Value> peak = between ? peak_beside(values[i - 1], values[i], values[i + 1]) : std::nullopt;
        const bool before = peak && peak->at.node.from_left < values[i].at.node.from_left;
        if (before) inspect(peak->at, peak->b);
        inspect(values[i].at, values[i].b);
        if (peak && !before) inspect(peak->at, peak->b);
      }
    }
    decide(end);
    this->end(end - 1);
  }

  void inspect_gap(std::size_t first, std::size_t end) {
    const bool contact_left = first > 0;
    const bool contact_right = end < set_.segments();
    if (!contact_left && !contact_right) return;
    std::vector<SurfacePoint<R>> all;
    std::vector<R> rates;
    bool steps = set_.is_at_step(end);
    for (std::size_t k = first; k < end; ++k) {
      steps = steps || set_.is_at_step(k);
      std::vector<SurfacePoint<R>> more = places(set_, k);
      const std::vector<SurfacePoint<R>> extrema = form_.profile_extrema(k);
      more.insert(more.end(), extrema.begin(), extrema.end());
      // Add the support's ends, and both sides of steps and corners.
      if (k > first || !contact_left) more.push_back(beside(set_, k, Side::right, R(0)));
      if (k + 1 < end || !contact_right) more.push_back(beside(set_, k + 1, Side::left, R(0)));
      std::stable_sort(more.begin(), more.end(), [](const SurfacePoint<R>& a, const SurfacePoint<R>& b) {
        return std::tie(a.node.from_left, b.node.from_right) < std::tie(b.node.from_left, a.node.from_right);
      });
      for (const SurfacePoint<R>& at : more) {
        const R here = rate(at);
        if (!all.empty() && rates.back() < 0 && here > 0) {
          if (const auto lowest = turn(all.back(), rates.back(), at, here)) {
            all.push_back(*lowest);
            rates.push_back(rate(*lowest));
          }
        }
        all.push_back(at);
        rates.push_back(here);
      }
    }
    // A gap that only opens, and then only closes up to its other end, is positive in between. It needs no integration.
    if (!steps) {
      std::size_t i = 0;
      while (contact_left && i < all.size() && rates[i] >= 0) ++i;
      while (contact_right && i < all.size() && rates[i] <= 0) ++i;
      if (i == all.size()) return;
    }
    const GapIntegral<R> from_left(form_, first);
    const GapIntegral<R> from_right(form_, end);
    const auto penetrates = [&](std::size_t i) {
      const bool left = contact_left && (!contact_right || i < all.size() / 2);
      if (is_clearly_open(left ? first : end, all[i])) return false;
      const Estimate<R> gap = (left ? from_left : from_right).reduced_gap(all[i]);
      return gap.value < -8 * gap.error;
    };
    // The gap is lowest beside a step, at the first or last place, or where it stops closing and begins to open.
    const auto turns = [&](std::size_t i) { return !(rates[i] > 0) && !(rates[i + 1] < 0); };
    const auto may_be_lowest = [&](std::size_t i) { return i == 0 || i + 1 == all.size() || turns(i - 1) || turns(i); };
    bool fails = steps;
    for (std::size_t i = 0; i < all.size() && !fails; ++i) fails = may_be_lowest(i) && penetrates(i);
    if (!fails) return;
    begin(first);
    for (std::size_t i = 0; i < all.size(); ++i) note(What::penetration, penetrates(i), all[i]);
    this->end(end - 1);
  }

  bool is_clearly_open(std::size_t end, const SurfacePoint<R>& at) {
    if constexpr (std::same_as<R, double>) {
      return false;
    } else {
      if (!rough_) rough_ = std::make_unique<RoughGaps<R>>(form_);
      return rough_->is_open(end, at);
    }
  }

  /// Returns the lowest place of the gap between two places of one segment; the gap closes at the first one and opens
  /// at the second one. Uses the method of false position; if an end stays twice, its rate is halved. The error of the
  /// gap is of second order.
  std::optional<SurfacePoint<R>> turn(SurfacePoint<R> closes, R closing, SurfacePoint<R> opens, R opening) const {
    if (closes.segment != opens.segment) return std::nullopt;
    const auto k = static_cast<std::size_t>(closes.segment);
    const R near = sqrt(epsilon<R>()) * (opens.node.from_left - closes.node.from_left);
    SurfacePoint<R> at = closes;
    for (int step = 0, stays = 0; step < 60; ++step) {
      const R& left = closes.node.from_left;
      const R d = left + (opens.node.from_left - left) * (closing / (closing - opening));
      const R moved = abs(d - at.node.from_left);
      at = surface_point(set_, k, d, set_.length(k) - d);
      if (moved <= near) break;
      const R here = rate(at);
      const int side = here < 0 ? -1 : 1;
      (side < 0 ? closes : opens) = at;
      (side < 0 ? closing : opening) = here;
      if (side == stays) (side < 0 ? opening : closing) /= 2;
      stays = side;
    }
    return at;
  }

  R rate(const SurfacePoint<R>& at) const {
    const auto segment = static_cast<std::size_t>(at.segment);
    return form_.sign(at) * form_.regular_factor(form_.slope_at(segment), at).value;
  }

  const TractionRepresentation<R>& form_;
  const ContactSet<R>& set_;
  R end_error_;
  std::unique_ptr<RoughGaps<R>> rough_;  ///< in higher precision than double, from the first gap on
  std::vector<Violation<R>> found_;
  bool open_ = false;
  SurfacePoint<R> previous_;
};

}  // namespace

template <Real R>
std::vector<Violation<R>> violations(const TractionRepresentation<R>& form, const R& end_error) {
  return Inspection<R>(form, end_error).run();
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template std::vector<Violation<R>> violations(const TractionRepresentation<R>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
