// How high a line lies along its length.
//
//        •----•
//       /      \            knots, straight between them, level before the first and after the last
//   ---•        •------
#pragma once

#include <span>
#include <vector>

namespace citykiln {

/// Heights of profiles are whole multiples of this.
inline constexpr double kProfileQuantum_m = 0x1p-7;
/// Tilts are whole multiples of this: at 8 m from the axis, of the heights' quantum.
inline constexpr double kTiltQuantum = 0x1p-10;

struct Knot {
  double at_m = 0;  ///< Along the line from the beginning of the whole way; a multiple of 1/8 m.
  double z_m = 0;   ///< Plane height, a multiple of kProfileQuantum_m.
  double tilt = 0;  ///< Rise a metre to the left of the axis; a multiple of kTiltQuantum.
  bool operator==(const Knot&) const = default;
};

/// Sorted by at_m, strictly. Empty: the line lies on the ground as it is.
using Profile = std::vector<Knot>;

/// Height and tilt at a place along the line, of the profile, which must not be empty, or of what between() gives of
/// it. O(log n).
Knot knot_at(std::span<const Knot> profile, double at_m);

/// The knots that say the profile between two places: those within, and the nearest on either side. O(log n).
std::span<const Knot> between(std::span<const Knot> profile, double from_m, double to_m);

}  // namespace citykiln
