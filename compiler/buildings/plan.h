// Plans buildings: decides which footprints become buildings, their heights, materials, styles and facade attributes.
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::buildings {

/// Returns one building per footprint, sorted by id. Outlines that are replaced by their parts (has_parts) count as
/// merged in the ledger "buildings/footprint".
///
/// A building belongs to the extent if its centroid does, and is not cut; a building part belongs to the extent if the
/// outline of its building does. Other buildings are dropped (kOutsideBounds).
///
/// height=* is measured from the lowest ground along the walls. If it is not tagged, storeys count from the mean ground
/// along the walls that face a street (street_sides.h), or from the highest ground if no wall does; storeys are added
/// below, down to the lowest ground. All parts of an outline (map/buildings/part_outlines.h) are measured from the
/// outline's ground: from the lowest, if height=* is tagged for one of them. A building on the ground whose eaves are
/// less than 2 m above its highest ground is raised (kHeightRaised). Walls extend 3 m below the lowest ground. A roof
/// without walls is a slab of 0.25 m, open below. It stands on posts (posts.h), as does a building that min_height
/// lifts but nothing supports (vertical_support.h; kUnsupportedBuilding). The result does not depend on the order of
/// the footprints. A building on the plate of a bridge (structures/plates.h), unless its layer is lower, stands on
/// that. Accepts any footprints.
std::vector<Building> plan(const map::FeatureView& features, const ground::GradedTerrain& ground, Report& report,
                           std::span<const map::Passageway> passageways = {},
                           std::span<const structures::Span> bridges = {});

}  // namespace citykiln::buildings
