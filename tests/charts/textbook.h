// Textbook methods in plain floating point, with no tolerance and no exact tests. Charts run them on hard input beside
// the program's own methods, and count how often each is right.
#pragma once

#include <optional>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::charts {

/// Returns the point where two lines meet, by Cramer's rule; empty only if the determinant is exactly 0.
/// @param a, b              A point of each line.
/// @param along_a, along_b  Their directions, of any length but 0.
std::optional<Vec2> line_intersection(Vec2 a, Vec2 along_a, Vec2 b, Vec2 along_b);

/// Returns the outline of two strips of equal width that start at one node, as a counter-clockwise ring of 6 points:
/// each side of one strip is intersected with the facing side of the other. The ring may cross itself, or reach far out
/// where the angle is small. Empty if the strips are exactly parallel, so also where they go straight on.
/// @param first_end, second_end  The other ends of the strips' axes; not equal to the node.
/// @param width_m                Full width: the sides are width_m / 2 from the axis.
std::optional<Ring> mitred_outline(Vec2 node, Vec2 first_end, Vec2 second_end, double width_m);

/// Triangulates a simple counter-clockwise ring by cutting off ears, into indices of its points. Stops when no corner
/// is an ear: the result then covers a part of the ring, with fewer than size - 2 triangles. O(n³).
std::vector<Triangle> cut_ears(const Ring& ring);

/// Moves each edge of a counter-clockwise ring inward by a depth and intersects neighbouring edges. The result has as
/// many points as the ring; where the depth does not fit it crosses itself or turns inside out. Empty if two
/// neighbouring edges are exactly parallel.
std::optional<Ring> inset_by_lines(const Ring& ring, double depth_m);

}  // namespace citykiln::charts
