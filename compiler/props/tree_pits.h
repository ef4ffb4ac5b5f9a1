// Pits of trees that stand in paving: a square of soil with an edging of stone, along the street or path.
//
//     ::::::::::::::::    paving
//     ::::+------+::::
//     ::::|  o   |::::    soil about the trunk, 3 cm above the paving; the edging, 8 cm
//     ::::+------+::::
//     ================    kerb: a pit is as small as keeps it off the carriageway
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/generate.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

struct TreePit {
  Vec2 at;            ///< Of its tree, plane metres.
  Vec2 along;         ///< Of two of its sides, length 1.
  double side_m = 0;  ///< With the edging.
  OsmId feature;      ///< The tree's.
  bool operator==(const TreePit&) const = default;
};

/// Is it paving that trees stand in: pavements, squares, parking, pedestrian streets, but no carriageway?
bool is_paving(map::LandCoverClass surface);

/// The pits of those trees that have paving about them, in their order: along the nearest road or path within 20 m, or
/// else east; as large as paving allows, from 1.5 m down to 0.75 m. A tree without so much has none, nor has one that
/// stands in another's pit.
///
/// @param surfaces  Must cover the trees and a metre about them.
/// O(trees · roads near).
std::vector<TreePit> tree_pits(std::span<const Placement> trees, std::span<const roads::Road> roads,
                               const ground::LandCoverIndex& surfaces);

/// On the ground at its corners; nothing where that is steep, or bent between them by over 2 cm. Where the edging is
/// lower than the tolerance, soil alone; without Detail::kTreePits nothing. Error: the edging's height above what is
/// left.
GeneratedProp generate(const TreePit& pit, const ground::GradedTerrain& ground, double tolerance_m);

}  // namespace citykiln::props
