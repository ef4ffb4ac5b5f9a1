#include "compiler/buildings/expand.h"

#include <algorithm>
#include <utility>

#include "compiler/buildings/dress.h"
#include "compiler/geometry/triangulate.h"

namespace citykiln::buildings {
namespace {

// One quad an edge. Rings run with the building on their left, so the wall looks to their right.
void add_walls(Mesh& mesh, const Ring& ring, double bottom_m, double top_m) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size()), n = static_cast<std::uint32_t>(ring.size());
  for (const Vec2 p : ring) mesh.positions.insert(mesh.positions.end(), {at_height(p, bottom_m), at_height(p, top_m)});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
}

Mesh lid_of(const PlaneTriangles& plane, double z, bool looks_up) {
  Mesh mesh{{}, {}, plane.triangles};
  for (const Vec2 p : plane.points) mesh.positions.push_back(at_height(p, z));
  if (!looks_up)
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

Expanded expand(const Building& building, std::uint64_t seed, double tolerance_m) {
  const double height_m = building.top_m - building.bottom_m;
  if (height_m < tolerance_m) return {{}, height_m};
  const materials::Tint wall = wall_tint(building, seed), roof = roof_tint(building, seed);
  Mesh walls;
  add_walls(walls, building.footprint.outer, building.bottom_m, building.top_m);
  for (const Ring& hole : building.footprint.holes) add_walls(walls, hole, building.bottom_m, building.top_m);
  const PlaneTriangles plane = triangulate(building.footprint);
  Expanded expanded;
  expanded.meshes.push_back({std::move(walls), building.wall, wall, building.id.osm});
  expanded.meshes.push_back({lid_of(plane, building.top_m, true), building.roof, roof, building.id.osm});
  if (!building.stands_on_ground)
    expanded.meshes.push_back({lid_of(plane, building.bottom_m, false), building.wall, wall, building.id.osm});
  return expanded;
}

}  // namespace citykiln::buildings
