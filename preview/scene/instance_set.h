// All instances of one mesh. An instance of Embree takes some 500 bytes, and a country has millions of trees: here all
// instances of a mesh are one user geometry, which transforms rays into the mesh's frame.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "preview/scene/mesh_part.h"

namespace citykiln::preview {

/// The placement of an instance: 32 bytes.
struct InstanceTransform {
  bake::Float3 translation;  ///< Metres from the world's origin.
  float scale = 1;
  bake::Float4 rotation;  ///< Unit quaternion x, y, z, w.
};

/// A mesh and the placements of its instances.
class InstanceSet {
 public:
  /// @param marking_atlas  Of the mesh's tile; null where it has none.
  /// @param materials  Per primitive the tile's texture of its material; null where it has none.
  /// @param cutout  Of the mesh; null where it has none.
  InstanceSet(RTCDevice device, const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
              std::vector<const MaterialTexture*> materials, std::shared_ptr<const CutoutTexture> cutout);
  ~InstanceSet();
  InstanceSet(const InstanceSet&) = delete;
  InstanceSet& operator=(const InstanceSet&) = delete;

  /// Whether a mesh is the same, triangle by triangle, with the same images.
  bool is_of(const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
             std::span<const MaterialTexture* const> materials) const;
  const impostor::SharedCutout& cutout() const { return mesh_->cutout; }
  const std::shared_ptr<const CutoutTexture>& cutout_texture() const { return cutout_; }
  /// Adds the instances of a tile whose origin is at `offset` in the world. Refers to both arguments.
  /// @param features  Of the tile.
  void add(const bake::InstancedMesh& instanced, const std::vector<OsmId>& features, Vec3 offset);
  /// Adds the instances to the uncommitted top scene, numbered from `first` in RTCHit::instID. The scene refers to this
  /// object, which must not move.
  void attach_to(RTCDevice device, RTCScene top, unsigned first);

  unsigned first() const { return first_; }
  std::size_t size() const { return transforms_.size(); }
  /// The hit, in the world's frame, on the instance of found.instID.
  Hit hit_in_world(const RTCHit& found, const RayFootprint& footprint) const;

 private:
  struct Calls;
  // The instances of one tile.
  struct Batch {
    std::size_t first;
    const bake::InstancedMesh* instanced;
    const std::vector<OsmId>* features;
  };

  OsmId feature_of(std::size_t instance) const;

  const bake::InstancedMesh* mesh_;
  std::vector<const MaterialTexture*> materials_;
  std::shared_ptr<const CutoutTexture> cutout_;
  std::vector<MeshPart> parts_;
  RTCScene scene_;
  Vec3 low_, high_;  // of the mesh
  std::vector<InstanceTransform> transforms_;
  std::vector<Batch> batches_;
  unsigned first_ = 0;
};

}  // namespace citykiln::preview
