#pragma once
// The message with which a constructor of the model refuses its data.

#include "model/invalid_data.hpp"
#include "support/test.hpp"

/// Returns "field: message" of the InvalidData that `construct` throws, or "accepted" if it throws nothing.
template <class F>
std::string refusal(F&& construct) {
  try {
    construct();
  } catch (const steadyslide::InvalidData& error) {
    return error.field() + ": " + error.what();
  }
  return "accepted";
}
