// Drapes polylines over the ground.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::props {

/// Returns a polyline on the graded ground. Points are added where it crosses an edge of the terrain's grid, and every
/// 2 m on graded ground.
///
/// Guarantees: all points of the polyline are kept; consecutive points differ in plan; points are snapped, so they are
/// at most 2^-10 m times (1 + slope) off the ground. Outside of the terrain no points are added. O(length / step).
std::vector<Vec3> drape_line(const Polyline& line, const ground::GradedTerrain& ground);

/// Returns a polyline without points that are at most bend_m from the line between points that are kept; the first and
/// the last point are kept. Source: Douglas, Peucker, "Algorithms for the Reduction of the Number of Points Required to
/// Represent a Digitized Line or its Caricature", Cartographica 10, 1973. O(points²) at most.
std::vector<Vec3> without_small_bends(const std::vector<Vec3>& line, double bend_m);

/// Returns the vector to the left at a point of a line in plan, for a strip of half width 1, mitred between both
/// segments at the point. It is at most twice as long as half the width, so sharper bends are bevelled.
/// @param line       At least two points; consecutive points differ in plan.
/// @param is_closed  True for a ring: its last point is the first one.
Vec2 mitred_side(const std::vector<Vec3>& line, std::size_t i, bool is_closed);

}  // namespace citykiln::props
