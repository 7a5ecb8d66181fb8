#include "model/singular_point.hpp"

#include <algorithm>
#include <set>

namespace steadyslide {
namespace {

// Name, words, form; end, friction jumps, derivative; power, logarithm, constant.
constexpr LocalTerms table[] = {
    {SingularKind::edge, "edge", "edge", "t = -intensity d^exponent", true, false, 0, true, false, false},
    {SingularKind::free, "free", "free end", "", true, false, 0, true, false, false},
    {SingularKind::step, "step", "step", "", true, false, 0, true, false, false},
    {SingularKind::friction_jump, "friction_jump", "friction jump",
     "constant - intensity cos(pi alpha) d^exponent at jumps", false, true, 0, true, false, false},
    {SingularKind::wedge, "wedge", "wedge", "constant + intensity log(d)/pi at wedges", false, false, 1, false, true,
     true},
    {SingularKind::wedge_and_jump, "wedge_and_jump", "wedge and friction jump", "", false, true, 1, true, false, true},
};
static_assert(std::is_sorted(std::begin(table), std::end(table),
                             [](const LocalTerms& a, const LocalTerms& b) { return a.kind < b.kind; }));

void add_ends(const ContactProblem& problem, const Rational& x, End end, std::vector<SingularPoint>& points) {
  // At the left end of contact, the contact is on the right.
  const Side inside = opposite(end);
  const ContactSide contact = inside == Side::left ? ContactSide::left : ContactSide::right;
  const std::size_t piece = problem.friction().piece(x, inside);
  const Rational s = problem.coupled_friction(piece);
  const std::vector<Rational> friction{problem.friction().values()[piece]};
  if (!problem.elasticity().indenter()) {
    points.push_back({x, SingularKind::edge, contact, friction, edge_exponent(end, s)});
  }
  points.push_back({x, SingularKind::free, contact, friction, free_exponent(end, s)});
}

/// Adds the point x between the friction pieces `left` and `right`, if something jumps there.
void add_interior(const ContactProblem& problem, const Rational& x, std::size_t left, std::size_t right,
                  std::vector<SingularPoint>& points) {
  const Indenter::Break at = problem.indenter().break_at(x);
  const std::vector<Rational>& f = problem.friction().values();
  if (at.step != 0) {
    // Contact ends at a step on its protruding side only: psi is measured away from the body.
    const bool right_protrudes = at.step < 0;
    const std::size_t piece = right_protrudes ? right : left;
    const Exponent exponent = edge_exponent(right_protrudes ? End::left : End::right, problem.coupled_friction(piece));
    points.push_back(
        {x, SingularKind::step, right_protrudes ? ContactSide::right : ContactSide::left, {f[piece]}, exponent});
    return;
  }
  const Exponent beta = jump_exponent(problem.coupled_friction(left), problem.coupled_friction(right));
  const std::optional<SingularKind> kind = inner_kind(beta.sign() != 0, at.derivative());
  if (!kind) return;
  const std::optional<Exponent> exponent = local_terms(*kind).has_power ? std::optional(beta) : std::nullopt;
  points.push_back({x, *kind, ContactSide::both, {f[left], f[right]}, exponent});
}

}  // namespace

Exponent edge_exponent(End end, const Rational& s) {
  const Exponent alpha = Exponent::angle(s);
  return end == End::left ? -half - alpha : alpha - half;
}

Exponent free_exponent(End end, const Rational& s) { return edge_exponent(end, s) + Exponent(1); }

Exponent jump_exponent(const Rational& s_left, const Rational& s_right) {
  return Exponent::angle(s_left) - Exponent::angle(s_right);
}

std::span<const LocalTerms> all_local_terms() { return table; }

const LocalTerms& local_terms(SingularKind kind) { return table[static_cast<std::size_t>(kind)]; }

std::optional<SingularKind> inner_kind(bool friction_jumps, int derivative) {
  for (const LocalTerms& terms : table) {
    if (!terms.is_end && terms.friction_jumps == friction_jumps && terms.derivative == derivative) return terms.kind;
  }
  return std::nullopt;
}

std::optional<InnerTerms> inner_terms(const Rational& s_left, const Rational& s_right, const Indenter::Break& at) {
  const std::optional<SingularKind> kind = inner_kind(s_left != s_right, at.derivative());
  if (!kind) return std::nullopt;
  if (local_terms(*kind).has_logarithm) return InnerTerms{*kind, at.wedge / (1 + s_left * s_left), 0};
  return InnerTerms{*kind, 0, at.wedge / (s_right - s_left)};
}

std::string_view name_of(ContactSide side) {
  constexpr std::string_view names[] = {"left", "right", "both"};
  return names[static_cast<std::size_t>(side)];
}

std::vector<SingularPoint> possible_singular_points(const ContactProblem& problem) {
  const std::vector<ContactProblem::Piece> pieces = problem.pieces();
  std::vector<SingularPoint> points;
  add_ends(problem, problem.indenter().left(), End::left, points);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    add_interior(problem, pieces[k].left, pieces[k - 1].friction, pieces[k].friction, points);
  }
  add_ends(problem, problem.indenter().right(), End::right, points);

  std::set<Rational> listed;
  for (std::size_t piece = 0; piece < problem.friction().values().size(); ++piece) {
    const Rational& f = problem.friction().values()[piece];
    if (!listed.insert(f).second) continue;
    const Rational s = problem.coupled_friction(piece);
    points.push_back({std::nullopt, SingularKind::free, ContactSide::right, {f}, free_exponent(End::left, s)});
    points.push_back({std::nullopt, SingularKind::free, ContactSide::left, {f}, free_exponent(End::right, s)});
  }
  return points;
}

}  // namespace steadyslide
