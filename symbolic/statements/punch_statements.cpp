// The flat punch in full contact. The formulas are put into A t = 0 as they are printed: exponents and amplitudes are
// data here, and what they must satisfy is Y+ = G Y- and the load. [Bal16, (4), (5)-(7), (8)]

#include <algorithm>

#include "symbolic/riemann_hilbert/contact_symbols.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

/// t = amplitude_k prod |x - e_j|^{power_j} on panel k.
struct Printed {
  std::vector<AngleForm> powers;
  std::vector<ex> amplitudes;
};

/// A t = 0 and int t = total; and the derived solution is the same.
ExactIdentity decided(const std::string& words, const ContactSymbols& data, const FundamentalSolution& y,
                      const Printed& printed, const ex& total) {
  const PhaseField& field = data.field;
  const FundamentalSolution candidate = y.with_powers(printed.powers);
  Comparison comparison(field);
  candidate.compare(comparison, field);
  comparison.equal("order at infinity", expression(candidate.power_sum(), data.alpha), -1);
  // F = C Y with C/z at infinity: C = -(int t)/pi, and t = (F+ - F-)/(2i).
  const ex constant = -total / data.pi;
  const ex factor = PolynomialSlope(-1, {}, {}, -total / data.pi).factor(data.x);
  for (std::size_t j = 0; j < y.regions().size(); ++j) {
    const auto& region = candidate.regions()[j];
    if (!region.friction) continue;
    const std::size_t k = *region.friction;
    const std::string panel = "panel " + std::to_string(k) + ": ";
    const ex sine = (phase(field, region.sigma, 1) - phase(field, region.sigma, -1)) / (2 * field.i());
    comparison.equal(panel + "t from F", printed.amplitudes[k], constant * sine);
    comparison.equal(panel + "t derived", printed.amplitudes[k],
                     y.sign_on(field, y.regions()[j]) * field.friction(k).cos * factor);
  }
  for (std::size_t j = 0; j < y.points().size(); ++j) {
    comparison.equal("power " + std::to_string(j), expression(printed.powers[j], data.alpha),
                     expression(y.points()[j].power, data.alpha));
  }
  return comparison.as(words);
}

/// -P cos(pi alpha)/pi times the powers -(1/2+alpha_0), alpha_(k-1) - alpha_k, ..., -(1/2-alpha_m).
Printed punch(const ContactSymbols& data, std::size_t jumps, const ex& total) {
  Printed printed;
  printed.powers.emplace_back(-1, std::map<std::size_t, int>{{0, -1}});
  for (std::size_t k = 1; k <= jumps; ++k) printed.powers.push_back(AngleForm(0, {{k - 1, 1}, {k, -1}}));
  printed.powers.emplace_back(-1, std::map<std::size_t, int>{{jumps, 1}});
  for (std::size_t k = 0; k <= jumps; ++k) {
    printed.amplitudes.push_back(total / (data.pi * data.field.friction(k).r));
  }
  return printed;
}

AngleForm mirrored(const AngleForm& form) {
  AngleForm result(form.halves());
  for (const auto& [k, factor] : form.times()) result += AngleForm(0, {{k, -factor}});
  return result;
}

DecidedStatement flat_punch(const std::string& id, const std::string& words, std::size_t jumps, bool unit) {
  const FundamentalSolution y = one_contact(EndKind::edge, EndKind::edge, jumps);
  const ContactSymbols data(y);
  const ex total = unit ? ex(1) : ex(-data.load);
  const Printed right = punch(data, jumps, total);
  DecidedStatement result{id, decided(words, data, y, right, total), {}};
  const auto control = [&](const std::string& statement, const auto& spoil) {
    Printed wrong = right;
    spoil(wrong);
    result.controls.push_back(decided(statement, data, y, wrong, total));
  };
  const auto scale = [&](Printed& wrong, const auto& by) {
    for (std::size_t k = 0; k <= jumps; ++k) wrong.amplitudes[k] *= by(k);
  };
  control("edges exchanged", [](Printed& wrong) { std::swap(wrong.powers.front(), wrong.powers.back()); });
  control("every alpha of the other sign", [](Printed& wrong) {
    std::transform(wrong.powers.begin(), wrong.powers.end(), wrong.powers.begin(), mirrored);
  });
  control("1/2 for 1/2 + alpha at the left edge", [](Printed& wrong) { wrong.powers.front() = AngleForm(-1); });
  control("without 1/sqrt(1+s^2)",
          [&](Printed& wrong) { scale(wrong, [&](std::size_t k) { return data.field.friction(k).r; }); });
  control("without 1/pi", [&](Printed& wrong) { scale(wrong, [&](std::size_t) { return ex(data.pi); }); });
  control("t of the other sign", [&](Printed& wrong) { scale(wrong, [](std::size_t) { return ex(-1); }); });
  if (jumps > 0) {
    control("beta of the other sign", [](Printed& wrong) { wrong.powers[1] = -wrong.powers[1]; });
    control("cos(pi alpha) of one side on both", [](Printed& wrong) { wrong.amplitudes[0] = wrong.amplitudes[1]; });
  }
  return result;
}

}  // namespace

void add_flat_punch(std::vector<DecidedStatement>& all) {
  all.push_back(
      flat_punch("rh-flat-punch-0", "[Bal16, (4)] solves A t = 0, int t = -P, and is what is derived", 0, false));
  all.push_back(
      flat_punch("rh-flat-punch-1", "[Bal16, (5)-(7)] solves A t = 0, int t = -P, and is what is derived", 1, false));
  all.push_back(flat_punch("rh-kernel", "t0 of [Bal16, (8)] has A t0 = 0 and int t0 = 1", 0, true));
  for (std::size_t jumps = 2; jumps <= 4; ++jumps) {
    const std::string count = std::to_string(jumps);
    all.push_back(flat_punch("rh-flat-punch-" + count,
                             "the flat punch with " + count + " jumps solves A t = 0, int t = -P", jumps, false));
  }
}

}  // namespace steadyslide::symbolic
