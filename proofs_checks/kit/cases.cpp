#include "proofs_checks/kit/cases.hpp"

namespace steadyslide::proofs_checks {

numeric::Digits digits_at(Precision precision, const Context& context) {
  switch (precision) {
    case Precision::quick_in_double: return context.quick ? numeric::Digits::sixteen : context.digits;
    case Precision::at_least_fifty: return std::max(context.digits, numeric::Digits::fifty);
    case Precision::in_double: return numeric::Digits::sixteen;
    default: return context.digits;
  }
}

std::size_t count_for(const Context& context, const CountByDigits& count) {
  if (context.quick && context.digits != numeric::Digits::sixteen) return 1;
  switch (context.digits) {
    case numeric::Digits::sixteen: return count.sixteen;
    case numeric::Digits::fifty: return count.fifty;
    default: return count.hundred;
  }
}

}  // namespace steadyslide::proofs_checks
