// The finished graph of streets: edges between junctions, and the blocks between edges.
#pragma once

#include "compiler/invent/town/streets/street_graph.h"

namespace citykiln::invent {

inline constexpr std::uint32_t kNoBlock = 0xffffffffu;

/// A part of one street without junctions inside.
struct StreetEdge {
  std::vector<std::uint32_t> vertices;  ///< Two or more, in order.
  Polyline axis;                        ///< Their positions.
  std::uint32_t street = 0;
  bool is_bridge = false;
  std::uint32_t left_block = kNoBlock, right_block = kNoBlock;  ///< Indices of StreetBlocks::rings.
};

/// Closed walks about the land between streets.
struct StreetBlocks {
  /// Counter-clockwise, along axes of streets; walks along dead ends and back are left out. Land that streets do not
  /// enclose has an empty ring.
  std::vector<Ring> rings;
  std::vector<char> has_dead_end;  ///< For each ring: 1 if a dead end lies in it.
};

/// Returns the edges, in the order of their first segments. An edge ends at a junction, at a dead end, where a bridge
/// begins or ends, and where another street begins.
std::vector<StreetEdge> street_edges(const StreetGraph& graph);

/// Returns the blocks of a graph, and fills the blocks of edges.
/// Cost: O(n log n).
StreetBlocks street_blocks(const StreetGraph& graph, std::vector<StreetEdge>& edges);

/// Removes what is not connected to the largest connected part.
void keep_largest_part(StreetGraph& graph);

}  // namespace citykiln::invent
