// From light to what a screen shows.
#pragma once

#include <array>
#include <cstdint>

namespace citykiln::preview {

/// Linear RGB radiance to 8 bit sRGB: a fixed exposure, then a filmic curve that keeps hues as they
/// near white. The same for every picture, so that pictures compare. Not finite or negative counts as black.
std::array<std::uint8_t, 3> tone_map(const float* rgb);

}  // namespace citykiln::preview
