#include "compiler/bake/ground/border_tint.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/erase_repeated.h"
#include "compiler/map/locate.h"

namespace citykiln::bake {
namespace {

struct Corner {
  std::uint32_t vertex, surface;
  auto operator<=>(const Corner&) const = default;
};

bool is_on_cell_border(Vec3 p) {
  const auto is_whole = [](double v) { return std::floor(v / map::kCell_m) * map::kCell_m == v; };
  return is_whole(p.x) || is_whole(p.y);
}

std::vector<Corner> soft_corners(const ground::GroundMesh& ground,
                                 const std::vector<ground::LandCoverPolygon>& surfaces) {
  std::vector<Corner> corners;
  for (std::size_t f = 0; f < ground.face_cover.size(); ++f) {
    const std::uint32_t surface = ground.face_cover[f];
    if (surface == ground::kNoLandCover || !has_soft_border(surfaces[surface].surface)) continue;
    for (const std::uint32_t v : ground.mesh.triangles[f])
      if (!is_on_cell_border(ground.mesh.positions[v])) corners.push_back({v, surface});
  }
  sort_unique(corners);
  return corners;
}

}  // namespace

BorderTints border_tints(const ground::GroundMesh& ground, const std::vector<ground::LandCoverPolygon>& surfaces,
                         std::uint64_t seed, plants::Month month) {
  assert(ground.face_cover.size() == ground.mesh.triangles.size());
  const std::size_t count = ground.mesh.positions.size();
  BorderTints border{std::vector<TintFactor>(count), std::vector<bool>(count, false)};
  const std::vector<Corner> corners = soft_corners(ground, surfaces);
  for (auto first = corners.begin(); first != corners.end();) {
    const auto end = std::find_if(first, corners.end(), [&](const Corner& c) { return c.vertex != first->vertex; });
    TintFactor sum{0, 0, 0};
    const double share = 1.0 / static_cast<double>(end - first);
    for (auto c = first; c != end; ++c) {
      const ground::LandCoverPolygon& surface = surfaces[c->surface];
      const TintFactor tint = surface_tint(surface, values_of(surface.surface).material, seed, month);
      sum = {sum.red + share * tint.red, sum.green + share * tint.green, sum.blue + share * tint.blue};
    }
    border.tints[first->vertex] = sum, border.is_shared[first->vertex] = end - first > 1;
    first = end;
  }
  return border;
}

}  // namespace citykiln::bake
