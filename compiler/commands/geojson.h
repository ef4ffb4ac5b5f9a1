// Layers for QGIS: shapes of the plane written as GeoJSON in longitude and latitude.
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
  std::string kind;  ///< Its class, "Residential".
  GeometryKind geometry{};
  std::vector<Ring> parts;  ///< One point, one line, or one polygon's rings with the outer one first. Plane metres.
  std::string tile{};       ///< Of which chunk it is a piece; empty: whole.
  double width_m = 0, bottom_m = 0, height_m = 0;  ///< 0: it has none.
  std::optional<int> layer{};                      ///< Of junctions: 0 on the ground.
  std::string passage{};                           ///< "bridge", "tunnel"; empty: on the ground.
};
using Layer = std::vector<LayerFeature>;

/// The layer `name` (roads, junctions, areas, buildings, plants) of a map or of a manifest. Of a manifest, roads and
/// areas are pieces, trimmed to their tiles, and junctions those of the ground alone; of a map, bridges' and tunnels'
/// follow the ground's. Errors: an unknown name.
Result<Layer> layer_of(const map::Features& features, const std::string& name);
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name);

/// A FeatureCollection (RFC 7946); coordinates to 1e-8 degrees. Same layer, same text.
std::string geojson_of(const Layer& layer, const map::Plane& plane, const std::vector<std::string>& attributions);

}  // namespace citykiln::commands
