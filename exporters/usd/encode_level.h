// Writes one tile at one tolerance as a USD layer, with its textures.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// The form of a layer. Crates (binary) are half the size and several times faster to read (usd.md); text is for
/// people and tests.
enum class UsdForm { kText, kCrate };

/// A layer with its textures.
struct UsdLevel {
  std::vector<std::byte> layer;
  std::vector<UsdFile> textures;  ///< Names contain a hash of the bytes: equal names mean equal bytes.
  UsdBounds bounds;  ///< In the tile's frame. Instances count as the boxes around their prototypes' turned boxes.
};

/// Returns the layer of a tile. It has the content of the tile's .glb, in metres from the tile's origin, z up.
///
///     /tile                      customData: tile, origin_m, tolerance_m, error_m, plant_error_m, lon_0, lat_0
///       ground, roads, water …   an Xform for each layer (bake/layer.h) with a Mesh for each material,
///         Asphalt …              and a PointInstancer (usd_meshes.h)
///         instances/meshes
///       materials                usd_materials.h
///       features                 a table: one array attribute for each column
///
/// @param tile  Its primitives and instanced meshes are sorted by layer.
/// @param texture_folder  The path from the layer, with a slash at the end: "../textures/".
/// Guarantees: deterministic; both forms have the same content. Memory: the size of the file.
UsdLevel encode_level(const bake::BakedTile& tile, const scene::Header& header, const std::string& texture_folder,
                      UsdForm form = UsdForm::kCrate);

}  // namespace citykiln::exporters
