#include "compiler/ground/water/pool_rims.h"

#include <algorithm>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

Polygon polygon_of(const LandCoverPolygon& pool) {
  Polygon polygon{pool.rings.front(), {}};
  polygon.holes.assign(pool.rings.begin() + 1, pool.rings.end());
  return polygon;
}

std::vector<Ring> rim_rings(const LandCoverPolygon& pool) {
  const Polygon polygon = polygon_of(pool);
  std::size_t edges = 0;
  for (const Ring& ring : pool.rings) edges += ring.size();
  std::vector<Ring> rings;
  for (const Polygon& moved : outset(polygon, std::vector<double>(edges, kPoolRim_m)).moved)
    for (const Ring* ring : rings_of(moved)) {
      Ring on_grid;
      for (const Vec2 p : *ring) on_grid.push_back(snapped(p));
      rings.push_back(without_repeats(on_grid));
    }
  std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3; });
  return rings;
}

LandCoverPolygon rim_of(const LandCoverPolygon& pool) {
  return {.id = rim_id(pool.id),
          .surface = map::LandCoverClass::kPoolRim,
          .area_m2 = pool.area_m2,
          .rings = rim_rings(pool),
          .level_m = *pool.level_m + kPoolRimRise_m,
          .raised_priority = pool.raised_priority};
}

}  // namespace

std::vector<LandCoverPolygon> with_pool_rims(std::vector<LandCoverPolygon> surfaces) {
  std::vector<LandCoverPolygon> rims;
  for (LandCoverPolygon& surface : surfaces) {
    if (surface.surface != map::LandCoverClass::kPool || surface.rings.empty()) continue;
    if (!surface.level_m) surface.level_m = 0;
    if (LandCoverPolygon rim = rim_of(surface); !rim.rings.empty()) rims.push_back(std::move(rim));
  }
  surfaces.insert(surfaces.end(), rims.begin(), rims.end());
  std::ranges::stable_sort(surfaces, {}, &LandCoverPolygon::id);
  return surfaces;
}

}  // namespace citykiln::ground
