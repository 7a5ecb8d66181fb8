#include "checker/problem.hpp"

#include <algorithm>

#include "checker/reader.hpp"

namespace steadyslide::checker {
namespace {

/// Returns the problem with equal neighbouring pieces merged.
Problem merged(Problem p) {
  for (std::size_t k = p.jumps.size(); k-- > 0;) {
    if (p.friction[k] != p.friction[k + 1]) continue;
    p.friction.erase(p.friction.begin() + static_cast<std::ptrdiff_t>(k));
    p.jumps.erase(p.jumps.begin() + static_cast<std::ptrdiff_t>(k));
  }
  const auto alike = [](const Problem::Piece& a, const Problem::Piece& b) { return a.profile == b.profile; };
  // unique() keeps the first of equal pieces; in the reversed list this is the rightmost one.
  std::ranges::reverse(p.pieces);
  p.pieces.erase(std::unique(p.pieces.begin(), p.pieces.end(), alike), p.pieces.end());
  std::ranges::reverse(p.pieces);
  return p;
}

}  // namespace

Problem::Loads Problem::Loads::read(const Reader& at) {
  const std::vector<Rational> ends = at.rationals();
  if (ends.size() != 2 || ends[0].sign() <= 0 || ends[0] > ends[1])
    at.fail("no loads", "[from, to] with 0 < from <= to");
  return {ends[0], ends[1]};
}

void Problem::read_harmonics(const Reader& at) {
  for (const Reader& term : at.list()) {
    term.check_keys({"n"}, {"cos", "sin"});
    const Rational n = term["n"].rational();
    int k = 1;
    while (k < 101 && n != k) ++k;
    if (k == 101) term["n"].fail("number out of range", "it is a whole number from 1 to 100");
    std::array<Rational, 2>& sum = harmonics[k];
    if (term.has("cos")) sum[0] = sum[0] + term["cos"].rational();
    if (term.has("sin")) sum[1] = sum[1] + term["sin"].rational();
  }
  std::erase_if(harmonics, [](const auto& term) { return term.second[0].sign() == 0 && term.second[1].sign() == 0; });
}

Problem Problem::of_certificate(const Reader& at, bool one_load, bool periodic) {
  const char* load = one_load ? "load" : "loads";
  Problem p;
  if (periodic) {
    at.check_keys({load, "load_at", "sliding", "gamma", "compliance", "friction", "indenter", "period", "harmonics"});
    p.period = at["period"].rational();
    if (p.period.sign() <= 0) at["period"].fail("out of range", "it is positive");
    p.read_harmonics(at["harmonics"]);
  } else {
    at.check_keys({load, "load_at", "sliding", "gamma", "compliance", "friction", "indenter"});
  }
  p.loads = one_load ? Loads{at["load"].rational(), at["load"].rational()} : Loads::read(at["loads"]);
  if (!at["load_at"].is_null()) p.load_at = at["load_at"].rational();
  p.slides_to_plus_x = at["sliding"].choice({"+x", "-x"}) == 0;
  p.gamma = at["gamma"].rational();
  p.compliance = at["compliance"].rational();
  at["friction"].check_keys({"values", "jumps"});
  p.friction = at["friction"]["values"].rationals();
  p.jumps = at["friction"]["jumps"].rationals();
  at["indenter"].check_keys({"left", "pieces"});
  p.left = at["indenter"]["left"].rational();
  for (const Reader& piece : at["indenter"]["pieces"].list()) {
    piece.check_keys({"to", "profile"});
    p.pieces.push_back({piece["to"].rational(), trimmed(piece["profile"].rationals())});
  }
  p.check(at.place());
  return p;
}

void Problem::check(const std::string& place) const {
  const auto require = [&](bool holds, const std::string& key, const std::string& rule, const std::string& value) {
    if (!holds) throw Malformed(place + "." + key, "out of range", rule, value);
  };
  require(loads.from.sign() > 0, "load", "the load is positive", loads.from.text());
  require(gamma < 1 && gamma > -1, "gamma", "it lies in ]-1, 1[", gamma.text());
  require(compliance.sign() > 0, "compliance", "it is positive", compliance.text());
  require(!friction.empty() && friction.size() == jumps.size() + 1, "friction.jumps",
          "there is one jump fewer than friction values", std::to_string(jumps.size()) + " jumps");
  for (const Rational& f : friction) require(f.sign() >= 0, "friction.values", "it is at least 0", f.text());
  require(!pieces.empty(), "indenter.pieces", "an indenter has at least one", "0 pieces");
  Rational previous = left;
  for (const Piece& piece : pieces) {
    require(piece.to > previous, "indenter.pieces", "pieces follow each other from left to right", piece.to.text());
    require(piece.profile.size() <= 65, "indenter.pieces", "the degree of a profile is at most 64", "more");
    previous = piece.to;
  }
  const Rational right = previous;
  previous = left;
  for (const Rational& c : jumps) {
    require(c > previous && c < right, "friction.jumps", "jumps increase, inside the support", c.text());
    previous = c;
  }
  require(period.sign() == 0 || period >= right - left, "period", "it is at least as long as the support",
          period.text());
  require(period.sign() == 0 || !load_at, "load_at", "with a period the attitude is given", "present");
  if (load_at) require(*load_at > left && *load_at < right, "load_at", "it lies inside the support", load_at->text());
}

std::string Problem::difference(const Problem& file) const {
  const Problem a = merged(*this);
  const Problem b = merged(file);
  if (b.loads.from < a.loads.from || b.loads.to > a.loads.to) return "load";
  if (a.load_at != b.load_at) return "load_at";
  if (a.slides_to_plus_x != b.slides_to_plus_x) return "sliding";
  if (a.gamma != b.gamma) return "gamma";
  if (a.compliance != b.compliance) return "compliance";
  if (a.friction != b.friction) return "friction.values";
  if (a.jumps != b.jumps) return "friction.jumps";
  if (a.left != b.left) return "indenter.left";
  if (a.period != b.period) return "half_space.period";
  if (a.harmonics != b.harmonics) return "indenter.harmonics";
  return a.pieces == b.pieces ? "" : "indenter.pieces";
}

bool Problem::theorem_1_applies() const {
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    if (s(k + 1) < s(k)) return false;
  }
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    if (value(pieces[k].profile - pieces[k - 1].profile, pieces[k - 1].to).sign() != 0) return false;
  }
  return !load_at;
}

ReducedProblem::ReducedProblem(const Problem& problem, Rational origin_, Rational unit_)
    : origin(std::move(origin_)), unit(std::move(unit_)), places(problem.jumps) {
  places.push_back(problem.left);
  for (const Problem::Piece& piece : problem.pieces) places.push_back(piece.to);
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::size_t piece = 0;
  std::size_t friction = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    anchors.push_back((places[k] - origin) / unit);
    steps.emplace_back(0);
    if (k + 1 == places.size()) break;
    if (places[k] == problem.pieces[piece].to) {
      ++piece;
      steps.back() = value(problem.pieces[piece].profile - problem.pieces[piece - 1].profile, places[k]) /
                     (problem.compliance * unit);
    }
    if (friction < problem.jumps.size() && places[k] == problem.jumps[friction]) ++friction;
    const Polynomial g = composed(derivative(problem.pieces[piece].profile), unit, origin) *
                         Polynomial{Rational(1) / problem.compliance};
    const auto found = std::ranges::find(slopes, g);
    slope_of.push_back(static_cast<std::size_t>(found - slopes.begin()));
    if (found == slopes.end()) slopes.push_back(g);
    s.push_back(problem.s(friction));
  }
  if (problem.load_at) load_at = (*problem.load_at - origin) / unit;
}

}  // namespace steadyslide::checker
