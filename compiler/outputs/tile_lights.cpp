#include "compiler/outputs/tile_lights.h"

#include "compiler/bake/far/bend.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::outputs {

std::vector<std::vector<bake::PlacedLamp>> lights_of_tiles(const scene::Scene& scene, std::size_t most, int threads) {
  using Lamps = std::vector<bake::PlacedLamp>;
  if (most == 0) return std::vector<Lamps>(scene.chunks.size());
  return for_each_slot<Lamps>(scene.chunks.size(), threads, [&](std::size_t i) {
    return bake::in_world(bake::brightest(bake::lamps_of(scene.header, scene.chunks[i]), most), scene.header);
  });
}

}  // namespace citykiln::outputs
