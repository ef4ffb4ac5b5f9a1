// Rotations by quaternions, as instances of baked tiles have them.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns a vector rotated by a unit quaternion (x, y, z, w).
inline Vec3 rotated(const bake::Float4& q, Vec3 v) {
  const Vec3 axis{q[0], q[1], q[2]};
  const Vec3 t = cross(axis, v) * 2;
  return v + t * q[3] + cross(axis, t);
}

}  // namespace citykiln::exporters
