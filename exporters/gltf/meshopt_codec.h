// EXT_meshopt_compression: attributes and indices as arrays, many of which one buffer view can hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression";

/// How a buffer view is packed, in the extension's terms. Arrays of one kind can follow each other in one view.
struct MeshoptKind {
  std::size_t stride = 0;           ///< Bytes of a decoded element.
  std::string mode = "ATTRIBUTES";  ///< Or "TRIANGLES".
  std::string filter = "NONE";      ///< Or "OCTAHEDRAL", "EXPONENTIAL".
  auto operator<=>(const MeshoptKind&) const = default;
};

/// Elements before they are packed: filtered attributes, or indices.
struct MeshoptArray {
  MeshoptKind kind;
  std::vector<unsigned char> bytes;
};

/// A packed buffer view.
struct MeshoptView {
  MeshoptKind kind;
  std::size_t count = 0;  ///< Of elements.
  std::vector<unsigned char> bytes;
};

struct MeshoptMesh {
  std::vector<MeshoptArray> attributes;  ///< In the mesh's order.
  std::vector<Component> components;     ///< Of the decoded data.
  MeshoptArray indices;
  std::size_t count = 0;  ///< Of vertices.
};

/// Prepares a mesh: vertices and triangles are reordered for the caches of graphics cards, which also packs best.
/// Normals and tangents become octahedral, with kPackedNormalBits per component; all other attributes stay exact.
/// @param index_stride  Bytes of an index in the file: 2 or 4.
MeshoptMesh meshopt_arrays(MeshArrays mesh, std::size_t index_stride);

/// Packs an array. @param indices  Each less than `vertices`.
MeshoptView encode_meshopt(const MeshoptArray& array, std::size_t vertices);

/// Unpacks a view; its elements as a reader of the file sees them. Returns nothing where the bytes are invalid, or the
/// count is larger than they can hold.
std::optional<std::vector<unsigned char>> decode_meshopt(const MeshoptView& view);

/// Whether a view of this kind can hold an attribute.
bool can_hold(const MeshoptKind& kind, const VertexAttribute& attribute);

}  // namespace citykiln::exporters
