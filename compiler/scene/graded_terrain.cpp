#include "compiler/scene/graded_terrain.h"

#include "compiler/contract/detail_tolerances.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::scene {

ground::GradedTerrain graded_terrain_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  const std::vector<ground::LandCoverPolygon> surfaces = coarse_land_cover(chunk);
  const Box2 box = box_of(header, chunk.tile).widened(ground::kGrading_m);
  const std::vector<roads::Road> decks(chunk.bridges.begin(), chunk.bridges.end());
  std::vector<roads::Road> bores;
  for (const structures::Span& tunnel : chunk.tunnels)
    if (tunnel.is_bored) bores.push_back(tunnel);
  return ground::grade_terrain(chunk.heights, {chunk.roads, chunk.watercourses, surfaces, box,
                                               has_detail(Detail::kRoadSurfaces, tolerance_m), decks, bores});
}

}  // namespace citykiln::scene
