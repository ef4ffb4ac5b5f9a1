// Sections: how a roof rises from its eaves, as a line with corners.
//
//        .--        dome, round: an arc; mansard, gambrel: a knee; hipped: straight
//      /
//     |
#pragma once

#include <vector>

#include "compiler/geometry/vec.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// Corners from the eaves to the top. x: the way from the eaves (0) to the ridge or pole (1), y: the height over the
/// eaves, 0 to 1. In `over_poles`, x is the distance from the pole instead, 1 at the eaves, 0 at the pole, and may
/// swell.
struct Section {
  std::vector<Vec2> corners;
  double error_m = 0;  ///< Largest distance between the lines and the curve they stand for.
};

/// The section of a roof that rises over a distance from its eaves: x never falls, y never falls.
///
/// @param span_m  From the eaves to the ridge or pole, in plan. > 0.
/// @param rise_m  Height of the ridge over the eaves. > 0.
/// Guarantees: error_m <= tolerance_m. An arc is a circle's while rise_m <= span_m, an ellipse's above. Square roots
/// only: an arc is halved until it is flat enough.
Section section_of(Form form, double span_m, double rise_m, double tolerance_m);

/// The section of a body of revolution: cone, dome, onion. x is the distance from the pole over that of the eaves, and
/// an onion's swells beyond 1; y never falls.
Section section_over_pole(Form form, double span_m, double rise_m, double tolerance_m);

}  // namespace citykiln::roofs
