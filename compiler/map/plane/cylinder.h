// Maps the map plane to the inside of a hollow cylinder: x runs along its axis, y along its circumference, z towards
// the axis. The frame has its origin at the plane's origin, where its axes are those of the plane.
//
//            z                     (x, y, z)  ->  (x, (R - z) sin(y / R), R - (R - z) cos(y / R))
//         .--|--.
//       /    |    \                y is the length of the arc along the ground at z = 0; the axis of the cylinder is
//      |    axis   |               parallel to x, at height R. Heights are measured along the radius.
//       \    |    /
//         '--+--'--> y
#pragma once

#include "compiler/map/plane/bent_point.h"

namespace citykiln::map {

/// The smallest and the largest radius that a world may have, in metres.
inline constexpr double kLeastCylinder_m = 100, kLargestCylinder_m = 1'000'000;

/// A hollow cylinder.
struct Cylinder {
  double radius_m = 0;  ///< Distance of the axis from z = 0: kLeastCylinder_m to kLargestCylinder_m.
  bool operator==(const Cylinder&) const = default;
};

/// The length of the circumference at z = 0.
double circumference_m(const Cylinder& cylinder);

/// Maps a point of the plane to the inside of the cylinder. Uses + - * / with direction_of() (geometry/trig.h), so that
/// every CPU gives the same bits. Error: below 1e-12 of the radius. Points one circumference apart along y meet within
/// this error.
/// @param p  Plane metres, z < radius_m.
BentPoint at(const Cylinder& cylinder, Vec3 p);

/// Returns the point of the plane that at() maps to `p`. Several do, which differ by whole turns; the result is the one
/// nearest to `near_y_m`. Error: below 1e-12 of the radius. Same bits on every CPU.
///
/// @param p         A point of the bent world, not on the axis.
/// @param near_y_m  Plane metres.
Vec3 flattened(const Cylinder& cylinder, Vec3 p, double near_y_m = 0);

/// The largest factor by which at() stretches lengths at heights of at least `low_m`: 1, or more below z = 0.
double stretch(const Cylinder& cylinder, double low_m);

/// Returns an upper bound of the distance between a straight triangle or edge and the image of the plane's one with the
/// same corners, by its extents along y and z: (s y² + 2 y z) / (8 R). It is half of the second derivative of at(), by
/// the variances of y and z over the corners, which are at most a quarter of their squared extents. Extents along x
/// add nothing.
/// @param stretch  The factor of lengths at the lowest corner.
double sag_m(const Cylinder& cylinder, double extent_y_m, double extent_z_m, double stretch = 1);

}  // namespace citykiln::map
