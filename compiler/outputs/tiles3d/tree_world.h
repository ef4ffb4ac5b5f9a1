// The world that a tileset is in, the ellipsoid or the inside of a cylinder, and what is known there of a content
// before it is baked: its box, and a bound of its error.
#pragma once

#include <optional>

#include "compiler/bake/bounds.h"
#include "compiler/bake/far/bend.h"
#include "compiler/contract/system/compression.h"
#include "compiler/map/plane/cylinder.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/map/plane/globe.h"
#include "compiler/scene/scene.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::outputs {

/// Refers to the header and the geoid, which must outlive it.
class TreeWorld {
 public:
  TreeWorld(const scene::Header& header, const map::Geoid& geoid)
      : geoid_(geoid), globe_(header.origin), cylinder_(scene::cylinder_of(header)) {}

  const std::optional<map::Cylinder>& cylinder() const { return cylinder_; }
  /// Returns the place and the axes, in the tileset's frame (metres), of a point of the plane.
  map::BentPoint at(Vec3 p) const;
  /// Returns a tile of the plane in the tileset's frame (bake/far/bend.h).
  bake::BakedTile bent(bake::BakedTile tile) const;
  /// Returns the plane's axes at height 0 at a place of the plane, in the tileset's frame.
  exporters::Axes axes_at(Vec2 place) const;

  /// Returns a box that contains the bent bounds, with the axes of the plane at their middle.
  exporters::OrientedBox box_of(const bake::Bounds& bounds) const;
  /// Returns an upper bound, in metres, of the error of a content: the sum for its shape, bending and quantisation.
  /// @param shape_m      A bound of the error in the plane.
  /// @param tolerance_m  The content's tolerance.
  /// @param bounds       The content's bounds in the plane.
  /// @param largest      The largest sizes of its instances, which may be of different ones.
  double error_bound_m(double shape_m, double tolerance_m, const bake::Bounds& bounds,
                       const bake::InstanceSize& largest, Compression compression) const;

 private:
  const map::Geoid& geoid_;
  map::Globe globe_;
  std::optional<map::Cylinder> cylinder_;
};

}  // namespace citykiln::outputs
