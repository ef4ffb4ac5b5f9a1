// Noise: smooth pseudorandom functions on a square that repeats, and on the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::materials {

/// Values on a square that repeats both ways, row by row; texel (0, 0) is its corner.
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

/// The numbers of waves (cells of the noise's lattice) along u (across) and v (along) of a square: {8, 2} stretches the
/// noise along v.
struct WaveCounts {
  std::uint32_t across = 1, along = 1;
};

/// Returns gradient noise, about -0.7 … 0.7, with mean near 0 and no wavelength above a side divided by `waves` (> 0).
///
/// Guarantees: repeats without a seam; a function of its arguments alone; only + − × ÷. O(texels).
/// Source: Perlin, "Improving Noise", SIGGRAPH 2002, on a lattice that wraps around.
Field gradient_noise(std::uint32_t side_px, WaveCounts waves, std::uint64_t key);

/// Returns a sum of octaves of gradient noise: each has twice the waves and `gain` times the amplitude of the one
/// before. Octaves with wavelengths below two texels are left out.
Field layered_noise(std::uint32_t side_px, WaveCounts first, int octaves, double gain, std::uint64_t key);

/// Returns independent random numbers, 0 … 1.
Field random_values(std::uint32_t side_px, std::uint64_t key);

/// Cellular noise: a square split into irregular cells.
struct Cells {
  Field chance;   ///< By texel: a random number 0 … 1 of the cell that contains the texel.
  Field to_edge;  ///< By texel: 0 at the edges of cells, rising inwards to about 1 in the middle of a cell.
};

/// Returns cells around `across` × `across` points, one in each square of a grid. Guarantees as for gradient_noise().
/// Source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.
Cells cells(std::uint32_t side_px, std::uint32_t across, std::uint64_t key);

/// Returns value noise of the plane, -1 … 1, with wavelengths of about wave_m (> 0): a function of its arguments alone,
/// so that all tiles get the same value at a place. 0 if the place is not finite or beyond 2^30 waves. O(1).
double noise_at(Vec2 place_m, double wave_m, std::uint64_t key);

}  // namespace citykiln::materials
