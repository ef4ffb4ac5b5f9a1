// Closes gaps of a few decimetres between paved areas and the streets and paths beside them, where grass would show.
//
//     car park  ┌──────────┐         ┌──────────┐      A corner of the area less than kWidestGap_m beside the edge of a
//               └──────────┘   ──►   │          │      street or path moves to kUnderEdge_m inside it.
//     ═══ street edge ═══════════════└──────────┘═
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The widest gap between a paved area and a street or path that is closed, in metres: assumed widths vary that much.
inline constexpr double kWidestGap_m = 0.9;
/// How far a moved corner lies inside the edge, whose surface covers it, in metres.
inline constexpr double kUnderEdge_m = 0.125;

/// Returns the polygons, with corners of car parks, squares and platforms moved to the streets and paths beside them.
/// A ring whose area would change by more than a fifth stays as it is. Moved corners are multiples of map::kMapStep_m.
/// O(corners · roads near).
std::vector<LandCoverPolygon> with_closed_gaps(std::vector<LandCoverPolygon> surfaces,
                                               std::span<const roads::Road> roads);

}  // namespace citykiln::ground
