// All instances of one mesh. They are one user geometry of Embree, which transforms rays into the mesh's frame, at 32
// bytes an instance (Embree's own instances take some 500 bytes).
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

/// The placement of an instance: 32 bytes.
struct InstanceTransform {
  bake::Float3 translation;  ///< Metres from the world's origin.
  float scale = 1;
  bake::Float4 rotation;  ///< Unit quaternion x, y, z, w.
};

/// A mesh and the placements of its instances. First add() the instances of all tiles, then attach_to() once; box_of()
/// and size() may be called any time, hit_in_world() after attach_to(). Instances are counted from 0 in the order in
/// which they are added.
class InstanceSet {
 public:
  explicit InstanceSet(std::shared_ptr<const MeshScene> mesh) : mesh_(std::move(mesh)) {}
  InstanceSet(const InstanceSet&) = delete;
  InstanceSet& operator=(const InstanceSet&) = delete;

  const MeshScene& mesh() const { return *mesh_; }
  /// Adds the instances of a tile. Refers to `instanced` and `features`, which must outlive this object. Must not be
  /// called after attach_to().
  ///
  /// @param instanced  Instances of mesh(), which MeshScene::is_of() tests.
  /// @param features   The OSM objects of the tile, which instances index.
  /// @param offset     The tile's origin in the frame of the world: metres from the world's origin, z up.
  void add(const bake::InstancedMesh& instanced, const std::vector<OsmId>& features, Vec3 offset);
  /// Adds all instances to a scene that is not committed yet. In RTCHit::instID, instance i has the number `first` + i.
  /// The scene refers to this object, which must not move.
  void attach_to(RTCDevice device, RTCScene top, unsigned first);

  /// Returns the box of an instance in the world's frame; empty for a mesh without triangles.
  ///
  /// @param instance  From 0, without first().
  RTCBounds box_of(std::size_t instance) const;
  unsigned first() const { return first_; }
  std::size_t size() const { return transforms_.size(); }
  std::size_t bytes() const { return transforms_.capacity() * sizeof(InstanceTransform); }  ///< Without the mesh.
  /// Returns the hit on the instance found.instID, in the world's frame.
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

  std::shared_ptr<const MeshScene> mesh_;
  std::vector<InstanceTransform> transforms_;
  std::vector<Batch> batches_;
  unsigned first_ = 0;
};

}  // namespace citykiln::preview
