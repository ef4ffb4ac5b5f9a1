// Writes layers as GeoJSON in longitude and latitude.
#pragma once

#include <string>
#include <vector>

#include "compiler/commands/layers/layer.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::commands {

/// Returns a FeatureCollection (RFC 7946). Coordinates have 1e-9 degrees, finer than the plane's grid, so that valid
/// polygons stay valid. A third coordinate is the height in the datum of the heightmaps, in metres. Properties begin
/// with id, part and class. Deterministic.
std::string geojson_of(const Layer& layer, const map::Plane& plane, const std::vector<std::string>& attributions);

}  // namespace citykiln::commands
