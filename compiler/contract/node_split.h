// How the mesh of a tile is divided into the nodes of a .glb.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln {

/// The value of --split.
enum class NodeSplit : std::uint8_t {
  kTile,     ///< One node for everything that is not instanced.
  kLayer,    ///< One node per layer (bake/layer.h), below the tile's node.
  kBuilding  ///< Like kLayer, with one node per building below the layer of buildings.
};

inline constexpr std::array<std::string_view, 3> kNodeSplitNames = {"tile", "layer", "building"};

inline std::string_view name_of(NodeSplit split) { return kNodeSplitNames[static_cast<std::size_t>(split)]; }

inline std::optional<NodeSplit> node_split_named(std::string_view name) {
  for (std::size_t i = 0; i < kNodeSplitNames.size(); ++i)
    if (kNodeSplitNames[i] == name) return static_cast<NodeSplit>(i);
  return std::nullopt;
}

}  // namespace citykiln
