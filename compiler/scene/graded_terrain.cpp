#include "compiler/scene/graded_terrain.h"

#include <cassert>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::scene {

ground::GradedTerrain graded_terrain_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  assert(tolerance_m > 0);
  const std::vector<ground::LandCoverPolygon> surfaces = coarse_land_cover(chunk);
  return ground::grade_terrain<structures::Span>(chunk.heights,
                                                 {.roads = chunk.roads,
                                                  .streams = chunk.watercourses,
                                                  .surfaces = surfaces,
                                                  .box = box_of(header, chunk.tile).widened(ground::kGrading_m),
                                                  .has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m),
                                                  .landforms = chunk.landforms},
                                                 chunk.bridges, chunk.tunnels);
}

}  // namespace citykiln::scene
