#include "enclosure/contact/decided_signs.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "enclosure/number/chebyshev_series.hpp"

namespace steadyslide::enclosure {
namespace {

using Kind = ContactTopology::Kind;

/// Half of a segment at one of its points, with distances d from this point, from 0 to half the segment's length.
struct Half {
  std::size_t segment;
  Side from;  ///< the side of the segment on which this point is
};

/// Distances from `low` to `high`. Both are exact, except at the end of the half.
struct Interval {
  Ball low;
  Ball high;
};

/// A part of half a segment, with the series of B over it, if it is made; t = -1 at the lower distance.
struct Stretch {
  Half half;
  Interval d;
  std::optional<ChebyshevSeries> b = {};
  std::array<std::optional<Ball>, 3> seen = {};  ///< distances at which B is negative, undecided, positive
};

class Decision {
 public:
  Decision(const TractionRepresentation& form, WorkBudget& work, int most_rounds)
      : form_(form),
        set_(form.set()),
        bits_(set_.bits()),
        nodes_(form.count(), bits_),
        work_(work),
        most_rounds_(most_rounds) {}

  SignsDecided run() {
    for (std::size_t k = 0; k < set_.segments() && result_.proved; ++k) {
      if (!set_.in_contact(k)) continue;
      for (const Side side : {Side::left, Side::right}) decide_half({k, side}, -set_.sign(k));
    }
    for (const ContactSet::Run& run : set_.off_contact()) {
      if (result_.proved) decide_gap(run.first, run.last);
    }
    return std::move(result_);
  }

 private:
  SurfacePoint place(const Half& half, const Interval& d) const {
    return set_.place(half.segment, half.from, Ball::hull(d.low, d.high));
  }

  static std::size_t point(const Half& half) { return ContactSet::point_of(half.segment, half.from); }

  ContactPanel::Interval part(const Half& half, const Interval& d) const {
    const Ball rest = set_.length(half.segment) - d.high;
    const bool left = half.from == Side::left;
    ContactPanel::Interval result{half.segment, left ? d.low : rest, left ? rest : d.low, d.high - d.low, {}};
    if (d.low.is_zero() && !set_.is_regular(point(half))) result.touches = half.from;
    return result;
  }

  /// Returns the end of a half. The two halves meet for all values in the box: one of them ends at an exact distance
  /// from its point.
  Ball end_of(const Half& half) const {
    const Ball& length = set_.length(half.segment);
    const Ball middle = (length / Ball(2)).midpoint();
    return half.from == Side::left ? middle : length - middle;
  }

  /// Makes the series of B from its values at thin places. Their number does not depend on cancellation in B. Does
  /// nothing next to a point where B is singular. For each value in the box, B is a function of the distance from the
  /// half's point.
  void expand(Stretch& stretch) {
    constexpr Ellipse ellipse = Ellipse::far;
    const auto& [low, high] = stretch.d;
    const Half& half = stretch.half;
    const Ball bound = form_.bound(form_.slope_of(half.segment), form_.panel(part(half, stretch.d)), ellipse);
    if (!bound.is_finite()) return;
    work_.take(nodes_.count() * form_.work_of_place());
    const Ball middle = (low + high) / Ball(2), radius = (high - low) / Ball(2);
    std::vector<Ball> values;
    for (int i = 0; i < nodes_.count(); ++i) {
      const Ball at = middle + radius * nodes_[i];
      values.push_back(form_.regular_factor(set_.place(half.segment, half.from, at)).value());
      stretch.seen[static_cast<std::size_t>(sign_of(values.back()) + 1)] = at;
    }
    if (all_finite(values)) stretch.b.emplace(nodes_, values, bound, ContactPanel::rho(ellipse));
  }

  /// Returns B's sign on the whole stretch; 0 if it is undecided. If interval arithmetic does not suffice, a series is
  /// made.
  int sign_on(Stretch& stretch, bool expands = true) {
    ++result_.intervals;
    work_.take(form_.work_of_place());
    const int sign = form_.regular_factor(place(stretch.half, stretch.d)).sign();
    if (sign != 0) return sign;
    if (!stretch.b && expands) expand(stretch);
    return stretch.b ? sign_of(stretch.b->range()) : 0;
  }

  static int sign_of(const Ball& x) { return x.is_positive() ? 1 : x.is_negative() ? -1 : 0; }

  /// Returns the two parts of a stretch that meet at `middle`.
  std::array<Stretch, 2> halves(const Stretch& whole, const Ball& middle) {
    const auto& [half, d, b, seen] = whole;
    std::array<Stretch, 2> result{Stretch{half, {d.low, middle}}, Stretch{half, {middle, d.high}}};
    if (b) {
      work_.take(work_of_restriction());
      const Ball t = (middle - d.low - (d.high - middle)) / (d.high - d.low);
      result[0].b = b->restricted(Ball(-1, bits_), t);
      result[1].b = b->restricted(t, Ball(1, bits_));
    }
    return result;
  }

  std::int64_t work_of_restriction() const {
    return std::int64_t{2} * nodes_.count() * nodes_.count() * ((bits_ + 63) / 64);
  }

  void fail(const Half& half, const Interval& d, bool refuted, std::string reason) {
    if (!result_.proved) return;
    result_.proved = false;
    result_.refuted = refuted;
    result_.reason = std::move(reason);
    const Ball distance = Ball::hull(d.low, d.high);
    result_.x = set_.x(point(half)) + (half.from == Side::left ? distance : -distance);
  }

  /// Returns d_1 of a closed interval [0, d_1] next to the half's point on which B has this sign. If there is none,
  /// returns 0, and `refuted` is true if B has the other sign.
  Ball first_interval(const Half& half, int wanted, bool& refuted) {
    const Ball zero(0, bits_);
    const Ball end = end_of(half);
    for (int k = 1; k <= 1 << 20; k *= 2) {
      const Ball d = end * power(Ball(2, bits_), -k);
      Stretch next{half, {zero, d.upper()}};
      const int sign = sign_on(next, k == 1);
      if (sign == wanted) return d.upper();
      refuted = sign == -wanted;
      if (refuted) return zero;
    }
    return zero;
  }

  /// Decides that B has the sign `wanted` on half a segment in contact, up to its point.
  void decide_half(const Half& half, int wanted) {
    if (!result_.proved) return;
    bool refuted = false;
    const Ball first = first_interval(half, wanted, refuted);
    if (!first.is_positive()) {
      fail(half, {Ball(0, bits_), Ball(0, bits_)}, refuted,
           refuted ? "the traction's leading term pulls" : "the sign of the traction's leading term is not decided");
      return;
    }
    std::vector<Stretch> open{{half, {first, end_of(half)}}};
    while (!open.empty() && result_.proved) {
      Stretch stretch = std::move(open.back());
      open.pop_back();
      const Interval& d = stretch.d;
      if (!(d.low < d.high)) continue;
      const int sign = sign_on(stretch);
      if (sign == wanted) continue;
      // At a place with the wrong sign, or at one that the box cannot decide, division does not help.
      const auto& pulls = stretch.seen[static_cast<std::size_t>(1 - wanted)];
      const auto& is_open = stretch.seen[1];
      const bool is_refuted = sign == -wanted || pulls;
      if (is_refuted || is_open || work_.is_spent() || !is_divisible(d)) {
        const std::optional<Ball>& at = pulls ? pulls : is_open;
        fail(half, at ? Interval{*at, *at} : d, is_refuted,
             is_refuted ? "the traction pulls" : undecided("the traction's sign is not decided"));
        return;
      }
      for (Stretch& part : halves(stretch, divide(d))) open.push_back(std::move(part));
    }
  }

  /// Returns the words, with the work budget as the reason if it is spent.
  std::string undecided(const char* words) const {
    return words + std::string(work_.is_spent() ? " within the budget of work" : "");
  }

  /// False for a relative width of 2^-20: such an undecided interval touches a zero, or the precision does not suffice.
  bool is_divisible(const Interval& d) const { return d.high - d.low > d.high * power(Ball(2, bits_), -20); }

  Ball divide(const Interval& d) const {
    if (d.low * Ball(4) < d.high) return sqrt(d.low * d.high).midpoint();
    return ((d.low + d.high) / Ball(2)).midpoint();
  }

  /// A part of a gap, with the change of the gap's height, from left to right.
  struct Cell {
    Stretch at;
    int sign;     ///< sign of gap' for increasing x; 0 if undecided
    Ball change;  ///< change of the gap over the cell, from left to right
    Ball range;   ///< its change up to any place of the cell lies between 0 and this
  };

  /// Returns the work at the nodes of the panel that integrates a cell.
  std::int64_t work_of_cell() const { return (form_.count() + 1) * form_.work_of_place() + 2 * work_of_restriction(); }

  Cell cell(Stretch at) {
    ++result_.intervals;
    work_.take(work_of_cell());
    const Half& half = at.half;
    const Interval& d = at.d;
    if (!at.b) expand(at);
    // The series increases the width due to the box; the interval increases the width due to cancellation.
    const LocalValue b = form_.regular_factor(place(half, d));
    const Ball values = at.b ? b.value().intersection(at.b->range()) : b.value();
    const int sign = (b.sign() != 0 ? b.sign() : sign_of(values)) * set_.sign(half.segment);
    // int |Y| over the cell: the power of the half's point is integrated, the other powers are enclosed.
    const Ball exponent = set_.power(point(half)) + Ball(1);
    const Ball low = d.low.is_positive() ? power(d.low, exponent) : Ball(0, bits_);
    const Ball weight = (power(d.high, exponent) - low) / exponent * form_.modulus(place(half, d), point(half));
    const Ball range = values * weight * Ball(set_.sign(half.segment));
    // The sum of ranges alone would exceed the gap's variation.
    Ball change = range.intersection(form_.gap_change(part(half, d), form_.slope_of(half.segment)));
    return {std::move(at), sign, std::move(change), range};
  }

  /// Returns cells from left to right: first intervals next to the contact on each side, the rest in geometric
  /// proportion.
  std::vector<Cell> cells_of(std::size_t first, std::size_t last) {
    std::vector<Cell> cells;
    for (std::size_t k = first; k <= last; ++k) {
      for (const Side side : {Side::left, Side::right}) {
        const Half half{k, side};
        const Ball end = end_of(half);
        Ball start(0, bits_);
        if (set_.point(point(half)).is_end()) {
          // The gap opens away from the contact: gap' > 0 on the right of contact, gap' < 0 on its left.
          bool refuted = false;
          start = first_interval(half, (side == Side::left ? 1 : -1) * set_.sign(k), refuted);
          if (!start.is_positive()) {
            if (set_.step(point(half)).contains_zero()) {
              fail(half, {Ball(0, bits_), Ball(0, bits_)}, refuted,
                   refuted ? "the surfaces penetrate beside the contact's end"
                           : "whether the surfaces open beside the contact's end is not decided");
              return {};
            }
            start = end;
          }
        }
        std::vector<Cell> of_half;
        if (start.is_positive()) of_half.push_back(cell({half, {Ball(0, bits_), start}}));
        if (start < end) {
          std::vector<ContactPanel::Interval> parts = ContactPanel::outward(set_, k, side, {start, end});
          if (side == Side::right) std::reverse(parts.begin(), parts.end());
          for (const ContactPanel::Interval& p : parts) {
            const Ball& low = side == Side::left ? p.from_left : p.from_right;
            of_half.push_back(cell({half, {low, low + p.length}}));
          }
        }
        if (side == Side::right) std::reverse(of_half.begin(), of_half.end());
        std::move(of_half.begin(), of_half.end(), std::back_inserter(cells));
      }
    }
    return cells;
  }

  void decide_gap(std::size_t first, std::size_t last) {
    const bool from_left = set_.point(first).kind == Kind::ends;
    const bool from_right = set_.point(last + 1).kind == Kind::begins;
    std::vector<Cell> cells = cells_of(first, last);
    Ball error = Ball::unknown(bits_);  // error of the gap's changes over all cells
    bool error_falls = true;
    for (int round = 0; result_.proved; ++round) {
      std::vector<char> open(cells.size(), 0);
      for (const Side side : {Side::left, Side::right}) {
        if (!(side == Side::left ? from_left : from_right)) continue;
        const std::optional<std::size_t> negative = mark(cells, open, side);
        if (!negative) continue;
        fail(cells[*negative].at.half, cells[*negative].at.d, true, "the surfaces penetrate");
        return;
      }
      const auto open_at = std::find(open.begin(), open.end(), 0);
      if (open_at == open.end()) return;
      // A round costs at most twice as much as the one before.
      const std::int64_t next = 2 * static_cast<std::int64_t>(cells.size()) * work_of_cell();
      if (next > work_.left()) work_.take(next);
      const Ball before = std::exchange(error, error_of(cells));
      // When only the error of the values remains, more bits help, and division does not.
      error_falls = error_falls && (!before.is_finite() || error * Ball(4) < before * Ball(3));
      const Cell& at = cells[static_cast<std::size_t>(open_at - open.begin())];
      const bool divides = error_falls || error < abs(at.range).upper() * Ball(4) || !at.range.is_finite();
      if (!divides || round == most_rounds_ || work_.is_spent()) {
        fail(at.at.half, at.at.d, false, undecided("the gap's sign is not decided"));
        return;
      }
      cells = divided(cells, open, error_falls ? &error : nullptr);
    }
  }

  /// Returns a bound of the total error of the gap's changes.
  Ball error_of(const std::vector<Cell>& cells) const {
    Ball sum(0, bits_);
    for (const Cell& c : cells) {
      if (c.change.is_finite()) sum += c.change.radius();
    }
    return sum;
  }

  /// Marks the cells in which the gap is positive, measured from the end of contact on that side. Returns the first
  /// cell at whose end the gap is negative, if there is one.
  std::optional<std::size_t> mark(const std::vector<Cell>& cells, std::vector<char>& open, Side side) const {
    const bool left = side == Side::left;
    const std::size_t n = cells.size();
    const auto at = [&](std::size_t i) -> const Cell& { return cells[left ? i : n - 1 - i]; };
    const auto direction = Ball(left ? 1 : -1);
    const auto entered = [&](const Cell& c) { return ContactSet::point_of(c.at.half.segment, side); };
    Ball height = direction * set_.step(entered(at(0)));
    Ball most = height;
    if (height.is_negative()) return left ? 0 : n - 1;
    bool grows = true;  // from the contact up to here
    for (std::size_t i = 0; i < n; ++i) {
      const Cell& c = at(i);
      if (i > 0 && at(i - 1).at.half.segment != c.at.half.segment) {
        const Ball risen = direction * set_.step(entered(c));
        height += risen;
        most += risen;
        grows = grows && !(risen.is_negative());
      }
      grows = grows && c.sign == (left ? 1 : -1);
      // A gap that only increases or only decreases is lowest at one of the cell's ends.
      const Ball lowest = (direction * (c.sign != 0 ? c.change : c.range)).lower();
      if (grows || (height + min(lowest, Ball(0, bits_))).is_positive()) open[left ? i : n - 1 - i] = 1;
      const Ball least = (direction * c.change).lower();
      height += grows ? max(least, Ball(0, bits_)) : least;
      most = (most + direction * c.change).upper();
      if (most.is_negative()) return left ? i : n - 1 - i;
      if (!height.is_finite()) {
        if (!grows) return {};
        height = Ball(0, bits_);
      }
    }
    return {};
  }

  /// Returns the cells, with those halved in which the gap's sign is open, and, if `error` is given, those that
  /// contribute to it.
  std::vector<Cell> divided(const std::vector<Cell>& cells, const std::vector<char>& open, const Ball* error) {
    const Ball share = error == nullptr ? Ball::unknown(bits_) : *error / Ball(4 * static_cast<int>(cells.size()));
    std::vector<Cell> result;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Cell& c = cells[i];
      const bool known = error == nullptr || c.change.radius() < share;
      if (open[i] != 0 && known) {
        result.push_back(c);
        continue;
      }
      const Interval& d = c.at.d;
      std::array<Stretch, 2> parts = halves(c.at, d.low.is_positive() ? divide(d) : (d.high / Ball(2)).midpoint());
      if (c.at.half.from == Side::right) std::swap(parts[0], parts[1]);
      for (Stretch& part : parts) result.push_back(cell(std::move(part)));
    }
    return result;
  }

  const TractionRepresentation& form_;
  const ContactSet& set_;
  Bits bits_;
  ChebyshevNodes nodes_;
  WorkBudget& work_;
  int most_rounds_;
  SignsDecided result_;
};

}  // namespace

SignsDecided decide_signs(const TractionRepresentation& form, WorkBudget& work, int most_rounds) {
  return Decision(form, work, most_rounds).run();
}

}  // namespace steadyslide::enclosure
