// Fits heights that never rise downstream to given heights.
//
//   given  •                          Pits and spikes of the terrain are short against the river beside them: a pit
//           •  •                      does not lower what lies downstream of it, nor a spike raise what lies
//            •    •   •               upstream. Water below the terrain costs less than above: the river cuts
//   found  ‾‾\____/‾‾\_____           through spikes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace citykiln::ground {

/// A given height of a node and the cost per metre below and above it. Both > 0; all costs together below 2^62.
struct WeightedHeight {
  double height_m = 0;
  std::int64_t below = 0, above = 0;
};

/// A flow network without cycles.
struct FlowGraph {
  std::vector<std::vector<WeightedHeight>> given;      ///< By node, at least one each.
  std::vector<std::vector<std::uint32_t>> downstream;  ///< By node: its lower neighbours, each with a lower number.
  std::vector<bool> is_sea;                            ///< Nodes that keep the height 0.
};

/// Returns a height per node.
///
/// Guarantees: no node lies lower than one downstream of it; sea lies at 0. Where every node has at most one neighbour
/// downstream, the sum of costs is the least possible and, of equals, the heights are the lowest. Where rivers part, a
/// node's cost counts for its lowest-numbered neighbour, and other arms are lowered to their beginning. O(n log² n).
/// Source: isotonic regression on a rooted tree (problem: Stout, "Isotonic regression via partitioning", 2013) by
/// mergeable heaps of slope changes ("slope trick"). Heights are weighted quantiles of the terrain that they are pooled
/// from.
std::vector<double> fit_descending(const FlowGraph& flow);

}  // namespace citykiln::ground
