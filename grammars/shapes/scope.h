// Scopes: the oriented box in which a shape is measured, split and moved.
#pragma once

#include <array>
#include <span>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// As in CGA, y is up in a building's scope, and z is a face's normal. Axes have length 1, right-handed, and are given
/// in plane metres (z up there).
struct Scope {
  Vec3 origin;
  std::array<Vec3, 3> axis = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}};
  std::array<double, 3> size_m = {0, 0, 0};

  Vec3 to_space(double x_m, double y_m, double z_m) const {
    return origin + axis[0] * x_m + axis[1] * y_m + axis[2] * z_m;
  }
  Vec3 centre() const { return to_space(size_m[0] / 2, size_m[1] / 2, size_m[2] / 2); }
  std::array<Vec3, 8> corners() const;
  double diagonal_m() const;
};

/// The box of all vertices along these axes; where there are none, no size at the axes' origin.
Scope scope_around(std::span<const Face> faces, const std::array<Vec3, 3>& axis, Vec3 origin_if_empty);

/// Axes of a face: z its normal; x level, along the face's foot as seen from outside; y up in the face. Of a face that
/// lies level, x runs along its first edge.
std::array<Vec3, 3> axes_of(const Face& face);
/// The same, of a face with this normal.
std::array<Vec3, 3> axes_of(const Face& face, Vec3 normal);

/// Of the scope's axes, the one nearest to this direction, and whether it points against it.
struct NearestAxis {
  int axis = 0;
  bool against = false;
};
NearestAxis nearest_axis(const Scope& scope, Vec3 direction);

}  // namespace citykiln::grammars
