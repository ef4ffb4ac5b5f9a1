// Maps radiance to what a screen shows.
#pragma once

#include <array>
#include <cstdint>

namespace citykiln::preview {

/// Returns 8 bit sRGB of linear RGB radiance: a fixed exposure, then a filmic curve that keeps hues near white. It is
/// the same for every picture, so that pictures can be compared. Values that are negative or not finite count as black.
std::array<std::uint8_t, 3> tone_map(const float* rgb);

}  // namespace citykiln::preview
