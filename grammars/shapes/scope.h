// The scope of a shape: the oriented box in which it is measured, split and moved.
#pragma once

#include <array>
#include <span>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// An oriented box in plane coordinates (metres, z up). Axes are right-handed unit vectors. In a building's scope y
/// points up, and in a face's scope z is along the normal, as in CGA.
struct Scope {
  Vec3 origin;
  std::array<Vec3, 3> axis = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}};
  std::array<double, 3> size_m = {0, 0, 0};

  /// Returns the point with these coordinates along the axes, relative to the origin.
  Vec3 to_space(double x_m, double y_m, double z_m) const {
    return origin + axis[0] * x_m + axis[1] * y_m + axis[2] * z_m;
  }
  Vec3 centre() const { return to_space(size_m[0] / 2, size_m[1] / 2, size_m[2] / 2); }
  std::array<Vec3, 8> corners() const;
  double diagonal_m() const;
};

/// Returns the bounding box of the outer rings along `axis`. Without vertices it has size 0 and is at
/// `origin_if_empty`.
Scope scope_around(std::span<const Face> faces, const std::array<Vec3, 3>& axis, Vec3 origin_if_empty);

/// Returns the axes of a face: z along its normal; x horizontal, along its lower edge as seen from outside; y up in the
/// face. In a horizontal face (within half a degree) x is along the first edge.
std::array<Vec3, 3> axes_of(const Face& face);
/// Returns the axes of a face whose normal is known.
std::array<Vec3, 3> axes_of(const Face& face, Vec3 normal);

/// The axis of a scope that is most nearly parallel to a direction.
struct NearestAxis {
  int axis = 0;          ///< Index into Scope::axis.
  bool against = false;  ///< The axis and the direction point in opposite directions.
};
/// Returns the axis that is most nearly parallel to a direction.
NearestAxis nearest_axis(const Scope& scope, Vec3 direction);

}  // namespace citykiln::grammars
