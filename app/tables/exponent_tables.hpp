#pragma once
// Tables of the exponents as text.

#include <string>
#include <vector>

namespace steadyslide::app {

struct TextTable {
  std::string title;
  std::string note;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> references;
};

std::vector<TextTable> exponent_tables();

}  // namespace steadyslide::app
