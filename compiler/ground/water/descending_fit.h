// Heights that never rise downstream, as near to given ones as that lets them.
//
//   given  •                          Pits and spikes of the land are few against the river beside them, so neither
//           •  •                      does a pit sink what lies downstream of it, nor a spike lift what lies upstream.
//            •    •   •
//   found  ‾‾\____/‾‾\_____           (below costs less than above: the river cuts through a spike)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace citykiln::ground {

/// One given height of a node, and what a metre below and above it costs. Both > 0; all costs together under 2^62.
struct WeightedHeight {
  double height_m = 0;
  std::int64_t below = 0, above = 0;
};

/// A network without cycles.
struct FlowGraph {
  std::vector<std::vector<WeightedHeight>> pulls;      ///< By node, at least one each.
  std::vector<std::vector<std::uint32_t>> downstream;  ///< By node: its lower neighbours, each of a lower number.
  std::vector<bool> is_sea;                            ///< Nodes that keep the height 0.
};

/// A height for each node.
///
/// Guarantees: no node lies lower than one downstream of it; sea lies at 0. Where every node has one neighbour
/// downstream at most, the sum of costs is the least possible (of several such, the lowest); where rivers part, each
/// follows its lowest-numbered neighbour, and the other arms are lowered to their beginning where they must.
/// O(n log² n).
/// Source: isotonic regression on a rooted tree by mergeable heaps of slope changes (slope trick): Stout, "Isotonic
/// regression via partitioning", 2013, for the problem; heights are weighted quantiles of what they pool.
std::vector<double> fit_descending(const FlowGraph& flow);

}  // namespace citykiln::ground
