#include "compiler/scene/ground_carving.h"

#include "compiler/scene/ground_cover.h"

namespace citykiln::scene {

ground::Carving carving_of(const Header& header, const Chunk& chunk, double tolerance_m) {
  const std::vector<ground::Surface> surfaces = surfaces_of(chunk);
  const Box2 box = box_of(header, chunk.tile).widened(ground::kCarve_m);
  const std::vector<roads::Road> decks(chunk.bridges.begin(), chunk.bridges.end());
  std::vector<roads::Road> bores;
  for (const structures::Span& tunnel : chunk.tunnels)
    if (tunnel.is_bored) bores.push_back(tunnel);
  return ground::carve(chunk.heights,
                       {chunk.roads, chunk.streams, surfaces, box, tolerance_m < kPlainRoads_m, decks, bores});
}

}  // namespace citykiln::scene
