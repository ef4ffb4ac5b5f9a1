// The records of features for the page: where each element is, and the recipe that was made of it.
#pragma once

#include "compiler/map/plane/geoid.h"
#include "compiler/scene/scene.h"
#include "exporters/page/page_json.h"

namespace citykiln::outputs {

/// Returns the record of each element that a recipe of the scene is made of. The recipe is that of the element's first
/// object: of buildings, bridges, tunnels, roads, watercourses, barriers, plants, lamps, things, wires and land, in
/// this order. Places are on the ellipsoid, in the frame of the tileset's root. O(n log n).
exporters::FeatureRecords page_records(const scene::Scene& scene, const map::Geoid& geoid);

}  // namespace citykiln::outputs
