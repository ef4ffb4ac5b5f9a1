// Random numbers as a pure function of (seed, object, purpose, index), so that they do not depend on tiles, threads or
// order.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"

namespace citykiln {

/// Philox4x32-10: returns 128 random bits for a counter and a key.
/// Source: Salmon, Moraes, Dror, Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3", SC 2011. Tested against the
/// authors' known answers.
std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// The random numbers of one object for one purpose.
class Draw {
 public:
  /// @param purpose  A short constant that separates this use from other uses of the object, such as "tint".
  Draw(std::uint64_t seed, StableId object, const char* purpose);

  /// The `index`-th number, uniform in [0, 1), a multiple of 2^-32.
  double unit(std::uint32_t index) const;

  /// The `index`-th number, uniform in [low, high).
  double between(double low, double high, std::uint32_t index) const { return low + (high - low) * unit(index); }

  /// The `index`-th integer, uniform in 0 … count - 1. count > 0.
  std::uint32_t below(std::uint32_t count, std::uint32_t index) const;

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 2> object_;
};

}  // namespace citykiln
