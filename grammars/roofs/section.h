// Cross sections: how a roof rises from its eaves, as a polyline.
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

/// Corners from the eaves to the top. x: distance inward, 0 at the eaves, 1 at the ridge; y: height, 0 to 1.
struct Section {
  std::vector<Vec2> corners;
  double error_m = 0;  ///< Bounds the distance between the roofs of the polyline and of the curve.
};

/// The section of a roof that is drawn along a line. The error is the distance of arcs from their chords.
///
/// @param span_m  From the eaves to the ridge, in plan. > 0.
/// @param rise_m  The height of the ridge over the eaves. > 0.
/// Guarantees: x and y never decrease; error_m <= tolerance_m as long as that needs at most 256 corners. An arc is that
/// of a circle if rise_m <= span_m, else of an ellipse. Arcs are halved until they are flat enough, which needs square
/// roots only, so the result is the same on every machine.
Section section_along(Form form, double span_m, double rise_m, double tolerance_m);

/// The section of a roof over inset facets. Its sides meet at any angle, so the error is measured vertically, which
/// does not depend on the angle. Otherwise as section_along().
/// @param knee  Of a mansard roof, if it is not the default.
Section section_over_skeleton(Form form, double span_m, double rise_m, double tolerance_m,
                              std::optional<Vec2> knee = {});

/// The section of a roof over an apex: x is the distance from the apex relative to that of the eaves, from 1 to 0; that
/// of an onion exceeds 1. The error is that at the farthest corner, reach_m from the apex.
Section section_over_apex(Form form, double span_m, double reach_m, double rise_m, double tolerance_m);

}  // namespace citykiln::roofs
