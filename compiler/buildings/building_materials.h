// What a building is made of, and its colours.
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

struct BuildingMaterials {
  materials::Material wall{}, roof{};
};

/// Materials as tagged, else by class, height and the roof's form (dress.inc; glass above kGlassTower_m). Where a
/// tagged colour is brighter than the material can be tinted, a lighter one takes its place; glass stays glass. Drawn
/// from the footprint's id alone, since a recipe knows no seed. O(vertices).
BuildingMaterials building_materials(const map::Footprint& footprint, roofs::Form form);

/// Towers higher than this are glass where nothing is tagged.
inline constexpr double kGlassTower_m = 60;

/// The tints of a building. Tagged colours as paint of that colour, muted as weather does; others a brightness within
/// the material's variation, and for plaster one of the hues of old towns.
materials::Tint wall_tint(const Building& building, std::uint64_t seed);
materials::Tint roof_tint(const Building& building, std::uint64_t seed);

}  // namespace citykiln::buildings
