#include "compiler/verify/non_ground_objects.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace citykiln::verify {
namespace {

// Appends the ids of the recipes.
template <typename Recipe>
void add_ids(std::span<const Recipe> recipes, std::vector<OsmId>& ids) {
  for (const Recipe& recipe : recipes) ids.push_back(recipe.id.osm);
}

// A fence may have the id of the area that it encloses; its faces then count as the area's, above which they stand.
std::vector<OsmId> walls_of(const scene::Scene& scene) {
  std::vector<OsmId> walls, land_cover_materials, only_walls;
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.barriers), walls);
    add_ids(std::span(chunk.surfaces), land_cover_materials);
  }
  std::ranges::sort(walls);
  std::ranges::sort(land_cover_materials);
  std::ranges::set_difference(walls, land_cover_materials, std::back_inserter(only_walls));
  return only_walls;
}

std::vector<OsmId> leaving_of(const scene::Scene& scene) {
  std::vector<OsmId> off_ground = walls_of(scene);
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.bridges), off_ground);
    add_ids(std::span(chunk.tunnels), off_ground);
  }
  std::ranges::sort(off_ground);
  return off_ground;
}

std::vector<OsmId> houses_of(const scene::Scene& scene) {
  std::vector<OsmId> building_ids;
  for (const scene::Chunk& chunk : scene.chunks) add_ids(std::span(chunk.buildings), building_ids);
  std::ranges::sort(building_ids);
  return building_ids;
}

// The land cover materials of buildings that are also mapped as a square, a pitch or a path.
std::vector<std::pair<OsmId, materials::Material>> fields_of(const scene::Scene& scene,
                                                             const std::vector<OsmId>& building_ids) {
  std::vector<std::pair<OsmId, materials::Material>> land_cover_materials;
  const auto add = [&](OsmId osm, map::LandCoverClass surface) {
    if (surface != map::LandCoverClass::kBuilding && std::ranges::binary_search(building_ids, osm))
      land_cover_materials.emplace_back(osm, map::values_of(surface).material);
  };
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const ground::LandCoverPolygon& surface : chunk.surfaces) add(surface.id.osm, surface.surface);
    for (const roads::Road& road : chunk.roads) add(road.id.osm, road.surface);
  }
  std::ranges::sort(land_cover_materials);
  return land_cover_materials;
}

std::vector<OsmId> steps_of(const scene::Scene& scene) {
  std::vector<OsmId> steps;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const roads::Road& road : chunk.roads)
      if (road.surface == map::LandCoverClass::kSteps) steps.push_back(road.id.osm);
  std::ranges::sort(steps);
  return steps;
}

}  // namespace

NonGroundObjects find_non_ground_objects(const scene::Scene& scene) {
  NonGroundObjects non_ground{leaving_of(scene), houses_of(scene)};
  non_ground.land_cover_materials = fields_of(scene, non_ground.building_ids);
  non_ground.stairs = steps_of(scene);
  return non_ground;
}

}  // namespace citykiln::verify
