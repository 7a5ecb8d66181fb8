#include "model/invalid_data.hpp"

#include <utility>

namespace steadyslide {

InvalidData::InvalidData(std::string field, const std::string& problem, const std::string& rule,
                         const std::string& value)
    : std::invalid_argument(problem + "; " + rule + "; " + value), field_(std::move(field)) {}

}  // namespace steadyslide
