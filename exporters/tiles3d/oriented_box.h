// Boxes with any three perpendicular axes, which are bounding volumes of 3D Tiles.
#pragma once

#include <array>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/vec.h"

namespace citykiln::exporters {

/// Three perpendicular unit vectors.
using Axes = std::array<Vec3, 3>;

/// A box: the points whose coordinates along the axes are in closed intervals. Metres, in the frame of a run: on the
/// ellipsoid (map/plane/globe.h), in the plane, or inside of a cylinder. The default is empty.
struct OrientedBox {
  Axes axes{};
  std::array<double, 3> low, high;

  OrientedBox() : OrientedBox({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {}
  explicit OrientedBox(const Axes& a);
  bool is_empty() const { return low[0] > high[0]; }
  void grow(Vec3 p);
  /// Grows by a box with any axes.
  void grow(const OrientedBox& box);
  /// Moves the sides outwards by `by_m`, then on to multiples of 2^-6 m.
  void round_outwards(double by_m = 0);
  Vec3 corner(unsigned i) const;  ///< i = 0 … 7.
};

/// Returns a box that contains all vertices of a tile and, for instances, the corners of their meshes' boxes. Grown by
/// 2^-6 m and rounded outwards, which is more than the rounding of single precision. O(vertices).
OrientedBox box_of(const bake::BakedTile& tile, const Axes& axes);

/// Returns the twelve numbers of a 3D Tiles box: centre and three half axes.
std::array<double, 12> numbers_of(const OrientedBox& box);

}  // namespace citykiln::exporters
