// KHR_draco_mesh_compression: packs a primitive into one buffer view, and unpacks it.
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
  std::vector<int> ids;  ///< Draco's id of each attribute, in the mesh's order.
  /// Vertices and triangles after decoding. Vertices may be more or fewer than in the mesh.
  std::size_t count = 0, triangles = 0;
};

/// Packs a mesh; vertices and triangles change their order. Normals become octahedral with kPackedNormalBits, tangents
/// multiples of 2^-7; all other attributes stay exact. Keeps every triangle, even one whose corners coincide. Returns
/// std::nullopt if Draco refuses the mesh, which then stays unpacked.
std::optional<DracoMesh> encode_draco(const MeshArrays& mesh);

/// Unpacks a mesh; returns std::nullopt if the bytes are invalid.
///
/// @param wanted  The attributes to unpack, without bytes.
/// @param ids     The Draco id of each of these attributes.
std::optional<MeshArrays> decode_draco(std::span<const unsigned char> bytes, std::vector<VertexAttribute> wanted,
                                       std::span<const int> ids);

}  // namespace citykiln::exporters
