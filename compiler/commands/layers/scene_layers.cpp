#include "compiler/commands/layers/scene_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "compiler/buildings/styles/style.h"
#include "compiler/commands/layers/road_properties.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/scene/graded_terrain.h"

namespace citykiln::commands {
namespace {

using scene::Chunk;
using scene::Scene;

using roads::Road;
using roads::WidthLimit;

// Adds the limits of the next piece. The is_wall of the first limit of a piece is unknown, so that of either piece
// counts.
void add_limits(std::vector<WidthLimit>& all, const std::vector<WidthLimit>& more) {
  for (const WidthLimit& limit : more) {
    const auto place = std::ranges::lower_bound(all, limit.at_m, {}, &WidthLimit::at_m);
    if (place != all.end() && place->at_m == limit.at_m)
      place->is_wall = place->is_wall || limit.is_wall;
    else
      all.insert(place, limit);
  }
}

void add_points(Road& road, const Road& piece, std::size_t first_vertex) {
  for (map::TrackPoint point : piece.points) {
    point.vertex += static_cast<std::uint32_t>(first_vertex);
    road.points.push_back(point);
  }
  sort_unique(road.points);
}

void add_profile(Profile& all, const Profile& more) {
  all.insert(all.end(), more.begin(), more.end());
  std::ranges::stable_sort(all, {}, &Knot::at_m);
  erase_repeated(all, &Knot::at_m);
}

// Appends a piece of the same road that begins before the road ends; pieces consist of whole segments, and vertices
// have the same distances along the way in all of them.
void append(Road& road, const Road& piece) {
  const std::vector<double> known = distances_along(road), along = distances_along(piece);
  const auto shared = std::ranges::lower_bound(known, along.front()) - known.begin();
  const auto first_new = std::ranges::upper_bound(along, known.back()) - along.begin();
  road.axis.insert(road.axis.end(), piece.axis.begin() + first_new, piece.axis.end());
  add_points(road, piece, static_cast<std::size_t>(shared));
  add_limits(road.width_limits.left, piece.width_limits.left);
  add_limits(road.width_limits.right, piece.width_limits.right);
  add_profile(road.profile, piece.profile);
}

// Returns the roads on the ground of all chunks, each once. Pieces of one road that overlap or meet become one, with
// the points, width limits and profile of all. If a part of a road is in no chunk, the road becomes several with one
// id, in order along it. Sorted by id. Cannot fail. O(n log n).
std::vector<Road> whole_roads(const scene::Scene& scene) {
  std::vector<const Road*> pieces;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Road& road : chunk.roads) pieces.push_back(&road);
  const auto order = [](const Road* road) { return std::tuple(road->id, road->start_along_m, road->axis.size()); };
  std::ranges::stable_sort(pieces, {}, order);
  std::vector<Road> whole;
  for (const Road* piece : pieces) {
    const bool continues =
        !whole.empty() && whole.back().id == piece->id && piece->start_along_m <= distances_along(whole.back()).back();
    continues ? append(whole.back(), *piece) : whole.push_back(*piece);
  }
  return whole;
}

// The heights of the ground of a whole manifest (a compiled scene), from the graded terrain of its tiles: the terrain
// after roads and water have cut into it.

// The graded terrain of each chunk. Refers to the scene.
struct SceneHeights {
  const scene::Scene& scene;
  std::vector<ground::GradedTerrain> graded;
};

// A tolerance without kerbs: objects stand on the higher side.
constexpr double kTolerance_m = 0.5;

double distance_m(const Box2& box, Vec2 p) {
  return std::max({box.min.x - p.x, p.x - box.max.x, box.min.y - p.y, p.y - box.max.y, 0.0});
}

// Returns the chunk whose tile is nearest to a place, usually the tile that contains it.
std::size_t chunk_near(const scene::Scene& scene, Vec2 p) {
  const auto column = static_cast<std::int32_t>(std::floor(p.x / scene.header.tile_m)),
             row = static_cast<std::int32_t>(std::floor(p.y / scene.header.tile_m));
  const scene::TileKey tile{column, row};
  const auto found = std::ranges::lower_bound(scene.chunks, tile, {}, &scene::Chunk::tile);
  if (found != scene.chunks.end() && found->tile == tile) return static_cast<std::size_t>(found - scene.chunks.begin());
  const auto nearest = std::ranges::min_element(scene.chunks, {}, [&](const scene::Chunk& chunk) {
    return distance_m(scene::box_of(scene.header, chunk.tile), p);
  });
  return static_cast<std::size_t>(nearest - scene.chunks.begin());
}

template <typename HeightIn>
double height_m(const SceneHeights& heights, Vec2 p, HeightIn height_in) {
  const std::size_t i = chunk_near(heights.scene, p);
  const scene::Chunk& chunk = heights.scene.chunks[i];
  if (scene::box_of(heights.scene.header, chunk.tile).contains(p)) return height_in(heights.graded[i]);
  return map::height_m_at(chunk.heights, p);
}

// Grades the terrain of all tiles.
SceneHeights heights_of(const scene::Scene& scene) {
  SceneHeights heights{scene, {}};
  for (const scene::Chunk& chunk : scene.chunks)
    heights.graded.push_back(scene::graded_terrain_of(scene.header, chunk, kTolerance_m));
  return heights;
}

// Returns the height at which objects stand at p: the height of the land, on roads of the kerbs' tops; outside all
// tiles the height of the terrain in the nearest tile. O(roads near).
double land_m(const SceneHeights& heights, Vec2 p) {
  return height_m(heights, p, [&](const ground::GradedTerrain& graded) { return ground::land_m(graded, p); });
}

// Returns the height of a ground face at p: the height of its height layer or, for standing water, the water's level.
double face_m(const SceneHeights& heights, Vec2 p, const ground::FaceHeight& face) {
  return height_m(heights, p, [&](const ground::GradedTerrain& graded) {
    return ground::layer_height_m(ground::heights_at(graded, p), face);
  });
}

/// The names of all elements of a scene.
std::map<OsmId, std::string> element_names(const Scene& scene) {
  std::map<OsmId, std::string> names;
  for (const Chunk& chunk : scene.chunks)
    for (const map::ElementText& text : chunk.texts) names.emplace(text.id, text.name);
  return names;
}

/// The data that all layers of a scene need.
struct Context {
  const Scene& scene;
  SceneHeights heights;
  std::map<OsmId, std::string> names;

  void add_name(Properties& properties, ObjectId id) const {
    if (const auto name = names.find(id.osm); name != names.end()) properties.add("name", name->second);
  }
};

/// Points with the heights that `height_m(point)` returns.
template <typename HeightAt>
std::vector<Vec3> lifted(std::span<const Vec2> points, HeightAt height_m) {
  std::vector<Vec3> line;
  for (const Vec2 p : points) line.push_back({p.x, p.y, height_m(p)});
  return line;
}

template <typename HeightAt>
LayerFeature& add_lifted_polygons(Layer& layer, ObjectId id, std::string kind, std::span<const Polygon> polygons,
                                  HeightAt height_m) {
  LayerFeature& feature =
      layer.emplace_back(LayerFeature{id, std::move(kind), GeometryKind::kPolygon, {}, /*has_z=*/true});
  for (const Polygon& polygon : polygons) {
    auto& rings = feature.parts.emplace_back();
    for (const Ring& ring : copied_rings(polygon)) rings.push_back(lifted(ring, height_m));
  }
  return feature;
}

// ---- roads and junctions ----

/// Returns the axis of a road with heights; without a profile it lies on the ground.
std::vector<Vec3> lifted_axis(const Context& context, const roads::Road& road) {
  const std::vector<double> along = distances_along(road);
  std::vector<Vec3> line = flat(road.axis);
  for (std::size_t i = 0; i < line.size(); ++i)
    line[i].z = road.profile.empty() ? land_m(context.heights, road.axis[i]) : knot_at(road.profile, along[i]).z_m;
  return line;
}

/// Adds a road, or another part of the last one.
void add_road(const Context& context, const roads::Road& road, int layer_number, map::Passage passage, Layer& layer) {
  const bool is_more = !layer.empty() && layer.back().id == road.id;
  if (!is_more) {
    LayerFeature& feature =
        layer.emplace_back(LayerFeature{road.id, class_of(road.surface), GeometryKind::kLine, {}, /*has_z=*/true});
    context.add_name(feature.properties, road.id);
    add_section(feature.properties, road.section);
    add_surface(feature.properties, road.surface);
    add_layer_and_passage(feature.properties, layer_number, passage);
    feature.properties.add("lit", road.is_lit);
    add_assumed(feature.properties, road.assumed);
  }
  layer.back().parts.push_back({lifted_axis(context, road)});
}

/// The bridges or tunnels of all chunks, each once.
std::map<ObjectId, const structures::Span*> spans_of(const Scene& scene, std::vector<structures::Span> Chunk::*kind) {
  std::map<ObjectId, const structures::Span*> spans;
  for (const Chunk& chunk : scene.chunks)
    for (const structures::Span& span : chunk.*kind) spans.emplace(span.id, &span);
  return spans;
}

Layer planned_roads(const Context& context) {
  Layer layer;
  for (const roads::Road& road : whole_roads(context.scene)) add_road(context, road, 0, map::Passage::kGround, layer);
  for (const auto& [id, span] : spans_of(context.scene, &Chunk::bridges))
    add_road(context, *span, span->layer, map::Passage::kBridge, layer);
  for (const auto& [id, span] : spans_of(context.scene, &Chunk::tunnels))
    add_road(context, *span, span->layer, map::Passage::kTunnel, layer);
  return layer;
}

/// The junctions of all chunks, each once.
std::vector<roads::Junction> all_junctions(const Scene& scene) {
  std::vector<roads::Junction> all;
  for (const Chunk& chunk : scene.chunks) all.insert(all.end(), chunk.junctions.begin(), chunk.junctions.end());
  const auto key = [](const roads::Junction& j) { return std::tie(j.nodes, j.family); };
  std::ranges::stable_sort(all, [&](const auto& a, const auto& b) { return key(a) < key(b); });
  erase_repeated(all, [&](const roads::Junction& j) { return std::pair(j.nodes, j.family); });
  return all;
}

/// The tile that holds a place, if the scene has it.
const Chunk* chunk_at(const Scene& scene, Vec2 at) {
  for (const Chunk& chunk : scene.chunks)
    if (scene::is_anchored(scene.header, chunk.tile, at)) return &chunk;
  return nullptr;
}

/// Junctions take area from each other across the borders of tiles, so all are outlined at once.
Layer planned_junctions(const Context& context) {
  const std::vector<roads::Road> roads = whole_roads(context.scene);
  const std::vector<roads::Junction> junctions = all_junctions(context.scene);
  const auto outlines = roads::outline_junctions(junctions, roads, 0);
  const auto arms = roads::arms_of(junctions, roads);
  Layer layer;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const Chunk* chunk = chunk_at(context.scene, junctions[j].nodes.front());
    if (outlines[j].empty() || chunk == nullptr) continue;
    const roads::Road& main = roads::main_road(roads, arms[j]);
    LayerFeature& junction = add_lifted_polygons(layer, main.id, class_of(main.surface), outlines[j],
                                                 [&](Vec2 p) { return land_m(context.heights, p); });
    context.add_name(junction.properties, main.id);
    junction.properties.add("layer", 0);
    junction.properties.add("tile", to_string(chunk->tile));
  }
  return layer;
}

// ---- areas ----

/// The pieces of one area: its polygons in each tile.
struct AreaPieces {
  const ground::LandCoverPolygon* first = nullptr;
  std::vector<Polygon> polygons;
  std::vector<std::string> tiles;
};

std::map<std::pair<ObjectId, map::LandCoverClass>, AreaPieces> area_pieces(const Scene& scene) {
  std::map<std::pair<ObjectId, map::LandCoverClass>, AreaPieces> areas;
  for (const Chunk& chunk : scene.chunks) {
    const Box2 box = scene::box_of(scene.header, chunk.tile);
    for (const ground::LandCoverPolygon& surface : chunk.surfaces) {
      // footprints and junctions have layers of their own
      const bool is_area =
          surface.area_m2 > ground::kPassedJunctionArea_m2 && surface.surface != map::LandCoverClass::kBuilding;
      if (!is_area) continue;
      std::vector<Polygon> inside = united_in(surface.rings, box);
      if (inside.empty()) continue;
      AreaPieces& pieces = areas[{surface.id, surface.surface}];
      if (pieces.first == nullptr) pieces.first = &surface;
      std::ranges::move(inside, std::back_inserter(pieces.polygons));
      pieces.tiles.push_back(to_string(chunk.tile));
    }
  }
  return areas;
}

std::vector<Polygon> joined_pieces(const AreaPieces& pieces) {
  if (pieces.tiles.size() == 1) return pieces.polygons;
  std::vector<Ring> rings;
  for (const Polygon& polygon : pieces.polygons) std::ranges::move(copied_rings(polygon), std::back_inserter(rings));
  return united(rings);
}

Layer planned_areas(const Context& context) {
  Layer layer;
  for (const auto& [key, pieces] : area_pieces(context.scene)) {
    const auto face = ground::face_height_of(*pieces.first);
    LayerFeature& area = add_lifted_polygons(layer, key.first, class_of(key.second), joined_pieces(pieces),
                                             [&](Vec2 p) { return face_m(context.heights, p, face); });
    context.add_name(area.properties, key.first);
    add_surface(area.properties, key.second);
    area.properties.add("area_m2", pieces.first->area_m2);
    if (pieces.first->level_m) area.properties.add("level_m", *pieces.first->level_m);
    area.properties.add("tiles", pieces.tiles);
  }
  return layer;
}

// ---- buildings and plants ----

// The kinds of a building's fronts: "cafe,bank".
void add_fronts(Properties& properties, const buildings::Building& building) {
  if (building.fronts.empty()) return;
  std::string kinds;
  for (const buildings::Front& front : building.fronts)
    kinds.append(kinds.empty() ? "" : ",").append(map::values_of(front.kind).name);
  properties.add("fronts", kinds);
  properties.add("assumed_fronts", std::ranges::any_of(building.fronts, &buildings::Front::is_assumed));
}

void add_planned_building(Properties& properties, const buildings::Building& building, double foot_m) {
  properties.add("levels", building.levels);
  properties.add("roof", roofs::name_of(building.roof_shape.form));
  properties.add("style", buildings::rule_file_of(building.style));
  properties.add("wall", materials::values_of(building.wall).name);
  properties.add("roof_material", materials::values_of(building.roof).name);
  properties.add("raised", !building.stands_on_ground);
  properties.add("bottom_m", building.bottom_m);
  properties.add("height_m", building.top_m - foot_m);
  add_fronts(properties, building);
  properties.add("eaves_m", buildings::eaves_m(building) - foot_m);
  if (building.year > 0) properties.add("year", building.year);
  properties.add("shop", building.has_shop);
  add_assumed(properties, building.assumed);
}

Layer planned_buildings(const Context& context) {
  Layer layer;
  for (const Chunk& chunk : context.scene.chunks) {
    for (const buildings::Building& building : chunk.buildings) {
      const std::vector<Polygon> outline = united(copied_rings(building.footprint));
      if (outline.empty()) continue;
      const double foot_m = building.stands_on_ground ? building.floor_m : building.bottom_m;
      const auto kind = map::word_of(static_cast<map::BuildingClass>(building.building_class));
      LayerFeature& feature =
          add_lifted_polygons(layer, building.id, std::string(kind), outline, [&](Vec2) { return foot_m; });
      context.add_name(feature.properties, building.id);
      add_planned_building(feature.properties, building, foot_m);
      feature.properties.add("tile", to_string(chunk.tile));
    }
  }
  return layer;
}

Layer planned_plants(const Context& context) {
  Layer layer;
  const plants::SpeciesTable species(context.scene.header.species);
  for (const Chunk& chunk : context.scene.chunks) {
    for (const plants::Tree& tree : chunk.trees) {
      // chunks also hold trees close to their tile
      if (!scene::is_anchored(context.scene.header, chunk.tile, tree.at)) continue;
      const auto place = lifted(std::span(&tree.at, 1), [&](Vec2 p) { return land_m(context.heights, p); });
      LayerFeature& plant = layer.emplace_back(LayerFeature{
          tree.id, plants::name_of(species, tree.species_mix), GeometryKind::kPoint, {{place}}, /*has_z=*/true});
      context.add_name(plant.properties, tree.id);
      if (tree.height_m > 0) plant.properties.add("height_m", tree.height_m);
      plant.properties.add("tile", to_string(chunk.tile));
    }
  }
  return layer;
}

}  // namespace

Result<Layer> layer_of(const scene::Scene& scene, const std::string& name) {
  constexpr std::array<std::pair<std::string_view, Layer (*)(const Context&)>, 5> kLayers = {
      {{"roads", planned_roads},
       {"junctions", planned_junctions},
       {"areas", planned_areas},
       {"buildings", planned_buildings},
       {"plants", planned_plants}}};
  for (const auto& [known, make] : kLayers)
    if (known == name) return make({scene, heights_of(scene), element_names(scene)});
  return Error{"--layer", fmt::format("expected {}, found \"{}\"", layer_names(), name)};
}

}  // namespace citykiln::commands
