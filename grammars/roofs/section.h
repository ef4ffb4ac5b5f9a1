// Sections: cross-sections of roofs, as polylines from the eaves to the top.
//
//        .--        dome, round: an arc; mansard, gambrel: with a knee; hipped: straight
//      /
//     |
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/vec.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// A polyline from the eaves to the top. x is the distance inward, 0 at the eaves and 1 at the ridge, except in the
/// result of section_over_apex(). y is the height, 0 to 1.
struct Section {
  std::vector<Vec2> corners;
  double error_m = 0;  ///< Bounds the distance in metres between the roof made from the polyline and the
                       ///< roof made from the exact curve.
};

/// Returns the section of a roof that is extruded along a line (strips.h). The error is the distance of arcs from their
/// chords.
///
/// @param span_m  The distance from the eaves to the ridge, in plan. > 0.
/// @param rise_m  The height of the ridge over the eaves. > 0.
/// Guarantees: x and y never decrease; error_m <= tolerance_m unless that needs more than 256 corners. Arcs are
/// circular if rise_m <= span_m, else elliptic. Arcs are halved until the chords are within the tolerance, which needs
/// only square roots, so the result is equal on every machine.
Section section_along(RoofForm form, double span_m, double rise_m, double tolerance_m);

/// Returns the section of a roof over a straight skeleton (inset_facets.h). The sides of such a roof meet at any angle,
/// so the error is the largest vertical distance, which is equal for every angle. Parameters and guarantees are equal
/// to section_along().
/// @param knee  The knee of a mansard roof, as shares of span (x) and rise (y); empty for the default.
Section section_over_skeleton(RoofForm form, double span_m, double rise_m, double tolerance_m,
                              std::optional<Vec2> knee = {});

/// Returns the section of a roof over an apex (apex.h). Here x is measured the other way: it is the distance from the
/// apex as a share of the distance between apex and eaves, so it falls from 1 at the eaves to 0 at the apex. In an
/// onion x exceeds 1. The error is valid for the corner of the footprint that is farthest from the apex.
/// @param reach_m  The distance from the apex to that corner, in plan.
Section section_over_apex(RoofForm form, double span_m, double reach_m, double rise_m, double tolerance_m);

}  // namespace citykiln::roofs
