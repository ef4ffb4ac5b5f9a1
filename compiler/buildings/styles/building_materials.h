// The materials and tints of buildings.
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// The materials of walls and roof.
struct BuildingMaterials {
  materials::Material wall{}, roof{};
};

/// The height above which buildings without a tagged material have glass facades, except classes with walls of stone.
inline constexpr double kGlassTower_m = 60;

/// Returns the materials of a footprint: the tagged ones, else by class, height and roof form (building_materials.inc).
/// If the material cannot be tinted to a tagged colour, a lighter one is chosen; glass stays glass. Random draws depend
/// only on the footprint's id, since a recipe has no seed. O(vertices).
BuildingMaterials building_materials(const map::Footprint& footprint, roofs::RoofForm form);

/// Returns the materials of a footprint whose style is known: as building_materials(), but where Assumption::kStyles is
/// among those of the footprint, untagged walls and tiled roofs are those of its country group.
BuildingMaterials regional_materials(const map::Footprint& footprint, roofs::RoofForm form, Style style);

/// Returns the tint of the walls or of the roof: towards the tagged colour, else a random brightness within the
/// material's variation, for plaster with one of 16 hues.
materials::Tint wall_tint(const Building& building, std::uint64_t seed);
materials::Tint roof_tint(const Building& building, std::uint64_t seed);

}  // namespace citykiln::buildings
