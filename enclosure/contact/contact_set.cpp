#include "enclosure/contact/contact_set.hpp"

#include <algorithm>

#include "model/singular_point.hpp"

namespace steadyslide::enclosure {

using Kind = ContactTopology::Kind;

ContactSet::ContactSet(const ReducedProblem& problem, ContactTopology topology, const std::vector<Ball>& log_offsets,
                       Bits bits)
    : problem_(&problem), topology_(std::move(topology)), bits_(bits), degree_(topology_.degree_at_infinity()) {
  std::size_t movable = 0;
  std::size_t interval = 0;
  bool contact = false;
  for (const ContactTopology::Point& point : topology_.points) {
    Ball offset(0, bits);
    if (point.beside) {
      offset = exp(log_offsets[movable++].at(bits));
      if (*point.beside == Side::left) offset = -offset;
    }
    x_.push_back(Ball(problem.anchors[point.anchor].x, bits) + offset);
    offsets_.push_back(offset);
    if (!point.beside) interval = point.anchor;
    if (point.kind != Kind::interior) contact = point.kind == Kind::begins;
    if (offsets_.size() == topology_.points.size()) break;
    intervals_.push_back(interval);
    contact_.push_back(contact);
    cosines_.push_back(Ball(1) / sqrt(Ball(1 + problem.intervals[interval].s * problem.intervals[interval].s, bits)));
  }
  for (std::size_t k = 0; k + 1 < points(); ++k) lengths_.push_back(distance(k, k + 1));

  for (std::size_t j = 0; j < points(); ++j) {
    const ContactTopology::Point& p = point(j);
    Exponent exponent;
    if (p.is_end()) {
      const End end = p.kind == Kind::begins ? End::left : End::right;
      const Rational& s = this->interval(p.kind == Kind::begins ? j : j - 1).s;
      exponent = p.vanishes ? free_exponent(end, s) : edge_exponent(end, s);
    } else if (j > 0 && j + 1 < points() && contact_[j]) {
      exponent = jump_exponent(this->interval(j - 1).s, this->interval(j).s);
    }
    regular_.push_back(exponent.sign() == 0);
    powers_.emplace_back(exponent, bits);
    exponents_.push_back(std::move(exponent));
  }

  // Y+ = |Y| e^{i pi sigma}, sigma the sum of the powers on the right; (s+i) cos(pi alpha) = i e^{-i pi alpha}. So eps
  // is e^{i pi (1/2 + sigma - alpha)}. Outside the contact sigma is an integer.
  Exponent sigma;
  signs_.resize(segments());
  for (std::size_t k = segments(); k-- > 0;) {
    sigma += exponents_[k + 1];
    const Exponent phase = in_contact(k) ? half + sigma - Exponent::angle(this->interval(k).s) : sigma;
    signs_[k] = phase.reduced().halves % 4 == 0 ? 1 : -1;
  }
}

Ball ContactSet::velocity(std::size_t j) const { return offsets_[j]; }

Ball ContactSet::distance(std::size_t i, std::size_t j) const {
  const std::size_t from = point(i).anchor;
  const std::size_t to = point(j).anchor;
  const Ball moved = offsets_[j] - offsets_[i];
  return from == to ? moved : Ball(problem_->anchors[to].x - problem_->anchors[from].x, bits_) + moved;
}

Ball ContactSet::step(std::size_t j) const {
  return point(j).beside ? Ball(0, bits_) : Ball(problem_->anchors[point(j).anchor].step, bits_);
}

SurfacePoint ContactSet::place(std::size_t segment, Side from, const Ball& distance) const {
  const Ball rest = length(segment) - distance;
  return from == Side::left ? SurfacePoint{segment, distance, rest} : SurfacePoint{segment, rest, distance};
}

bool ContactSet::is_ordered() const {
  return std::all_of(lengths_.begin(), lengths_.end(), [](const Ball& length) { return length.is_positive(); });
}

std::vector<ContactSet::Run> ContactSet::runs(bool contact) const {
  std::vector<Run> result;
  for (std::size_t k = 0; k < segments(); ++k) {
    if (contact_[k] != contact) continue;
    if (k > 0 && contact_[k - 1] == contact && !point(k).is_end()) {
      result.back().last = k;
    } else {
      result.push_back({k, k});
    }
  }
  return result;
}

std::vector<ContactSet::Run> ContactSet::gaps() const {
  std::vector<Run> result;
  for (const Run& run : runs(false)) {
    if (point(run.first).kind == Kind::ends && point(run.last + 1).kind == Kind::begins) result.push_back(run);
  }
  return result;
}

}  // namespace steadyslide::enclosure
