// Rigid units: sets of nodes of the profile graph whose heights change together. A unit is all nodes of one junction
// plane (the plane on which a junction's roads lie), or a single other node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

struct RigidUnits {
  std::vector<std::uint32_t> of;     ///< The unit of each node.
  std::vector<std::uint32_t> first;  ///< For each unit, and for the end, an offset into `nodes`.
  std::vector<std::uint32_t> nodes;

  /// Numbers the units in the order of their first nodes. O(n).
  explicit RigidUnits(const ProfileGraph& graph);

  std::uint32_t count() const { return static_cast<std::uint32_t>(first.size() - 1); }
  /// The nodes of a unit.
  std::span<const std::uint32_t> members(std::uint32_t unit) const {
    return std::span(nodes).subspan(first[unit], first[unit + 1] - first[unit]);
  }
};

}  // namespace citykiln::ground
