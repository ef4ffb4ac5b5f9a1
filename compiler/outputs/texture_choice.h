// The textures that a run writes: those of citykiln, finer ones, or those of artists.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/materials/texture_cache.h"
#include "compiler/outputs/material_sets.h"
#include "compiler/spec.h"

namespace citykiln::outputs {

/// A texture of an artist in two versions.
struct ChosenTexture {
  materials::SharedTexture whole;        ///< With normals and roughness, for fine levels.
  materials::SharedTexture colour_only;  ///< For levels without normals.
};

/// Replaces the textures of baked tiles. Thread-safe.
class TextureChoice {
 public:
  /// @param seed  The header's.
  TextureChoice(const Outputs& outputs, std::uint64_t seed, const std::vector<MaterialSet>& sets);

  /// Replaces a tile's textures as the settings say. Tiles whose tolerance has no Detail::kGroundNormals get textures
  /// without normals and roughness.
  void apply(bake::BakedTile& tile) const;
  /// A hash of what is replaced; 0 if nothing is.
  std::uint64_t hash() const { return hash_; }

 private:
  std::vector<ChosenTexture> own_;
  bool is_fine_;
  materials::TextureCache fine_;
  std::uint64_t hash_ = 0;
};

/// Returns lines with the credits of sets, such as "flemish brick: Jane Doe, CC0".
std::vector<std::string> credits_of(const std::vector<MaterialSet>& sets);

/// Returns the sets of the outputs' folder of materials, at the size that the outputs ask for. Errors: those of
/// read_material_sets().
Result<std::vector<MaterialSet>> sets_of(const Outputs& outputs);

}  // namespace citykiln::outputs
