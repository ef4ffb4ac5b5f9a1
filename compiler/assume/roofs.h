// Assumes the roofs of buildings without roof:shape.
#pragma once

#include <cstdint>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the features with assumed roofs: a building without roof:shape gets a roof shape, pitch and material as tags
/// would give them. They depend on country group, building tradition, storeys, area, and whether it touches another
/// building (roofs.inc). A tagged material, colour, angle or direction stays. A building in a row uses the random draw
/// of drawing_member() (heights.h); if its roof is gabled, or a mansard of a building tradition, the ridge is at a
/// right angle to its longest party wall.
///
/// Some footprints keep the roofs of plan_roof(): parts, buildings with parts, buildings off the ground, with a tagged
/// height of the roof or without walls, and classes that have a special roof, such as halls, barns, churches, garages
/// and towers.
///
/// If storeys are assumed too, assume_heights() has to run before. The radius is kHeightRow_m, from centroid to
/// centroid, and the buildings that touch those within it.
std::vector<map::Footprint> assume_roofs(const map::FeatureView& features, std::uint64_t seed, Report& report);

}  // namespace citykiln::assume
