#include "exporters/gltf/encode_tile.h"

#include <fmt/format.h>

#include "exporters/gltf/quantise.h"

namespace citykiln::exporters {

EncodedTile encode_tile(const bake::BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                        int threads) {
  if (options.compression == Compression::kNone)
    return {encode_glb(tile, header, options, threads), tile.error_m, triangles_of(tile)};
  const bake::BakedTile packed = quantised(tile);
  return {encode_glb(packed, header, options, threads), packed.error_m, triangles_of(packed)};
}

std::string glb_name(scene::TileKey tile, std::size_t level) {
  return fmt::format("glb/{}_L{}.glb", to_string(tile), level);
}

std::uint64_t triangles_of(const bake::BakedTile& tile) {
  std::uint64_t count = 0;
  for (const bake::Primitive& primitive : tile.primitives) count += primitive.triangles.size();
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    for (const bake::Primitive& primitive : instanced.primitives)
      count += primitive.triangles.size() * instanced.translations.size();
  }
  return count;
}

std::uint64_t instances_of(const bake::BakedTile& tile) {
  std::uint64_t count = 0;
  for (const bake::InstancedMesh& instanced : tile.instanced) count += instanced.translations.size();
  return count;
}

}  // namespace citykiln::exporters
