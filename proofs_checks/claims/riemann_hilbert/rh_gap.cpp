// Compares the gap between the profile and the surface from the Riemann-Hilbert form with that from the logarithmic
// potential.

#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rh_gap {
namespace {

/// The formula gap = steps on the way + int Y B_k, from a contact end to a point.
struct GapTerms {
  Number scale = 1;
  int steps = 1;  ///< factor of the steps
  bool unsigned_y = false;
  bool excess = true;  ///< include the polynomial at infinity
};

/// A contact end at a gap.
template <class R>
struct Facing {
  const TractionRepresentation<R>& form;
  std::size_t end;
  std::size_t panel;  ///< contact panel at this end

  bool rightwards() const { return !form.set().in_contact(end); }
  R distance(const R& xi) const { return xi - form.set().x(end); }

  R steps_to(std::size_t segment) const {
    R sum = 0;
    for (std::size_t j = std::min(end, segment + 1); j <= std::max(end, segment); ++j) {
      if (form.set().point(j).anchor) sum += form.problem().anchors()[*form.set().point(j).anchor].step;
    }
    return rightwards() ? sum : R(-sum);
  }

  /// Returns the rise of the profile from the contact at this end to a point in the gap.
  R rise(const R& xi) const {
    const R origin = to_real<R>(Trial::frame().origin);
    const R unit = to_real<R>(Trial::frame().unit);
    const std::size_t inside = rightwards() ? end - 1 : end;
    const R contact = (form.set().x(inside) + form.set().x(inside + 1)) / 2;
    const auto at = [&](const R& near, const R& place) {
      return R(height<R>(form.problem().problem(), R(origin + unit * near), R(origin + unit * place)) / unit);
    };
    return at(xi, xi) - at(contact, form.set().x(end)) + form.tilt() * distance(xi);
  }
};

template <Real R>
class GapCheck {
 public:
  GapCheck(Findings& findings, const GapTerms& terms, const TractionRepresentation<R>& form)
      : findings_(findings), terms_(terms), form_(form), grid_(traction_density(form)) {
    if (terms.excess) excess_ = excess(form);
  }

  /// Checks every gap from both of its ends, at `places` points of each of its segments.
  void operator()(Random& random, int places) {
    const auto& set = form_.set();
    std::size_t panel = 0;  // number of contact panels so far
    std::optional<Facing<R>> left;
    for (std::size_t k = 0; k < set.segments(); ++k) {
      if (set.in_contact(k)) {
        left.emplace(Facing<R>{form_, k + 1, panel++});
        continue;
      }
      std::size_t end = k + 1;
      while (end < set.segments() && !set.in_contact(end)) ++end;
      std::optional<Facing<R>> right;
      if (end < set.segments()) right.emplace(Facing<R>{form_, end, panel});
      for (int i = 0; i < places; ++i) {
        gap(left, right, k, to_real<R>(random.between(Rational(1, 20), Rational(19, 20))));
      }
    }
  }

 private:
  /// Checks a point in a gap from both contact ends. The difference between the two results must agree with the closure
  /// error of the gap.
  void gap(const std::optional<Facing<R>>& left, const std::optional<Facing<R>>& right, std::size_t segment,
           const R& fraction) {
    const SurfacePoint<R> at =
        numeric::beside(form_.set(), segment, Side::right, R(fraction * form_.set().length(segment)));
    Heights difference;
    for (const auto* from : {&left, &right}) {
      if (!*from) continue;
      const Heights h = heights(**from, at.node.x);
      compare("gap", by_form(numeric::GapIntegral<R>(form_, (*from)->end).reduced_gap(at).value, **from, segment), h);
      const int sign = from == &left ? 1 : -1;
      difference.profile += sign * h.profile;
      difference.surface += sign * h.surface;
    }
    if (!left || !right || left->end != segment) return;
    const numeric::GapIntegral<R> whole(form_, left->end);
    compare("closure", by_form(whole.closure_error(whole.rule()).value, *left, right->end), difference);
  }

  R by_form(R gap, const Facing<R>& from, std::size_t segment) const {
    if (terms_.unsigned_y) gap *= form_.sign(static_cast<std::ptrdiff_t>(from.rightwards() ? from.end : from.end - 1));
    return R(terms_.scale) * gap + (terms_.steps - 1) * from.steps_to(segment);
  }

  struct Heights {
    R profile = 0;
    R surface = 0;
  };

  /// Returns the heights of profile and surface at a point in a gap, relative to the contact end.
  Heights heights(const Facing<R>& from, const R& xi) const {
    using std::abs, std::pow;
    R surface = grid_.displacement(from.panel, from.rightwards() ? Side::right : Side::left, R(abs(from.distance(xi))));
    for (std::size_t j = 0; j < excess_.size(); ++j) {
      const int n = static_cast<int>(j) + 1;
      surface += excess_[j] * (pow(xi, n) - pow(form_.set().x(from.end), n)) / n;
    }
    return {from.rise(xi), surface};
  }

  void compare(std::string_view name, const R& gap, const Heights& h) {
    using std::abs, std::max;
    findings_.compare(name, gap, R(h.profile - h.surface), max(R(abs(h.profile)), R(abs(h.surface))));
  }

  Findings& findings_;
  const GapTerms& terms_;
  const TractionRepresentation<R>& form_;
  trapezoidal::Grid<R> grid_;
  std::vector<R> excess_;
};

}  // namespace

Claim claim() {
  return formula_claim<Trial, GapTerms>("rh-gap")
      .cases(trials("rh-gap", {20, 3, 1}))
      .checked([]<Real R>(Findings& findings, const GapTerms& terms, const Trial& trial, const Context& context) {
        const TrialForm<R> tried(trial);
        Random random(context.seed, "rh-gap, places: " + text_of(trial));
        GapCheck<R>(findings, terms, tried.form())(random, context.quick ? 1 : 3);
      })
      .wrong("the integral with the other sign", &GapTerms::scale, -1)
      .wrong("half of the integral", &GapTerms::scale, 0.5)
      .wrong("`|Y|` instead of `Y`", &GapTerms::unsigned_y, true)
      .wrong("steps not counted", &GapTerms::steps, 0)
      .wrong("steps counted with the other sign", &GapTerms::steps, -1)
      .wrong("the polynomial at infinity forgotten", &GapTerms::excess, false)
      .near_miss("the gap", [](GapTerms& terms, const Number& step) { terms.scale += 2 * step; });
}

}  // namespace steadyslide::proofs_checks::rh_gap
