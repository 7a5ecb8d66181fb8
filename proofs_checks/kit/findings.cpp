#include "proofs_checks/kit/findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "proofs_checks/kit/verdict.hpp"

namespace steadyslide::proofs_checks {

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value == 0 ? "%.0f" : "%.1e", value);
  return text;
}

const Quantity& Findings::quantity(std::string_view name) const {
  const auto found = std::ranges::find(quantities_, name, &Quantity::name);
  if (found == quantities_.end()) throw std::logic_error("not a quantity of the claim: " + std::string(name));
  return *found;
}

void Findings::begin_case(std::string where, bool effective) {
  ++case_number_;
  where_ = std::move(where);
  effective_ = effective;
}

Findings::Tally& Findings::tally(const Quantity& quantity, bool effective) {
  auto found = std::ranges::find(tallies_, quantity.what, [](const Tally& t) { return t.quantity.what; });
  if (found == tallies_.end()) found = tallies_.insert(found, {0, 0, 0, 0, quantity});
  if (found->last_case != case_number_) {
    found->last_case = case_number_;
    ++found->cases;
    if (effective) ++found->effective;
  }
  return *found;
}

void Findings::compare(const Quantity& quantity, double difference) {
  // This comparison also fails for NaN; the opposite comparison would accept it.
  if (!(difference <= quantity.tolerance)) {
    throw Refutation{{where_, quantity.what + ": relative difference " + short_text(difference) +
                                  " exceeds the tolerance " + short_text(quantity.tolerance)}};
  }
  Tally& t = tally(quantity, effective_);
  t.worst = std::max(t.worst, difference);
}

void Findings::skip(const Quantity& quantity) { tally(quantity, false); }

void Findings::decide(const std::string& statement, bool holds) {
  require(holds, "exactly false: " + statement);
  for (auto& [known, times] : decisions_) {
    if (known == statement) {
      ++times;
      return;
    }
  }
  decisions_.emplace_back(statement, 1);
}

void Findings::measure(ConvergenceRate rate) {
  if (refutes(rate)) throw Refutation{{where_, describe(rate)}};
  rates_.push_back(std::move(rate));
}

void Findings::require(bool holds, const std::string& what_fails) {
  if (!holds) throw Refutation{{where_, what_fails}};
}

std::vector<Evidence> Findings::evidence(const std::string& cases) const {
  std::vector<Evidence> all;
  if (!decisions_.empty()) {
    ExactIdentity identity{"decided in exact arithmetic, case by case", {}};
    for (const auto& [statement, times] : decisions_) {
      identity.identities.push_back(statement + " (" + std::to_string(times) + " times)");
    }
    all.emplace_back(std::move(identity));
  }
  for (const Tally& t : tallies_) {
    const auto required = static_cast<std::size_t>(std::ceil(t.quantity.required * static_cast<double>(t.cases)));
    all.emplace_back(Agreement{t.quantity.what, t.quantity.routes, short_text(t.worst),
                               short_text(t.quantity.tolerance), t.cases, t.effective,
                               std::max<std::size_t>(required, 1), cases});
  }
  for (const ConvergenceRate& rate : rates_) all.emplace_back(rate);
  return all;
}

}  // namespace steadyslide::proofs_checks
