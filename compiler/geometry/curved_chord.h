// A line between two mapped points that leaves their chord and returns to it. Its slopes at both
// ends are given, relative to the chord, so that it joins its neighbours without a corner.
//
//            _----_            One bulge beside each end: a hump on one side of the chord, with the
//     a *---'------'---___* b  slope given there.
//       |<------>|             The reach of the bulge at a: it ends there.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// One unit of slope: metres to the left of the chord for each metre along it.
inline constexpr double kSlopeUnit = 1.0 / 64;
/// The reach of a bulge as long as the whole chord. Reaches are in 64ths of the chord's length.
inline constexpr int kWholeReach = 64;
/// The reaches of two bulges that overlap, the largest first: both bulges have the same one.
inline constexpr std::uint8_t kCommonReaches[] = {64, 56, 48, 40};
/// The largest slope, in kSlopeUnit: 45 degrees.
inline constexpr int kMostSlopeUnits = 64;
/// The largest number of straight pieces of a bulge.
inline constexpr int kMostPieces = 8;
/// The step of the points of curves, in metres: that of mapped points, so that both are stored
/// alike.
inline constexpr double kCurveStep_m = 1.0 / 128;

/// The shape of a line from a to b. At the share t of the chord, from 0 to 1, the line lies to the
/// left of the chord by the chord's length times
///
///     leave t (1 - t / p)²  -  arrive (1 - t) (1 - (1 - t) / q)²
///
/// with slopes in metres for each metre and p, q: the reaches as shares of the chord. Each term, a
/// bulge, is 0 beyond its reach. The line never turns back along the chord, and so does not cross
/// itself.
struct CurvedChord {
  std::int8_t leave = 0, arrive = 0;  ///< Slopes at a and b, both seen from a to b, in kSlopeUnit.
  /// The reaches of the bulges at a and b, 1 to kWholeReach, or 0 where the slope is 0. Reaches
  /// with a sum of more than kWholeReach are equal.
  std::uint8_t leave_reach = 0, arrive_reach = 0;
  /// The straight pieces of each bulge, or of the whole chord if the bulges overlap. 1: the line is
  /// drawn as the chord, without points.
  std::uint8_t pieces = 1;
  bool operator==(const CurvedChord&) const = default;
};

/// Returns the distance of the smooth line to the left of the chord at the share t, 0 to 1, as a
/// share of the chord's length.
double offset_at(const CurvedChord& chord, double t);

/// Returns the points of the line between a and b, without a and b, in the order from a to b; empty
/// if the line is straight. Points are multiples of kCurveStep_m, and no two neighbours are equal.
/// The reversed chord from b to a has the same points, reversed. O(pieces).
Polyline points_between(const CurvedChord& chord, Vec2 a, Vec2 b);

/// Limits of a curved chord for fitted_chord().
struct CurveLimits {
  double most_m = 0;        ///< The largest distance of the line from the chord.
  double reach_m = 0;       ///< The largest reach of a bulge.
  double error_m = 0.1;     ///< The largest distance of the straight pieces from the line.
  double turn = 0.174;      ///< The largest difference of slope between pieces; 0.174: 9.9 degrees.
  double shortest_m = 0.5;  ///< The shortest piece; it has precedence over error_m and turn.
};

/// Returns a chord with the given slopes, in kSlopeUnit, and the largest reaches within most_m and
/// reach_m. Bulges that overlap have the largest of kCommonReaches that fits; each ends in the
/// middle of the chord if none does. The distance is sampled, so it may exceed most_m by up to 2 %.
///
/// It has the fewest pieces that keep error_m and turn, or fewer if pieces would be shorter than
/// shortest_m or more than kMostPieces. A slope becomes 0 if its reach would be less than one unit.
/// O(1).
/// @param length_m       The length of the chord, > 0.
/// @param leave, arrive  From -kMostSlopeUnits to kMostSlopeUnits.
CurvedChord fitted_chord(double length_m, int leave, int arrive, const CurveLimits& limits);

/// Returns a chord with points_between() equal to the inner points of the line, or nothing if none
/// is found. It need not be the chord that made the line. Most lines of fitted_chord() are found:
/// at least 97 % of those of 4 m or more in the test. Slopes of more than 60 units are not.
/// O(points).
/// @param line  At least three points.
std::optional<CurvedChord> chord_through(std::span<const Vec2> line);

/// Returns the same line seen from b to a.
CurvedChord reversed(const CurvedChord& chord);

}  // namespace citykiln
