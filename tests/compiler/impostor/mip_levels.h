// Mip levels of opacities as a renderer makes them: each texel is the rounded mean of 2 × 2.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/impostor/mip_opacity.h"

namespace citykiln::impostor {

struct MipLevel {
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint8_t> opacity;
};

/// Returns the next level.
/// @param level  Has an even number of columns and rows.
inline MipLevel halved(const MipLevel& level) {
  MipLevel half{level.columns / 2, level.rows / 2, {}};
  for (std::size_t row = 0; row < half.rows; ++row)
    for (std::size_t column = 0; column < half.columns; ++column) {
      const std::size_t at = 2 * row * level.columns + 2 * column, below = at + level.columns;
      const int sum = level.opacity[at] + level.opacity[at + 1] + level.opacity[below] + level.opacity[below + 1];
      half.opacity.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
    }
  return half;
}

inline double opaque_share(const MipLevel& level) {
  const auto opaque = std::ranges::count_if(level.opacity, [](std::uint8_t o) { return o >= kAlphaCutoff; });
  return static_cast<double>(opaque) / static_cast<double>(level.opacity.size());
}

/// The share of the area that passes the cutoff if opacities are interpolated between texels, by 8 × 8 samples a texel.
inline double interpolated_share(const MipLevel& level) {
  constexpr int kSamples = 8;
  const auto columns = static_cast<int>(level.columns), rows = static_cast<int>(level.rows);
  const auto at = [&](int column, int row) -> double {
    return level
        .opacity[static_cast<std::size_t>(std::clamp(row, 0, rows - 1) * columns + std::clamp(column, 0, columns - 1))];
  };
  std::int64_t opaque = 0;
  for (int y = 0; y < rows * kSamples; ++y)
    for (int x = 0; x < columns * kSamples; ++x) {
      const double u = (x + 0.5) / kSamples - 0.5, v = (y + 0.5) / kSamples - 0.5;
      const int column = static_cast<int>(u + 1) - 1, row = static_cast<int>(v + 1) - 1;
      const double s = u - column, t = v - row;
      opaque += (at(column, row) * (1 - s) + at(column + 1, row) * s) * (1 - t) +
                    (at(column, row + 1) * (1 - s) + at(column + 1, row + 1) * s) * t >=
                kAlphaCutoff - 0.5;
    }
  return static_cast<double>(opaque) / (static_cast<double>(columns) * rows * kSamples * kSamples);
}

}  // namespace citykiln::impostor
