// Baked tiles in a ray tracing scene: Embree's bounding volume hierarchies, and the material of each triangle.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"

namespace citykiln::preview {

/// A ray's hit on a surface. Frame of the world: metres from World::origin, x east, y north, z up.
struct Hit {
  Vec3 position;                     ///< On the triangle, not along the ray: its error does not grow with the distance.
  Vec3 geometric_normal;             ///< Unit, towards the ray's origin.
  Vec3 shading_normal;               ///< Unit, interpolated, on the same side.
  std::array<double, 3> albedo{};    ///< Linear: the colour of material or image, times tint.
  std::array<double, 3> emission{};  ///< Emitted radiance, in the sky's unit.
  float roughness = 1;
  double translucency = 0;  ///< Transmitted light as a share of reflected light.
  materials::Material material{};
  double distance_m = 0;
  double rounding_m = 0;  ///< Upper bound of single precision's errors of a ray's origin here and of the plane.
};

/// Angle of the cone that a diffusely scattered ray stands for.
inline constexpr double kScattered_rad = 0.2;

/// Immutable and thread-safe. Refers to the tiles, which must outlive it.
class World {
 public:
  /// Places tiles by their origins about `near`, rounded to whole metres: single precision is finest there, and within
  /// 16 km of it baked positions, which lie on a grid of 2^-10 m, are exact.
  ///
  /// An instanced mesh is kept once for all tiles that have it; an instance takes 32 bytes and its share of the
  /// hierarchy. Cost: O(n log n).
  World(std::span<const bake::BakedTile> tiles, Vec3 near);
  ~World();
  World(World&&) noexcept;

  Vec3 origin() const;
  /// The first surface along a ray. Directions are unit vectors; rays that are not finite, or have no direction, hit
  /// nothing.
  /// @param spread_rad  Angle of the cone that the ray stands for: images are filtered over it.
  std::optional<Hit> first_hit(Vec3 from, Vec3 direction, double spread_rad = kScattered_rad) const;
  /// Whether any surface is along the ray.
  bool is_blocked(Vec3 from, Vec3 direction) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// An origin for rays that leave a hit without hitting it again: off the surface by the hit's rounding, to the side of
/// the direction.
Vec3 leave(const Hit& hit, Vec3 direction);

}  // namespace citykiln::preview
