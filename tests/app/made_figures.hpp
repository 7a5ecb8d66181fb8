#pragma once

#include "app/figures/figures.hpp"
#include "support/test.hpp"

namespace steadyslide::testing {

/// Returns the figure of this name. It is made once for all tests.
inline const app::Figure& made(const std::string& name) {
  static std::map<std::string, app::Figure> figures;
  const auto maker = std::ranges::find(app::figures(), name, &app::FigureMaker::name);
  REQUIRE(maker != app::figures().end());
  if (!figures.contains(name)) figures.emplace(name, maker->make());
  return figures.at(name);
}

}  // namespace steadyslide::testing
