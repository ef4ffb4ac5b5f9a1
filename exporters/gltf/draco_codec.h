// KHR_draco_mesh_compression: a primitive as one run of bytes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

inline constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";

struct DracoMesh {
  std::vector<unsigned char> bytes;
  std::vector<int> ids;                  ///< Draco's id of each attribute, in the mesh's order.
  std::size_t count = 0, triangles = 0;  ///< As decoded: vertices may be more or fewer than before.
};

/// Packs a mesh; vertices and triangles change their order. Normals are octahedral with kPackedNormalBits, tangents
/// multiples of 2^-7; attributes on the grids of packed meshes stay exact, as do all others. Every triangle is kept,
/// even where its corners coincide. Returns nothing where Draco refuses the mesh, which then stays unpacked.
std::optional<DracoMesh> encode_draco(const MeshArrays& mesh);

/// Unpacks a mesh; returns nothing where the bytes are invalid.
/// @param wanted  The attributes, without bytes. @param ids  One per attribute.
std::optional<MeshArrays> decode_draco(std::span<const unsigned char> bytes, std::vector<VertexAttribute> wanted,
                                       std::span<const int> ids);

}  // namespace citykiln::exporters
