// EXT_meshopt_compression: each attribute and the indices as a buffer view of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

/// A compressed buffer view, in the extension's terms.
struct MeshoptView {
  std::vector<unsigned char> bytes;
  std::size_t count = 0, stride = 0;  ///< Of the decoded data.
  std::string mode = "ATTRIBUTES";    ///< Or "TRIANGLES".
  std::string filter = "NONE";        ///< Or "OCTAHEDRAL", "EXPONENTIAL".
};

struct MeshoptAttribute {
  std::string name;
  Component component{};  ///< Of the decoded data.
  std::size_t width = 0;
  MeshoptView view;
};

struct MeshoptMesh {
  std::vector<MeshoptAttribute> attributes;  ///< In the mesh's order.
  MeshoptView indices;
};

/// Packs a mesh; vertices and triangles are reordered for the caches of graphics cards, which also packs best. Normals
/// and tangents become octahedral, with kPackedNormalBits per component; all other attributes stay exact.
/// @param index_stride  Bytes of an index in the file: 2 or 4.
MeshoptMesh encode_meshopt(MeshArrays mesh, std::size_t index_stride);

/// Unpacks an attribute, normals and tangents in 8 bits per component. Returns nothing where the bytes are invalid, or
/// the count is larger than they can hold.
std::optional<VertexAttribute> decode_meshopt(const MeshoptAttribute& attribute);
std::optional<std::vector<std::uint32_t>> decode_meshopt_indices(const MeshoptView& view);

}  // namespace citykiln::exporters
