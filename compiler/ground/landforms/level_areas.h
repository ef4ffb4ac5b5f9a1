// Planes of areas that are built level: pitches, courts, running tracks, helipads and small aprons,
// large car parks, wide squares.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/landforms/recipe.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// True if an area is built as a plane: its class and size have a row in level_areas.inc.
bool is_level_area(const map::AreaFeature& area);

/// Returns a landform of LandformKind::kLevel for each area of is_level_area(), in their order.
/// Areas that contain none of their samples, or whose terrain is level already, are skipped.
///
/// The plane is that of fitted_surface() for the terrain inside the outline, no steeper than the
/// row of the class allows. Areas of sports within 1 m of each other, such as a pitch within a
/// running track, have one plane, with the smallest of their slopes. The result depends only on the
/// terrain in areas that are connected this way. Samples form a square grid, 0.5 m or more apart:
/// about 100 to 600 in each area. O(n log n), n: points and samples.
std::vector<Landform> level_areas(std::span<const map::AreaFeature> areas, const map::Heightfield& heights);

}  // namespace citykiln::ground
