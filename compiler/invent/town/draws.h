// Random numbers of one object, drawn one after the other.
#pragma once

#include <cstdint>

#include "compiler/contract/random_sequence.h"

namespace citykiln::invent {

/// Draws numbers one after the other. They depend only on seed, role, ordinal and the number of draws before
/// (contract/random_sequence.h).
class Draws {
 public:
  /// @param role     A short constant, such as "street", that separates kinds of objects.
  /// @param ordinal  The number of the object among those of its role.
  Draws(std::uint64_t seed, const char* role, std::uint64_t ordinal)
      : sequence_(seed, stable_id(StableId{0}, role, ordinal), role) {}

  /// Returns a number in [0, 1).
  double unit() { return sequence_.unit(next_++); }
  /// Returns a number in [low, high).
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Returns a whole number from 0 to count - 1. count > 0.
  std::uint32_t below(std::uint32_t count) { return sequence_.below(count, next_++); }
  /// True with this probability.
  bool chance(double probability) { return unit() < probability; }

 private:
  RandomSequence sequence_;
  std::uint32_t next_ = 0;
};

}  // namespace citykiln::invent
