#pragma once
// A periodic contact problem as the search for its zone sees it.

#include <algorithm>
#include <optional>
#include <vector>

#include "model/contact_problem.hpp"
#include "model/singular_point.hpp"
#include "numeric/periodic/periodic_traction.hpp"

namespace steadyslide::numeric {

/// The ends of a zone, measured from the origin.
template <Real R>
struct ZoneEnds {
  R left, right;
  bool left_is_free, right_is_free;
};

/// The data of a problem, measured from the origin, in reduced quantities. Without edges, a zone may lie across the ends
/// of the support; there the last friction piece and the first one meet.
template <Real R>
struct ZoneData {
  /// Refers to `contact`.
  ZoneData(const ContactProblem& contact, const Rational& origin)
      : problem(contact),
        whole(problem.indenter().right() - problem.indenter().left() == *problem.body().period()),
        period(to_real<R>(*problem.body().period())),
        left(to_real<R>(problem.indenter().left() - origin)),
        right(to_real<R>(problem.indenter().right() - origin)) {
    pieces.push_back(whole ? problem.friction().values().size() - 1 : 0);
    for (int shift = whole ? -1 : 0; shift <= (whole ? 1 : 0); ++shift) {
      const Rational moved = shift * *problem.body().period();
      const auto add = [&](const Rational& place, std::size_t piece) {
        places.push_back(place + moved);
        jumps.push_back(to_real<R>(places.back() - origin));
        pieces.push_back(piece);
      };
      if (whole) add(problem.indenter().left(), 0);
      for (std::size_t k = 0; k < problem.friction().jumps().size(); ++k) add(problem.friction().jumps()[k], k + 1);
    }
    const Rational c = problem.elasticity().compliance();
    for (const Harmonic& term : problem.indenter().harmonics()) {
      g.resize(std::max(g.size(), static_cast<std::size_t>(term.n)), {R(0), R(0)});
      const Rational factor = 2 * term.n / (*problem.body().period() * c);
      Complex<R>& slope = g[static_cast<std::size_t>(term.n - 1)];
      slope.re += pi<R>() * to_real<R>(factor * term.sine);
      slope.im -= pi<R>() * to_real<R>(factor * term.cosine);
    }
  }

  /// Returns the index in `pieces` on that side of x.
  std::size_t region(const R& x, Side side) const {
    const auto found = side == Side::left ? std::lower_bound(jumps.begin(), jumps.end(), x)
                                          : std::upper_bound(jumps.begin(), jumps.end(), x);
    return static_cast<std::size_t>(found - jumps.begin());
  }

  /// Returns the traction on a zone with these ends. If the ends of a whole period are not free, there is no gap.
  PeriodicState<R> state(const ZoneEnds<R>& ends) const {
    const std::size_t first = region(ends.left, Side::right), last = region(ends.right, Side::left);
    const auto friction = [&](std::size_t k) { return problem.coupled_friction(pieces[k]); };
    const auto exponent = [&](End end, bool is_free, std::size_t k) {
      return is_free ? free_exponent(end, friction(k)) : edge_exponent(end, friction(k));
    };
    std::vector<R> arcs, cosines, s;
    const bool closed = whole && !ends.left_is_free;
    std::vector<Power<R>> powers{Power<R>::of(closed ? jump_exponent(friction(last), friction(first))
                                                     : exponent(End::left, ends.left_is_free, first))};
    // Lengths between places of the data are rounded once.
    std::optional<Rational> from_exact;
    if (!ends.left_is_free) from_exact = problem.indenter().left();
    R from = ends.left;
    for (std::size_t k = first; k <= last; ++k) {
      std::optional<Rational> to_exact;
      if (k < last) to_exact = places[k];
      if (k == last && !ends.right_is_free) to_exact = problem.indenter().right();
      const R to = k == last ? ends.right : jumps[k];
      arcs.push_back(from_exact && to_exact ? to_real<R>(*to_exact - *from_exact) : R(to - from));
      from = to;
      from_exact = to_exact;
      cosines.push_back(cos_pi_alpha<R>(friction(k)));
      s.push_back(to_real<R>(friction(k)));
      if (k < last) powers.push_back(Power<R>::of(jump_exponent(friction(k), friction(k + 1))));
    }
    Complex<R> phase{R(ends.right_is_free ? -1 : 1), R(0)};
    int m = (ends.left_is_free ? 1 : 0) + (ends.right_is_free ? 1 : 0) - 1;
    if (closed) {
      phase = {s.back() * cosines.back(), -cosines.back()};
      m = 0;
    } else {
      powers.push_back(Power<R>::of(exponent(End::right, ends.right_is_free, last)));
      arcs.push_back(period - (ends.right - ends.left));
    }
    return periodic_state<R>(
        {{PeriodicFundamentalSolution<R>(ends.left, std::move(arcs), std::move(powers)), std::move(cosines), phase, 0},
         std::move(s),
         g,
         to_real<R>(problem.load()),
         m});
  }

  /// Returns psi/c without its constant.
  R height(const R& x) const {
    R sum = 0;
    for (std::size_t n = 1; n <= g.size(); ++n) {
      const R wave = 2 * static_cast<double>(n) * pi<R>() / period;
      sum += (g[n - 1].re * sin(wave * x) - g[n - 1].im * cos(wave * x)) / wave;
    }
    return sum;
  }

  const ContactProblem& problem;
  std::vector<R> jumps;             ///< `places`, from the origin
  std::vector<Rational> places;     ///< where the friction changes, in the user's x
  std::vector<std::size_t> pieces;  ///< the friction pieces before and behind each of them
  bool whole;                       ///< the indenter has no edges
  R period, left, right;
  std::vector<Complex<R>> g;  ///< A_n + i B_n of periodic_traction.hpp
};

}  // namespace steadyslide::numeric
