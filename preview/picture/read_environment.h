// Reads environment maps.
#pragma once

#include <cstddef>
#include <string>

#include "compiler/contract/result.h"
#include "preview/light/environment_map.h"

namespace citykiln::preview {

/// Largest environment map: 1.6 GB.
inline constexpr int kMostEnvironmentWidth = 16384, kMostEnvironmentHeight = 8192;

/// An environment map, and the number of texels with a channel that was negative or not finite, which became 0.
struct ReadEnvironment {
  EnvironmentMap map;
  std::size_t mended = 0;
};

/// Reads a panorama (latitude and longitude; equirectangular) from an .exr or .hdr file; one channel is grey.
///
/// @param turn_deg  Compass bearing of the middle of the picture, clockwise: 0 is north, and a quarter of the width to
/// the right is east. Between whole columns, columns are interpolated.
///
/// Errors: another extension, a file that cannot be read, one larger than the limit (before memory is asked for), or
/// not twice as wide as high.
Result<ReadEnvironment> read_environment(const std::string& path, double turn_deg);

}  // namespace citykiln::preview
