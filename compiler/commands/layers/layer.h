// Layers for QGIS and other GIS: features with properties, in the plane. geojson.h writes them as GeoJSON.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/vec.h"

namespace citykiln::commands {

/// The properties of a feature as JSON, in the order in which they are added: `,"name":"Rue Grimaldi"`.
class Properties {
 public:
  /// Adds a text; an empty one is left out.
  /// @param value  Valid UTF-8.
  void add(std::string_view name, std::string_view value);
  void add(std::string_view name, const char* value) { add(name, std::string_view(value)); }
  /// Adds a number with the fewest digits that preserve it.
  void add(std::string_view name, double value);
  void add(std::string_view name, std::integral auto value) { add_json(name, std::to_string(value)); }
  /// Adds true; false is left out.
  void add(std::string_view name, bool value);
  /// Adds a list of texts.
  void add(std::string_view name, const std::vector<std::string>& values);

  const std::string& json() const { return json_; }

 private:
  void add_json(std::string_view name, std::string_view value);
  std::string json_;
};

/// The geometry of a feature.
enum class GeometryKind { kPoint, kLine, kPolygon };

/// One feature of a layer.
struct LayerFeature {
  ObjectId id;
  std::string kind;  ///< The class, such as "ResidentialRoad".
  GeometryKind geometry{};
  /// One part, or several of a line or polygon. A part is one point, one line, or the rings of one polygon, outer ring
  /// first. Plane metres; z only where has_z.
  std::vector<std::vector<std::vector<Vec3>>> parts;
  bool has_z = false;
  Properties properties{};  ///< The properties after id, part and class.
};
/// The features of one layer.
using Layer = std::vector<LayerFeature>;

/// Returns points as the coordinates of a feature without has_z; z is 0.
std::vector<Vec3> flat(std::span<const Vec2> points);
/// Returns polygons as the parts of a feature without has_z.
std::vector<std::vector<std::vector<Vec3>>> flat(std::span<const Polygon> polygons);

/// Returns the names of layers for error messages: "roads, junctions, areas, buildings or plants".
std::string_view layer_names();

}  // namespace citykiln::commands
