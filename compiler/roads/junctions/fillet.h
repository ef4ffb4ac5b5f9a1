// Fillets: arcs that round the corner between two arms (roads that leave a junction), from the left kerb of an arm to
// the right kerb of the next arm counter-clockwise.
//
//     | |         An arc of radius r that touches both kerbs has its centre r from either. So the centre is where the
//     | (  +      first axis, offset left by its half width + r, meets the next axis, offset right by its own. Axes are
//     |  `---     offset with their bends. Radius 0 gives the kerbs' own corner.
//     `------
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/network.h"

namespace citykiln::roads {

/// The first kJunctionRadius_m (24 m) of an arm, or all of it if it is shorter. No junction extends farther along it.
struct ArmPath {
  Polyline axis;                   ///< At least two points; the last one may be interpolated.
  double left_m = 0, right_m = 0;  ///< Distances to the kerbs at the node, seen along the arm.
  double drift = 0;                ///< By how much left_m grows and right_m shrinks per metre; tapers alone use it.
};
/// Returns the path of an arm.
ArmPath arm_path(std::span<const Road> roads, const Arm& arm);

/// The point where an arc touches the kerb of an arm.
struct TangentPoint {
  Vec2 at;                  ///< Point of the kerb, not snapped.
  double along_m = 0;       ///< Distance along the arm's axis from its node; negative if `at` lies behind the node.
  std::size_t segment = 0;  ///< The segment of the axis beside which `at` lies.
};

/// An arc with both ends.
struct Fillet {
  Vec2 centre;
  double radius_m = 0;
  TangentPoint arm, next;  ///< Ends of the arc, on the kerb of `arm` and of `next`; at one place if the radius is 0.
};

/// Returns the fillet between the left kerb of `arm` and the right kerb of `next`. If several arcs of this radius touch
/// both kerbs, returns the one nearest to the junction.
///
/// Returns nothing if no arc lies beside both paths and clear of their bends. This is so if the arms continue each
/// other straight on, if they run side by side, or if the kerbs meet only on the outside of a bend. O(n²) in the few
/// points of the paths.
/// @param radius_m  >= 0; 0 gives the corner of the kerbs.
std::optional<Fillet> fillet_between(const ArmPath& arm, const ArmPath& next, double radius_m);

/// Largest distances of a fillet's ends from the node, along its two arms.
struct FilletLimits {
  double along_arm_m = 0, along_next_m = 0;
};

/// Returns the fillet of the wanted radius or, if that exceeds the limits, of the largest multiple of 1/2 m below it
/// that keeps to them. Nothing if even radius 0 does not fit.
std::optional<Fillet> largest_fillet(const ArmPath& arm, const ArmPath& next, double wanted_radius_m,
                                     const FilletLimits& limits);

}  // namespace citykiln::roads
