// glTF 2.0, binary: one tile at one tolerance. Only here the z-up frame becomes y-up (glb_axes.h).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "exporters/gltf/compression.h"

namespace citykiln::exporters {

/// How instances are written: by EXT_mesh_gpu_instancing (small; three.js, Cesium, glTFast), or by one node each
/// (Blender, Godot).
enum class Instancing { kExtension, kNodes };

/// Returns the .glb of a tile.
///
/// | data                | glTF                                                                                       |
/// |---------------------|--------------------------------------------------------------------------------------------|
/// | primitives          | one mesh, one primitive per key, or more where 16 bits cannot number the vertices of one   |
/// | instances           | as `instancing` says                                                                       |
/// | features            | _FEATURE_ID_0 (EXT_mesh_features, EXT_instance_features) into a property table of UINT64   |
/// |                     | OSM ids and UINT8 element types (EXT_structural_metadata)                                  |
/// | origin, tolerances, | the root node's extras: tile, origin_m (doubles), tolerance_m, error_m, plant_error_m,     |
/// | errors              | rounding_m (largest error of single precision), plane, and viewpoint, if baked for one     |
/// | attribution         | asset.copyright                                                                            |
/// | uvs                 | TEXCOORD_0, metres                                                                         |
/// | images              | PNG in the buffer, each once, scaled to metres by KHR_texture_transform; row 0 is v = 0    |
/// | normal maps         | with TANGENT                                                                               |
///
/// Guarantees: same input, same bytes, for any number of threads; valid by Khronos' validator with 0 errors and 0
/// warnings. A packed .glb holds quantised(tile) (quantise.h) and states its error; but by kQuantize its vertices and
/// triangles are in another order; its normals have kPackedNormalBits.
std::vector<std::byte> encode_glb(const bake::BakedTile& tile, const scene::Header& header, Instancing instancing,
                                  Compression compression = Compression::kNone, int threads = 1);

/// Reads a tile from a .glb that encode_glb wrote, packed or not. decode_glb(encode_glb(tile)) == tile for both ways of
/// instancing, where it is not packed. Errors: anything else; never a crash, whatever the bytes (fuzzed).
/// @param name  The file's name in error messages.
Result<bake::BakedTile> decode_glb(std::span<const std::byte> bytes, const std::string& name);

Result<Done> write_glb(const bake::BakedTile& tile, const scene::Header& header, Instancing instancing,
                       const std::string& path, Compression compression = Compression::kNone, int threads = 1);
Result<bake::BakedTile> read_glb(const std::string& path);

}  // namespace citykiln::exporters
