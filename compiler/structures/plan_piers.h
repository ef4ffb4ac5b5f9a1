// Places piers at usual distances, moved along the axis to where nothing is in the way.
//
//     ==+============+============+==   deck with evenly spaced target positions
//       |        ->  |            |
//       |   [road]   |            |     the nearest free position is taken
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Returns the bridges with their piers.
///
/// @param bridges    Sorted by id, without piers.
/// @param graded     Of the whole map.
/// @param obstacles  The land cover of the whole map; classes of lower priority than water are ignored.
///
/// Guarantees: no pier's foot is nearer than kPierClear_m to a road, rails, a path, a building or a lower bridge; it
/// stands in water only if there is no dry position within reach. Piers of one bridge are 15 to 40 m apart where
/// positions are free; one stands at each joint. Each ends below the graded ground. A bridge lower than 2 m has none;
/// no pier is higher than 60 m. The result for a bridge depends only on what is within 64 m of it and on bridges joined
/// with it. Ledger "structures/pier"; dropped: kNoPlaceForPier. O(bridges · obstacles near).
std::vector<Span> place_piers(std::vector<Span> bridges, const ground::GradedTerrain& graded,
                              std::span<const ground::LandCoverPolygon> obstacles, Report& report);

inline constexpr double kPierClear_m = 0.5;

}  // namespace citykiln::structures
