#include "preview/scene/baked_scene.h"

#include <algorithm>

namespace citykiln::preview {

BakedScene::BakedScene(RTCDevice device, std::span<const bake::BakedTile> tiles, Vec3 origin)
    : device_(device), origin_(origin), geometry_(device) {
  for (const bake::BakedTile& tile : tiles) add_primitives(tile);
  for (const bake::BakedTile& tile : tiles) add_instances(tile);
  geometry_.commit();
}

std::size_t BakedScene::bytes() const {
  std::size_t bytes = geometry_.bytes();
  for (const auto& set : geometry_.instance_sets()) bytes += set->mesh().bytes();
  for (const auto& texture : marking_atlases_) bytes += texture->bytes();
  for (const auto& texture : material_textures_) bytes += texture->bytes();
  for (const auto& texture : facade_atlases_) bytes += texture->bytes();
  return bytes;
}

// Tiles with equal marking atlases share one.
const MipTexture* BakedScene::marking_atlas_of(const bake::BakedTile& tile) {
  if (tile.marking_atlas.texels.empty()) return nullptr;
  const auto same =
      std::ranges::find_if(marking_atlases_, [&](const auto& other) { return other->image() == tile.marking_atlas; });
  if (same != marking_atlases_.end()) return same->get();
  return marking_atlases_.emplace_back(std::make_unique<MipTexture>(tile.marking_atlas)).get();
}

// Tiles with equal textures share them.
const MaterialTexture* BakedScene::material_of(const bake::BakedTile& tile, materials::Material material) {
  const auto own = std::ranges::find(tile.textures, material, &materials::Texture::material);
  if (own == tile.textures.end()) return nullptr;
  const auto same =
      std::ranges::find_if(material_textures_, [&](const auto& other) { return other->texture() == **own; });
  if (same != material_textures_.end()) return same->get();
  return material_textures_.emplace_back(std::make_unique<MaterialTexture>(**own)).get();
}

// No two tiles have equal facade atlases.
const FacadeAtlasTexture* BakedScene::facade_atlas_of(const bake::BakedTile& tile) {
  if (tile.facade_atlas.colour.texels.empty()) return nullptr;
  return facade_atlases_.emplace_back(std::make_unique<FacadeAtlasTexture>(tile.facade_atlas)).get();
}

void BakedScene::add_primitives(const bake::BakedTile& tile) {
  const MipTexture* marking_atlas = marking_atlas_of(tile);
  const FacadeAtlasTexture* facade_atlas = facade_atlas_of(tile);
  for (const bake::Primitive& primitive : tile.primitives) {
    if (primitive.triangles.empty()) continue;
    MeshPart part = mesh_part_of(primitive, tile.origin - origin_, marking_atlas, material_of(tile, primitive.material),
                                 facade_atlas);
    if (!primitive.features.empty()) part.features = &tile.features;
    add_emitters(part, emitters_);
    geometry_.add(std::move(part));
  }
}

// The cutout's texture, which meshes with equal cutouts share; null where there is none.
std::shared_ptr<const CutoutTexture> BakedScene::cutout_of(const bake::InstancedMesh& instanced) const {
  if (instanced.cutout->colour.texels.empty()) return nullptr;
  for (const auto& set : geometry_.instance_sets())
    if (const auto& like = set->mesh().cutout();
        like && (&like->cutout() == &*instanced.cutout || like->cutout() == *instanced.cutout))
      return like;
  return std::make_shared<CutoutTexture>(*instanced.cutout);
}

void BakedScene::add_instances(const bake::BakedTile& tile) {
  const MipTexture* marking_atlas = marking_atlas_of(tile);
  for (const bake::InstancedMesh& instanced : tile.instanced) {
    std::vector<const MaterialTexture*> used;
    for (const bake::Primitive& primitive : instanced.primitives) used.push_back(material_of(tile, primitive.material));
    const auto& sets = geometry_.instance_sets();
    const auto like =
        std::ranges::find_if(sets, [&](const auto& set) { return set->mesh().is_of(instanced, marking_atlas, used); });
    InstanceSet& set = like != sets.end()
                           ? **like
                           : geometry_.add(std::make_unique<InstanceSet>(std::make_shared<MeshScene>(
                                 device_, instanced.primitives, marking_atlas, used, cutout_of(instanced))));
    set.add(instanced, tile.features, tile.origin - origin_);
  }
}

}  // namespace citykiln::preview
