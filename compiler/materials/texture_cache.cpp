#include "compiler/materials/texture_cache.h"

#include <algorithm>

namespace citykiln::materials {

std::vector<SharedTexture> TextureCache::textures_of(std::span<const Material> materials, double tolerance_m) const {
  std::vector<SharedTexture> textures;
  for (const Material material : materials)
    if (has_texture(material, tolerance_m)) textures.push_back(texture(material, tolerance_m));
  return textures;
}

Texture TextureCache::made(Material material, double tolerance_m) const {
  const auto own = std::ranges::find(own_, material, &Texture::material);
  if (own == own_.end()) return texture_of(material, tolerance_m, seed_, scale_);
  Texture texture = *own;
  if (!has_normals(material, tolerance_m)) texture.normal = {}, texture.surface = {};
  return texture;
}

SharedTexture TextureCache::texture(Material material, double tolerance_m) const {
  // references to map elements stay valid when others are inserted
  Slot& slot = [&]() -> Slot& {
    const std::lock_guard lock(mutex_);
    return slots_[{material, has_normals(material, tolerance_m)}];
  }();
  std::call_once(slot.once, [&] { slot.texture.emplace(made(material, tolerance_m)); });
  return *slot.texture;
}

}  // namespace citykiln::materials
