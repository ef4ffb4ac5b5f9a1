// The backdrop: the land around a scene, in an Embree scene of its own. Rays are tested against it after the scene
// itself.
#pragma once

#include "preview/scene/baked_scene.h"

namespace citykiln::preview {

/// The backdrop in Embree. Immutable. A ray that stays over Backdrop::clear, where there is no backdrop, or is above
/// all land when it leaves that box, is not tested in Embree. Rays in streets therefore cost a few multiplications.
class BackdropScene {
 public:
  /// @param backdrop  Has a tile, which must outlive this object.
  /// @param origin    The world's origin in plane metres.
  BackdropScene(RTCDevice device, const Backdrop& backdrop, Vec3 origin);

  const SceneGeometry& geometry() const { return scene_.geometry(); }
  std::size_t bytes() const { return scene_.bytes(); }
  /// True if land is nearer than the ray's end. `found` is then updated to the hit on the land.
  bool intersect(RTCRayHit& found) const;
  /// True if land is between the ends of the ray.
  bool is_blocking(RTCRay& ray) const;

 private:
  bool may_meet(const RTCRay& ray) const;

  BakedScene scene_;
  Box2 clear_;        // in the world's frame
  double highest_m_;  // above the origin
};

}  // namespace citykiln::preview
