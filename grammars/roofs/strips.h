// Roofs that are one section drawn along a line: gabled, round, saltbox, skillion, and rows of teeth and gables; and
// two gabled roofs that cross. They are functions of the place alone, so they lie over any footprint.
#pragma once

#include <vector>

#include "grammars/roofs/facet.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// A roof of strips, with what it is measured by.
struct Strips {
  std::vector<Facet> facets;  ///< Cover the frame, and far beyond it.
  double error_m = 0;         ///< Of curves, at most the tolerance.
};

/// From the eaves to the ridge, in plan: what an angle is measured over.
double strip_span_m(Form form, const OrientedBox& frame, bool has_direction);

/// @param reach_m  How far beyond the frame the facets go: more than eaves stand out.
/// Rows run along the frame, or, if has_direction, across it. Other forms than those above are gabled.
Strips strips(Form form, const OrientedBox& frame, bool has_direction, double rise_m, double reach_m,
              double tolerance_m);

}  // namespace citykiln::roofs
