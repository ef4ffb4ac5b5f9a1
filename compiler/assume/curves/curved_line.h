// Replaces the chords of lines by curves.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/assume/curves/bends.h"
#include "compiler/geometry/polygon.h"

namespace citykiln::assume {

/// A line with points of curves between its mapped points.
struct CurvedLine {
  Polyline axis;
  /// The index in `axis` of each mapped point, ascending, from 0 to the last.
  std::vector<std::uint32_t> mapped;
  bool is_curved() const { return axis.size() > mapped.size(); }
};

/// has_room(line, chord, curve): true if a curve, from one end of a chord to its other, may replace the chord.
using HasRoom = std::function<bool(std::size_t, std::size_t, const Polyline&)>;

/// Returns the lines with curves through all of their points, in the same order.
///
/// - A curve keeps to the ChordLimits of its chord and to slopes_of(); chords without room, chords of less than 1 m and
///   chords of which the straight pieces would be the chord itself stay straight.
/// - A line that would cross itself, though it does not as mapped, stays as mapped.
/// - A line that is reversed gives the same points, reversed.
///
/// O(n log n), n: points of all lines, and the calls of has_room for chords with slopes.
std::vector<CurvedLine> curved_lines(std::span<const Line> lines, const HasRoom& has_room);

}  // namespace citykiln::assume
