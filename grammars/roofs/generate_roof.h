// Any roof of Simple 3D Buildings on any footprint. Which method makes which, and why it closes: roofs.md.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/straight_skeleton.h"
#include "grammars/roofs/roof.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// Makes the roof.
///
/// @param footprint    Plane metres on the plane's grid (2^-7 m); any rings: what is inside of an odd number is roofed.
/// @param tolerance_m  Curves are as flat as it allows, knees and eaves that it does not see are left out, and a roof
/// that
///                     rises no higher is flat; error_m says how far that moved it. > 0.
/// @param object       Whom diagnoses name.
/// Guarantees: roof, eaves and floor close, whatever the footprint; no vertex of the footprint moves; ridges run along
/// the longer side unless told otherwise. Total: where no roof of the shape can be made it is flat, diagnosed
/// kRoofFallback; a footprint without area has no roof, diagnosed so too. Draws no chance; the same bytes for the same
/// input. Cost: some 50 µs over a rectangle, 1 ms where a skeleton is needed, more than linear in the footprint's
/// corners.
Roof generate_roof(const Polygon& footprint, const RoofShape& shape, double tolerance_m, OsmId object, Report& report);

/// The same by the straight skeleton alone, in one kernel, for charts; nothing where it fails. Forms as mansard,
/// gabled.
std::optional<Roof> roof_by_skeleton(const Polygon& footprint, const RoofShape& shape, double tolerance_m,
                                     SkeletonKernel kernel);

}  // namespace citykiln::roofs
