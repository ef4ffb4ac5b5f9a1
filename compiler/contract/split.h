// How the mesh of a tile is divided into the nodes of a .glb.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln {

/// The value of --split.
enum class Split : std::uint8_t {
  kTile,     ///< One node for everything that is not instanced.
  kLayer,    ///< One node per layer (bake/layer.h), below the tile's node.
  kBuilding  ///< Like kLayer, with one node per building below the layer of buildings.
};

inline constexpr std::array<std::string_view, 3> kSplitNames = {"tile", "layer", "building"};

inline std::string_view name_of(Split split) { return kSplitNames[static_cast<std::size_t>(split)]; }

inline std::optional<Split> split_named(std::string_view name) {
  for (std::size_t i = 0; i < kSplitNames.size(); ++i)
    if (kSplitNames[i] == name) return static_cast<Split>(i);
  return std::nullopt;
}

}  // namespace citykiln
