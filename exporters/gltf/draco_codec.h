// KHR_draco_mesh_compression: a primitive as one stream of bytes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

struct DracoMesh {
  std::vector<unsigned char> bytes;
  std::vector<int> ids;                  ///< Draco's own of each stream, in their order.
  std::size_t count = 0, triangles = 0;  ///< As decoded: vertices may be more or fewer than they were.
};

/// Vertices and triangles in another order. Normals are on kPackedNormalBits of an octahedron, tangents in steps of
/// 2^-11; all else is as it was, for numbers on the grid of packed meshes are packed as such. No triangle is left out,
/// even where its corners are one place. Nothing: Draco will not have it; then it stays as it is.
std::optional<DracoMesh> encode_draco(const MeshArrays& mesh);

/// The mesh that was encoded; `wanted` are streams without bytes. Nothing: the bytes are not what they say.
std::optional<MeshArrays> decode_draco(std::span<const unsigned char> bytes, std::vector<VertexAttribute> wanted,
                                       std::span<const int> ids);

}  // namespace citykiln::exporters
