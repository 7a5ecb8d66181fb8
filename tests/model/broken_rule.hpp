#pragma once
// What a constructor of the model says when it refuses its data.

#include "model/invalid_data.hpp"
#include "support/test.hpp"

/// "field: message" of the InvalidData that `construct` throws, "accepted" if it throws none.
template <class F>
std::string refusal(F&& construct) {
  try {
    construct();
  } catch (const steadyslide::InvalidData& error) {
    return error.field() + ": " + error.what();
  }
  return "accepted";
}
