// Layers for QGIS and other GIS: features of the plane written as GeoJSON in longitude and latitude.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"
#include "compiler/map/plane.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

enum class GeometryKind { kPoint, kLine, kPolygon };

/// One feature of a layer.
struct LayerFeature {
  ObjectId id;
  std::string kind;  ///< Its class, such as "Residential".
  GeometryKind geometry{};
  std::vector<Ring> parts;  ///< One point, one line, or the rings of one polygon, outer ring first. Plane metres.
  std::string tile{};       ///< The tile of a piece; empty for a whole object.
  double width_m = 0, bottom_m = 0, height_m = 0;  ///< 0: none.
  std::optional<int> layer{};                      ///< Of junctions; 0 is the ground.
  std::string passage{};                           ///< "bridge" or "tunnel"; empty on the ground.
};
using Layer = std::vector<LayerFeature>;

/// Returns the layer `name` (roads, junctions, areas, buildings, plants) of a map or a manifest. In layers of a
/// manifest roads and areas are trimmed to their tiles and junctions are those of the ground; in layers of a map the
/// junctions of bridges and tunnels follow those of the ground. Error: an unknown name.
Result<Layer> layer_of(const map::Features& features, const std::string& name);
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name);

/// "bridge", "tunnel", or "" for the ground.
std::string passage_name(map::Passage passage);

/// A FeatureCollection (RFC 7946) with coordinates to 1e-8 degrees. Deterministic.
std::string geojson_of(const Layer& layer, const map::Plane& plane, const std::vector<std::string>& attributions);

}  // namespace citykiln::commands
