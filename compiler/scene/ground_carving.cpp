#include "compiler/scene/ground_carving.h"

#include "compiler/scene/ground_cover.h"

namespace citykiln::scene {
namespace {

bool is_paved(const ground::Surface& surface) {
  const ground::HeightLayer layer = ground::layer_of(surface.surface);
  return layer == ground::HeightLayer::kRoad || layer == ground::HeightLayer::kCarriageway;
}

}  // namespace

ground::Carving carving_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  std::vector<ground::Surface> paved = surfaces_of(chunk);
  std::erase_if(paved, [](const ground::Surface& s) { return !is_paved(s); });
  const Box2 box = box_of(header, chunk.tile).widened(ground::kCarve_m);
  return ground::carve(chunk.heights, chunk.roads, std::move(paved), box, tolerance_m < kPlainRoads_m);
}

}  // namespace citykiln::scene
