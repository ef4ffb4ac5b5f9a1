// Words of materials and surfaces, and a finding for those that the program does not know.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/map/tags/read_context.h"
#include "compiler/materials/material.h"

namespace citykiln::map {

/// Returns the material of walls by building:material=*, such as "Brick", "natural stone" or "concrete/glass" (the
/// first word that is known); nothing if no word is in material_values.inc.
std::optional<materials::Material> wall_material_of(std::string_view value);
/// Returns the material of a roof by roof:material=*; nothing if no word is known.
std::optional<materials::Material> roof_material_of(std::string_view value);
/// Returns whether surface=* is paved; nothing if no word is in surfaces.inc.
std::optional<bool> is_paved_surface(std::string_view value);
/// Returns the word that rules of things have for material=*: "wood" for "Timber"; nothing if no word is in
/// things/thing_materials.inc.
std::optional<std::string_view> thing_material_of(std::string_view value);

/// Diagnoses kBadTagValue for each tag that touches the extent and whose key is barrier, building, building:material,
/// fence_type, material, roof:material, surface or wall, if none of its words is known and none is indefinite
/// (is_indefinite): on any element, built or not. Call it after diagnose_unread(): a tag that kUnknownKind names is not
/// named again. O(n).
void diagnose_unknown_words(const ReadContext& context);

}  // namespace citykiln::map
