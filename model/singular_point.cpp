#include "model/singular_point.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace steadyslide {
namespace {

// In the order of SingularKind: end, friction jumps, slope jumps; power, logarithm, constant.
constexpr std::array<LocalTerms, 6> all_local_terms{{
    {SingularKind::edge, "edge", "edge", true, false, false, true, false, false},
    {SingularKind::free, "free", "free end", true, false, false, true, false, false},
    {SingularKind::step, "step", "step", true, false, false, true, false, false},
    {SingularKind::friction_jump, "friction_jump", "friction jump", false, true, false, true, false, false},
    {SingularKind::wedge, "wedge", "wedge", false, false, true, false, true, true},
    {SingularKind::wedge_and_jump, "wedge_and_jump", "wedge and friction jump", false, true, true, true, false, true},
}};
static_assert(std::is_sorted(all_local_terms.begin(), all_local_terms.end(),
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

/// Adds the point where the friction pieces `left` and `right` meet, if something jumps there.
void add_interior(const ContactProblem& problem, std::size_t left, std::size_t right, const Indenter::Break& at,
                  std::vector<SingularPoint>& points) {
  const Rational& x = at.x;
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
  const std::optional<SingularKind> kind = inner_kind(beta.sign() != 0, at.wedge != 0);
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

const LocalTerms& local_terms(SingularKind kind) { return all_local_terms[static_cast<std::size_t>(kind)]; }

std::optional<SingularKind> inner_kind(bool friction_jumps, bool slope_jumps) {
  for (const LocalTerms& terms : all_local_terms) {
    const bool fits = terms.friction_jumps == friction_jumps && terms.slope_jumps == slope_jumps;
    if (!terms.is_end && fits) return terms.kind;
  }
  return std::nullopt;
}

std::optional<InnerTerms> inner_terms(const Rational& s_left, const Rational& s_right, const Indenter::Break& at) {
  const std::optional<SingularKind> kind = inner_kind(s_left != s_right, at.wedge != 0);
  if (!kind) return std::nullopt;
  if (local_terms(*kind).has_logarithm) return InnerTerms{*kind, at.wedge / (1 + s_left * s_left), 0};
  return InnerTerms{*kind, 0, at.wedge / (s_right - s_left)};
}

std::string_view name_of(ContactSide side) {
  switch (side) {
    case ContactSide::left: return "left";
    case ContactSide::right: return "right";
    case ContactSide::both: return "both";
  }
  return "";
}

std::vector<SingularPoint> possible_singular_points(const ContactProblem& problem) {
  const std::vector<ContactProblem::Piece> pieces = problem.pieces();
  const std::vector<Indenter::Break>& breaks = problem.indenter().breaks();
  std::vector<SingularPoint> points;
  add_ends(problem, problem.indenter().left(), End::left, points);
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const ContactProblem::Piece& left = pieces[k - 1];
    const ContactProblem::Piece& right = pieces[k];
    const bool is_break = left.profile != right.profile;
    add_interior(problem, left.friction, right.friction, is_break ? breaks[left.profile] : Indenter::Break{right.left},
                 points);
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
