// The common input of all roof methods: a cleaned footprint with its box and eaves.
#pragma once

#include <optional>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// The thickness of overhanging eaves, by which the roof is lifted: about that of rafters and tiles.
inline constexpr double kThickness_m = 0.1875;

struct RoofInput {
  Polygon footprint;  ///< The result of cleaned().
  Polygon eaves;      ///< The outline of the eaves; empty: no overhang.
  OrientedBox box;
  RoofShape shape;
  double tolerance_m = 0;  ///< The tolerance less the share spent on eaves that were left out.
  Vec2 left_out_m;         ///< The overhang and the thickness of eaves that were left out, being below the tolerance.
};

/// Computes the box, and the eaves if the form can have them. @param footprint  Not empty.
RoofInput roof_input(Polygon footprint, const RoofShape& shape, double tolerance_m);

/// Returns the height of a roof whose main slopes are span_m long in plan.
double rise_of(const RoofShape& shape, double span_m);

/// Returns the knee of a shape that has one, as shares of the span and the rise. A knee beyond the ridge is moved to
/// the ridge, and one below the eaves to the eaves, which leaves one slope.
std::optional<Vec2> knee_of(const RoofShape& shape, double span_m);

}  // namespace citykiln::roofs
