// Lots without buildings: sections (divide.cpp) are split like a cake.
//
//    ┌───────┬───────┐   the smallest rectangle about a lot is split square to its longer
//    │       │       │   axis, then its halves, until lots have the usual area; a split that
//    ├───┬───┼───┬───┤   leaves a part without a frontage is made along the other axis instead
//    ══════ street ═══
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/parcels/edge_owners.h"

namespace citykiln::parcels {

/// A part of a frontage: the street's edge.
using FrontageEdge = std::pair<Vec2, Vec2>;

/// A lot that is split by lines, as a tree. A place is to the left of a node's line or to the right.
struct SplitTree {
  struct Node {
    Vec2 at, along;
    std::uint32_t left = kNoIndex, right = kNoIndex;  ///< Indices of nodes; kNoIndex for leaves.
  };
  std::vector<Node> nodes;                  ///< The first is the root. Empty: not split.
  std::vector<std::pair<Vec2, Vec2>> cuts;  ///< The lines within the lot, and kOverlap_m beyond.
};

/// Splits a lot until each part has at most 1.25 times the usual area, or no split leaves both parts at least 0.4 times
/// the usual frontage. Source: Vanegas, Kelly, Weber, Halatsch, Aliaga, Müller, "Procedural Generation of Parcels in
/// Urban Modeling", Computer Graphics Forum 31, 2012, section 4.1 (without their random offsets). O(n) for each part.
SplitTree split(const Ring& lot, const std::vector<FrontageEdge>& frontages, const LotSize& size);

/// Returns the number of the leaf that a place is in, below leaf_limit(); 0 if the lot is not split.
std::uint32_t leaf_at(const SplitTree& tree, Vec2 p);
/// Returns an upper bound of the numbers of leaves. Not every number below it is a leaf.
inline std::uint32_t leaf_limit(const SplitTree& tree) {
  return std::max<std::uint32_t>(1, 2 * static_cast<std::uint32_t>(tree.nodes.size()));
}

/// The split trees of lots without buildings.
struct Splits {
  std::uint32_t first_label = kNoIndex;   ///< The label of the first tree's lot.
  std::vector<SplitTree> trees;           ///< One for each label.
  std::vector<std::uint32_t> first_leaf;  ///< The label of the first leaf of each tree.
};

/// Returns the label that a place has after all splits.
inline std::uint32_t split_label(const Splits& splits, std::uint32_t label, Vec2 p) {
  if (label < splits.first_label) return label;
  const std::uint32_t tree = label - splits.first_label;
  return splits.first_leaf[tree] + leaf_at(splits.trees[tree], p);
}

}  // namespace citykiln::parcels
