#include "numeric/flat_punch/punch_core.hpp"

#include <algorithm>

#include "numeric/flat_punch/friction_layout.hpp"

namespace steadyslide::numeric {

template <Real R>
std::optional<PunchCore<R>> punch_core(const ContactProblem& problem) {
  using std::abs;
  const Indenter& punch = problem.indenter();
  const auto is_flat = [&](const Indenter::Piece& piece) {
    return piece.profile == punch.pieces().front().profile && piece.profile.degree() <= 0;
  };
  if (problem.elasticity().indenter() || !std::all_of(punch.pieces().begin(), punch.pieces().end(), is_flat))
    return std::nullopt;

  const FrictionLayout<R> layout = FrictionLayout<R>::of(problem);
  const auto end = [&](R FrictionStrip<R>::*weight, int side) {
    R integral = 0;
    R moment = 0;
    for (const FrictionStrip<R>& strip : layout.strips()) {
      const R part = strip.*weight * (2 * strip.length / layout.length());
      integral += part;
      moment += part * layout.middle(strip);
    }
    return R(moment / integral + side * integral / 2);
  };
  const R centre = to_real<R>((punch.left() + punch.right()) / 2);
  const R half_length = to_real<R>((punch.right() - punch.left()) / 2);
  const auto in_users_x = [&](const R& y) {
    return Estimate<R>{centre + half_length * y, 16 * epsilon<R>() * (abs(centre) + half_length)};
  };
  return PunchCore<R>{in_users_x(end(&FrictionStrip<R>::above_half, -1)),
                      in_users_x(end(&FrictionStrip<R>::below_half, 1))};
}

template std::optional<PunchCore<double>> punch_core(const ContactProblem&);
template std::optional<PunchCore<Real50>> punch_core(const ContactProblem&);
template std::optional<PunchCore<Real100>> punch_core(const ContactProblem&);

}  // namespace steadyslide::numeric
