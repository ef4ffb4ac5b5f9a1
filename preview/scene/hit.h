// The hit of a ray on a surface.
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
  Vec3 position{};  ///< On the triangle, not along the ray, so its error does not grow with the distance.
  Rgb emission{};   ///< Emitted radiance, in the sky's unit.
  std::uint32_t emitter = kNoEmitter;  ///< Index of the triangle in World::emitters(), if it shines; else kNoEmitter.
  bool is_front = true;                ///< True if the ray met the triangle's front.
  materials::Material material{};
  std::optional<Pane> pane{};  ///< The pane, if the ray met window glass from outside.
  OsmId feature{};             ///< The OSM object of the surface; zero if it has none.
  double distance_m = 0;
  /// Upper bound of the errors of single precision: of the triangle's plane, and of the origin of a ray that begins
  /// here.
  double rounding_m = 0;
};

/// Returns an origin for rays that leave a hit without hitting it again: moved off the surface by twice the hit's
/// rounding, to the side of the direction.
Vec3 leave(const Hit& hit, Vec3 direction);

}  // namespace citykiln::preview
