// Assumes the roofs of buildings without roof:shape.
#pragma once

#include <cstdint>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Sets the roof shape, pitch and material of buildings without roof:shape as tags would, by group of countries,
/// storeys, area, and whether the building touches others (roofs.inc). A tagged material, colour, height, angle or
/// direction stays. Buildings in a row have equal random draws, mostly (kHeightRow_m), and ridges across their party
/// walls.
///
/// Parts, buildings with parts, roofs without walls and classes with a roof of their own (halls, barns, churches,
/// garages, towers and the like) keep the roofs of plan_roof(). Storeys are those of assume_heights(), which has to run
/// first where its assumption is on.
map::Features assume_roofs(map::Features features, std::uint64_t seed, Report& report);

}  // namespace citykiln::assume
