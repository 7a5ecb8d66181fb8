#pragma once
// The functions that every text of statements may call, and their arguments.

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

/// Returns the functions of every text that need no field.
WrittenFunctions plain_functions();

// Conversions of an expression. Each throws UnreadableStatement if the expression has another type.

int integer(const GiNaC::ex& e);
/// Returns a non-negative integer.
std::size_t count(const GiNaC::ex& e);
/// Returns the entries of a list.
std::vector<GiNaC::ex> entries(const GiNaC::ex& e);
GiNaC::ex list_of(const std::vector<GiNaC::ex>& entries);
/// Takes the components from left to right, three entries each: 1 if the left end is free, 1 if the right end is free,
/// number of jumps.
FundamentalSolution contact(const GiNaC::ex& ends_and_jumps);

}  // namespace steadyslide::symbolic
