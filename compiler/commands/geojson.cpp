#include "compiler/commands/geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <nlohmann/json.hpp>

#include "compiler/map/land_cover_class.h"
#include "compiler/roads/junctions/layers.h"
#include "compiler/roads/plan.h"

namespace citykiln::commands {
namespace {

std::string class_of(map::LandCoverClass surface) { return std::string(map::values_of(surface).name); }

std::vector<Ring> copy_rings(const Polygon& polygon) {
  std::vector<Ring> rings = {polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  return rings;
}

Layer roads_of(const map::Features& features) {
  Layer layer;
  for (const map::Track& track : features.tracks) {
    const double width_m = map::carriageway_width_m(track.section);
    layer.push_back({track.id, class_of(track.surface), GeometryKind::kLine, {track.axis}, {}, width_m});
  }
  return layer;
}

Layer areas_of(const map::Features& features) {
  Layer layer;
  for (const map::AreaFeature& area : features.areas) {
    layer.push_back({area.id, class_of(area.surface), GeometryKind::kPolygon, copy_rings(area.polygon)});
  }
  return layer;
}

Layer buildings_of(const map::Features& features) {
  Layer layer;
  for (const map::Footprint& building : features.footprints) {
    layer.push_back({building.id,
                     building.is_part ? "Part" : "Building",
                     GeometryKind::kPolygon,
                     copy_rings(building.polygon),
                     {},
                     0,
                     building.min_height_m,
                     building.height_m});
  }
  return layer;
}

Layer plants_of(const map::Features& features) {
  Layer layer;
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kTree) continue;
    const char* kind = point.plant_tags.leaves == map::LeafType::kNeedle ? "NeedleLeaved" : "BroadLeaved";
    layer.push_back({point.id, kind, GeometryKind::kPoint, {{point.at}}, {}, 0, 0, point.height_m});
  }
  return layer;
}

// The place of a network: its tile if it is a piece, its layer, and its passage if it is off the ground.
struct Network {
  std::string tile;
  int layer = 0;
  map::Passage passage = map::Passage::kGround;
};

// Adds junction outlines in the order of the junctions, with the ids of their main roads.
void add_junctions(std::span<const roads::Junction> junctions, std::span<const roads::Road> roads,
                   const Network& network, Layer& layer) {
  const auto outlines = roads::outline_junctions(junctions, roads, 0);
  const auto arms = roads::arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const roads::Road& main = roads::main_road(roads, arms[j]);
    for (const Polygon& polygon : outlines[j])
      layer.push_back({main.id, class_of(main.surface), GeometryKind::kPolygon, copy_rings(polygon), network.tile, 0, 0,
                       0, network.layer, passage_name(network.passage)});
  }
}

Layer junctions_of(const map::Features& features) {
  Report ignored;
  const std::vector<roads::Road> roads = roads::plan(features, ignored);
  Layer layer;
  add_junctions(roads::plan_junctions(roads, ignored), roads, {}, layer);
  for (const roads::RoadLayer& off_ground : roads::plan_layers(features, ignored))
    add_junctions(off_ground.junctions, off_ground.roads, {{}, off_ground.layer, off_ground.passage}, layer);
  return layer;
}

Layer roads_of(const scene::Scene& scene) {
  Layer layer;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const roads::Road& road : chunk.roads) {
      layer.push_back({road.id,
                       class_of(road.surface),
                       GeometryKind::kLine,
                       {road.axis},
                       to_string(chunk.tile),
                       roads::width_m(road)});
    }
  }
  return layer;
}

/// Each junction once, in the tile that contains its first node.
Layer junctions_of(const scene::Scene& scene) {
  Layer layer;
  for (const scene::Chunk& chunk : scene.chunks)
    add_junctions(scene::anchored_junctions(scene.header, chunk), chunk.roads, {to_string(chunk.tile)}, layer);
  return layer;
}

/// Each ring becomes a feature of its own, since land cover polygons are rings with winding numbers and not polygons
/// with holes.
Layer areas_of(const scene::Scene& scene) {
  Layer layer;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const ground::LandCoverPolygon& surface : chunk.surfaces) {
      for (const Ring& ring : surface.rings) {
        const char* hole = signed_area_m2(ring) < 0 ? "Hole" : "";
        layer.push_back(
            {surface.id, class_of(surface.surface) + hole, GeometryKind::kPolygon, {ring}, to_string(chunk.tile)});
      }
    }
  }
  return layer;
}

Layer buildings_of(const scene::Scene& scene) {
  Layer layer;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const buildings::Building& building : chunk.buildings) {
      layer.push_back({building.id, building.stands_on_ground ? "Building" : "Raised", GeometryKind::kPolygon,
                       copy_rings(building.footprint), to_string(chunk.tile), 0, building.bottom_m,
                       building.top_m - building.bottom_m});
    }
  }
  return layer;
}

Layer plants_of(const scene::Scene& scene) {
  Layer layer;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const plants::Tree& tree : chunk.trees) {
      // chunks also hold trees close to their tile
      if (!scene::is_anchored(scene.header, chunk.tile, tree.at)) continue;
      layer.push_back({tree.id,
                       plants::name_of(tree.species_mix),
                       GeometryKind::kPoint,
                       {{tree.at}},
                       to_string(chunk.tile),
                       0,
                       0,
                       tree.height_m});
    }
  }
  return layer;
}

template <typename Source>
Result<Layer> layer_named(const Source& source, const std::string& name) {
  if (name == "roads") return roads_of(source);
  if (name == "areas") return areas_of(source);
  if (name == "buildings") return buildings_of(source);
  if (name == "plants") return plants_of(source);
  if (name == "junctions") return junctions_of(source);
  return Error{"--layer", fmt::format("expected roads, junctions, areas, buildings or plants, found \"{}\"", name)};
}

// ---- writing ----

void write_position(std::string& out, Vec2 p, const map::Plane& plane) {
  const map::LonLat place = plane.backward(p);
  fmt::format_to(std::back_inserter(out), "[{:.8f},{:.8f}]", place.lon_deg, place.lat_deg);
}

void write_positions(std::string& out, const Ring& points, bool closes, const map::Plane& plane) {
  out += '[';
  for (std::size_t i = 0; i < points.size() + (closes ? 1 : 0); ++i) {
    if (i > 0) out += ',';
    write_position(out, points[i % points.size()], plane);
  }
  out += ']';
}

void write_geometry(std::string& out, const LayerFeature& feature, const map::Plane& plane) {
  constexpr std::array kNames = {"Point", "LineString", "Polygon"};
  fmt::format_to(std::back_inserter(out), R"({{"type":"{}","coordinates":)",
                 kNames[static_cast<std::size_t>(feature.geometry)]);
  if (feature.geometry == GeometryKind::kPoint) {
    write_position(out, feature.parts[0][0], plane);
  } else if (feature.geometry == GeometryKind::kLine) {
    write_positions(out, feature.parts[0], false, plane);
  } else {
    out += '[';
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      if (i > 0) out += ',';
      write_positions(out, feature.parts[i], true, plane);
    }
    out += ']';
  }
  out += '}';
}

void write_properties(std::string& out, const LayerFeature& feature) {
  fmt::format_to(std::back_inserter(out), R"({{"id":"{}","part":{},"class":"{}")", to_string(feature.id.osm),
                 feature.id.part, feature.kind);
  if (!feature.tile.empty()) fmt::format_to(std::back_inserter(out), R"(,"tile":"{}")", feature.tile);
  if (feature.layer) fmt::format_to(std::back_inserter(out), R"(,"layer":{})", *feature.layer);
  if (!feature.passage.empty()) fmt::format_to(std::back_inserter(out), R"(,"passage":"{}")", feature.passage);
  if (feature.width_m > 0) fmt::format_to(std::back_inserter(out), R"(,"width_m":{})", feature.width_m);
  if (feature.bottom_m != 0) fmt::format_to(std::back_inserter(out), R"(,"bottom_m":{})", feature.bottom_m);
  if (feature.height_m > 0) fmt::format_to(std::back_inserter(out), R"(,"height_m":{})", feature.height_m);
  out += '}';
}

}  // namespace

std::string passage_name(map::Passage passage) {
  return passage == map::Passage::kBridge ? "bridge" : passage == map::Passage::kTunnel ? "tunnel" : "";
}

Result<Layer> layer_of(const map::Features& features, const std::string& name) { return layer_named(features, name); }
Result<Layer> layer_of(const scene::Scene& scene, const std::string& name) { return layer_named(scene, name); }

std::string geojson_of(const Layer& layer, const map::Plane& plane, const std::vector<std::string>& attributions) {
  assert(std::ranges::none_of(layer, [](const LayerFeature& f) { return f.parts.empty(); }));
  std::string out =
      R"({"type":"FeatureCollection","attribution":)" + nlohmann::json(attributions).dump() + ",\"features\":[";
  for (std::size_t i = 0; i < layer.size(); ++i) {
    out += i > 0 ? ",\n" : "\n";
    out += R"({"type":"Feature","properties":)";
    write_properties(out, layer[i]);
    out += ",\"geometry\":";
    write_geometry(out, layer[i], plane);
    out += '}';
  }
  return out + "\n]}\n";
}

}  // namespace citykiln::commands
