// The input of all roof methods: a cleaned footprint with its box and eaves.
#pragma once

#include <optional>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// The thickness of overhanging eaves, about that of rafters and tiles; lifts the roof by it.
inline constexpr double kThickness_m = 0.1875;

struct RoofInput {
  Polygon footprint;  ///< As made by cleaned().
  Polygon eaves;      ///< Around it; empty for no overhang.
  OrientedBox box;
  RoofShape shape;
  double tolerance_m = 0;  ///< What remains of it after eaves were left out.
  Vec2 left_out_m;         ///< Eaves below the tolerance: their overhang and thickness.
};

/// Computes the box, and the eaves of forms that can have them. @param footprint  Not empty.
RoofInput roof_input(Polygon footprint, const RoofShape& shape, double tolerance_m);

/// The height of a roof whose main slopes are span_m long in plan.
double rise_of(const RoofShape& shape, double span_m);

/// The knee of a shape that has one, as shares of the span and the rise. If the slopes do not meet before the ridge,
/// they are one; so is a knee at the eaves and the slope above it.
std::optional<Vec2> knee_of(const RoofShape& shape, double span_m);

}  // namespace citykiln::roofs
