// What names in a .glb say: of materials, and of pictures.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

std::optional<materials::Material> material_named(std::string_view name);

/// A name's beginning, where it ends so.
std::optional<std::string_view> strip_suffix(std::string_view name, std::string_view ending);

/// Inverse of material_name() (glb.h), but for whether there are uvs, which is not for the material to say. Throws
/// FormatError.
bake::PrimitiveKey primitive_key_named(const std::string& name);

}  // namespace citykiln::exporters
