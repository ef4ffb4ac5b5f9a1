// What a ray hits.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/contract/stable_id.h"
#include "compiler/materials/material.h"
#include "preview/scene/emitters.h"
#include "preview/surface/room.h"
#include "preview/surface/surface_point.h"

namespace citykiln::preview {

/// A ray's hit on a surface. Frame of the world: metres from World::origin, x east, y north, z up.
struct Hit : SurfacePoint {
  Vec3 position{};  ///< On the triangle, not along the ray: its error does not grow with the distance.
  Rgb emission{};   ///< Emitted radiance, in the sky's unit.
  std::uint32_t emitter = kNoEmitter;  ///< Number of the shining triangle (emitters.h).
  bool is_front = true;                ///< Whether the ray met the triangle's front.
  materials::Material material{};
  std::optional<Pane> pane{};  ///< Of window glass that is met from outside.
  OsmId feature{};             ///< The OSM object of the surface; none where it has none.
  double distance_m = 0;
  double rounding_m = 0;  ///< Upper bound of single precision's errors of a ray's origin here and of the plane.
};

/// An origin for rays that leave a hit without hitting it again: off the surface by the hit's rounding, to the side of
/// the direction.
Vec3 leave(const Hit& hit, Vec3 direction);

}  // namespace citykiln::preview
