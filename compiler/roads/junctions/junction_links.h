// Links: parts of roads from one node to the next. A node is a place where roads meet; an arm is a road that leaves a
// node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/roads/network.h"

namespace citykiln::roads {

inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// The link from an arm's node to the next node of its family, or to the end of its road.
struct Link {
  double length_m = 0;
  std::uint32_t node = kNoNode;  ///< The node at its other end.
  std::uint32_t arm = 0;         ///< The index of the arm at the link's other end, among that node's arms.
};

/// Finds the next node along a road. Refers to roads and nodes, which must outlive it.
class NodeIndex {
 public:
  NodeIndex(std::span<const Road> roads, std::span<const Node> nodes);

  /// Returns the link that begins with an arm. A link longer than `max_m` is not followed to its end: its length is
  /// then greater than max_m, and it has no node. O(vertices passed).
  Link link_of(const Arm& arm, double max_m) const;

 private:
  std::span<const Road> roads_;
  std::span<const Node> nodes_;
  std::vector<std::uint32_t> first_;  // of each road, into node_at_
  std::vector<std::uint32_t> node_at_;
};

}  // namespace citykiln::roads
