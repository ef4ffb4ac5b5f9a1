// Random numbers of one object, drawn one after the other.
#pragma once

#include <cstdint>

#include "compiler/contract/random_sequence.h"

namespace citykiln::invent {

/// The numbers depend on seed, role and ordinal only (contract/random_sequence.h). All bounds are as there.
class Draws {
 public:
  /// @param role     A short constant, such as "street", that separates kinds of objects.
  /// @param ordinal  The number of the object among those of its role.
  Draws(std::uint64_t seed, const char* role, std::uint64_t ordinal)
      : sequence_(seed, stable_id(StableId{0}, role, ordinal), role) {}

  double unit() { return sequence_.unit(next_++); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::uint32_t below(std::uint32_t count) { return sequence_.below(count, next_++); }
  /// True with this probability.
  bool chance(double probability) { return unit() < probability; }

 private:
  RandomSequence sequence_;
  std::uint32_t next_ = 0;
};

}  // namespace citykiln::invent
