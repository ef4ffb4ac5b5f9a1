// Errors of reading and writing. The stages in between cannot fail: they mend or drop data and diagnose it (report.h).
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace citykiln {

/// An error in one line of text: the file and the place in it, and what was expected there.
struct Error {
  std::string where;    ///< "monaco.osm.pbf", "town.osm:12:5", "scene.kiln, byte 96".
  std::string message;  ///< "expected a PBF blob header, found the end of the file".
};

/// Returns "where: message", or the message alone if `where` is empty.
inline std::string to_string(const Error& error) {
  return error.where.empty() ? error.message : error.where + ": " + error.message;
}

/// A value, or an error instead of it.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return std::holds_alternative<T>(state_); }
  T& operator*() { return value(); }
  const T& operator*() const { return const_cast<Result*>(this)->value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &**this; }
  const Error& error() const {
    assert(!*this);
    return std::get<Error>(state_);
  }

 private:
  T& value() {
    assert(*this);
    return std::get<T>(state_);
  }
  std::variant<T, Error> state_;
};

/// The result of functions without a product.
struct Done {};

}  // namespace citykiln
