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
  kQuantize,  ///< KHR_mesh_quantization, integers of 8 and 16 bits, which graphics cards read directly.
  kDraco,     ///< KHR_draco_mesh_compression, the smallest.
  kMeshopt    ///< EXT_meshopt_compression with KHR_mesh_quantization, the fastest to unpack.
};

inline constexpr std::array<std::string_view, 4> kCompressionNames = {"none", "quantize", "draco", "meshopt"};

inline std::string_view name_of(Compression compression) {
  return kCompressionNames[static_cast<std::size_t>(compression)];
}

inline std::optional<Compression> compression_named(std::string_view name) {
  for (std::size_t i = 0; i < kCompressionNames.size(); ++i)
    if (kCompressionNames[i] == name) return static_cast<Compression>(i);
  return std::nullopt;
}

}  // namespace citykiln
