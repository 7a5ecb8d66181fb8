#pragma once
// The functions that every text of statements may call, and what their arguments are.

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "symbolic/riemann_hilbert/riemann_hilbert.hpp"

namespace steadyslide::symbolic {

struct ArgumentCount {
  ArgumentCount(std::size_t n) : ArgumentCount(n, n) {}
  ArgumentCount(std::size_t least, std::size_t most, std::size_t step = 1) : least(least), most(most), step(step) {}
  bool admit(std::size_t n) const { return least <= n && n <= most && (n - least) % step == 0; }

  std::size_t least;
  std::size_t most;
  std::size_t step;
};

struct WrittenFunction {
  ArgumentCount arguments;
  std::function<GiNaC::ex(const std::vector<GiNaC::ex>&)> value;
};
using WrittenFunctions = std::map<std::string, WrittenFunction>;

/// The functions of every text that need no field.
WrittenFunctions plain_functions();

// Conversions of an expression. Each throws UnreadableStatement if the expression has another type.

int integer(const GiNaC::ex& e);
/// An integer that is not negative.
std::size_t count(const GiNaC::ex& e);
/// The entries of a list.
std::vector<GiNaC::ex> entries(const GiNaC::ex& e);
GiNaC::ex list_of(const std::vector<GiNaC::ex>& entries);
/// Components from left to right, three entries each: is the left end free, is the right end free, number of jumps.
FundamentalSolution contact(const GiNaC::ex& ends_and_jumps);

}  // namespace steadyslide::symbolic
