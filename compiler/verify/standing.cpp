#include "compiler/verify/standing.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace citykiln::verify {
namespace {

// Names of recipes, added to others.
template <typename Recipe>
void add_ids(std::span<const Recipe> recipes, std::vector<OsmId>& ids) {
  for (const Recipe& recipe : recipes) ids.push_back(recipe.id.osm);
}

// A fence may bear the id of the field it goes around: then its faces are taken for the field's, over which they stand.
std::vector<OsmId> walls_of(const scene::Scene& scene) {
  std::vector<OsmId> walls, fields, only_walls;
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.barriers), walls);
    add_ids(std::span(chunk.surfaces), fields);
  }
  std::ranges::sort(walls);
  std::ranges::sort(fields);
  std::ranges::set_difference(walls, fields, std::back_inserter(only_walls));
  return only_walls;
}

std::vector<OsmId> leaving_of(const scene::Scene& scene) {
  std::vector<OsmId> leaving = walls_of(scene);
  for (const scene::Chunk& chunk : scene.chunks) {
    add_ids(std::span(chunk.bridges), leaving);
    add_ids(std::span(chunk.tunnels), leaving);
  }
  std::ranges::sort(leaving);
  return leaving;
}

std::vector<OsmId> houses_of(const scene::Scene& scene) {
  std::vector<OsmId> houses;
  for (const scene::Chunk& chunk : scene.chunks) add_ids(std::span(chunk.buildings), houses);
  std::ranges::sort(houses);
  return houses;
}

// Of houses that are mapped as a square, a pitch or a path too.
std::vector<std::pair<OsmId, materials::Material>> fields_of(const scene::Scene& scene,
                                                             const std::vector<OsmId>& houses) {
  std::vector<std::pair<OsmId, materials::Material>> fields;
  const auto add = [&](OsmId osm, map::LandCoverClass surface) {
    if (surface != map::LandCoverClass::kBuilding && std::ranges::binary_search(houses, osm))
      fields.emplace_back(osm, map::values_of(surface).material);
  };
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const ground::LandCoverPolygon& surface : chunk.surfaces) add(surface.id.osm, surface.surface);
    for (const roads::Road& road : chunk.roads) add(road.id.osm, road.surface);
  }
  std::ranges::sort(fields);
  return fields;
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

Standing standing_of(const scene::Scene& scene) {
  Standing standing{leaving_of(scene), houses_of(scene)};
  standing.fields = fields_of(scene, standing.houses);
  standing.steps = steps_of(scene);
  return standing;
}

}  // namespace citykiln::verify
