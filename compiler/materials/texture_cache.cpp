#include "compiler/materials/texture_cache.h"

namespace citykiln::materials {

std::vector<SharedTexture> TextureCache::textures_of(std::span<const Material> materials, double tolerance_m) const {
  std::vector<SharedTexture> textures;
  for (const Material material : materials)
    if (has_texture(material, tolerance_m)) textures.push_back(texture(material, tolerance_m));
  return textures;
}

SharedTexture TextureCache::texture(Material material, double tolerance_m) const {
  // references to map elements stay valid when others are inserted
  Slot& slot = [&]() -> Slot& {
    const std::lock_guard lock(mutex_);
    return slots_[{material, has_normals(material, tolerance_m)}];
  }();
  std::call_once(slot.once, [&] { slot.texture.emplace(texture_of(material, tolerance_m, seed_, scale_)); });
  return *slot.texture;
}

}  // namespace citykiln::materials
