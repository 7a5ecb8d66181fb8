#pragma once
// A record as bytes, for the way from one process to another of the same program. What a record consists of is said once:
// pass(archive, record), a function beside it, hands its members to an archive, which writes or reads them.

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace steadyslide::proofs_checks {

template <class T>
inline constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends members to its bytes.
class ArchiveWriter {
 public:
  template <class... Members>
  void operator()(Members&... members) {
    (one(members), ...);
  }
  std::string bytes;

 private:
  template <class T>
  void one(T& value) {
    if constexpr (is_plain<T>) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else {
      pass(*this, value);
    }
  }
  void one(std::string& text) {
    std::size_t size = text.size();
    one(size);
    bytes += text;
  }
  template <class T>
  void one(std::vector<T>& values) {
    std::size_t size = values.size();
    one(size);
    for (T& value : values) one(value);
  }
  template <class... Alternatives>
  void one(std::variant<Alternatives...>& value) {
    std::size_t index = value.index();
    one(index);
    std::visit([this](auto& alternative) { one(alternative); }, value);
  }
};

/// Takes members from bytes.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : left_(bytes) {}

  template <class... Members>
  void operator()(Members&... members) {
    (one(members), ...);
  }
  bool at_end() const { return left_.empty(); }

 private:
  std::string_view taken(std::size_t size) {
    if (size > left_.size()) throw std::invalid_argument("a record breaks off");
    const std::string_view result = left_.substr(0, size);
    left_.remove_prefix(size);
    return result;
  }
  template <class T>
  void one(T& value) {
    if constexpr (is_plain<T>) {
      std::memcpy(&value, taken(sizeof value).data(), sizeof value);
    } else {
      pass(*this, value);
    }
  }
  void one(std::string& text) {
    std::size_t size = 0;
    one(size);
    text = taken(size);
  }
  template <class T>
  void one(std::vector<T>& values) {
    std::size_t size = 0;
    one(size);
    for (; size > 0; --size) one(values.emplace_back());
  }
  template <class... Alternatives>
  void one(std::variant<Alternatives...>& value) {
    std::size_t index = 0;
    one(index);
    choose(value, index, std::index_sequence_for<Alternatives...>());
    std::visit([this](auto& alternative) { one(alternative); }, value);
  }
  template <class Variant, std::size_t... All>
  static void choose(Variant& value, std::size_t index, std::index_sequence<All...>) {
    const bool known = ((index == All && (value.template emplace<All>(), true)) || ...);
    if (!known) throw std::invalid_argument("a record has a part of an unknown kind");
  }

  std::string_view left_;
};

template <class Record>
std::string archived(const Record& record) {
  ArchiveWriter writer;
  pass(writer, const_cast<Record&>(record));  // a writer changes nothing
  return std::move(writer.bytes);
}

/// Fills the record. Throws std::invalid_argument where there are too few or too many bytes.
template <class Record>
void unarchive(std::string_view bytes, Record& record) {
  ArchiveReader reader(bytes);
  pass(reader, record);
  if (!reader.at_end()) throw std::invalid_argument("a record goes on behind its end");
}

}  // namespace steadyslide::proofs_checks
