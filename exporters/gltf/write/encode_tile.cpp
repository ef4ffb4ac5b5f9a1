#include "exporters/gltf/write/encode_tile.h"

#include <fmt/format.h>

#include <utility>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pack/quantise.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {

EncodedTile encode_tile(bake::BakedTile tile, const scene::Header& header, const GlbOptions& options, int threads,
                        Layout layout) {
  if (options.compression != Compression::kNone) tile = quantised(std::move(tile), options.compression);
  GlbParts parts = build_glb(tile, header, options, threads);
  SharedGlb glb =
      layout == Layout::kShared ? share_prototypes(std::move(parts)) : SharedGlb{join_glb(std::move(parts)), {}};
  return {std::move(glb.glb), std::move(glb.files), tile.error_m, triangles_of(tile)};
}

std::string glb_name(scene::TileKey tile, std::size_t level) {
  return fmt::format("{}/{}_L{}.glb", kGlbFolder, to_string(tile), level);
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
