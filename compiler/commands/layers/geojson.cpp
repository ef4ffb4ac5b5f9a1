#include "compiler/commands/layers/geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <nlohmann/json.hpp>

#include "compiler/map/plane/degrees.h"

namespace citykiln::commands {
namespace {

// Writes geometries of one layer.
struct Writer {
  std::string& out;
  const map::Plane& plane;

  void position(Vec3 p, bool has_z) {
    const LonLat place = plane.backward({p.x, p.y});
    out += '[' + map::degrees_text(place.lon_deg, map::kFineDegreeDecimals) + ',' +
           map::degrees_text(place.lat_deg, map::kFineDegreeDecimals);
    if (has_z) fmt::format_to(std::back_inserter(out), ",{:.2f}", p.z);
    out += ']';
  }

  // Writes a list of what `write_item(i)` writes.
  template <typename WriteItem>
  void list(std::size_t count, WriteItem write_item) {
    out += '[';
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) out += ',';
      write_item(i);
    }
    out += ']';
  }

  void positions(const std::vector<Vec3>& points, bool has_z, bool closes) {
    list(points.size() + (closes ? 1 : 0), [&](std::size_t i) { position(points[i % points.size()], has_z); });
  }

  void part(const LayerFeature& feature, const std::vector<std::vector<Vec3>>& lines) {
    if (feature.geometry == GeometryKind::kPoint) return position(lines[0][0], feature.has_z);
    if (feature.geometry == GeometryKind::kLine) return positions(lines[0], feature.has_z, false);
    list(lines.size(), [&](std::size_t i) { positions(lines[i], feature.has_z, true); });
  }

  void geometry(const LayerFeature& feature) {
    constexpr std::array kNames = {"Point", "LineString", "Polygon"};
    const bool is_multi = feature.parts.size() > 1;
    fmt::format_to(std::back_inserter(out), R"({{"type":"{}{}","coordinates":)", is_multi ? "Multi" : "",
                   kNames[static_cast<std::size_t>(feature.geometry)]);
    if (is_multi)
      list(feature.parts.size(), [&](std::size_t i) { part(feature, feature.parts[i]); });
    else
      part(feature, feature.parts[0]);
    out += '}';
  }
};

}  // namespace

std::string geojson_of(const Layer& layer, const map::Plane& plane, const std::vector<std::string>& attributions) {
  assert(std::ranges::none_of(layer, [](const LayerFeature& f) { return f.parts.empty(); }));
  std::string out =
      R"({"type":"FeatureCollection","attribution":)" + nlohmann::json(attributions).dump() + ",\"features\":[";
  Writer writer{out, plane};
  for (std::size_t i = 0; i < layer.size(); ++i) {
    const LayerFeature& feature = layer[i];
    out += i > 0 ? ",\n" : "\n";
    fmt::format_to(std::back_inserter(out),
                   R"({{"type":"Feature","properties":{{"id":"{}","part":{},"class":"{}"{}}},"geometry":)",
                   to_string(feature.id.osm), feature.id.part, feature.kind, feature.properties.json());
    writer.geometry(feature);
    out += '}';
  }
  return out + "\n]}\n";
}

}  // namespace citykiln::commands
