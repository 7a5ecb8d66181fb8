// The gap between the profile and the surface, from the Riemann-Hilbert form and from the logarithmic potential.

#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::RiemannHilbertForm;
using numeric::SurfacePoint;

/// gap = steps on the way + int Y B_k, from a contact end to a place.
template <class R>
struct GapTerms {
  std::shared_ptr<const TrialForm<R>> trial;
  R scale = 1;
  R steps = 1;  ///< how often they are counted
  bool unsigned_y = false;
  bool excess = true;
};
using GapFormula = Formula<GapTerms, Trial>;

/// One end of contact seen from a gap.
template <class R>
struct Facing {
  const RiemannHilbertForm<R>& form;
  std::size_t end;
  std::size_t panel;  ///< of the contact, next to the end

  bool rightwards() const { return !form.set().in_contact(end); }
  R distance(const R& xi) const { return xi - form.set().x(end); }

  R steps_to(std::size_t segment) const {
    R sum = 0;
    const auto add = [&](std::size_t j, int sign) {
      if (form.set().point(j).anchor) sum += sign * form.problem().anchors()[*form.set().point(j).anchor].step;
    };
    if (rightwards()) {
      for (std::size_t j = end; j <= segment; ++j) add(j, 1);
    } else {
      for (std::size_t j = segment + 1; j <= end; ++j) add(j, -1);
    }
    return sum;
  }

  /// Of the profile from the contact at the end to a place in the gap.
  R rise(const R& xi) const {
    const R origin = numeric::to_real<R>(Trial::frame().origin);
    const R unit = numeric::to_real<R>(Trial::frame().unit);
    const std::size_t inside = rightwards() ? end - 1 : end;
    const R contact = (form.set().x(inside) + form.set().x(inside + 1)) / 2;
    const auto at = [&](const R& near, const R& place) {
      return R(height<R>(form.problem().problem(), R(origin + unit * near), R(origin + unit * place)) / unit);
    };
    return at(xi, xi) - at(contact, form.set().x(end)) + form.tilt() * distance(xi);
  }
};

template <Real R>
class Comparison {
 public:
  Comparison(Findings& findings, const GapTerms<R>& terms)
      : findings_(findings),
        terms_(terms),
        form_(terms.trial->form()),
        surface_(traction_density(form_), friction_of(form_), [](std::size_t, const auto&) { return R(0); }) {}

  /// A place in a gap, seen from the contact ends that face it, and what they miss of each other: what the profile
  /// misses there is the same for both.
  void gap(const std::optional<Facing<R>>& left, const std::optional<Facing<R>>& right, std::size_t segment,
           const R& fraction) {
    const Quantity quantity{
        "gap at a random place", {"steps and int Y B_k", "logarithmic potential of t"}, tolerance<R>()};
    const Quantity closure{
        "what closes over a whole gap", {"steps and int Y B_k", "logarithmic potential of t"}, tolerance<R>()};
    const SurfacePoint<R> at =
        numeric::beside(form_.set(), segment, Side::right, R(fraction * form_.set().length(segment)));
    Heights difference;
    for (const auto* from : {&left, &right}) {
      if (!*from) continue;
      const Heights h = heights(**from, at.node.x);
      compare(quantity, by_form(numeric::GapIntegral<R>(form_, (*from)->end).reduced_gap(at).value, **from, segment),
              h);
      const int sign = from == &left ? 1 : -1;
      difference.profile += sign * h.profile;
      difference.surface += sign * h.surface;
    }
    if (!left || !right || left->end != segment) return;
    const numeric::GapIntegral<R> whole(form_, left->end);
    compare(closure, by_form(whole.closure_error(whole.rule()), *left, right->end), difference);
  }

 private:
  R by_form(R gap, const Facing<R>& from, std::size_t segment) const {
    if (terms_.unsigned_y) gap *= form_.sign(static_cast<std::ptrdiff_t>(from.rightwards() ? from.end : from.end - 1));
    return terms_.scale * gap + (terms_.steps - 1) * from.steps_to(segment);
  }

  struct Heights {
    R profile = 0;
    R surface = 0;
  };

  /// Of a place in a gap above the contact end.
  Heights heights(const Facing<R>& from, const R& xi) const {
    using std::abs, std::pow;
    R surface =
        surface_.displacement(from.panel, from.rightwards() ? Side::right : Side::left, R(abs(from.distance(xi))));
    const std::vector<R> rest = terms_.excess ? excess(form_) : std::vector<R>{};
    for (std::size_t j = 0; j < rest.size(); ++j) {
      const int n = static_cast<int>(j) + 1;
      surface += rest[j] * (pow(xi, n) - pow(form_.set().x(from.end), n)) / n;
    }
    return {from.rise(xi), surface};
  }

  void compare(const Quantity& quantity, const R& gap, const Heights& h) {
    using std::abs, std::max;
    const R scale = max(R(abs(h.profile)), R(abs(h.surface)));
    findings_.compare(quantity, static_cast<double>(R(abs(gap - (h.profile - h.surface)) / scale)));
  }

  Findings& findings_;
  const GapTerms<R>& terms_;
  const RiemannHilbertForm<R>& form_;
  numeric::SurfaceCheck<R> surface_;
};

/// Every gap, seen from both of its ends.
template <Real R>
void check_gaps(Findings& findings, const GapTerms<R>& terms, Random& random, int places) {
  const RiemannHilbertForm<R>& form = terms.trial->form();
  const auto& set = form.set();
  Comparison<R> comparison(findings, terms);
  std::size_t panel = 0;  // contact panels so far
  std::optional<Facing<R>> left;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (set.in_contact(k)) {
      left.emplace(Facing<R>{form, k + 1, panel++});
      continue;
    }
    std::size_t end = k + 1;
    while (end < set.segments() && !set.in_contact(end)) ++end;
    std::optional<Facing<R>> right;
    if (end < set.segments()) right.emplace(Facing<R>{form, end, panel});
    for (int i = 0; i < places; ++i) {
      comparison.gap(left, right, k, numeric::to_real<R>(random.between(Rational(1, 20), Rational(19, 20))));
    }
  }
}

std::vector<Evidence> check(const Context& context, const GapFormula& formula) {
  const auto walk = [&]<Real R>() {
    const std::vector<Trial> all = trials(context, "rh-gap", count_for(context, {20, 3, 1}));
    Findings findings;
    Random random(context.seed, "rh-gap, places");
    for (const Trial& trial : all) {
      findings.begin_case(trial.name + ": " + text_of(trial.problem));
      check_gaps(findings, formula.at<R>(trial), random, context.quick ? 1 : 3);
    }
    return findings.evidence(detail_of(context, all));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim rh_gap() {
  const GapFormula right = GapFormula::from(
      []<Real R>(const Trial& trial) { return GapTerms<R>{std::make_shared<const TrialForm<R>>(trial)}; });
  // Plain: the formula is the solver's form, which lives at the number type it is examined in.
  return make_claim(
      claim_text("rh-gap"), check, right,
      std::vector<Wrong<GapFormula>>{
          {"the integral with the other sign", right.changed([](auto& terms, const Trial&) { terms.scale = -1; })},
          {"half of the integral",
           right.changed([]<class R>(GapTerms<R>& terms, const Trial&) { terms.scale = R(1) / 2; })},
          {"|Y| instead of Y", right.changed([](auto& terms, const Trial&) { terms.unsigned_y = true; })},
          {"steps not counted", right.changed([](auto& terms, const Trial&) { terms.steps = 0; })},
          {"steps counted with the other sign", right.changed([](auto& terms, const Trial&) { terms.steps = -1; })},
          {"the polynomial at infinity forgotten",
           right.changed([](auto& terms, const Trial&) { terms.excess = false; })},
          {"near miss: the gap moved by ten times the tolerance",
           right.changed([]<class R>(GapTerms<R>& terms, const Trial&) { terms.scale += 2 * near_miss<R>(); })}});
}

}  // namespace steadyslide::proofs_checks
