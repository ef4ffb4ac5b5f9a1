// Writes .usdz files: a layer and its textures in one zip archive without compression.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Returns a tile as one file: its layer, "tile.usdc" (encode_level.h), and "textures/…", in a zip archive without
/// compression. The data of each file begin at a multiple of 64 bytes; dates are constant. Coordinates are in the
/// tile's frame; its origin is in customData only. Error: more than 4 GB. Source: OpenUSD, "Usdz File Format
/// Specification"; PKWARE, APPNOTE.TXT 6.3.
Result<std::vector<std::byte>> encode_usdz(const bake::BakedTile& tile, const scene::Header& header);

}  // namespace citykiln::exporters
