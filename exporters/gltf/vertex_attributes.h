// A primitive as glTF keeps it: an array for each attribute, and indices. What codecs take and give.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace citykiln::exporters {

/// glTF's own numbers.
enum class Component : int {
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

inline std::size_t bytes_of(Component component) {
  if (component == Component::kUnsignedByte) return 1;
  return component == Component::kShort || component == Component::kUnsignedShort ? 2 : 4;
}

/// One attribute, element after element.
struct VertexAttribute {
  std::string name;  ///< "POSITION"
  Component component = Component::kFloat;
  std::size_t width = 3;  ///< Numbers an element. An element takes whole multiples of four bytes.
  std::vector<unsigned char> bytes;
  bool operator==(const VertexAttribute&) const = default;
};

inline std::size_t stride_of(const VertexAttribute& stream) { return stream.width * bytes_of(stream.component); }

struct MeshArrays {
  std::size_t count = 0;                 ///< Vertices.
  std::vector<VertexAttribute> streams;  ///< Each with `count` elements.
  std::vector<std::uint32_t> indices;    ///< Three a triangle, each below count.
};

/// The numbers of an attribute as whole steps of 2 to the power of `exponent`.
struct Steps {
  int exponent = 0;
  std::vector<std::int32_t> counts;  ///< In 24 bits with their signs.
};

/// For places, uvs and feature ids in single precision that all lie on the grid of packed meshes (compression.h).
std::optional<Steps> steps_of(const VertexAttribute& stream);

}  // namespace citykiln::exporters
