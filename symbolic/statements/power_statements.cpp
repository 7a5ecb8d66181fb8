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
  all.push_back(neutral_mode());
}

}  // namespace steadyslide::symbolic
