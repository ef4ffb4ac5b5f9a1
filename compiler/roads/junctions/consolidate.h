// Merges nodes that a driver takes for one junction. A node is a place where roads meet; a link is the part of a road
// from one node to the next; an arm is a road that leaves a node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/roads/network.h"

namespace citykiln::roads {

// Links: parts of roads from one node to the next. A node is a place where roads meet; an arm is a road that leaves a
// node.

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

/// Returns the group of each node, as the index of the group's first node.
///
/// Two nodes merge if a link between them
/// - has no length left between their corners;
/// - joins two street junctions and has less than a car's length left;
/// - crosses the median of a dual carriageway, and is no longer than one and a half times the wider carriageway;
/// - encloses an island with a second link between the same nodes. Street junctions have three arms of residential or
/// higher class. Driveways, car parks, paths, roundabout rings and circular nodes merge by the first rule only.
///
/// Each of three rounds merges the pairs of groups that are each other's nearest, so a group has at most eight nodes
/// and its content depends on a bounded neighbourhood. A group fits into a square of kJunctionRadius_m. Diagnosed:
/// kJunctionsMerged. O(nodes).
std::vector<std::uint32_t> consolidate(std::span<const Road> roads, std::span<const Node> nodes, const NodeIndex& index,
                                       Report& report);

}  // namespace citykiln::roads
