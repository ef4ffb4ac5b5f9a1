// Chance in the renderer: a pure function of (seed, pixel, sample, dimension), fast rather than strong.
#pragma once

#include <cstdint>

namespace citykiln::preview {

/// The random numbers of one path, taken in order. Each pixel and sample has its own stream, so threads do not matter.
class PathDraw {
 public:
  PathDraw(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample) : state_(mix(mix(seed ^ (std::uint64_t{pixel} << 32)) + sample)) {}

  /// Uniform in [0, 1).
  float next() {
    state_ += 0x9e3779b97f4a7c15u;
    return static_cast<float>(mix(state_) >> 40) * 0x1p-24f;
  }

 private:
  // SplitMix64 (Steele, Lea, Flood 2014)
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  std::uint64_t state_;
};

}  // namespace citykiln::preview
