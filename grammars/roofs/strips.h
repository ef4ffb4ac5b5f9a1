// Roofs of one section drawn along a line: gabled, round, saltbox, skillion, rows of teeth and gables, and two crossing
// gabled roofs. Their height depends on the position alone, so they fit any footprint.
#pragma once

#include <vector>

#include "grammars/roofs/facet.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

struct Strips {
  std::vector<Facet> facets;  ///< Cover the box, and more.
  double error_m = 0;         ///< Of curves, at most the tolerance.
};

/// From the eaves to the ridge in plan, over which an angle is measured.
double strip_span_m(Form form, const OrientedBox& box, bool has_direction);

/// @param reach_m  How far the facets extend beyond the box: more than the eaves.
/// Rows run along the box, or across it if has_direction. Forms not listed above are gabled.
Strips strips(Form form, const OrientedBox& box, bool has_direction, double rise_m, double reach_m, double tolerance_m);

}  // namespace citykiln::roofs
