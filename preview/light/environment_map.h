// Environment maps: light from all directions, as a picture.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::preview {

/// Radiance from all directions, in the sky's unit, as a panorama (latitude and longitude; equirectangular).
///
/// Row 0 is the zenith (+z) and the last row the nadir. With `turn_deg` = 0 the middle of the picture is north (+y), a
/// quarter to the right of it is east (+x), and both sides are south, as a viewer inside sees it. `turn_deg` is the
/// compass bearing of the middle, clockwise. A direction of bearing b = atan2(x, y) and elevation e = asin(z) is at
/// column ((b - turn) / 360° + 1/2) modulo 1 of the width and row (1/2 - e / 180°) of the height.
struct EnvironmentMap {
  int width = 0, height = 0;
  std::vector<float> rgb{};  ///< Linear, finite and not negative; row by row from the top.
  double turn_deg = 0;
};

/// Largest environment map: 1.6 GB.
inline constexpr int kMostEnvironmentWidth = 16384, kMostEnvironmentHeight = 8192;

/// An environment map, and the number of texels with a channel that was negative or not finite, which became 0.
struct ReadEnvironment {
  EnvironmentMap map;
  std::size_t mended = 0;
};

/// Reads a panorama from an .exr or .hdr file; a picture of one channel is grey. Errors: another extension, a file that
/// cannot be read, one larger than the limit (before memory is asked for), or not twice as wide as high.
Result<ReadEnvironment> read_environment(const std::string& path);

}  // namespace citykiln::preview
