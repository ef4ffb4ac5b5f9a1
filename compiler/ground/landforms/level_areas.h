// Planes of areas that are built level: pitches, courts, running tracks, helipads, large car parks, wide squares.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/ground/landforms/recipe.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// True if an area is built as a plane (level_areas.inc).
bool is_level_area(const map::AreaFeature& area);

/// Returns a landform of kind kLevel for each area of is_level_area(), in their order.
///
/// Its plane is fitted to the terrain in it (fitted_surface()), no steeper than its class allows. Areas of sports that
/// touch or overlap, such as a pitch within a running track, have one plane. Depends on the terrain in the areas that
/// touch each other. O(areas · 200 samples).
std::vector<Landform> level_areas(std::span<const map::AreaFeature> areas, const map::Heightfield& heights);

}  // namespace citykiln::ground
