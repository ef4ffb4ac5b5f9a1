// Encodes a baked tile as a .glb, packed or not, with the numbers that report.json states about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/layout.h"
#include "compiler/scene/scene.h"
#include "exporters/gltf/glb.h"
#include "exporters/gltf/pack/shared_layout.h"

namespace citykiln::exporters {

/// A .glb with the error that it states, which includes the error of packing.
struct EncodedTile {
  std::vector<std::byte> glb;
  std::vector<SharedFile> shared;  ///< Files that it refers to, with Layout::kShared.
  double error_m = 0;
  /// The number in the file, without triangles that packing drops (quantise.h), with those of every instance.
  std::uint64_t triangles = 0;
};

/// Returns the .glb of a tile. Packed tiles are quantised first (quantise.h), so that their stated error holds. Memory:
/// the tile and twice the file.
EncodedTile encode_tile(bake::BakedTile tile, const scene::Header& header, const GlbOptions& options, int threads,
                        Layout layout = Layout::kEmbedded);

/// Returns the path of a tile's file in a run's folder: "glb/3_-2_L0.glb".
std::string glb_name(scene::TileKey tile, std::size_t level);

/// Returns the number of triangles of a baked tile, with those of every instance.
std::uint64_t triangles_of(const bake::BakedTile& tile);
std::uint64_t instances_of(const bake::BakedTile& tile);

}  // namespace citykiln::exporters
