// One shape that stands in many places. Embree's own instances take some 500 bytes each, and a country has millions of
// trees; here all places of a shape are one user geometry, whose rays are turned into the shape's frame on the way.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "preview/mesh_part.h"

namespace citykiln::preview {

/// Where a copy stands: 32 bytes.
struct InstanceTransform {
  bake::Float3 translation;  ///< Metres from the world's origin.
  float scale = 1;
  bake::Float4 rotation;  ///< Unit quaternion x, y, z, w.
};

/// A shape and its places.
class InstanceSet {
 public:
  /// @param texture  The sheet of the shape's tile, if any.
  /// @param surfaces  Of each of its primitives the tile's texture of its material, if any.
  InstanceSet(RTCDevice device, const bake::InstancedMesh& shape, const MipTexture* texture,
              std::vector<const MaterialTexture*> surfaces);
  ~InstanceSet();
  InstanceSet(const InstanceSet&) = delete;
  InstanceSet& operator=(const InstanceSet&) = delete;

  /// Is it the same shape, triangle by triangle, and on the same sheet and textures, if on any?
  bool is_of(const bake::InstancedMesh& shape, const MipTexture* texture,
             std::span<const MaterialTexture* const> surfaces) const;
  /// Adds the places of a tile whose origin is at `offset` in the world.
  void add(const bake::InstancedMesh& instanced, Vec3 offset);
  /// Adds all places to the uncommitted top scene. They are numbered from `first` in RTCHit::instID; the crowd must
  /// stay where it is as long as the scene is used.
  void attach_to(RTCDevice device, RTCScene top, unsigned first);

  unsigned first() const { return first_; }
  std::size_t size() const { return places_.size(); }
  /// A hit in the world's frame on the copy that found.instID names.
  Hit hit_in_world(const RTCHit& found, const RayFootprint& beam) const;

 private:
  struct Calls;

  const bake::InstancedMesh* shape_;
  std::vector<const MaterialTexture*> surfaces_;
  std::unique_ptr<CutoutTexture> cutout_;
  std::vector<MeshPart> parts_;
  RTCScene scene_;
  Vec3 low_, high_;  // of the shape
  std::vector<InstanceTransform> places_;
  unsigned first_ = 0;
};

}  // namespace citykiln::preview
