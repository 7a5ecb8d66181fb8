#pragma once
// The parameters at which a claim is examined: a grid and random values. A quick run examines fewer of them. So does a
// run with more digits, because each case then costs more.

#include <algorithm>
#include <any>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/problem_text.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {

template <class Case>
struct CaseList {
  std::vector<Case> cases;
  std::string detail;  ///< the origin of the cases, with the seed
};

/// A case without its type, for the runner.
using CaseData = std::shared_ptr<const void>;
struct ExaminedCase {
  CaseData data;
  std::string where;
};
struct Examples {
  std::vector<ExaminedCase> cases;
  std::string detail;
};
using CaseSource = std::function<Examples(const Context&)>;

/// Returns a CaseSource that calls list(context), which returns a CaseList<Case>. The name of a case c is text_of(c) if
/// this function exists, otherwise c.name.
template <class Case, class List>
CaseSource case_source(List list) {
  return [list = std::move(list)](const Context& context) {
    CaseList<Case> all = list(context);
    Examples examples{{}, std::move(all.detail)};
    for (Case& c : all.cases) {
      std::string where;
      if constexpr (requires { text_of(c); }) {
        where = text_of(c);
      } else {
        where = c.name;
      }
      examples.cases.push_back({std::make_shared<const Case>(std::move(c)), std::move(where)});
    }
    return examples;
  };
}

/// The number type in which a claim is examined, given the digits of the run.
enum class Precision {
  as_asked,
  quick_in_double,  ///< double in a quick run: for slow principal values and solved problems
  at_least_fifty,
  in_double
};
inline numeric::Digits digits_at(Precision precision, const Context& context) {
  switch (precision) {
    case Precision::quick_in_double: return context.quick ? numeric::Digits::sixteen : context.digits;
    case Precision::at_least_fifty: return std::max(context.digits, numeric::Digits::fifty);
    case Precision::in_double: return numeric::Digits::sixteen;
    default: return context.digits;
  }
}

/// A number of cases for each number of digits.
struct CountByDigits {
  std::size_t sixteen;
  std::size_t fifty;
  std::size_t hundred;
};

/// Returns the number of cases for the context's digits. A quick run with more than double's digits gets one case.
inline std::size_t count_for(const Context& context, const CountByDigits& count) {
  if (context.quick && context.digits != numeric::Digits::sixteen) return 1;
  switch (context.digits) {
    case numeric::Digits::sixteen: return count.sixteen;
    case numeric::Digits::fifty: return count.fifty;
    default: return count.hundred;
  }
}

/// Returns a function of the context. It returns all cases, or the first `quick` ones in a quick run.
template <class Case>
auto fixed_cases(std::vector<Case> all, std::size_t quick, std::string detail) {
  return [=](const Context& context) {
    const std::size_t count = context.quick ? std::min(quick, all.size()) : all.size();
    return CaseList<Case>{{all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}, detail};
  };
}

/// Returns fixed_cases() for this context; the detail begins with their number: "7 solved problems".
template <class Case>
CaseList<Case> first_when_quick(const Context& context, std::vector<Case> all, std::size_t quick,
                                const std::string& what) {
  CaseList<Case> list = fixed_cases(std::move(all), quick, what)(context);
  list.detail = std::to_string(list.cases.size()) + " " + what;
  return list;
}

/// Results that are computed once for a case and then serve a claim and all its controls. The address of a case
/// identifies it: cases do not move while their claim exists.
class KeptForCases {
 public:
  template <class Case, class Make>
  const std::invoke_result_t<const Make&>& at(const Case& c, const Make& make) {
    std::any& slot = kept_[&c];
    if (!slot.has_value()) slot = make();
    return *std::any_cast<std::invoke_result_t<const Make&>>(&slot);
  }

 private:
  std::map<const void*, std::any> kept_;
};

/// Returns the cases of `grid`, then `count` random cases make(random). A quick run takes one random case, and every
/// 4th case of the grid in double, every 16th with more digits.
template <class Case, class Make>
CaseList<Case> grid_and_random(const Context& context, std::string_view stream, const std::vector<Case>& grid,
                               const CountByDigits& count, const Make& make) {
  CaseList<Case> list;
  const std::size_t stride = !context.quick ? 1 : context.digits == numeric::Digits::sixteen ? 4 : 16;
  for (std::size_t k = 0; k < grid.size(); k += stride) list.cases.push_back(grid[k]);
  const std::size_t fixed = list.cases.size();
  std::size_t random_count = count_for(context, count);
  if (context.quick) random_count = std::min<std::size_t>(random_count, 1);
  Random random(context.seed, stream);
  for (std::size_t k = 0; k < random_count; ++k) list.cases.push_back(make(random));
  list.detail = std::to_string(fixed) + " of a grid, " + std::to_string(random_count) + " random with seed " +
                std::to_string(context.seed);
  return list;
}

/// Returns the cases make(random, k) for k = 0, ..., count - 1, or count_when_quick of them in a quick run. `what`
/// describes them: "random polynomials".
template <class Make>
auto random_cases(const Context& context, std::string_view stream, std::size_t count, std::size_t count_when_quick,
                  const std::string& what, const Make& make) {
  CaseList<std::invoke_result_t<const Make&, Random&, std::size_t>> list{
      {}, what + ", seed " + std::to_string(context.seed)};
  Random random(context.seed, stream);
  for (std::size_t k = 0; k < (context.quick ? count_when_quick : count); ++k) list.cases.push_back(make(random, k));
  return list;
}

}  // namespace steadyslide::proofs_checks
