// Materials and tints of buildings.
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

struct BuildingMaterials {
  materials::Material wall{}, roof{};
};

/// Buildings without tagged material and higher than this have glass facades.
inline constexpr double kGlassTower_m = 60;

/// Returns the materials of a footprint: as tagged, otherwise by class, height and roof form (building_materials.inc).
/// A tagged colour that the material cannot be tinted to selects a lighter material; glass stays glass. Random draws
/// depend on the footprint's id alone, since a recipe has no seed. O(vertices).
BuildingMaterials building_materials(const map::Footprint& footprint, roofs::Form form);

/// Returns the tint of the walls or of the roof: towards the tagged colour, otherwise a random brightness within the
/// material's variation, and for plaster one of 16 hues.
materials::Tint wall_tint(const Building& building, std::uint64_t seed);
materials::Tint roof_tint(const Building& building, std::uint64_t seed);

}  // namespace citykiln::buildings
