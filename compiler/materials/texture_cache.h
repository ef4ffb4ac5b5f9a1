// Textures, each drawn once, however many tiles show it.
#pragma once

#include <map>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "compiler/materials/texture.h"

namespace citykiln::materials {

/// From any thread. Logically const: a texture is a function of the seed and what is asked for. Memory: what has been
/// asked for, about a megabyte each at most.
class TextureCache {
 public:
  explicit TextureCache(std::uint64_t seed) : seed_(seed) {}

  /// As textures_of() makes them.
  std::vector<Texture> textures_of(std::span<const Material> materials, double tolerance_m) const;

 private:
  struct Slot {
    std::once_flag once;
    Texture texture;
  };

  const Texture& texture(Material material, double tolerance_m) const;

  std::uint64_t seed_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<Material, double>, Slot> slots_;
};

}  // namespace citykiln::materials
