// Lots without buildings: land along streets is cut into sections, and sections are split like a cake.
//
//    ┌───────┬───────┐   the smallest rectangle about a lot is split square to its longer
//    │       │       │   axis, then its halves, until lots have the usual area; a split that
//    ├───┬───┼───┬───┤   leaves a part without a front is made along the other axis instead
//    ══════ street ═══
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/parcels/fronts.h"

namespace citykiln::parcels {

/// The side of the cells in which sections of streets without buildings end, in metres.
inline constexpr double kSection_m = 128;

/// Gives each free section of frontages a label, from first_label on, and returns the usual size of lots of each.
/// Sections end at corners, at buildings' land, and where they leave a cell of kSection_m that begins at whole
/// multiples of it, so that they are local. They do not end within a usual front of a corner or a building's land.
std::vector<LotSize> label_sections(const Strips& strips, const std::vector<LotSize>& sizes, std::uint32_t first_label,
                                    Fronts& fronts);

/// A part of a front: the street's edge.
using FrontEdge = std::pair<Vec2, Vec2>;

/// A lot that is split by lines, as a tree. A place is to the left of a node's line or to the right.
struct SplitTree {
  struct Node {
    Vec2 at, along;
    std::uint32_t left = kNone, right = kNone;  ///< Indices of nodes; kNone for leaves.
  };
  std::vector<Node> nodes;                  ///< The first is the root. Empty: not split.
  std::vector<std::pair<Vec2, Vec2>> cuts;  ///< The lines within the lot, and kOverlap_m beyond.
};

/// Splits a lot until its parts have at most the usual area, or cannot be split into parts that have fronts.
/// Source: Vanegas, Kelly, Weber, Halatsch, Aliaga, Müller, "Procedural Generation of Parcels in Urban Modeling",
/// Computer Graphics Forum 31, 2012, section 4.1 (without their random offsets). O(n) for each part.
SplitTree split(const Ring& lot, const std::vector<FrontEdge>& fronts, const LotSize& size);

/// Returns the number of the leaf that a place is in, below leaf_count(); 0 if the lot is not split.
std::uint32_t leaf_at(const SplitTree& tree, Vec2 p);
inline std::uint32_t leaf_count(const SplitTree& tree) {
  return std::max<std::uint32_t>(1, 2 * static_cast<std::uint32_t>(tree.nodes.size()));
}

/// The split trees of lots without buildings.
struct Splits {
  std::uint32_t first_label = kNone;      ///< The label of the first tree's lot.
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
