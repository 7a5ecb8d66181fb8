#pragma once
// Tables of texts, as rows of JSON: [["text", "text"], ...].

#include <nlohmann/json.hpp>

#include "support/test.hpp"

namespace steadyslide::testing {

template <class Row = std::pair<std::string, std::string>>
std::vector<Row> rows_of(const std::string& file) {
  return nlohmann::json::parse(file_text(file));
}

}  // namespace steadyslide::testing
