// Scopes: the oriented box in which a shape is measured, split and moved.
#pragma once

#include <array>
#include <span>

#include "grammars/shapes/face.h"

namespace citykiln::grammars {

/// As in CGA, y points up in a building's scope and z along the normal of a face. Axes are unit vectors, right-handed,
/// in plane coordinates (metres, z up).
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

/// The bounding box of the outer rings along `axis`. Without vertices: no size, at `origin_if_empty`.
Scope scope_around(std::span<const Face> faces, const std::array<Vec3, 3>& axis, Vec3 origin_if_empty);

/// The axes of a face: z along its normal; x horizontal, along its lower edge as seen from outside; y up in the face.
/// In a horizontal face (within half a degree) x is along the first edge.
std::array<Vec3, 3> axes_of(const Face& face);
/// The same for a known normal.
std::array<Vec3, 3> axes_of(const Face& face, Vec3 normal);

/// The axis of the scope that is nearest to a direction, and whether it points against it.
struct NearestAxis {
  int axis = 0;
  bool against = false;
};
NearestAxis nearest_axis(const Scope& scope, Vec3 direction);

}  // namespace citykiln::grammars
