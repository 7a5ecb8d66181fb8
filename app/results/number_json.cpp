#include "app/results/number_json.hpp"

namespace steadyslide::app {

using Json = nlohmann::ordered_json;

Json text_json(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json number_json(const library::NumberText& number) {
  return {{number.proved ? "mid" : "value", text_json(number.value)},
          {number.proved ? "rad" : "error", text_json(number.error)}};
}

}  // namespace steadyslide::app
