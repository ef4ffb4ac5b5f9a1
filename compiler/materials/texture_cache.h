// Cache of textures, each generated once for all tiles.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/materials/texture.h"

namespace citykiln::materials {

/// A cache of textures. Thread-safe. A texture is a function of the seed and the arguments. Memory: up to 3 MB per
/// texture at scale 1, as long as the cache lives.
class TextureCache {
 public:
  /// @param scale  Multiplies the texels of a side: a power of two.
  /// @param own    Textures that replace the drawn ones of their materials, whatever the scale. At tolerances where
  ///               the drawn one has no normals they lose theirs, and their roughness.
  explicit TextureCache(std::uint64_t seed, std::uint32_t scale = 1, std::vector<Texture> own = {})
      : seed_(seed), scale_(scale), own_(std::move(own)) {}

  /// Returns the textures of all materials in a list that have one, in order.
  /// @param materials  Sorted, unique.
  std::vector<SharedTexture> textures_of(std::span<const Material> materials, double tolerance_m) const;
  /// Returns the texture of a material. Precondition: has_texture().
  SharedTexture texture(Material material, double tolerance_m) const;

 private:
  Texture made(Material material, double tolerance_m) const;

  struct Slot {
    std::once_flag once;
    std::optional<SharedTexture> texture;
  };

  std::uint64_t seed_;
  std::uint32_t scale_;
  std::vector<Texture> own_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<Material, bool>, Slot> slots_;  // with normals or without
};

}  // namespace citykiln::materials
