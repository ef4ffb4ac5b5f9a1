// Names of materials in a .glb.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Returns the name of the material of primitives with this key: the material's own, "Asphalt", with a suffix if
/// needed:
///
/// | suffix     | primitives                                                                  |
/// |------------|-----------------------------------------------------------------------------|
/// | Marked     | on the marking atlas                                                        |
/// | FacadeAtlas | on the facade atlas                                                        |
/// | Cutout     | on a cutout: alphaMode MASK, double-sided                                   |
/// | Untextured | without uvs, where one of the tile's textures belongs to the material       |
///
/// In a .glb the tile, the tolerance and a number may follow, so that names are unique: "PaintFacadeAtlas_0_-1_0.5m".
std::string material_name(const bake::PrimitiveKey& key, std::span<const materials::SharedTexture> textures);

/// Returns the material of this name, if there is one.
std::optional<materials::Material> material_named(std::string_view name);

/// Returns the name without the suffix; std::nullopt if it does not end with it.
std::optional<std::string_view> strip_suffix(std::string_view name, std::string_view suffix);

/// Returns the key of a name: the inverse of material_name(). Ignores the part after an underscore. The key has no
/// layer, and has_uvs only if the name implies uvs. Throws FormatError.
bake::PrimitiveKey primitive_key_named(const std::string& name);

}  // namespace citykiln::exporters
