// Places the piers of bridges: evenly spaced positions, each moved along the axis to the nearest free one.
//
//     ==+============+============+==   deck with evenly spaced target positions
//       |        ->  |            |
//       |   [road]   |            |     the nearest free position is taken
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Returns the bridges with their piers.
///
/// @param bridges    Sorted by id, without piers. A span is one bridge as a recipe.
/// @param graded     The graded terrain of the whole map: the terrain after roads and water have cut into it.
/// @param obstacles  The land cover of the whole map. Classes of lower priority than water are ignored.
///
/// Guarantees: no pier's foot is nearer than kPierClear_m to a road, rails, a path, a building or a lower bridge, but
/// for the rounding of its position to 1/4 m. A pier stands in water only if no dry position is free within 12 m along
/// the axis. Bridges up to 30 m long have piers at joints only; longer bridges have piers 15 to 40 m apart if those
/// positions are free. Each pier ends 0.5 m or more below the graded ground, 2 m or more below water. From there to the
/// deck it is 2.5 to 60 m high. The piers of a bridge depend on data within 64 m of it, and on the piers of bridges
/// before it that are nearer than 12 m to its own, joined or not. Ledger "structures/pier"; dropped: kNoPlaceForPier.
/// O(bridges · obstacles near).
std::vector<Span> place_piers(std::vector<Span> bridges, const ground::GradedTerrain& graded,
                              std::span<const ground::LandCoverPolygon> obstacles, Report& report);

/// The smallest distance, in plan, between a pier's foot and an obstacle.
inline constexpr double kPierClear_m = 0.5;

}  // namespace citykiln::structures
