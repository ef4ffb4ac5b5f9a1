// The compression of meshes in a .glb.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln {

/// The value of --compress.
enum class Compression : std::uint8_t {
  kNone,
  kLean,      ///< KHR_mesh_quantization of normals and uvs alone; positions stay exact, and nodes without a scale.
  kQuantize,  ///< KHR_mesh_quantization, of positions too: nodes scale their meshes.
  kDraco,     ///< KHR_draco_mesh_compression, the smallest.
  kMeshopt    ///< EXT_meshopt_compression with KHR_mesh_quantization, the fastest to unpack.
};

inline constexpr std::array<std::string_view, 5> kCompressionNames = {"none", "lean", "quantize", "draco", "meshopt"};

inline std::string_view name_of(Compression compression) {
  return kCompressionNames[static_cast<std::size_t>(compression)];
}

inline std::optional<Compression> compression_named(std::string_view name) {
  for (std::size_t i = 0; i < kCompressionNames.size(); ++i)
    if (kCompressionNames[i] == name) return static_cast<Compression>(i);
  return std::nullopt;
}

}  // namespace citykiln
