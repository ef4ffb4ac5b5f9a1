// The land around a scene, in an Embree scene of its own. Rays are tested against it after the scene itself.
#pragma once

#include "preview/scene/baked_scene.h"

namespace citykiln::preview {

/// The land around a scene in Embree. Immutable. Rays that end above Backdrop::clear, or leave it above all land, do
/// not enter Embree, so in streets the land around costs a few multiplications a ray.
class BackdropScene {
 public:
  /// @param backdrop  Has a tile, which must outlive this object.
  /// @param origin    The world's origin in plane metres.
  BackdropScene(RTCDevice device, const Backdrop& backdrop, Vec3 origin);

  const SceneGeometry& geometry() const { return scene_.geometry(); }
  std::size_t bytes() const { return scene_.bytes(); }
  /// True if land is nearer than the ray's end. The ray then has that hit.
  bool intersect(RTCRayHit& found) const;
  bool is_blocking(RTCRay& ray) const;

 private:
  bool may_meet(const RTCRay& ray) const;

  BakedScene scene_;
  Box2 clear_;        // in the world's frame
  double highest_m_;  // above the origin
};

}  // namespace citykiln::preview
