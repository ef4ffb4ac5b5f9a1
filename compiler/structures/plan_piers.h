// Where piers stand: about as far apart as such bridges are built, moved to where nothing is in the way.
//
//     ==+============+============+==   deck: wanted at even shares
//       |        ->  |            |
//       |   [road]   |            |     found: the nearest free place along the axis
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// @param bridges   Sorted by id, without piers.
/// @param carving   Of the whole map.
/// @param standing  What covers the ground of the whole map; classes below paths do not matter.
///
/// Guarantees: no pier's foot comes nearer than kPierClear_m to a road, rails, a path, a building or a lower bridge;
/// it stands in water only where there is no dry place within reach; piers of one bridge are 15 to 40 m apart where
/// places are free, and one stands where bridges meet. Each ends below the graded terrain. A bridge lower than 2 m has
/// none, and no pier is higher than 60 m. What a bridge gets hangs on what is within 64 m of it, and on bridges it is
/// joined with. Ledger "structures/pier"; dropped: kNoPlaceForPier. O(bridges · what is near).
std::vector<Span> place_piers(std::vector<Span> bridges, const ground::GradedTerrain& graded,
                              std::span<const ground::LandCoverPolygon> standing, Report& report);

inline constexpr double kPierClear_m = 0.5;

}  // namespace citykiln::structures
