// Tree pits: squares of soil with a stone edging around trees in paving, aligned to the street or path.
//
//     ::::::::::::::::    paving
//     ::::+------+::::
//     ::::|  o   |::::    soil 3 cm above the paving, edging 8 cm
//     ::::+------+::::
//     ================    kerb: pits are small enough to stay off the carriageway
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

struct TreePit {
  Vec2 at;            ///< The tree, plane metres.
  Vec2 along;         ///< Direction of two sides of the pit, length 1.
  double side_m = 0;  ///< Including the edging.
  OsmId feature;      ///< The tree.
  bool operator==(const TreePit&) const = default;
};

/// Returns the pits of trees in paving, in the order of the trees. Paving is the land cover of pavements, squares,
/// platforms, parking, islands, paved footpaths and pedestrian streets. A pit is aligned to the nearest road or path
/// within 20 m, else to the x axis. Its side is the largest of 1.5, 1.25, 1 and 0.75 m for which all of it lies in
/// paving. A tree without such room, or within 2.25 m of an earlier tree with a pit, has none.
///
/// @param index  Land cover of the trees and 1 m around them.
/// O(trees · roads near).
std::vector<TreePit> tree_pits(std::span<const Placement> trees, std::span<const roads::Road> roads,
                               const ground::LandCoverIndex& index);

/// Generates a tree pit on the ground. Returns no mesh if the ground is steeper than 1 in 4 or more than 2 cm off the
/// plane of the corners, or if Detail::kTreePits is not shown. Returns the soil alone if the tolerance is at least the
/// height of the edging. The error is the height of the edging above the surface that replaces it.
GeneratedProp generate(const TreePit& pit, const ground::GradedTerrain& ground, double tolerance_m);

}  // namespace citykiln::props
