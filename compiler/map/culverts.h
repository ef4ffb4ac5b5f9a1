// Leads watercourses through the dams and dykes that cross them.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the watercourses with the parts inside a dam or dyke underground: a map has the line of the river go on
/// through the dam, and a bed there would cut the dam open. A watercourse becomes several, with part numbers along its
/// line; one that a dam's line does not cross stays as it is. Each crossing is decided by the dam and the watercourse
/// alone. O(n log n).
std::vector<Waterway> with_culverts(std::vector<Waterway> waterways, std::span<const Landform> landforms);

}  // namespace citykiln::map
