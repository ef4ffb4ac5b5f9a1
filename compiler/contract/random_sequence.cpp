// Philox4x32-10 with the constants of Salmon, Moraes, Dror, Shaw, "Parallel Random Numbers: As Easy as 1, 2, 3",
// SC 2011, section 4.3.
#include "compiler/contract/random_sequence.h"

#include <cassert>

namespace citykiln {
namespace {

using Counter = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

Counter philox_round(const Counter& c, const Key& k) {
  const std::uint64_t p0 = std::uint64_t{0xD2511F53u} * c[0];
  const std::uint64_t p1 = std::uint64_t{0xCD9E8D57u} * c[2];
  return {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(p1),
          static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(p0)};
}

std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

Counter philox4x32_10(Counter counter, Key key) {
  for (int round = 0; round < 10; ++round) {
    counter = philox_round(counter, key);
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
  return counter;
}

RandomSequence::RandomSequence(std::uint64_t seed, StableId object, const char* purpose) {
  assert(purpose != nullptr && *purpose != '\0');
  const auto id = static_cast<std::uint64_t>(stable_id(object, purpose, 0));
  key_ = {low(seed), high(seed)};
  object_ = {low(id), high(id)};
}

double RandomSequence::unit(std::uint32_t index) const {
  return philox4x32_10({index, 0, object_[0], object_[1]}, key_)[0] * 0x1p-32;
}

std::uint32_t RandomSequence::below(std::uint32_t count, std::uint32_t index) const {
  assert(count > 0);
  const std::uint32_t bits = philox4x32_10({index, 0, object_[0], object_[1]}, key_)[0];
  return static_cast<std::uint32_t>(std::uint64_t{bits} * count >> 32);
}

}  // namespace citykiln
