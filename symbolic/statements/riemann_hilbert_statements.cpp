#include "symbolic/local/local_action.hpp"
#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"
#include "symbolic/statements/statements.hpp"
#include "symbolic/statements/written_statements.hpp"

namespace steadyslide::symbolic {

namespace embedded {
extern const std::string_view riemann_hilbert_txt;
}

namespace {

using GiNaC::ex;
using GiNaC::symbol;

DecidedStatement exponent_at(const std::string& id, PointKind kind, const std::string& words, const AngleForm& stated,
                             const std::vector<std::pair<std::string, AngleForm>>& wrong) {
  const PhaseField field({symbol("s_l"), symbol("s_r")});
  const std::vector<ex> alphas{symbol("alpha_l"), symbol("alpha_r")};
  const auto decided = [&](const std::string& statement, const AngleForm& form) {
    Comparison comparison(field);
    compare_crossing(comparison, field, kind, form);
    comparison.equal("is of its kind", is_admissible(kind, form) ? 1 : 0, 1);
    comparison.equal("derived", expression(derived_exponent(kind), alphas), expression(form, alphas));
    return comparison.as(statement);
  };
  const std::string point = id.substr(std::string("rh-exponent-").size());
  DecidedStatement result{id, decided(words, stated), {}, "phase(" + point + ")"};
  for (const auto& [statement, form] : wrong) result.controls.push_back(decided(statement, form));
  return result;
}

void add_exponents(std::vector<DecidedStatement>& all) {
  const auto form = [](int halves, int left, int right) { return AngleForm(halves, {{0, left}, {1, right}}); };
  all.push_back(exponent_at("rh-exponent-left-edge", PointKind::left_edge, "a left edge has `p = -(1/2 + alpha)`",
                            form(-1, 0, -1),
                            {{"`-(1/2 - alpha)`", form(-1, 0, 1)},
                             {"`1/2 - alpha`", form(1, 0, -1)},
                             {"-1/2", form(-1, 0, 0)},
                             {"with the friction off the contact", form(-1, -1, 0)}}));
  all.push_back(exponent_at("rh-exponent-right-edge", PointKind::right_edge, "a right edge has `p = -(1/2 - alpha)`",
                            form(-1, 1, 0),
                            {{"`-(1/2 + alpha)`", form(-1, -1, 0)},
                             {"`1/2 + alpha`", form(1, 1, 0)},
                             {"-1/2", form(-1, 0, 0)},
                             {"with the friction off the contact", form(-1, 0, 1)}}));
  all.push_back(exponent_at("rh-exponent-left-free", PointKind::left_free, "a free left end has `p = 1/2 - alpha`",
                            form(1, 0, -1),
                            {{"`1/2 + alpha`", form(1, 0, 1)},
                             {"`-(1/2 + alpha)`", form(-1, 0, -1)},
                             {"`3/2 - alpha`", form(3, 0, -1)},
                             {"1/2", form(1, 0, 0)}}));
  all.push_back(exponent_at("rh-exponent-right-free", PointKind::right_free, "a free right end has `p = 1/2 + alpha`",
                            form(1, 1, 0),
                            {{"`1/2 - alpha`", form(1, -1, 0)},
                             {"`-(1/2 - alpha)`", form(-1, 1, 0)},
                             {"`3/2 + alpha`", form(3, 1, 0)},
                             {"1/2", form(1, 0, 0)}}));
  all.push_back(exponent_at("rh-exponent-jump", PointKind::jump, "a friction jump has `p = alpha(c-) - alpha(c+)`",
                            form(0, 1, -1),
                            {{"`alpha(c+) - alpha(c-)`", form(0, -1, 1)},
                             {"`alpha(c-) + alpha(c+)`", form(0, 1, 1)},
                             {"`1/2 + alpha(c-) - alpha(c+)`", form(1, 1, -1)},
                             {"`1 + alpha(c-) - alpha(c+)`", form(2, 1, -1)},
                             {"0", form(0, 0, 0)}}));
}

// The operator on one power, by its limits on the two banks: with (-z)^lambda cut along x > 0,
//
//   W = -(-z)^lambda/sin(pi lambda),   W+- = -x^lambda e^{-+ i pi lambda}/sin(pi lambda) for x > 0,
//
// has (W+ - W-)/(2i) = x^lambda, so (1/pi) int_0^1 x'^lambda/(x'-z) dx' - W is analytic at 0. Derivatives with respect
// to lambda give the logarithms, and polynomials in log(-z) give the integer powers. For a density on x < 0, W is
// -W(-z).

constexpr int most_logs = 2;

struct ActionNames {
  PhaseField field;
  symbol power{"X"};      // |x|^lambda
  symbol logarithm{"L"};  // log|x|
  symbol phase{"E"};      // e^{i pi lambda}
  symbol pi{"pi"};
  ex i = field.i();
  ex sine = (phase - 1 / phase) / (2 * i);
  LocalConstants constants{i * (phase * phase + 1) / (phase * phase - 1), 1 / sine, pi};

  /// Returns df/dlambda.
  ex derived(const ex& f) const { return f.diff(phase) * i * pi * phase + f.diff(power) * power * logarithm; }
  /// Returns W or its derivatives. `bank` is +1 above x > 0, -1 below x > 0, and 0 on x < 0.
  ex fractional(int logs, int bank) const {
    ex w = -power * GiNaC::pow(phase, -bank) / sine;
    for (int k = 0; k < logs; ++k) w = derived(w);
    return w;
  }
  /// Returns the same for lambda = 0: a polynomial P with P(l - i pi) - P(l + i pi) = 2i l^logs. Its constant is that
  /// of finite parts.
  ex integer(int logs, int bank) const {
    const ex l = logarithm - bank * i * pi;
    if (logs == 0) return -l / pi;
    if (logs == 1) return -l * l / (2 * pi) - pi / 6;
    return -l * l * l / (3 * pi) - pi * l / 3;
  }
};

enum class ActionVariant { right, cotangent, cosecant, exchanged, banks, pi };

DecidedStatement local_action() {
  const ActionNames names;
  const auto value = [&](const LocalDensity& density, Side side) {
    ex sum = 0;
    for (const auto& [monomial, coefficient] : density) {
      if (monomial.side != side) continue;
      sum += coefficient * (monomial.fractional ? ex(names.power) : ex(1)) * GiNaC::pow(names.logarithm, monomial.logs);
    }
    return sum;
  };
  const auto decided = [&](const std::string& words, ActionVariant variant) {
    Comparison comparison(names.field);
    LocalConstants constants = names.constants;
    if (variant == ActionVariant::cotangent) constants.cot = -constants.cot;
    if (variant == ActionVariant::cosecant) constants.cosecant = -constants.cosecant;
    if (variant == ActionVariant::pi) constants.pi = 1;
    const int upper = variant == ActionVariant::banks ? -1 : 1;
    for (const bool fractional : {true, false}) {
      for (const Side side : {Side::right, Side::left}) {
        for (int logs = 0; logs <= most_logs; ++logs) {
          const Side image = variant == ActionVariant::exchanged ? opposite(side) : side;
          const int mirror = side == Side::right ? 1 : -1;
          const auto w = [&](int bank) {
            return fractional ? names.fractional(logs, bank) : names.integer(logs, bank);
          };
          const LocalDensity density{{{side, fractional, 0, logs}, 1}};
          const LocalDensity h = act(density, constants);
          const std::string name = std::string(side == Side::right ? "x > 0, " : "x < 0, ") +
                                   (fractional ? "power, " : "integer, ") + std::to_string(logs) + " logarithms: ";
          // The banks of -z are exchanged, so -W(-z) has the limits -W-+ at z.
          const ex above = mirror * w(mirror * upper);
          const ex below = mirror * w(-mirror * upper);
          comparison.equal(name + "t", (above - below) / (2 * names.i), value(density, side))
              .equal(name + "H t there", (above + below) / 2, value(h, image))
              .equal(name + "H t beyond", mirror * w(0), value(h, opposite(image)));
        }
      }
    }
    return comparison.as(words);
  };
  return {
      "rh-local-action",
      decided(
          "`|x|^lambda log|x|^m`, `m <= 2`, on one side of 0: its image by `H` is the mean of the limits of `W`, up to one "
          "power series",
          ActionVariant::right),
      {decided("`cot(pi lambda)` of the other sign", ActionVariant::cotangent),
       decided("`1/sin(pi lambda)` of the other sign", ActionVariant::cosecant),
       decided("the sides exchanged", ActionVariant::exchanged), decided("the banks exchanged", ActionVariant::banks),
       decided("without `pi`", ActionVariant::pi)},
      "same-limits(powers, power-origin)"};
}

}  // namespace

std::vector<DecidedStatement> riemann_hilbert_statements() {
  std::vector<DecidedStatement> decided_here{local_action()};
  add_exponents(decided_here);
  return written_statements(embedded::riemann_hilbert_txt, decided_here);
}

}  // namespace steadyslide::symbolic
