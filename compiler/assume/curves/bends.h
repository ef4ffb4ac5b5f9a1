// Decides the directions in which curved lines pass their nodes.
//
//            o-----              at a node where a line goes on, the turn is divided between its two chords: each
//           /  node              takes a part of the angle, in proportion to how far it may leave its chord for its
//     -----o                     length, so that a long straight stays straight
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::assume {

/// Nodes at which lines turn less than this keep their corners: they are not seen.
inline constexpr double kLeastTurn_deg = 6;
/// Nodes at which lines turn more than this keep their corners: these are meant.
inline constexpr double kMostTurn_deg = 60;
/// The most that a line turns at a junction that it runs through.
inline constexpr double kMostTurnAtJunction_deg = 30;
/// A circle of few nodes turns by more at each.
inline constexpr double kMostTurnInCircle_deg = 75;

/// The limits of a chord of a line.
struct ChordLimits {
  double most_m = 0;   ///< The largest distance from the chord; 0: the chord stays as mapped.
  double reach_m = 0;  ///< CurveLimits::reach_m.
  double error_m = 0;  ///< CurveLimits::error_m.
};

/// A line whose axis may be curved. Refers to data that must outlive it.
struct Line {
  std::span<const Vec2> axis;           ///< At least two points, no repeated neighbours.
  std::span<const std::int64_t> nodes;  ///< An id of each point; lines of one network meet where ids are equal.
  int network = 0;
  int priority = 0;                 ///< Two lines of the highest that meet go on in each other.
  bool is_circle = false;           ///< A roundabout or a part of one.
  std::vector<ChordLimits> chords;  ///< One for each pair of neighbouring points.
  /// One for each point: true where the corner is meant.
  std::vector<bool> is_corner{};
};

/// The slopes with which a line leaves the start of a chord and arrives at its end, to the left of the chord, in
/// kSlopeUnit.
struct Slopes {
  int leave = 0, arrive = 0;
  bool operator==(const Slopes&) const = default;
};

/// Returns the slopes of all chords of all lines. A line goes on
///
/// - at its inner points, and in the one other line that ends where it ends, up to kMostTurn_deg;
/// - through a junction if no other line does, or if two lines of the highest priority meet there, up to
///   kMostTurnAtJunction_deg.
///
/// Elsewhere slopes are 0: the chord keeps its direction. The slopes at a node depend on the chords that meet there.
/// O(n log n), n: points of all lines.
std::vector<std::vector<Slopes>> slopes_of(std::span<const Line> lines);

}  // namespace citykiln::assume
