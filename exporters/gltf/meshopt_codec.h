// EXT_meshopt_compression: each attribute and the indices as a stream of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// A compressed buffer view, in the extension's words.
struct MeshoptView {
  std::vector<unsigned char> bytes;
  std::size_t count = 0, stride = 0;  ///< Of what it decodes to.
  std::string mode = "ATTRIBUTES";    ///< Or "TRIANGLES".
  std::string filter = "NONE";        ///< Or "OCTAHEDRAL", "EXPONENTIAL".
};

struct MeshoptAttribute {
  std::string name;
  Component component{};  ///< Of what it decodes to.
  std::size_t width = 0;
  MeshoptView view;
};

struct MeshoptMesh {
  std::vector<MeshoptAttribute> streams;  ///< In the mesh's order.
  MeshoptView indices;
};

/// Vertices and triangles in another order (for the caches of graphics cards, which also is what packs best).
/// Normals and tangents become 16 bits a number, on kPackedNormalBits of an octahedron; all else is as it was. Numbers
/// on the grid of packed meshes are packed as such. @param index_stride  2 or 4.
MeshoptMesh encode_meshopt(MeshArrays mesh, std::size_t index_stride);

/// What a stream was, normals and tangents in single precision and of unit length. Nothing: the bytes are not what they
/// say, or claim more than so few can hold.
std::optional<VertexAttribute> decode_meshopt(const MeshoptAttribute& stream);
std::optional<std::vector<std::uint32_t>> decode_meshopt_indices(const MeshoptView& view);

}  // namespace citykiln::exporters
