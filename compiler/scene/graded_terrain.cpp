#include "compiler/scene/graded_terrain.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/roads/pieces/drive_kerbs.h"
#include "compiler/roads/pieces/dropped_kerbs.h"
#include "compiler/scene/drive_mouths.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::scene {

ground::GradedTerrain graded_terrain_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  assert(tolerance_m > 0);
  const std::vector<ground::LandCoverPolygon> surfaces = coarse_land_cover(chunk);
  const bool has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m);
  std::vector<roads::KerbRamp> ramps;
  if (has_kerbs) {
    ramps = roads::kerb_ramps_of(chunk.roads, chunk.junctions, header.tile_m, header.has_street_furniture);
    std::ranges::move(roads::drive_ramps_of(chunk.roads, chunk.junctions, header.tile_m, header.has_street_furniture,
                                            drive_mouths_of(header, chunk)),
                      std::back_inserter(ramps));
  }
  return ground::grade_terrain<structures::Span>(chunk.heights,
                                                 {.roads = chunk.roads,
                                                  .streams = chunk.watercourses,
                                                  .surfaces = surfaces,
                                                  .box = box_of(header, chunk.tile).widened(ground::kGrading_m),
                                                  .has_kerbs = has_kerbs,
                                                  .landforms = chunk.landforms,
                                                  .kerb_ramps = ramps},
                                                 chunk.bridges, chunk.tunnels);
}

}  // namespace citykiln::scene
