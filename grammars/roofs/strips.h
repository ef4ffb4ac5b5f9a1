// Roofs that are one section (a cross-section as a polyline) extruded along a line: gabled, round, saltbox, skillion,
// rows of teeth and gables, and two crossing gabled roofs. The height depends only on the position, so these roofs fit
// any footprint.
#pragma once

#include <vector>

#include "grammars/roofs/facet.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// The facets of such a roof: pieces of the plan over which it is planar.
struct Strips {
  std::vector<Facet> facets;  ///< The facets cover the box and its surroundings up to reach_m.
  double error_m = 0;         ///< The error of curves, at most the tolerance.
};

/// Returns the distance from the eaves to the ridge in plan. Rise over this distance is the tangent of the roof's
/// angle.
/// @param has_direction  The roof has a mapped direction (RoofShape::direction).
double strip_span_m(RoofForm form, const OrientedBox& box, bool has_direction);

/// Returns the facets of a form. Forms that are not listed at the top of this file are gabled.
/// @param reach_m  The distance by which facets extend beyond the box: more than the eaves.
/// @param has_direction  The roof has a mapped direction: rows of teeth or gables follow each other across the box
/// instead of along it.
/// @param rise_m   The height of the ridge over the eaves plane.
Strips strips(RoofForm form, const OrientedBox& box, bool has_direction, double rise_m, double reach_m,
              double tolerance_m);

}  // namespace citykiln::roofs
