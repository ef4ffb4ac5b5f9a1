// Replaces the chords of lines by curves.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/assume/curves/bends.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::assume {

/// A line with its mapped points and the points of curves between them.
struct CurvedLine {
  Polyline axis;
  /// The index in `axis` of each mapped point, ascending; the first is 0.
  std::vector<std::uint32_t> mapped;
  bool is_curved() const { return axis.size() > mapped.size(); }
};

/// Returns true if a curve may replace a chord: has_room(index of the line, index of the chord,
/// curve). The curve contains both ends of the chord.
using HasRoom = std::function<bool(std::size_t, std::size_t, const Polyline&)>;

/// Returns the lines, in the same order, with curves through all of their points. New points are
/// multiples of kCurveStep_m (geometry/curved_chord.h).
///
/// - A curve keeps to the ChordLimits of its chord and has the slopes of slopes_of().
/// - A chord stays straight if it is shorter than 1 m, if its slopes are 0, if its curve needs no
///   points, or if has_room() is false for its curve.
/// - A line whose curves would add crossings with itself stays as mapped.
/// - A reversed line has the same points, reversed, if has_room() does not depend on the direction.
///
/// O(n log n), n: points of all lines, and the calls of has_room() for curves with points.
std::vector<CurvedLine> curved_lines(std::span<const CurvableLine> lines, const HasRoom& has_room);

}  // namespace citykiln::assume
