// EXT_meshopt_compression: packs attributes and indices as arrays. Arrays of one kind can share a buffer view.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression";

/// The way a buffer view is packed, in the extension's terms. Arrays of one kind can follow each other in one view.
struct MeshoptKind {
  std::size_t stride = 0;           ///< Bytes per decoded element.
  std::string mode = "ATTRIBUTES";  ///< "ATTRIBUTES" or "TRIANGLES".
  std::string filter = "NONE";      ///< "NONE", "OCTAHEDRAL" or "EXPONENTIAL".
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
  std::size_t count = 0;  ///< The number of elements.
  std::vector<unsigned char> bytes;
};

struct MeshoptMesh {
  std::vector<MeshoptArray> attributes;  ///< In the mesh's order.
  std::vector<Component> components;     ///< The component type of each decoded attribute.
  MeshoptArray indices;
  std::size_t count = 0;  ///< The number of vertices.
};

/// Prepares a mesh for packing. Reorders vertices and triangles for the caches of graphics cards, which also packs
/// best. Normals and tangents become octahedral, with kPackedNormalBits per component; all other attributes stay exact.
/// @param index_stride  Bytes per index in the file: 2 or 4.
MeshoptMesh meshopt_arrays(MeshArrays mesh, std::size_t index_stride);

/// Packs an array.
///
/// @param vertices  The number of vertices. Indices must be less than it.
MeshoptView encode_meshopt(const MeshoptArray& array, std::size_t vertices);

/// Unpacks a view into the elements that a reader of the file sees. Returns std::nullopt if the bytes are invalid or
/// too few for the count.
std::optional<std::vector<unsigned char>> decode_meshopt(const MeshoptView& view);

/// True if a view of this kind can hold an attribute.
bool can_hold(const MeshoptKind& kind, const VertexAttribute& attribute);

}  // namespace citykiln::exporters
