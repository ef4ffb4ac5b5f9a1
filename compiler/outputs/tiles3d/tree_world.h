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
  /// The point of the tileset's frame that a point of the plane is bent to.
  map::BentPoint at(Vec3 p) const;
  bake::BakedTile bent(bake::BakedTile tile) const;
  /// The axes of the plane at a place.
  exporters::Axes axes_at(Vec2 place) const;

  /// Returns a box that contains the bent bounds, with the axes of the plane at their middle.
  exporters::OrientedBox box_of(const bake::Bounds& bounds) const;
  /// Returns a bound of the error that a content states: of its shape, of bending, and of packing.
  /// @param shape_m  A bound of the error in the plane.
  /// @param largest  The size of the tile's largest instance.
  double error_bound_m(double shape_m, double tolerance_m, const bake::Bounds& bounds,
                       const bake::InstanceSize& largest, Compression compression) const;

 private:
  const map::Geoid& geoid_;
  map::Globe globe_;
  std::optional<map::Cylinder> cylinder_;
};

}  // namespace citykiln::outputs
