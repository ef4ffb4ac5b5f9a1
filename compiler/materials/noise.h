// Noise: smooth chance over a square that repeats, and over the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::materials {

/// Values of a square that repeats both ways, row by row; texel (0, 0) is its corner.
struct Field {
  std::uint32_t side_px = 0;
  std::vector<float> values;

  float& at(std::uint32_t column, std::uint32_t row) {
    return values[static_cast<std::size_t>(row) * side_px + column];
  }
  float at(std::uint32_t column, std::uint32_t row) const {
    return values[static_cast<std::size_t>(row) * side_px + column];
  }
};

/// Waves across a square, each way: 8 and 2 are waves four times as long along v as across u.
struct WaveCounts {
  std::uint32_t across = 1, along = 1;
};

/// Gradient noise, about -0.7 … 0.7, mean near 0, and no wave longer than a side divided by `waves`.
///
/// Guarantees: repeats without a seam; a function of (side_px, waves, key) alone; only + − × ÷. O(texels).
/// Source: Perlin, "Improving Noise", SIGGRAPH 2002, on a lattice that wraps.
Field gradient_noise(std::uint32_t side_px, WaveCounts waves, std::uint64_t key);

/// `octaves` of it, each of twice as many waves and `gain` times as high as the one before; those that texels cannot
/// show are left out.
Field layered_noise(std::uint32_t side_px, WaveCounts first, int octaves, double gain, std::uint64_t key);

/// Stones: the square in irregular cells.
struct Cells {
  Field chance;   ///< 0 … 1, the same all over a cell.
  Field to_edge;  ///< 0 on the edges, rising inwards, about 1 in the middle.
};

/// Cells about `across` × `across` points, one in each square of a grid (Worley, "A Cellular Texture Basis Function",
/// SIGGRAPH 1996). Guarantees as above.
Cells cells(std::uint32_t side_px, std::uint32_t across, std::uint64_t key);

/// Value noise of the plane, -1 … 1, waves of about `wave_m`: a function of place, key and wave alone, so that whatever
/// tile asks is told the same. Total: a place that is not finite, or beyond 2^30 waves, is told 0. O(1).
double noise_at(Vec2 place_m, double wave_m, std::uint64_t key);

}  // namespace citykiln::materials
