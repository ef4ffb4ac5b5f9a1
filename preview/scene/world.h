// Baked tiles in a ray tracing scene: Embree's bounding volume hierarchies, and the material of each triangle.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "compiler/bake/baked_tile.h"
#include "preview/scene/hit.h"

namespace citykiln::preview {

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
  /// Whether any surface is along the ray, nearer than a distance > 0.
  bool is_blocked(Vec3 from, Vec3 direction, double distance_m = std::numeric_limits<double>::infinity()) const;
  /// All triangles that shine, by their numbers in hits. Those of instances are left out.
  std::span<const Emitter> emitters() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace citykiln::preview
