// Decides the directions in which curved lines pass their nodes.
//
//            o-----              A node where a line goes on divides its turn between the two
//           /  node              chords there. Each chord takes an angle in proportion to its limit
//     -----o                     most_m over its length, so that a long straight stays straight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::assume {

/// Nodes with a smaller turn keep their corners, since such corners are not seen.
inline constexpr double kLeastTurn_deg = 10;
/// Nodes with a larger turn keep their corners, since such corners are real. It holds where two
/// chords meet.
inline constexpr double kMostTurn_deg = 60;
/// The largest turn of a line through a junction, where more than two chords meet.
inline constexpr double kMostTurnAtJunction_deg = 30;
/// The largest turn of a roundabout at a node. It is larger, since circles of few nodes turn by
/// more at each.
inline constexpr double kMostTurnInCircle_deg = 75;

/// The limits of a chord of a line.
struct ChordLimits {
  double most_m = 0;   ///< The largest distance from the chord, metres; 0: it stays as mapped.
  double reach_m = 0;  ///< The largest reach of a bulge, metres (CurveLimits::reach_m).
  double error_m = 0;  ///< The largest error of straight pieces, metres.
};

/// A line whose axis may be curved. It refers to data that must outlive it.
struct CurvableLine {
  std::span<const Vec2> axis;           ///< At least two points, no repeated neighbours.
  std::span<const std::int64_t> nodes;  ///< An id of each point; lines meet where ids are equal.
  int network = 0;                      ///< Lines of different networks do not meet.
  int priority = 0;                     ///< At a junction the chords of the highest priority go on.
  bool is_circle = false;               ///< A roundabout or a part of one.
  std::vector<ChordLimits> chords;      ///< One for each pair of neighbours.
  /// One for each point, or empty: true where a corner is kept. The node then has no curve.
  std::vector<bool> is_corner{};
};

/// The slopes of a line at the start and at the end of a chord, both seen from start to end: metres
/// to the left of the chord for each metre along it, in kSlopeUnit. 0: the line has the chord's
/// direction.
struct Slopes {
  int leave = 0, arrive = 0;
  bool operator==(const Slopes&) const = default;
};

/// Returns the slopes of all chords of all lines, by line and chord.
///
/// Two chords share the turn at a node, so that the line goes on without a corner:
/// - if only these two meet there, inside a line or at ends of lines: up to kMostTurn_deg;
/// - at a junction, the two chords of the roundabout, else the two of the highest priority, else
///   those of the only line that passes through: up to kMostTurnAtJunction_deg.
///
/// The limit is kMostTurnInCircle_deg if both chords belong to roundabouts. All other slopes are 0.
///
/// A chord takes no more of a turn than a curve with a radius of 6 m allows within most_m, so a
/// part of a corner may remain. Slopes are even numbers. The slopes at a node depend only on the
/// chords that meet there. O(n log n), n: points of all lines.
std::vector<std::vector<Slopes>> slopes_of(std::span<const CurvableLine> lines);

}  // namespace citykiln::assume
