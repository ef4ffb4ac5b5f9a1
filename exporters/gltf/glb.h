// Writes one tile at one tolerance as a .glb (glTF 2.0, binary), and reads it. The plane's z-up frame becomes y-up
// (glb_axes.h).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/place_lamps.h"
#include "compiler/contract/node_split.h"
#include "compiler/contract/result.h"
#include "compiler/contract/system/compression.h"
#include "compiler/contract/target.h"

namespace citykiln::exporters {

struct GlbParts;  // glb_parts.h, with the JSON library

/// How a tile is written.
struct GlbOptions {
  Target target = Target::kGeneric;
  NodeSplit split = NodeSplit::kLayer;
  Compression compression = Compression::kNone;  ///< Must be one that the target's reader supports.
  bool has_exact_pictures = false;               ///< Images are PNG only, even if the target's reader supports more.
  std::span<const bake::PlacedLamp> lights{};    ///< Lamps to write as lights (encode_lights.h), at any time of day.
  bool is_on_ellipsoid = false;  ///< The tile is bent (bake/far/bend.h): extras name its frame instead of the plane.
};

/// Returns the .glb of a tile.
///
/// | data                | glTF                                                                                       |
/// |---------------------|--------------------------------------------------------------------------------------------|
/// | primitives          | nodes by layer, tile or building (encode_glb.cpp), one primitive per key                   |
/// | instances           | a node each, or EXT_mesh_gpu_instancing, as the target's reader knows                      |
/// | lights              | KHR_lights_punctual (encode_lights.h); read_glb skips them                                 |
/// | features            | _FEATURE_ID_0 (EXT_mesh_features, EXT_instance_features) into a property table             |
/// |                     | (property_table.h, EXT_structural_metadata)                                                |
/// | origin, tolerances, | the root node's extras: tile, origin_m (doubles), tolerance_m, error_m, plant_error_m,     |
/// | errors              | rounding_m (largest error of single precision), plane, and viewpoint, if baked for one;    |
/// |                     | frame instead of plane for tiles on the ellipsoid or inside of a cylinder                  |
/// | attribution         | asset.copyright                                                                            |
/// | uvs                 | TEXCOORD_0 in units of the image, row 0 is v = 0. In packed meshes metres, on textures 16  |
/// |                     | bits in steps of materials::kTextureCoordinateStep_m, scaled by KHR_texture_transform      |
/// | images              | JPEG or WebP for opaque colours, else PNG or WebP (picture_formats.h), each once; the size |
/// |                     | of a texel is in its extras                                                                |
/// | normal maps         | with TANGENT                                                                               |
/// | colours             | COLOR_0; of plants shares of the largest tint, which is a factor of the material           |
/// |                     | (plant_tints.h); left out where all are white                                              |
///
/// @param tile  Its primitives and instanced meshes are sorted by layer.
///
/// Guarantees: deterministic for any number of threads; Khronos' validator reports 0 errors and 0 warnings. Vertices
/// and triangles of a packed .glb are reordered, and its normals have kPackedNormalBits. Values that are not on the
/// grids of quantise.h stay in single precision, so encode_tile() quantises first.
std::vector<std::byte> encode_glb(const bake::BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                                  int threads = 1);

/// Returns the result of encode_glb() before its parts are joined.
GlbParts build_glb(const bake::BakedTile& tile, const scene::Header& header, const GlbOptions& options, int threads);

/// Reads a tile from a .glb that encode_glb wrote, for any target. decode_glb(encode_glb(tile)) == tile if the file is
/// not packed and has exact pictures, if the target has no shades_flat, and for NodeSplit::kBuilding if features ascend
/// in the primitives of buildings, as bake() writes them. Targets with shades_flat leave the normals of flat meshes out
/// (flat_shading.h), which then read as those of their faces, with vertices in another order. Errors: bytes that
/// encode_glb() does not write. No bytes make the function crash (fuzzed).
/// @param name  The name of the file in error messages.
Result<bake::BakedTile> decode_glb(std::span<const std::byte> bytes, const std::string& name);

/// Writes the result of encode_glb() to a file. Error: a file that cannot be written.
Result<Done> write_glb(const bake::BakedTile& tile, const scene::Header& header, const GlbOptions& options,
                       const std::string& path, int threads = 1);
/// Reads a file that write_glb() or a run wrote, with the files of shared images beside it. Errors: files that cannot
/// be read; those of decode_glb().
Result<bake::BakedTile> read_glb(const std::string& path);

}  // namespace citykiln::exporters
