// Sections: how a roof rises from its eaves, as a line with corners.
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

/// Corners from the eaves to the top. x: how far in, 0 at the eaves, 1 at the ridge; y: how high, 0 to 1.
struct Section {
  std::vector<Vec2> corners;
  double error_m = 0;  ///< Largest distance between the roofs of the lines and of the curve they stand for.
};

/// The section of a roof that is drawn along a line: its error is how far arcs bulge from their chords.
///
/// @param span_m  From the eaves to the ridge or pole, in plan. > 0.
/// @param rise_m  Height of the ridge over the eaves. > 0.
/// Guarantees: x never falls, y never falls; error_m <= tolerance_m while that needs no more than 256 corners. An arc
/// is a circle's while rise_m <= span_m, an ellipse's above. Square roots only: an arc is halved until it is flat
/// enough.
Section section_along(Form form, double span_m, double rise_m, double tolerance_m);

/// The section of a roof over a base, whose sides meet at any angle: so its error is measured upright, where no angle
/// makes it larger. Else as section_along().
/// @param knee  Of a mansard, if not its own.
Section section_over_skeleton(Form form, double span_m, double rise_m, double tolerance_m,
                              std::optional<Vec2> knee = {});

/// The section of a body over a pole: x is the distance from the pole over that of the eaves, from 1 to 0, and an
/// onion's swells. Its error is that of the farthest corner, reach_m from the pole.
Section section_over_apex(Form form, double span_m, double reach_m, double rise_m, double tolerance_m);

}  // namespace citykiln::roofs
