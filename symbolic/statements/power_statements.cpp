// What the powers of Y are between, the sign of the power at a friction jump, and the modes that a falling jump adds.

#include <algorithm>

#include "symbolic/statements/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

/// Infimum and supremum of the form, twice, over angles in ]-1/2, 1/2[ or, where s >= 0, in [0, 1/2[.
std::pair<int, int> twice_range(const AngleForm& form, bool nonnegative) {
  if (!nonnegative) return form.twice_bounds();
  std::pair<int, int> range{form.halves(), form.halves()};
  for (const auto& [k, factor] : form.times()) (factor < 0 ? range.first : range.second) += factor;
  return range;
}

struct Range {
  PointKind kind;
  std::pair<int, int> any;          // twice the ends
  std::pair<int, int> nonnegative;  // where s >= 0
};

DecidedStatement power_ranges() {
  const std::vector<Range> right{{PointKind::left_edge, {-2, 0}, {-2, -1}},
                                 {PointKind::right_edge, {-2, 0}, {-1, 0}},
                                 {PointKind::left_free, {0, 2}, {0, 1}},
                                 {PointKind::right_free, {0, 2}, {1, 2}},
                                 {PointKind::jump, {-2, 2}, {-1, 1}}};
  const PhaseField field;
  const auto decided = [&](const std::string& words, const std::vector<Range>& ranges) {
    Comparison comparison(field);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      const AngleForm form = derived_exponent(right[k].kind);
      for (const bool nonnegative : {false, true}) {
        const auto [low, high] = twice_range(form, nonnegative);
        const auto& stated = nonnegative ? ranges[k].nonnegative : ranges[k].any;
        comparison.equal("infimum", ex(low) / 2, ex(stated.first) / 2)
            .equal("supremum", ex(high) / 2, ex(stated.second) / 2);
      }
    }
    return comparison.as(words);
  };
  const auto changed = [&](std::size_t k, const std::pair<int, int>& any, const std::pair<int, int>& nonnegative) {
    std::vector<Range> wrong = right;
    wrong[k] = {right[k].kind, any, nonnegative};
    return wrong;
  };
  return {"rh-power-ranges",
          decided("over all angles in ]-1/2, 1/2[ the powers are in ]-1, 0[ at edges, ]0, 1[ at free ends, ]-1, 1[ at "
                  "jumps; for s >= 0 in ]-1, -1/2] and [-1/2, 0[, ]0, 1/2] and [1/2, 1[, ]-1/2, 1/2[",
                  right),
          {decided("a left edge down to -3/2", changed(0, {-3, 0}, {-2, -1})),
           decided("left and right edge exchanged for s >= 0", changed(0, {-2, 0}, {-1, 0})),
           decided("a free left end above 1/2 for s >= 0", changed(2, {0, 2}, {1, 2})),
           decided("a jump in ]-1/2, 1/2[ for all angles", changed(4, {-1, 1}, {-1, 1})),
           decided("a jump below 0 alone for s >= 0", changed(4, {-2, 2}, {-1, 0}))}};
}

/// beta has the sign of s_l - s_r, and cos(pi beta) > 0 where s_l s_r > -1.
DecidedStatement jump_sign() {
  const PhaseField field({symbol("s_l"), symbol("s_r")});
  const auto& l = field.friction(0);
  const auto& r = field.friction(1);
  const auto decided = [&](const std::string& words, const AngleForm& power, const ex& sine, const ex& cosine) {
    const ex plus = field.phase(power, 1);
    const ex minus = field.phase(power, -1);
    return Comparison(field)
        .equal("sin(pi beta)", (plus - minus) / (2 * field.i()), sine)
        .equal("cos(pi beta)", (plus + minus) / 2, cosine)
        .as(words);
  };
  const AngleForm beta = derived_exponent(PointKind::jump);
  const ex root = 1 / (l.r * r.r);
  const ex sine = (l.s - r.s) * root;
  const ex cosine = (1 + l.s * r.s) * root;
  return {
      "rh-jump-sign",
      decided("sin(pi beta) = (s_l - s_r)/(r_l r_r) and cos(pi beta) = (1 + s_l s_r)/(r_l r_r)", beta, sine, cosine),
      {decided("beta of the other sign", -beta, sine, cosine), decided("s_r - s_l", beta, -sine, cosine),
       decided("1 - s_l s_r", beta, sine, (1 - l.s * r.s) * root),
       decided("alpha_l + alpha_r", AngleForm(0, {{0, 1}, {1, 1}}), sine, cosine)}};
}

/// cos(pi alpha) = sin(pi (1/2 + alpha)) = 1/sqrt(1+s^2), sin(pi alpha) = s/sqrt(1+s^2), by the square of e^{i pi alpha}.
DecidedStatement cosine() {
  const PhaseField field({symbol("s")});
  const auto& f = field.friction(0);
  const ex i = field.i();
  const auto decided = [&](const std::string& words, const ex& cosine, const ex& sine, const AngleForm& shifted) {
    const ex phase = cosine + i * sine;
    return Comparison(field)
        .equal("modulus", cosine * cosine + sine * sine, 1)
        .equal("tangent", sine, f.s * cosine)
        .equal("-(its square) is G", -phase * phase, jump_relation(f.s, i).ratio)
        .equal("sin(pi (1/2 + alpha))", (field.phase(shifted, 1) - field.phase(shifted, -1)) / (2 * i), cosine)
        .as(words);
  };
  const AngleForm shifted(1, {{0, 1}});
  return {"rh-cosine",
          decided("cos(pi alpha) = sin(pi (1/2 + alpha)) = 1/sqrt(1+s^2), sin(pi alpha) = s/sqrt(1+s^2)", f.cos, f.sin,
                  shifted),
          {decided("without the root", f.cos * f.cos, f.s * f.cos * f.cos, shifted),
           decided("sine and cosine exchanged", f.sin, f.cos, shifted), decided("-alpha", f.cos, -f.sin, shifted),
           decided("both of the other sign", -f.cos, -f.sin, shifted)}};
}

/// Sliding the other way mirrors the contact: front and rear friction change places, and edges and free ends too.
DecidedStatement mirrored_powers() {
  const std::vector<ex> alphas{symbol("alpha_l"), symbol("alpha_r")};
  const PhaseField field;
  const auto decided = [&](const std::string& words, const ex& sign, const std::vector<std::size_t>& order) {
    Comparison comparison(field);
    const auto power = [&](PointKind kind, const std::vector<std::size_t>& index) {
      return expression(derived_exponent(kind).renamed(index), alphas);
    };
    comparison.equal("jump", power(PointKind::jump, order), sign * power(PointKind::jump, {0, 1}))
        .equal("edges", power(PointKind::left_edge, {0, 0}) + power(PointKind::right_edge, {0, 0}), -1)
        .equal("free ends", power(PointKind::left_free, {0, 0}) + power(PointKind::right_free, {0, 0}), 1)
        .equal("left end", power(PointKind::left_free, {0, 0}), power(PointKind::left_edge, {0, 0}) + 1)
        .equal("right end", power(PointKind::right_free, {0, 0}), power(PointKind::right_edge, {0, 0}) + 1);
    return comparison.as(words);
  };
  return {
      "rh-power-relations",
      decided("frictions exchanged, beta has the other sign; a free end has the power of the edge and one more; the "
              "powers of two edges sum to -1, of two free ends to 1",
              -1, {1, 0}),
      {decided("the same sign", 1, {1, 0}), decided("without the exchange", -1, {0, 1}), decided("twice", -2, {1, 0}),
       decided("no power", 0, {1, 0})}};
}

/// Y/(z-c), c the first jump: Y+/Y- stays G on every panel, the powers sum to one less.
DecidedStatement neutral_mode() {
  constexpr EndKind edge = EndKind::edge;
  const std::vector<std::vector<Component>> layouts{
      {{edge, edge, 2}}, {{edge, edge, 4}}, {{edge, edge, 2}, {edge, edge, 2}}};
  const auto decided = [&](const std::string& words, const AngleForm& less, int order) {
    bool first = true;
    const PhaseField field(symbols("s", 4));
    const std::vector<ex> alpha = symbols("alpha", 4);
    Comparison comparison(field);
    for (const auto& layout : layouts) {
      const FundamentalSolution y(layout);
      std::vector<AngleForm> powers;
      for (const auto& point : y.points()) powers.push_back(point.power);
      powers[1] += less;
      const FundamentalSolution mode = y.with_powers(powers);
      mode.compare(comparison, field);
      comparison.equal(first ? "order" : "order again", expression(mode.power_sum(), alpha),
                       order - static_cast<int>(layout.size()));
      for (std::size_t j = 0; j < y.regions().size(); ++j) {
        if (!y.regions()[j].friction) continue;
        comparison.equal("t over that of Y", mode.sign_on(field, mode.regions()[j]),
                         (j < 2 ? -1 : 1) * y.sign_on(field, y.regions()[j]));
      }
      first = false;
    }
    return comparison.as(words);
  };
  const auto refuted = [&](const std::string& words, const AngleForm& less, int order) {
    // A sum of powers that is no integer has no sign: the first equation that fails is the one of the banks.
    const FundamentalSolution y({{edge, edge, 2}});
    const PhaseField field(symbols("s", 2));
    std::vector<AngleForm> powers;
    for (const auto& point : y.points()) powers.push_back(point.power);
    powers[1] += less;
    Comparison comparison(field);
    const FundamentalSolution mode = y.with_powers(powers);
    mode.compare(comparison, field);
    comparison.equal("order", expression(mode.power_sum(), symbols("alpha", 2)), order - 1);
    return comparison.as(words);
  };
  return {
      "rh-neutral-mode",
      decided("Y/(z-c), c a jump: Y+ = G Y- on every panel, another sign of t on the left of c, order -n-1 at infinity "
              "with edges at all ends",
              AngleForm(-2), -1),
      {decided("order -n", AngleForm(-2), 0), refuted("Y/(z-c)^(1/2)", AngleForm(-1), -1),
       refuted("beta of the other sign", AngleForm(0, {{0, -2}, {1, 2}}), -1),
       refuted("Y/(z-c)^2", AngleForm(-4), -1)}};
}

}  // namespace

void add_powers(std::vector<DecidedStatement>& all) {
  all.push_back(power_ranges());
  all.push_back(cosine());
  all.push_back(jump_sign());
  all.push_back(mirrored_powers());
  all.push_back(neutral_mode());
}

}  // namespace steadyslide::symbolic
