#include "model/invalid_data.hpp"

#include <utility>

namespace steadyslide {

InvalidData::InvalidData(std::string field, std::string problem, std::string rule, std::string value)
    : std::invalid_argument(problem + "; " + rule + "; " + value), field_(std::move(field)) {}

}  // namespace steadyslide
