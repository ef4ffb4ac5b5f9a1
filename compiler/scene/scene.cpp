#include "compiler/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/ground/plan.h"

namespace citykiln::scene {
namespace {

// Surfaces that are one object's (the runs of a trimmed road) become one.
void join_equal(std::vector<ground::Surface>& surfaces) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < surfaces.size(); ++i) {
    ground::Surface& last = surfaces[kept];
    if (last.id == surfaces[i].id && last.surface == surfaces[i].surface) {
      last.rings.insert(last.rings.end(), surfaces[i].rings.begin(), surfaces[i].rings.end());
    } else if (++kept != i) {
      surfaces[kept] = std::move(surfaces[i]);
    }
  }
  surfaces.resize(std::min(surfaces.size(), kept + 1));
}

}  // namespace

Box2 box_of(const Header& header, TileKey tile) {
  const Vec2 min{tile.x * header.tile_m, tile.y * header.tile_m};
  return {{std::max(min.x, header.region.min.x), std::max(min.y, header.region.min.y)},
          {std::min(min.x + header.tile_m, header.region.max.x), std::min(min.y + header.tile_m, header.region.max.y)}};
}

std::vector<TileKey> tiles_of(const Header& header) {
  const auto number = [&](double v) { return static_cast<std::int32_t>(std::floor(v / header.tile_m)); };
  const auto last = [&](double v) { return static_cast<std::int32_t>(std::ceil(v / header.tile_m)) - 1; };
  std::vector<TileKey> tiles;
  for (std::int32_t x = number(header.region.min.x); x <= last(header.region.max.x); ++x)
    for (std::int32_t y = number(header.region.min.y); y <= last(header.region.max.y); ++y) tiles.push_back({x, y});
  return tiles;
}

std::vector<roads::Junction> anchored_junctions(const Header& header, const Chunk& chunk) {
  std::vector<roads::Junction> anchored;
  for (const roads::Junction& junction : chunk.junctions) {
    const Vec2 at = junction.places.front();
    if (std::floor(at.x / header.tile_m) == chunk.tile.x && std::floor(at.y / header.tile_m) == chunk.tile.y)
      anchored.push_back(junction);
  }
  return anchored;
}

ground::Surface junction_surface(const roads::Junction& junction, std::span<const roads::Road> roads,
                                 std::span<const roads::Arm> arms) {
  // apart from all parts that a way is cut into
  constexpr std::uint32_t kJunctionPart = 0x80000000u;
  const roads::Road& main = roads::main_road(roads, arms);
  return {{main.id.osm, main.id.part | kJunctionPart}, main.surface, 0, roads::stroke(junction, roads, arms)};
}

ground::Surface footprint_surface(const buildings::Building& building) {
  ground::Surface surface{building.id,
                          map::SurfaceClass::kBuilding,
                          static_cast<std::uint32_t>(std::min(area_m2(building.footprint), 4.0e9)),
                          {building.footprint.outer}};
  surface.rings.insert(surface.rings.end(), building.footprint.holes.begin(), building.footprint.holes.end());
  return surface;
}

std::vector<ground::Surface> surfaces_of(const Chunk& chunk) {
  std::vector<ground::Surface> surfaces = chunk.surfaces;
  const std::vector<roads::Ends> ends = roads::ends_of(chunk.roads);
  for (std::size_t i = 0; i < chunk.roads.size(); ++i) {
    surfaces.push_back(ground::surface_of(chunk.roads[i], ends[i]));
    if (ground::Surface pavement = ground::pavement_of(chunk.roads[i], ends[i]); !pavement.rings.empty())
      surfaces.push_back(std::move(pavement));
  }
  for (const roads::Junction& junction : chunk.junctions) {
    const auto arms = roads::arms_at(chunk.roads, junction.places, junction.family);
    // a manifest that names places where no road passes
    if (arms.empty() || arms.size() != junction.cuts.size()) continue;
    surfaces.push_back(junction_surface(junction, chunk.roads, arms));
  }
  for (const roads::Strip& stream : chunk.streams) surfaces.push_back(ground::surface_of(stream));
  for (const buildings::Building& building : chunk.buildings)
    if (building.stands_on_ground) surfaces.push_back(footprint_surface(building));
  std::stable_sort(surfaces.begin(), surfaces.end(), [](const ground::Surface& a, const ground::Surface& b) {
    return std::tie(a.id, a.surface) < std::tie(b.id, b.surface);
  });
  join_equal(surfaces);
  return surfaces;
}

}  // namespace citykiln::scene
