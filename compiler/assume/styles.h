// Marks the buildings whose style is assumed to be the usual one of their country group.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the footprints with Assumption::kStyles in Footprint::assumed of every one. The planning of buildings
/// then takes the style, and the materials and colours that are not tagged, from Footprint::country: it chooses one of
/// the styles of the group by storeys and party walls (buildings/style.h). The radius is 0: no mark depends on another
/// footprint.
std::vector<map::Footprint> assume_styles(std::span<const map::Footprint> footprints, Report& report);

}  // namespace citykiln::assume
