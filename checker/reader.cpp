#include "checker/reader.hpp"

#undef NDEBUG  // keep the library's assertions, which protect its assumptions for the optimizer
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <set>

namespace steadyslide::checker {
namespace {

using nlohmann::json;

json json_of(const toml::node& node) {
  json result;
  if (const auto* table = node.as_table()) {
    result = json::object();
    for (const auto& [key, value] : *table) result[std::string(key.str())] = json_of(value);
  } else if (const auto* array = node.as_array()) {
    result = json::array();
    for (const toml::node& item : *array) result.push_back(json_of(item));
  } else if (const auto* text = node.as_string()) {
    result = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result = std::to_string(integer->get());
  } else if (const auto* decimal = node.as_floating_point()) {
    std::array<char, 40> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), decimal->get()).ptr;
    result = std::string(digits.data(), end);
  }
  return result;
}

}  // namespace

Reader Reader::of_json(const std::string& text, const std::string& name) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      throw Malformed(name, "key given twice", "a key stands once in its object", value.dump());
    }
    if (depth > 20) throw Malformed(name, "nested too deep", "a certificate nests at most 20 deep", "more");
    return true;
  };
  try {
    auto document = std::make_shared<json>(json::parse(text, watch));
    return {document, *document, "certificate"};
  } catch (const json::exception& error) {
    throw Malformed(name, "not JSON", "a certificate is a JSON document", error.what());
  }
}

Reader Reader::of_toml(const std::string& text, const std::string& name) {
  std::string ascii = text;
  int depth = 0;
  for (char& c : ascii) {
    // The library (3.3.0) has undefined behaviour for some non-ASCII characters. They occur in comments only.
    if (static_cast<unsigned char>(c) > 127) c = '?';
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (depth > 32) throw Malformed(name, "nested too deep", "brackets nest at most 32 deep", "more");
  }
  try {
    auto document = std::make_shared<json>(json_of(toml::parse(ascii)));
    return {document, *document, name};
  } catch (const toml::parse_error& error) {
    throw Malformed(name, "not TOML", "a problem file is written in TOML", std::string(error.description()));
  }
}

Reader Reader::operator[](const std::string& key) const { return {document_, value_->at(key), place_ + "." + key}; }

void Reader::fail(const std::string& what, const std::string& rule) const {
  throw Malformed(place_, what, rule, value_->dump(-1, ' ', true, json::error_handler_t::replace));
}

void Reader::check_keys(std::initializer_list<const char*> required,
                        std::initializer_list<const char*> optional) const {
  if (!value_->is_object()) fail("wrong type", "it has keys");
  std::set<std::string> known(required.begin(), required.end());
  for (const std::string& key : known) {
    if (!has(key)) throw Malformed(place_, "missing key", "it has to be given", key);
  }
  known.insert(optional.begin(), optional.end());
  for (const auto& [key, value] : value_->items()) {
    if (!known.contains(key)) throw Malformed(place_, "unknown key", "docs/ has all keys", json(key).dump());
  }
}

std::vector<Reader> Reader::list() const {
  if (!value_->is_array()) fail("wrong type", "it is a list");
  std::vector<Reader> result;
  for (const json& item : *value_) {
    result.push_back({document_, item, place_ + "[" + std::to_string(result.size()) + "]"});
  }
  return result;
}

std::string Reader::string() const {
  if (!value_->is_string()) fail("wrong type", "it is a string");
  return value_->get<std::string>();
}

bool Reader::boolean() const {
  if (!value_->is_boolean()) fail("wrong type", "it is true or false");
  return value_->get<bool>();
}

std::int64_t Reader::integer(std::int64_t least, std::int64_t most) const {
  const bool fits = value_->is_number_integer() && *value_ >= least && *value_ <= most;
  if (!fits) fail("out of range", "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value_->get<std::int64_t>();
}

std::size_t Reader::choice(std::initializer_list<const char*> names) const {
  const std::string given = string();
  const auto found = std::ranges::find(names, given);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string rule = "one of";
  for (const char* name : names) rule += std::string(" ") + name;
  fail("unknown word", rule);
}

std::vector<Rational> Reader::rationals() const {
  std::vector<Rational> result;
  for (const Reader& item : list()) result.push_back(item.rational());
  return result;
}

std::string read_file(const std::string& name) {
  constexpr std::size_t most = std::size_t{1} << 26;
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) {
    throw Malformed(name, "cannot be read", "it names a file", "a directory");
  }
  std::ifstream file(name, std::ios::binary);
  std::string text;
  std::vector<char> part(std::size_t{1} << 16);
  while (text.size() <= most && file.read(part.data(), static_cast<std::streamsize>(part.size())).gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) throw Malformed(name, "cannot be read", "it names a file", "no such file");
  if (text.size() > most) throw Malformed(name, "too long", "a file has at most 64 MiB", "more");
  return text;
}

}  // namespace steadyslide::checker
