// Noise with round bulges and sharp creases between them, as on the surface of a cumulus.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace citykiln::preview {

/// Cellular noise (Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996): 1 - d², where d is the distance to the
/// nearest of random points, one in each unit cell. Repeats after kPeriod cells. Thread-safe.
class BillowNoise {
 public:
  static constexpr int kPeriod = 8;

  /// Computes a tile of 64³ samples in 256 kB. Cost: 30 ms.
  BillowNoise();

  /// Returns the noise at a place given in cells, interpolated between samples: 0 to 1.
  float at(float x, float y, float z) const;
  /// Returns the mean over all places.
  float mean() const { return mean_; }

 private:
  static constexpr int kSamples = 64;
  std::vector<std::uint8_t> tile_;  // x is the fastest index
  float mean_ = 0;
};

}  // namespace citykiln::preview
