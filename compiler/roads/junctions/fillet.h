// The corner between two neighbouring arms, rounded: an arc that leaves the left kerb of one arm and comes to the right
// kerb of the next.
//
//     | |         The arc of radius r that touches both kerbs has its centre r off either of them: where the first
//     | (  +      axis moved left by its half and r meets the next axis moved right by its half and r. Axes are taken
//     |  `---     as they run, bends and all; radius 0 gives the kerbs' own corner.
//     `------
#pragma once

#include <optional>
#include <span>

#include "compiler/roads/network.h"

namespace citykiln::roads {

/// An arm from its place on, as far as a junction may reach.
struct ArmPath {
  Polyline axis;                   ///< At least two points; the last one may be interpolated.
  double left_m = 0, right_m = 0;  ///< To the kerbs, seen along the arm.
};
ArmPath path_of(std::span<const Road> roads, const Arm& arm);

/// Where an arc touches an arm's kerb.
struct TangentPoint {
  Vec2 at;                  ///< On the kerb, not snapped.
  double along_m = 0;       ///< Along the axis from the arm's place; below 0 where the kerb is met behind it.
  std::size_t segment = 0;  ///< Of the axis, that `at` lies beside.
};

struct Fillet {
  Vec2 centre;
  double radius_m = 0;
  TangentPoint arm, next;  ///< At one point for radius 0.
};

/// The corner between the left kerb of `arm` and the right kerb of the next arm counter-clockwise; of several, the one
/// nearest to the junction.
///
/// Nothing where no such arc lies along both arms and clear of all their bends: where kerbs never meet (arms that go
/// straight on into each other, or run side by side), or only on the outside of a bend. O(n²) in the paths' points, a
/// few.
std::optional<Fillet> fillet_between(const ArmPath& arm, const ArmPath& next, double radius_m);

/// How far a fillet may lie along its two arms.
struct FilletLimits {
  double along_arm_m = 0, along_next_m = 0;
};

/// The fillet of the radius wanted, or of the largest multiple of 1/2 m below it that keeps to the limits. Nothing
/// where even the kerbs' own corner does not.
std::optional<Fillet> largest_fillet(const ArmPath& arm, const ArmPath& next, double wanted_radius_m,
                                     const FilletLimits& limits);

}  // namespace citykiln::roads
