// Fired tiles as rays see them: Embree's trees of triangles and instances, and what each triangle is made of.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "compiler/bake/baked.h"

namespace citykiln::preview {

/// Where a ray met a surface. Frame of the world: plane metres from World::origin, z up.
struct Hit {
  Vec3 position;               ///< Computed from the triangle, not along the ray, so that its error is that of the triangle.
  Vec3 geometric_normal;       ///< Unit, towards where the ray came from.
  Vec3 shading_normal;         ///< Unit, interpolated, on the same side.
  std::array<float, 3> albedo; ///< Linear.
  float roughness = 1;
  materials::Material material{};
  double distance_m = 0;
};

/// Immutable once built; safe to ask from many threads.
class World {
 public:
  /// Tiles lie as their origins say, about `origin` (plane metres): near the camera, so that single precision is finest there. Cost: O(n log n).
  World(std::span<const bake::BakedTile> tiles, Vec3 origin);
  ~World();
  World(World&&) noexcept;

  Vec3 origin() const;
  /// The first surface along a ray. Directions are unit vectors; rays that are not finite meet nothing.
  std::optional<Hit> first_hit(Vec3 from, Vec3 direction) const;
  /// Is there anything at all along the ray?
  bool is_blocked(Vec3 from, Vec3 direction) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// A point from which a ray can leave a hit without meeting it again: moved off along the geometric normal by the rounding error of its coordinates.
Vec3 leave(const Hit& hit, Vec3 direction);

}  // namespace citykiln::preview
