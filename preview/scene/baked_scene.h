// Whole baked tiles in one Embree scene. Tiles share equal meshes and images.
#pragma once

#include <span>

#include "preview/scene/scene_geometry.h"

namespace citykiln::preview {

/// Baked tiles in Embree. Refers to the tiles, which must outlive this object.
class BakedScene {
 public:
  /// @param origin  The world's origin in plane metres.
  BakedScene(RTCDevice device, std::span<const bake::BakedTile> tiles, Vec3 origin);

  const SceneGeometry& geometry() const { return geometry_; }
  /// Returns the triangles that shine, indexed by Hit::emitter, without triangles of instances.
  std::span<const Emitter> emitters() const { return emitters_; }
  /// Returns the bytes of corners, instances and textures, without the tiles and Embree's hierarchies.
  std::size_t bytes() const;

 private:
  const MipTexture* marking_atlas_of(const bake::BakedTile& tile);
  const MaterialTexture* material_of(const bake::BakedTile& tile, materials::Material material);
  const FacadeAtlasTexture* facade_atlas_of(const bake::BakedTile& tile);
  std::shared_ptr<const CutoutTexture> cutout_of(const bake::InstancedMesh& instanced) const;
  void add_primitives(const bake::BakedTile& tile);
  void add_instances(const bake::BakedTile& tile);

  RTCDevice device_;
  Vec3 origin_;
  std::vector<std::unique_ptr<MipTexture>> marking_atlases_;
  std::vector<std::unique_ptr<MaterialTexture>> material_textures_;
  std::vector<std::unique_ptr<FacadeAtlasTexture>> facade_atlases_;
  std::vector<Emitter> emitters_;
  SceneGeometry geometry_;
};

}  // namespace citykiln::preview
