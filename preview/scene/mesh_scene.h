// A mesh in its own frame in Embree, which instances share.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "preview/scene/mesh_part.h"

namespace citykiln::preview {

/// A mesh in Embree. Immutable. Refers to the primitives and textures, which must outlive this object.
class MeshScene {
 public:
  /// @param marking_atlas  The atlas of the mesh's tile; null: none.
  /// @param materials      The texture of each primitive's material; null: none.
  /// @param cutout         The mesh's cutout; null: none.
  MeshScene(RTCDevice device, const std::vector<bake::Primitive>& primitives, const MipTexture* marking_atlas,
            std::vector<const MaterialTexture*> materials, std::shared_ptr<const CutoutTexture> cutout);
  ~MeshScene();
  MeshScene(const MeshScene&) = delete;
  MeshScene& operator=(const MeshScene&) = delete;

  /// True if `mesh` is equal to this one, triangle by triangle, and has equal images.
  bool is_of(const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
             std::span<const MaterialTexture* const> materials) const;

  RTCScene scene() const { return scene_; }
  const std::vector<MeshPart>& parts() const { return parts_; }
  const std::shared_ptr<const CutoutTexture>& cutout() const { return cutout_; }
  /// Returns the lowest corner of the mesh's box; high() returns the highest.
  Vec3 low() const { return low_; }
  Vec3 high() const { return high_; }
  /// Returns the bytes of the copied positions, without primitives and Embree's hierarchy.
  std::size_t bytes() const;

 private:
  const std::vector<bake::Primitive>* primitives_;
  std::vector<const MaterialTexture*> materials_;
  std::shared_ptr<const CutoutTexture> cutout_;
  std::vector<MeshPart> parts_;
  RTCScene scene_;
  Vec3 low_, high_;
};

}  // namespace citykiln::preview
