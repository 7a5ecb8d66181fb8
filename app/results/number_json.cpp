#include "app/results/number_json.hpp"

#include <charconv>
#include <cmath>

#include "model/rational.hpp"

namespace steadyslide::app {

using Json = nlohmann::ordered_json;

Json text_json(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json decimal_json(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || read != end || error != std::errc() || !std::isfinite(value)) return text_json(text);
  if (value == 0 && text != "0") return Json(text);
  if (parse_rational(library::full_number(value, 16)) != parse_rational(text)) return Json(text);
  const bool is_whole = std::abs(value) < 1e15 && value == std::trunc(value);
  return is_whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json number_json(const library::NumberText& number) {
  return {{number.proved ? "mid" : "value", decimal_json(number.value)},
          {number.proved ? "rad" : "error", decimal_json(number.error)}};
}

}  // namespace steadyslide::app
