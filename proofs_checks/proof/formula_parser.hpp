#pragma once
// Reads the text of a formula (formula.hpp).

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "proofs_checks/proof/formula.hpp"

namespace steadyslide::proofs_checks {

/// The functions of one argument that each formula may use.
const std::map<std::string, std::function<Real50(const Real50&)>>& formula_functions();

/// Returns the formula as a tree. Adds to `names` those that an instance has to give a value. Throws std::logic_error
/// if the text is not a formula.
Formula::Node parse_formula(std::string_view text, std::set<std::string>& names);

}  // namespace steadyslide::proofs_checks
