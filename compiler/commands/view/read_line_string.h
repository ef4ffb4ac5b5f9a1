// Reads a LineString of a GeoJSON file.
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

/// Returns the first LineString of a GeoJSON file (RFC 7946) of up to 64 MB: a geometry, a feature, or a feature in a
/// collection. Errors: a file that cannot be read, is not GeoJSON or has no LineString; fewer than 2 places; a place
/// that is not 2 or 3 finite numbers with a latitude within ±90°.
Result<std::vector<LonLatHeight>> read_line_string(const std::string& path);

}  // namespace citykiln::commands
