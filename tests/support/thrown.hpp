#pragma once

#include <exception>
#include <string>

namespace steadyslide::testing {

/// What `act` throws says, or "no error".
template <class F>
std::string thrown_by(const F& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace steadyslide::testing
