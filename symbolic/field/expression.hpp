#pragma once
// The model's exact numbers as GiNaC expressions. Compiling ginac.h is slow: include this header only in sources of
// this layer and in tests. GiNaC is not thread-safe, not even for unrelated expressions.

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::symbolic {

GiNaC::numeric to_expression(const Rational& value);
/// Throws std::domain_error unless the number is rational.
Rational to_rational(const GiNaC::numeric& value);

/// Returns `count` symbols name_first, name_(first+1), ...
std::vector<GiNaC::ex> symbols(const std::string& name, std::size_t count, std::size_t first = 0);

}  // namespace steadyslide::symbolic
