// One shape that stands in many places. Embree's own instances take some 500 bytes each, and a country has millions of
// trees; here all places of a shape are one user geometry, whose rays are turned into the shape's frame on the way.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "preview/mesh_part.h"

namespace citykiln::preview {

/// Where a copy stands: 32 bytes.
struct Place {
  bake::Float3 translation;  ///< Metres from the world's origin.
  float scale = 1;
  bake::Float4 rotation;  ///< Unit quaternion x, y, z, w.
};

/// A shape and its places.
class Crowd {
 public:
  /// @param texture  The sheet of the shape's tile, if any.
  /// @param surfaces  Of each of its primitives the tile's texture of its material, if any.
  Crowd(RTCDevice device, const bake::Instanced& shape, const SheetTexture* texture,
        std::vector<const SurfaceTexture*> surfaces);
  ~Crowd();
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// Is it the same shape, triangle by triangle, and on the same sheet and textures, if on any?
  bool is_of(const bake::Instanced& shape, const SheetTexture* texture,
             std::span<const SurfaceTexture* const> surfaces) const;
  /// Adds the places of a tile whose origin is at `offset` in the world.
  void add(const bake::Instanced& instanced, Vec3 offset);
  /// Adds all places to the uncommitted top scene. They are numbered from `first` in RTCHit::instID; the crowd must
  /// stay where it is as long as the scene is used.
  void attach_to(RTCDevice device, RTCScene top, unsigned first);

  unsigned first() const { return first_; }
  std::size_t size() const { return places_.size(); }
  /// A hit in the world's frame on the copy that found.instID names.
  Hit hit_in_world(const RTCHit& found, const Beam& beam) const;

 private:
  struct Calls;

  const bake::Instanced* shape_;
  std::vector<const SurfaceTexture*> surfaces_;
  std::unique_ptr<CutoutTexture> cutout_;
  std::vector<MeshPart> parts_;
  RTCScene scene_;
  Vec3 low_, high_;  // of the shape
  std::vector<Place> places_;
  unsigned first_ = 0;
};

}  // namespace citykiln::preview
