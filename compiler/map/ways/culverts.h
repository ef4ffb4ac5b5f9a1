// Leads watercourses through the dams and dykes that cross them, in culverts.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the watercourses; their parts inside a dam or dyke become tunnels. On a map the river's line runs on through
/// a dam, and a river bed there would cut the dam in two.
///
/// A culvert ends at the dam's foot: as far beside the dam's edge as the dam is high, for a dyke twice as far. Its
/// watercourse becomes several, with increasing ObjectId::part. Watercourses off the ground, and those that cross no
/// dam's line, stay unchanged. Each crossing depends on the dam and the watercourse only. O(n log n).
std::vector<Waterway> with_culverts(std::vector<Waterway> waterways, std::span<const Landform> landforms);

}  // namespace citykiln::map
