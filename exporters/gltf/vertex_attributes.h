// A primitive as glTF stores it: one array per attribute, and indices. Mesh codecs read and write it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace citykiln::exporters {

/// glTF's component types, by its numbers.
enum class Component : int {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

inline std::size_t bytes_of(Component component) {
  if (component == Component::kByte || component == Component::kUnsignedByte) return 1;
  return component == Component::kShort || component == Component::kUnsignedShort ? 2 : 4;
}

/// The component type and the number of components of an element, which is a number or an array of numbers.
template <typename T>
struct ElementType {
  static constexpr Component kComponent = std::is_same_v<T, float> ? Component::kFloat
                                          : sizeof(T) == 1         ? Component::kUnsignedByte
                                          : sizeof(T) == 2         ? Component::kUnsignedShort
                                                                   : Component::kUnsignedInt;
  static constexpr std::size_t kWidth = 1;
};
template <typename T, std::size_t N>
struct ElementType<std::array<T, N>> : ElementType<T> {
  static constexpr std::size_t kWidth = N;
};

/// One attribute: the bytes of its elements in sequence.
struct VertexAttribute {
  std::string name;  ///< "POSITION"
  Component component = Component::kFloat;
  std::size_t width = 3;  ///< Components per element, which is padded to a multiple of four bytes.
  std::vector<unsigned char> bytes;
  bool operator==(const VertexAttribute&) const = default;
};

inline std::size_t stride_of(const VertexAttribute& attribute) {
  return (attribute.width * bytes_of(attribute.component) + 3) / 4 * 4;
}

/// True if the values of an attribute are unit vectors.
inline bool is_direction(const VertexAttribute& attribute) {
  return attribute.name == "NORMAL" || attribute.name == "TANGENT";
}

struct MeshArrays {
  std::size_t count = 0;                    ///< The number of vertices.
  std::vector<VertexAttribute> attributes;  ///< Each with `count` elements.
  std::vector<std::uint32_t> indices;       ///< Three per triangle, each less than count.
};

/// The components of an attribute as whole multiples of 2^exponent.
struct Steps {
  int exponent = 0;
  std::vector<std::int32_t> counts;  ///< Signed, at most 24 bits.
};

/// Returns the values of an attribute with the largest possible exponent, at most 0. Returns std::nullopt unless they
/// are positions, uvs or feature ids in single precision, multiples of 2^-10, and fit.
std::optional<Steps> steps_of(const VertexAttribute& attribute);

}  // namespace citykiln::exporters
