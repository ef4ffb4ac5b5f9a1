// Reads tags whose values are words of materials and surfaces, and diagnoses words that no table has.
//
// A value may have several words (words_of() in tag_values.h); each function uses the first one that its table has.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/map/tags/read_context.h"
#include "compiler/materials/material.h"

namespace citykiln::map {

/// Returns the material of walls by the value of building:material=*, such as "Brick", "natural stone" or
/// "concrete/glass"; nothing if no word is in material_values.inc.
std::optional<materials::Material> wall_material_of(std::string_view value);
/// Returns the material of a roof by the value of roof:material=*; nothing if no word is in material_values.inc.
std::optional<materials::Material> roof_material_of(std::string_view value);
/// Returns whether a surface is paved, by the value of surface=*; nothing if no word is in surfaces.inc.
std::optional<bool> is_paved_surface(std::string_view value);
/// Returns the word by which the rules of things know a value of material=*, such as "wood" for "Timber"; nothing if no
/// word is in things/thing_materials.inc. The text is static.
std::optional<std::string_view> thing_material_of(std::string_view value);

/// Diagnoses kBadTagValue, once for each element whose box touches the extent and each of its tags that has only
/// unknown words. The keys are barrier, building, building:material, fence_type, material, roof:material, surface and
/// wall. Elements count whether they are built or not. Values with an indefinite word (is_indefinite()) are not
/// diagnosed. Call it after diagnose_unread(): a tag that kUnknownKind names is not named again. O(tags); each
/// different value is looked up once.
void diagnose_unknown_words(const ReadContext& context);

}  // namespace citykiln::map
