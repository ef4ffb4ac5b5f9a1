// Height profiles along lines: polylines of height over distance, given by their vertices (knots).
//
//        •----•
//       /      \            knots with straight segments between them; level before the first and after the last
//   ---•        •------
#pragma once

#include <span>
#include <vector>

namespace citykiln {

/// The unit of heights: heights of knots are whole multiples.
inline constexpr double kProfileQuantum_m = 0x1p-7;
/// The unit of tilts: tilts are whole multiples. At 8 m from the axis, one unit changes the height by
/// kProfileQuantum_m.
inline constexpr double kTiltQuantum = 0x1p-10;

/// A vertex of a profile.
struct Knot {
  double at_m = 0;  ///< Distance along the line from the beginning of the whole way; a multiple of 1/8 m.
  double z_m = 0;   ///< Plane height, a multiple of kProfileQuantum_m.
  double tilt = 0;  ///< Rise per metre to the left of the axis; a multiple of kTiltQuantum.
  bool operator==(const Knot&) const = default;
};

/// Knots with strictly increasing at_m. Empty: the line follows the terrain.
using Profile = std::vector<Knot>;

/// Returns the interpolated height and tilt at a distance along the line.
/// @param profile  A profile that is not empty, or the part that between() returned for an interval around at_m.
/// O(log n).
Knot knot_at(std::span<const Knot> profile, double at_m);

/// Returns the knots that define the profile between two distances: the knots between the distances and one knot on
/// either side. O(log n).
std::span<const Knot> between(std::span<const Knot> profile, double from_m, double to_m);

}  // namespace citykiln
