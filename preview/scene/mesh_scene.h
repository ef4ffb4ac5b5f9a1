// A mesh of its own frame in Embree, which instances share.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "preview/scene/mesh_part.h"

namespace citykiln::preview {

/// Immutable once built. Refers to the primitives and textures, which must outlive it.
class MeshScene {
 public:
  /// @param marking_atlas  Of the mesh's tile; null where it has none.
  /// @param materials  Per primitive the texture of its material; null where it has none.
  /// @param cutout  Of the mesh; null where it has none.
  MeshScene(RTCDevice device, const std::vector<bake::Primitive>& primitives, const MipTexture* marking_atlas,
            std::vector<const MaterialTexture*> materials, std::shared_ptr<const CutoutTexture> cutout);
  ~MeshScene();
  MeshScene(const MeshScene&) = delete;
  MeshScene& operator=(const MeshScene&) = delete;

  /// Whether another mesh is the same, triangle by triangle, with the same images.
  bool is_of(const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
             std::span<const MaterialTexture* const> materials) const;

  RTCScene scene() const { return scene_; }
  const std::vector<MeshPart>& parts() const { return parts_; }
  const std::shared_ptr<const CutoutTexture>& cutout() const { return cutout_; }
  Vec3 low() const { return low_; }
  Vec3 high() const { return high_; }
  /// Of the copies of positions; without primitives and Embree's hierarchy.
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
