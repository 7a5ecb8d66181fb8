#include "app/tables/exponent_tables.hpp"

namespace steadyslide::app {

std::vector<TextTable> exponent_tables() { return {}; }

}  // namespace steadyslide::app
