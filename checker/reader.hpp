#pragma once
// A JSON or TOML document as a tree of values. Each value has its place, which every error names.

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "checker/failure.hpp"
#include "checker/rational.hpp"

namespace steadyslide::checker {

class Reader {
 public:
  /// Reads JSON. A key must not occur twice in an object.
  static Reader of_json(const std::string& text, const std::string& name);
  /// Reads TOML. Numbers become strings; a float becomes the shortest decimal with the same value.
  static Reader of_toml(const std::string& text, const std::string& name);

  bool is_null() const { return value_->is_null(); }
  bool has(const std::string& key) const { return value_->contains(key); }
  /// Checks that this is an object with all keys of the first list, and no keys outside both lists.
  void check_keys(std::initializer_list<const char*> required, std::initializer_list<const char*> optional = {}) const;
  /// Returns the value of a key that check_keys has accepted.
  Reader operator[](const std::string& key) const;
  std::vector<Reader> list() const;
  std::string string() const;
  bool boolean() const;
  std::int64_t integer(std::int64_t least, std::int64_t most) const;
  /// Returns the index of the value in these strings.
  std::size_t choice(std::initializer_list<const char*> names) const;
  Rational rational() const { return Rational::parse(string(), place_); }
  std::vector<Rational> rationals() const;
  const std::string& place() const { return place_; }
  [[noreturn]] void fail(const std::string& what, const std::string& rule) const;

 private:
  Reader(std::shared_ptr<const nlohmann::json> document, const nlohmann::json& value, std::string place)
      : document_(std::move(document)), value_(&value), place_(std::move(place)) {}

  std::shared_ptr<const nlohmann::json> document_;  ///< owner of the value
  const nlohmann::json* value_;
  std::string place_;
};

/// Returns the text of a file. Throws Malformed if it cannot be read, is a directory or is longer than 64 MiB.
std::string read_file(const std::string& name);

}  // namespace steadyslide::checker
