#pragma once
// The part of emscripten's header of this name that bindings/explorer/bindings.cpp uses, so that the ordinary compiler can read
// it. It computes nothing.

#include <cstddef>
#include <type_traits>
#include <vector>

namespace emscripten {

class val {
 public:
  template <class T>
  explicit val(const T&) {}
  static val array() { return val(0); }
  static val object() { return val(0); }
  static val null() { return val(0); }
  static val global(const char*) { return val(0); }
  template <class Key, class Value>
  void set(const Key&, const Value&) {}
  template <class Result, class... Values>
  Result call(const char*, const Values&...) const {
    return Result();
  }
  template <class... Values>
  val new_(const Values&...) const {
    return val(0);
  }
  template <class Key>
  val operator[](const Key&) const {
    return val(0);
  }
  template <class T>
  T as() const {
    return T();
  }
};

template <class T>
val typed_memory_view(std::size_t, const T*) {
  return val(0);
}

template <class T>
std::vector<T> convertJSArrayToNumberVector(const val&) {
  return {};
}

template <class Class>
struct class_ {
  explicit class_(const char*) {}
  template <class... Values>
  const class_& constructor() const {
    static_assert(std::is_constructible_v<Class, Values...>);
    return *this;
  }
  template <class Function>
  const class_& function(const char*, Function) const {
    return *this;
  }
};

}  // namespace emscripten

#define EMSCRIPTEN_BINDINGS(name) void bindings_of_##name()
