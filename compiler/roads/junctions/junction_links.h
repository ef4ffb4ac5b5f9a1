// From one junction to the next: who is at the other end of an arm, and how far.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/roads/network.h"

namespace citykiln::roads {

inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// An arm's way to the next node of its family, or to its road's end.
struct Link {
  double length_m = 0;
  std::uint32_t node = kNoNode;  ///< The node it comes to.
  std::uint32_t arm = 0;         ///< Of that node: the same stretch seen from there.
};

/// Which node each vertex of each road is.
class NodeIndex {
 public:
  NodeIndex(std::span<const Road> roads, std::span<const Node> nodes);

  /// O(vertices passed), at most until `reach_m` are walked: then the length is more than that and the node unknown.
  Link link_of(const Arm& arm, double reach_m) const;

 private:
  std::span<const Road> roads_;
  std::span<const Node> nodes_;
  std::vector<std::uint32_t> first_;  // of each road, into node_at_
  std::vector<std::uint32_t> node_at_;
};

}  // namespace citykiln::roads
