// Random numbers that depend only on (seed, object, purpose, index), so that tiles, threads and the order of work do
// not change them.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"

namespace citykiln {

/// Returns 128 random bits for a counter and a key, by Philox4x32-10. Source: Salmon, Moraes, Dror, Shaw, "Parallel
/// Random Numbers: As Easy as 1, 2, 3", SC 2011. Tested against the authors' known answers.
std::array<std::uint32_t, 4> philox4x32_10(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// The random numbers of one object for one purpose.
class RandomSequence {
 public:
  /// @param purpose  A short constant, such as "tint", that separates this use of the object's numbers from others.
  RandomSequence(std::uint64_t seed, StableId object, const char* purpose);

  /// Returns the `index`-th number, uniform in [0, 1), a multiple of 2^-32.
  double unit(std::uint32_t index) const;

  /// Returns the `index`-th number, uniform in [low, high).
  double between(double low, double high, std::uint32_t index) const { return low + (high - low) * unit(index); }

  /// Returns the `index`-th integer, uniform in 0 … count - 1. count > 0.
  std::uint32_t below(std::uint32_t count, std::uint32_t index) const;

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 2> object_;
};

}  // namespace citykiln
