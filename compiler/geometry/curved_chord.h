// A line between two mapped points that leaves their chord and returns to it, so that the line has no corner at either.
//
//            _----_            the line; its slope at each end is given, relative to the chord
//     a *---'------'---___* b
//       |<------>|             reach: beyond it a bulge has no effect, and the line follows the chord
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// One slope unit, metres to the left a metre along the chord.
inline constexpr double kSlopeUnit = 1.0 / 64;
/// The reach that is the whole chord.
inline constexpr int kWholeReach = 64;
/// The reaches of bulges that overlap: both have the same.
inline constexpr std::uint8_t kCommonReaches[] = {64, 56, 48, 40};
/// The largest slope, in kSlopeUnit.
inline constexpr int kMostSlopeUnits = 64;
/// The largest number of pieces.
inline constexpr int kMostPieces = 8;
/// The step of the points of a curved chord, metres; that of mapped points, so that both are stored alike.
inline constexpr double kCurveStep_m = 1.0 / 128;

/// The shape of the line from a to b. At the share t of the chord the line lies to the left of the chord, by its length
/// times
///
///     leave t (1 - t / p)²  -  arrive (1 - t) (1 - (1 - t) / q)²        p, q: the reaches, as shares of the chord
///
/// where a term is 0 beyond its reach. The line never turns back, and so does not cross itself.
struct CurvedChord {
  std::int8_t leave = 0, arrive = 0;  ///< The slopes of the line at a and b, seen from a to b; in kSlopeUnit.
  /// The reaches of the bulges at a and b, 1 to kWholeReach; 0 where the slope is 0.
  std::uint8_t leave_reach = 0, arrive_reach = 0;
  std::uint8_t pieces = 1;  ///< The straight pieces of each bulge, or of the chord if the bulges overlap. 1: no points.
  bool operator==(const CurvedChord&) const = default;
};

/// Returns the offset to the left of the chord at the share t, as a share of the chord's length.
double offset_at(const CurvedChord& chord, double t);

/// Returns the points of the line between a and b, without these, from a to b; multiples of kCurveStep_m. None has the
/// place of its neighbour. The reversed chord from b to a has the same points, reversed. O(pieces).
Polyline points_between(const CurvedChord& chord, Vec2 a, Vec2 b);

/// Limits of a curved chord.
struct CurveLimits {
  double most_m = 0;        ///< The largest distance from the chord.
  double reach_m = 0;       ///< The largest reach of a bulge.
  double error_m = 0.1;     ///< The largest distance of the straight pieces from the line.
  double turn = 0.165;      ///< The largest turn between two pieces, as a difference of slopes; 0.165: 9.4 degrees.
  double shortest_m = 0.5;  ///< The shortest piece.
};

/// Returns the chord with these slopes, in kSlopeUnit, which keeps the limits, except that it has at most kMostPieces.
/// A slope whose bulge would be shorter than a unit of reach becomes 0. O(1).
CurvedChord fitted_chord(double length_m, int leave, int arrive, const CurveLimits& limits);

/// Returns the chord of which the line from the first to the last of these points consists, by points_between();
/// nothing if there is none. Lines of fitted_chord() are found, but for some of less than 4 m, whose points are rounded
/// too coarsely; not always as the same chord. O(points) unless it is one.
std::optional<CurvedChord> chord_through(std::span<const Vec2> line);

/// Returns the chord from b to a.
CurvedChord reversed(const CurvedChord& chord);

}  // namespace citykiln
