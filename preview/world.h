// Fired tiles as rays see them: Embree's trees of triangles and instances, and what each triangle is made of.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"

namespace citykiln::preview {

/// Where a ray met a surface. Frame of the world: metres from World::origin, x east, y north, z up.
struct Hit {
  Vec3 position;                     ///< On the triangle, not along the ray: its error does not grow with the distance.
  Vec3 geometric_normal;             ///< Unit, towards where the ray came from.
  Vec3 shading_normal;               ///< Unit, interpolated, on the same side.
  std::array<double, 3> albedo{};    ///< Linear: base colour, or the sheet's, times tint.
  std::array<double, 3> emission{};  ///< Radiance that it sends out by itself, in the sky's unit.
  float roughness = 1;
  double translucency = 0;  ///< What it lets through, as a share of what it throws back.
  materials::Material material{};
  double distance_m = 0;
  double rounding_m = 0;  ///< How far off its plane single precision may put a ray's origin here, and the plane itself.
};

/// Of light that a diffuse surface has thrown back: a few of its rays stand for all directions.
inline constexpr double kScattered_rad = 0.2;

/// Immutable once built; safe to ask from many threads. Refers to the tiles, which must outlive it.
class World {
 public:
  /// Tiles lie as their origins say, about `near` rounded to whole metres: there single precision is finest, and within
  /// 16 km of it baked positions, which lie on a grid of 2^-10 m, keep their very values.
  ///
  /// A shape that stands in many places is kept once, for all tiles that have the same; a place takes 32 bytes and its
  /// share of the tree. Cost: O(n log n).
  World(std::span<const bake::BakedTile> tiles, Vec3 near);
  ~World();
  World(World&&) noexcept;

  Vec3 origin() const;
  /// The first surface along a ray. Directions are unit vectors; rays that are not finite, or go nowhere, meet nothing.
  /// @param spread_rad  How wide a cone the ray stands for: a sheet is smoothed over what that covers of it.
  std::optional<Hit> first_hit(Vec3 from, Vec3 direction, double spread_rad = kScattered_rad) const;
  /// Is there anything at all along the ray?
  bool is_blocked(Vec3 from, Vec3 direction) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// A point from which a ray can leave a hit without meeting it again: off the surface, to the side that the ray goes,
/// by the hit's rounding.
Vec3 leave(const Hit& hit, Vec3 direction);

}  // namespace citykiln::preview
