#pragma once
// A value that is computed once, at first use. Safe between threads.

#include <memory>
#include <mutex>

namespace steadyslide::numeric {

template <class T>
class Once {
 public:
  template <class Make>
  const T& operator()(const Make& make) const {
    std::call_once(flag_, [&] { value_.reset(new T(make())); });  // not make_unique, because T may not be movable
    return *value_;
  }

 private:
  mutable std::once_flag flag_;
  mutable std::unique_ptr<const T> value_;
};

}  // namespace steadyslide::numeric
