// glTF 2.0, binary: one tile at one tolerance. y-up is made here and nowhere else.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "exporters/gltf/compression.h"

namespace citykiln::exporters {

/// How shared meshes are placed: by EXT_mesh_gpu_instancing (small; three.js, Cesium, glTFast), or by a node each
/// (Blender, Godot).
enum class Instancing { kExtension, kNodes };

/// The material under which a primitive is written: "Asphalt"; "AsphaltMarked" where it is on the sheet,
/// "PaintFacade" on the atlas, "BroadLeafCutout" on a cutout (alphaMode MASK, both sides); "AsphaltUntextured" where it
/// has no uvs, and Asphalt has one of the tile's textures.
std::string material_name(const bake::PrimitiveKey& key, std::span<const materials::Texture> textures);

/// One glTF mesh whose primitives are merged by key; instances as asked; features as _FEATURE_ID_0
/// (EXT_mesh_features, EXT_instance_features) into a property table of UINT64 OSM ids and UINT8 element types
/// (EXT_structural_metadata); the tile's origin as doubles, error, tolerance, tile and the worst rounding to
/// single precision in the root node's extras, and for which eye it was made, if for one; attribution in
/// asset.copyright; uvs as TEXCOORD_0, metres, or on textures 16 bits in steps of materials::kTextureCoordinateStep_m;
/// the sheet, the atlas and the textures as PNGs inside, shown with KHR_texture_transform from there to the picture:
/// its row 0, v = 0, is the picture's top; each cutout once, for all shapes that have the same; TANGENT where there are
/// normals. Same input, same bytes. Valid by Khronos' validator with 0 errors and 0 warnings. Packed, it holds
/// quantised(tile) (quantise.h), whose error it states, vertices and triangles in another order, and normals of
/// kPackedNormalBits. @param threads  Never changes a byte.
std::vector<std::byte> encode_glb(const bake::BakedTile& tile, const scene::Header& header, Instancing instancing,
                                  Compression compression = Compression::kNone, int threads = 1);

/// A tile back from a .glb that encode_glb made, packed or not; read(encode(tile)) == tile for either way of instancing
/// where it is not packed.
/// Errors: anything else, never a crash.
Result<bake::BakedTile> decode_glb(std::span<const std::byte> bytes, const std::string& name);

Result<Done> write_glb(const bake::BakedTile& tile, const scene::Header& header, Instancing instancing,
                       const std::string& path, Compression compression = Compression::kNone, int threads = 1);
Result<bake::BakedTile> read_glb(const std::string& path);

}  // namespace citykiln::exporters
