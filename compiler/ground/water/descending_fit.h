// Fits heights that never rise downstream to given heights.
//
//   • given     •                  Pits and spikes of the terrain are short compared with the river beside them: a
//   _ found                         pit does not lower the river downstream of it, nor a spike raise it upstream.
//   •_•____ _•____ _•___•__         Water below the terrain costs less than water above it, so rivers cut through
//          •      •        •_•      spikes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace citykiln::ground {

/// A height that a node should have, and the costs of a metre of the result below it and above it. Both costs are > 0;
/// the sum of all costs must be below 2^62.
struct WeightedHeight {
  double height_m = 0;
  std::int64_t below = 0, above = 0;
};

/// A network of watercourses without cycles.
struct FlowGraph {
  std::vector<std::vector<WeightedHeight>> given;      ///< For each node its given heights, at least one.
  std::vector<std::vector<std::uint32_t>> downstream;  ///< For each node its downstream neighbours, of lower number.
  std::vector<bool> is_sea;                            ///< Nodes that keep the height 0.
};

/// Returns a height per node.
///
/// Guarantees: no node is lower than a node downstream of it; the sea is at 0. If every node has at most one neighbour
/// downstream, the sum of costs is minimal, and among equal sums the heights are the lowest. If a river splits, the
/// node's cost counts for its lowest-numbered neighbour, and the other arms are lowered to that node's height. O(n log²
/// n).
///
/// Source: isotonic regression on a rooted tree (problem: Stout, "Isotonic regression via partitioning", 2013) by
/// mergeable heaps of slope changes ("slope trick"). Each height is a weighted quantile of the terrain along a part of
/// the river.
std::vector<double> fit_descending(const FlowGraph& flow);

}  // namespace citykiln::ground
