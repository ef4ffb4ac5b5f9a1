// What names in a .glb say: of materials, and of pictures.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/bake/baked.h"

namespace citykiln::exporters {

std::optional<materials::Material> material_called(std::string_view name);

/// A name's beginning, where it ends so.
std::optional<std::string_view> without(std::string_view name, std::string_view ending);

/// Inverse of material_name() (glb.h), but for whether there are uvs, which is not for the material to say. Throws
/// Wrong.
bake::PrimitiveKey key_named(const std::string& name);

}  // namespace citykiln::exporters
