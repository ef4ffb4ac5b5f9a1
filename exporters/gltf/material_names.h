// Names of materials in a .glb.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// The name of the material of primitives with this key: the material's own, "Asphalt", with a suffix where needed:
///
/// | suffix     | primitives                                                                  |
/// |------------|-----------------------------------------------------------------------------|
/// | Marked     | on the marking atlas                                                        |
/// | FacadeAtlas | on the facade atlas                                                        |
/// | Cutout     | on a cutout: alphaMode MASK, double-sided                                   |
/// | Untextured | without uvs, where one of the tile's textures belongs to the material       |
///
/// In a .glb tile, tolerance and a number may follow, so that names are unique: "PaintFacadeAtlas_0_-1_0.5m".
std::string material_name(const bake::PrimitiveKey& key, std::span<const materials::Texture> textures);

/// The material of this name, if there is one.
std::optional<materials::Material> material_named(std::string_view name);

/// The name without the suffix; nothing where it has another.
std::optional<std::string_view> strip_suffix(std::string_view name, std::string_view suffix);

/// Inverse of material_name(), without what follows an underscore in the name; has_uvs is false where the name does not
/// imply uvs, and the layer is not known. Throws FormatError.
bake::PrimitiveKey primitive_key_named(const std::string& name);

}  // namespace citykiln::exporters
