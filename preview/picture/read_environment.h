// Reads environment maps.
#pragma once

#include <cstddef>
#include <string>

#include "compiler/contract/result.h"
#include "preview/light/environment_map.h"

namespace citykiln::preview {

/// Width and height of the largest environment map: 1.6 GB.
inline constexpr int kMostEnvironmentWidth = 16384, kMostEnvironmentHeight = 8192;

/// An environment map that was read.
struct ReadEnvironment {
  EnvironmentMap map;
  std::size_t mended = 0;  ///< The number of texels with a channel that was negative or not finite, and became 0.
};

/// Reads a panorama (equirectangular: longitude by latitude) from an .exr or .hdr file. One channel is read as grey.
///
/// @param turn_deg  Compass bearing of the middle of the picture, clockwise: with 0 it is north, and a quarter of the
/// width to the right is east. A turn that is not a whole number of columns interpolates between columns.
///
/// Errors: another extension; a file that cannot be read; an image larger than the limits, found before memory is
/// allocated; an image that is not twice as wide as high.
Result<ReadEnvironment> read_environment(const std::string& path, double turn_deg);

}  // namespace citykiln::preview
