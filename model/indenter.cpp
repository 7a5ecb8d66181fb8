#include "model/indenter.hpp"

#include <algorithm>
#include <string>

#include "model/invalid_data.hpp"

namespace steadyslide {

Indenter::Indenter(const Rational& left, std::vector<Piece> pieces) : left_(left), pieces_(std::move(pieces)) {
  if (pieces_.empty()) {
    throw InvalidData("indenter.pieces", "no piece", "an indenter has at least one", "0 pieces");
  }
  Rational previous = left_;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    if (pieces_[k].to <= previous) {
      throw InvalidData("indenter.pieces[" + std::to_string(k) + "].to", "piece of no length",
                        "pieces follow each other from left to right, each with a positive length",
                        "from " + to_string(previous) + " to " + to_string(pieces_[k].to));
    }
    previous = pieces_[k].to;
  }
  std::vector<Break> breaks;
  for (std::size_t k = 0; k + 1 < pieces_.size(); ++k) {
    const Rational& x = pieces_[k].to;
    const Polynomial difference = pieces_[k + 1].profile - pieces_[k].profile;
    breaks.push_back({x, difference(x), difference.derivative()(x)});
  }
  breaks_ = std::make_shared<const std::vector<Break>>(std::move(breaks));
}

const Polynomial& Indenter::profile(const Rational& x, Side side) const {
  const auto ends_before = [side](const Piece& piece, const Rational& place) {
    return side == Side::left ? piece.to < place : piece.to <= place;
  };
  return std::lower_bound(pieces_.begin(), pieces_.end() - 1, x, ends_before)->profile;
}

Indenter::Break Indenter::break_at(const Rational& x) const {
  const auto found = std::lower_bound(breaks_->begin(), breaks_->end(), x,
                                      [](const Break& at, const Rational& place) { return at.x < place; });
  return found != breaks_->end() && found->x == x ? *found : Break{x};
}

Indenter::Break Indenter::Break::reduced(const Rational& origin, const Rational& unit,
                                         const Rational& compliance) const {
  return {(x - origin) / unit, step / (compliance * unit), wedge / compliance};
}

Indenter Indenter::with_harmonics(std::vector<Harmonic> terms, const Rational& origin) const {
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (terms[k].n > 0) continue;
    throw InvalidData("indenter.harmonics[" + std::to_string(k) + "].n", "number out of range",
                      "a harmonic has a positive number", std::to_string(terms[k].n));
  }
  Indenter result = *this;
  result.harmonics_ = std::move(terms);
  result.origin_of_harmonics_ = origin;
  return result;
}

bool Indenter::is_smooth() const {
  return std::all_of(breaks_->begin(), breaks_->end(), [](const Break& b) { return b.step == 0 && b.wedge == 0; });
}

Indenter Indenter::moved(const Rational& scale, const Rational& shift) const {
  std::vector<Piece> pieces;
  Rational from = left_;
  for (const Piece& piece : pieces_) {
    const Rational& end = scale < 0 ? from : piece.to;
    pieces.push_back({scale * end + shift, piece.profile.composed(1 / scale, -shift / scale)});
    from = piece.to;
  }
  if (scale < 0) std::reverse(pieces.begin(), pieces.end());
  std::vector<Harmonic> terms = harmonics_;
  if (scale < 0) {
    for (Harmonic& term : terms) term.sine = -term.sine;
  }
  return Indenter(scale * (scale < 0 ? right() : left_) + shift, std::move(pieces))
      .with_harmonics(std::move(terms), scale * origin_of_harmonics_ + shift);
}

Indenter Indenter::scaled(const Rational& factor) const {
  std::vector<Piece> pieces = pieces_;
  for (Piece& piece : pieces) piece.profile = Polynomial::constant(factor) * piece.profile;
  std::vector<Harmonic> terms = harmonics_;
  for (Harmonic& term : terms) {
    term.cosine *= factor;
    term.sine *= factor;
  }
  return Indenter(left_, std::move(pieces)).with_harmonics(std::move(terms), origin_of_harmonics_);
}

}  // namespace steadyslide
