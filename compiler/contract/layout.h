// The place of prototypes (the meshes of plants and lamps) and images: in each .glb, or in files that tiles share.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln {

/// The value of --layout.
enum class Layout : std::uint8_t {
  kEmbedded,  ///< In the .glb.
  kShared     ///< In files in glb/shared (exporters/gltf/pack/shared_layout.h).
};

inline constexpr std::array<std::string_view, 2> kLayoutNames = {"embedded", "shared"};

inline std::string_view name_of(Layout layout) { return kLayoutNames[static_cast<std::size_t>(layout)]; }

inline std::optional<Layout> layout_named(std::string_view name) {
  for (std::size_t i = 0; i < kLayoutNames.size(); ++i)
    if (kLayoutNames[i] == name) return static_cast<Layout>(i);
  return std::nullopt;
}

}  // namespace citykiln
