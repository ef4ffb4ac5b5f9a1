// Maps radiance to the colours of a screen.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace citykiln::preview {

/// Returns 8 bit sRGB of linear RGB radiance: a fixed exposure, then a filmic curve that keeps hues near white. The
/// mapping does not depend on the picture, so that pictures can be compared. Values that are negative or not finite
/// count as black.
/// @param rounding  Added before the fraction of a byte is cut off. In [0, 1).
std::array<std::uint8_t, 3> tone_map(std::span<const float, 3> rgb, double rounding = 0.5);

/// Returns a rounding that differs from pixel to pixel, so that a smooth sky has no bands. Its mean is 0.5. Source:
/// interleaved gradient noise, Jimenez, "Next Generation Post Processing in Call of Duty", 2014.
double dither_at(int x, int y);

}  // namespace citykiln::preview
