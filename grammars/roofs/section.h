// Cross sections: the rise of a roof from its eaves to its top, as a polyline.
//
//        .--        dome, round: an arc; mansard, gambrel: a knee; hipped: straight
//      /
//     |
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/vec.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// A polyline from the eaves to the top. x is the distance inward, 0 at the eaves and 1 at the ridge; y is the height,
/// 0 to 1.
struct Section {
  std::vector<Vec2> corners;
  double error_m = 0;  ///< Bounds the distance between the roofs of the polyline and of the curve, in metres.
};

/// Returns the section of a roof that is drawn along a line. The error is the distance of arcs from their chords.
///
/// @param span_m  The distance from the eaves to the ridge, in plan. > 0.
/// @param rise_m  The height of the ridge over the eaves. > 0.
/// Guarantees: x and y never decrease; error_m <= tolerance_m unless that needs more than 256 corners. Arcs are those
/// of a circle if rise_m <= span_m, else of an ellipse. They are halved until they are flat enough, which needs only
/// square roots, so the result is equal on every machine.
Section section_along(Form form, double span_m, double rise_m, double tolerance_m);

/// Returns the section of a roof over inset facets. Its sides meet at any angle, so the error is measured vertically,
/// which does not depend on the angle. Else like section_along().
/// @param knee  The knee of a mansard roof, if it is not the default.
Section section_over_skeleton(Form form, double span_m, double rise_m, double tolerance_m,
                              std::optional<Vec2> knee = {});

/// Returns the section of a roof over an apex. x is the distance from the apex relative to that of the eaves, from 1 to
/// 0; in an onion it exceeds 1. The error is that at the farthest corner, reach_m from the apex.
Section section_over_apex(Form form, double span_m, double reach_m, double rise_m, double tolerance_m);

}  // namespace citykiln::roofs
