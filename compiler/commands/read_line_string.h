// Reads a line of a GeoJSON file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// A place in degrees, and its height above sea level in metres if it has one.
struct LonLatHeight {
  double lon_deg = 0, lat_deg = 0;
  std::optional<double> height_m{};
};

/// The first LineString of a GeoJSON file (RFC 7946): a geometry, a feature, or a feature in a collection. Files up to
/// 64 MB. Errors: a file that cannot be read, is no GeoJSON, has no LineString, or one with fewer than 2 places, or
/// with places that are not 2 or 3 finite numbers with a latitude within ±90°.
Result<std::vector<LonLatHeight>> read_line_string(const std::string& path);

}  // namespace citykiln::commands
