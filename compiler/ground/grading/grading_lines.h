// Grading lines: lines along which the graded terrain bends. They are the terrain's grid where it is not level, lines
// across roads at bends of their profiles, axes of roads whose tilt changes, and the feet of cuts and banks. They
// become edges of a cell's reference triangulation.
#pragma once

#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/grading/graded_heights.h"

namespace citykiln::ground {

/// Returns all lines that may touch the cell, each from its lower end to its upper one, split where the ground bends
/// along them. They may cross. They depend on the graded terrain near them, not on the cell. O(roads near the cell +
/// squares of the terrain's grid in it).
std::vector<std::pair<GridPoint, GridPoint>> grading_lines(GradedHeights& heights, const Box2& cell);

/// Returns the lines that come near the cell's border. A cell without grading needs only these, so that its border has
/// the same bits as its neighbours'.
std::vector<std::pair<GridPoint, GridPoint>> lines_near_border(std::vector<std::pair<GridPoint, GridPoint>> lines,
                                                               const Box2& cell);

}  // namespace citykiln::ground
