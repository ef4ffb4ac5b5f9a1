#include "compiler/outputs/tile_lights.h"

#include "compiler/bake/far/bend.h"
#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::outputs {

std::vector<bake::PlacedLamp> lights_of(const scene::Header& header, const scene::Chunk& chunk, std::size_t most) {
  if (most == 0 || header.shown.lamps == scene::LampLight::kOff) return {};
  return bake::in_world(bake::brightest(bake::lamps_of(header, chunk), most), header);
}

std::vector<std::vector<bake::PlacedLamp>> lights_of_tiles(const scene::Scene& scene, std::size_t most, int threads) {
  return for_each_slot<std::vector<bake::PlacedLamp>>(
      scene.chunks.size(), threads, [&](std::size_t i) { return lights_of(scene.header, scene.chunks[i], most); });
}

}  // namespace citykiln::outputs
