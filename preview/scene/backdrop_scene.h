// The land around a scene in an Embree scene of its own, which rays meet after the scene itself.
#pragma once

#include "preview/scene/baked_scene.h"

namespace citykiln::preview {

/// Immutable. Rays that end above the box that is clear, or leave it above all land, do not enter Embree: in streets
/// the land around costs a few multiplications a ray.
class BackdropScene {
 public:
  /// @param backdrop  With a tile, which must outlive this. @param origin  Of the world, plane metres.
  BackdropScene(RTCDevice device, const Backdrop& backdrop, Vec3 origin);

  const SceneGeometry& geometry() const { return scene_.geometry(); }
  std::size_t bytes() const { return scene_.bytes(); }
  /// Whether land is nearer than the ray's end; the ray then has that hit.
  bool intersect(RTCRayHit& found) const;
  bool is_blocking(RTCRay& ray) const;

 private:
  bool may_meet(const RTCRay& ray) const;

  BakedScene scene_;
  Box2 clear_;        // in the world's frame
  double highest_m_;  // above the origin
};

}  // namespace citykiln::preview
