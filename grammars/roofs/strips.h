// Roofs of one section drawn along a line: gabled, round, saltbox, skillion, rows of teeth and gables, and two crossing
// gabled roofs. Their height depends only on the position, so they fit any footprint.
#pragma once

#include <vector>

#include "grammars/roofs/facet.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

struct Strips {
  std::vector<Facet> facets;  ///< The facets cover the box and its surroundings up to reach_m.
  double error_m = 0;         ///< The error of curves, at most the tolerance.
};

/// Returns the distance from the eaves to the ridge in plan, over which the angle of the roof is measured.
double strip_span_m(Form form, const OrientedBox& box, bool has_direction);

/// Returns the facets of a form. Rows run along the box, or across it if has_direction. Forms not listed above are
/// gabled.
/// @param reach_m  The distance by which facets extend beyond the box: more than the eaves.
Strips strips(Form form, const OrientedBox& box, bool has_direction, double rise_m, double reach_m, double tolerance_m);

}  // namespace citykiln::roofs
