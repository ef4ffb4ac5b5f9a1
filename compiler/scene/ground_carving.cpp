#include "compiler/scene/ground_carving.h"

#include "compiler/scene/ground_cover.h"

namespace citykiln::scene {

ground::Carving carving_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  const std::vector<ground::Surface> surfaces = surfaces_of(chunk);
  const Box2 box = box_of(header, chunk.tile).widened(ground::kCarve_m);
  return ground::carve(chunk.heights, {chunk.roads, chunk.streams, surfaces, box, tolerance_m < kPlainRoads_m});
}

}  // namespace citykiln::scene
