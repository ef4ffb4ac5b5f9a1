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
  Vec2 along;         ///< Direction of two of its sides, length 1.
  double side_m = 0;  ///< Including the edging.
  OsmId feature;      ///< The tree.
  bool operator==(const TreePit&) const = default;
};

/// Whether trees in this land cover have pits: pavements, squares, parking, pedestrian streets; no carriageways.
bool is_paving(map::LandCoverClass surface);

/// Returns the pits of trees in paving, in their order: aligned to the nearest road or path within 20 m, else to the x
/// axis; the largest side of 1.5, 1.25, 1 and 0.75 m that paving allows. Trees without room, or in the pit of an
/// earlier tree, have none.
///
/// @param index  Land cover of the trees and 1 m around them.
/// O(trees · roads near).
std::vector<TreePit> tree_pits(std::span<const Placement> trees, std::span<const roads::Road> roads,
                               const ground::LandCoverIndex& index);

/// Generates a tree pit on the ground. Nothing if the ground is steep, or more than 2 cm off the plane of its corners.
/// Soil alone if the edging is lower than the tolerance; nothing without Detail::kTreePits. The error is the height of
/// the edging above what is left.
GeneratedProp generate(const TreePit& pit, const ground::GradedTerrain& ground, double tolerance_m);

}  // namespace citykiln::props
