// Fillets: arcs from the left kerb of an arm to the right kerb of the next arm counter-clockwise.
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

/// The first part of an arm, as long as a junction can be.
struct ArmPath {
  Polyline axis;                   ///< At least two points; the last one may be interpolated.
  double left_m = 0, right_m = 0;  ///< Distances to the kerbs, seen along the arm.
};
ArmPath arm_path(std::span<const Road> roads, const Arm& arm);

/// The point where an arc touches a kerb.
struct TangentPoint {
  Vec2 at;                  ///< Point of the kerb, not snapped.
  double along_m = 0;       ///< Distance along the axis from the arm's node; negative behind the node.
  std::size_t segment = 0;  ///< The segment of the axis beside which `at` lies.
};

struct Fillet {
  Vec2 centre;
  double radius_m = 0;
  TangentPoint arm, next;  ///< Ends of the arc on both kerbs; at one place if the radius is 0.
};

/// Returns the fillet between the left kerb of `arm` and the right kerb of `next`; if there are several, the one
/// nearest to the junction.
///
/// Returns nothing if no such arc lies along both arms and clear of all their bends: the kerbs never meet (arms that
/// continue straight on or run side by side), or only on the outside of a bend. O(n²) in the few points of the paths.
/// @param radius_m  >= 0.
std::optional<Fillet> fillet_between(const ArmPath& arm, const ArmPath& next, double radius_m);

/// The maximum extent of a fillet along its two arms.
struct FilletLimits {
  double along_arm_m = 0, along_next_m = 0;
};

/// Returns the fillet of the wanted radius, or of the largest multiple of 1/2 m below it that keeps to the limits.
/// Nothing if even radius 0 does not fit.
std::optional<Fillet> largest_fillet(const ArmPath& arm, const ArmPath& next, double wanted_radius_m,
                                     const FilletLimits& limits);

}  // namespace citykiln::roads
