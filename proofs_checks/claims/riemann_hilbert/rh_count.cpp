#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rh_count {
namespace {

/// The kinds of the ends of each component: true for an edge, false for a free end, left end first.
struct Edges {
  std::vector<std::pair<bool, bool>> components;
  std::size_t number;
};

std::string text_of(const Edges& c) {
  return std::to_string(c.components.size()) + " components, ends number " + std::to_string(c.number);
}

CaseList<Edges> every_choice(const Context& context) {
  CaseList<Edges> list;
  for (std::size_t n = 1; n <= (context.quick ? 2 : 4); ++n) {
    for (std::size_t kinds = 0; kinds < (std::size_t{1} << (2 * n)); ++kinds) {
      Edges c{{}, kinds};
      for (std::size_t i = 0; i < n; ++i)
        c.components.emplace_back((kinds >> (2 * i)) & 1U, (kinds >> (2 * i + 1)) & 1U);
      list.cases.push_back(std::move(c));
    }
  }
  list.detail = "every choice of edges and free ends, " + std::string(context.quick ? "one or two" : "one to four") +
                " components";
  return list;
}

/// Returns the counts from the exponents, as exact angles, and from the solver's form.
Values counted(const Edges& c) {
  const TrialForm<double> trial(with_ends(c.components));
  const TractionRepresentation<double>& form = trial.form();
  Exponent sum;
  int free = 0;
  for (std::size_t j = 0; j < form.set().points().size(); ++j) {
    const auto& point = form.set().point(j);
    const bool jump = !point.is_end() && form.fundamental_solution().powers()[j].value != 0;
    if (point.is_end() || jump) sum += form.exponent(j);
    if (point.is_free()) ++free;
  }
  const int coefficients = static_cast<int>(form.q().size());
  return {{"sum", sum},
          {"S", Rational(form.degree_at_infinity())},
          {"coefficients", Rational(coefficients)},
          {"unknowns", Rational(free + coefficients)}};
}

/// The numbers of unknowns and conditions for n components.
struct Count {
  int degree_of_q = -1;  ///< plus -S
  int moments = 0;       ///< plus S
  int gaps = -1;         ///< plus n
};

Values predicted(const Edges& c, const Count& count) {
  const int n = static_cast<int>(c.components.size());
  int free = 0;
  for (const auto& [left, right] : c.components) free += (left ? 0 : 1) + (right ? 0 : 1);
  const int S = free - n;
  return {{"sum", Exponent(S)},
          {"S", Rational(S)},
          {"coefficients", Rational(std::max(0, count.degree_of_q - S + 1))},
          {"unknowns", Rational(1 + std::max(0, S + count.moments) + n + count.gaps)}};
}

auto with(const Count& count) {
  return [count](Values& p, const Edges& c) { p = predicted(c, count); };
}

}  // namespace

Claim claim() {
  return compared<Edges>("rh-count")
      .cases(every_choice)
      .precision(Precision::in_double)
      .measured(counted)
      .predicted([](const Edges& c) { return predicted(c, {}); })
      .wrong("`q` of degree `-S`", with({.degree_of_q = 0}))
      .wrong("one moment too many", with({.moments = 1}))
      .wrong("a condition for every component, not every gap", with({.gaps = 0}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rh_count
