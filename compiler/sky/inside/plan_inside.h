// Plans the light and the air inside of a cylinder.
#pragma once

#include "compiler/geometry/box.h"
#include "compiler/sky/inside/recipe.h"

namespace citykiln::sky {

/// Illuminance of level ground in the middle of the map by all lines, when nothing blocks them: a bright day.
inline constexpr double kInsideDaylight_lx = 60000;

/// Returns the inside of a cylinder around a map. After Rama: six lines, three on either side of the middle along the
/// axis, a third of a turn apart, none above the middle of the map; their colour is daylight's. The cylinder is as long
/// as the map with a radius on either side, at least three times its diameter. Same bytes on every CPU.
/// @param extent  The extent of the map, plane metres.
Inside plan_inside(const map::Cylinder& cylinder, const Box2& extent);

/// Returns the illuminance of level ground by all lines in lux, without air and shadows.
///
/// @param at  The place of the ground, plane metres.
double daylight_lx(const Inside& inside, Vec3 at);

}  // namespace citykiln::sky
