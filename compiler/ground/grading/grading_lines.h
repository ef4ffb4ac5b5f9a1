// Lines along which the graded terrain bends: the terrain's own grid but where it is level, lines across roads where
// their profiles bend, their axes where they twist, and the feet of cuts and banks. A cell's reference triangulation
// has them as edges.
#pragma once

#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// Profiles are felt beside the road at every knot and at least this often.
inline constexpr double kStation_m = 16;

/// All that may touch the cell, each from its lower end; they may cross. Cut where the ground bends under
/// them. They depend on the graded terrain near them, not on the cell.
/// O(roads near the cell + squares of the terrain's grid in it).
std::vector<std::pair<GridPoint, GridPoint>> grading_lines(GradedHeights& heights, const Box2& cell);

/// Of these, those that come near the cell's border: where nothing is carved the others may be left out, and the border
/// is the same to the bit.
std::vector<std::pair<GridPoint, GridPoint>> lines_near_border(std::vector<std::pair<GridPoint, GridPoint>> lines,
                                                               const Box2& cell);

}  // namespace citykiln::ground
