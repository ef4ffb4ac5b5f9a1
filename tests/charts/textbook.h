// Textbook methods in plain floating point, for comparison: what a program has that does not expect hard input.
#pragma once

#include <optional>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::charts {

/// Returns where two lines meet, by Cramer's rule; nothing if the determinant is 0.
std::optional<Vec2> meeting_of(Vec2 a, Vec2 along_a, Vec2 b, Vec2 along_b);

/// Returns the outline of two strips of one width that meet at their first points: each side of one is intersected with
/// the side of the other. Nothing if lines are parallel.
std::optional<Ring> mitred_outline(Vec2 node, Vec2 first_end, Vec2 second_end, double width_m);

/// Triangulates a ring by cutting off ears. Leaves the rest when no corner is an ear.
std::vector<Triangle> cut_ears(const Ring& ring);

/// Moves all edges of a ring inward and intersects neighbours. Nothing if two neighbours are parallel.
std::optional<Ring> inset_by_lines(const Ring& ring, double depth_m);

}  // namespace citykiln::charts
