// Generates a roof of any form of OpenStreetMap's Simple 3D Buildings on any footprint. roofs.md explains the methods.
#pragma once

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/polygons/straight_skeleton.h"
#include "grammars/roofs/roof.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// Generates the roof. Without a direction, ridges run along the longer side of the footprint. Draws no random numbers.
///
/// @param footprint  Plane metres, multiples of 2^-7 m. Any rings: the even-odd rule applies.
/// @param tolerance_m  > 0. Bounds the error of curves. Knees and eaves smaller than the tolerance are left out, and a
/// roof that rises no higher is flat. Roof::error_m is the resulting error.
/// @param object  The OSM element that diagnoses name.
/// Guarantees: roof, eaves and floor are closed for any footprint; no vertex of the footprint moves.
/// Bad input: if the form cannot be built, the roof is flat, with a diagnosis kRoofFallback; a footprint without area
/// has no roof, with the same diagnosis.
/// Cost: about 50 µs over a rectangle, 1 ms with a skeleton; more than linear in the number of corners.
Roof generate_roof(const Polygon& footprint, const RoofShape& shape, double tolerance_m, OsmId object, Report& report);

/// Generates the roof by the straight skeleton, computed in the number type of one kernel, for charts. Returns
/// std::nullopt if that fails.
/// @param shape  Has a form that is built over a skeleton, such as mansard or gabled.
std::optional<Roof> roof_by_skeleton(const Polygon& footprint, const RoofShape& shape, double tolerance_m,
                                     SkeletonKernel kernel);

}  // namespace citykiln::roofs
