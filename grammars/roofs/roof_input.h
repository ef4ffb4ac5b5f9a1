// Where a roof is to stand, and what it is to be: what every method starts from.
#pragma once

#include <optional>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// Eaves that stand out are as thick as rafters and tiles, and lift the roof by it.
inline constexpr double kThickness_m = 0.1875;

struct RoofInput {
  Polygon footprint;  ///< Tidied (outline.h).
  Polygon eaves;      ///< Around it; empty where none stand out.
  OrientedBox frame;
  RoofShape shape;
  double tolerance_m = 0;  ///< What eaves that were left out have left of it.
  Vec2 left_out_m;         ///< Eaves that the tolerance does not see: how far they stand out, how thick they are.
};

/// Lays out the frame, and the eaves of forms that can have them. `footprint` is not empty.
RoofInput roof_input(Polygon footprint, const RoofShape& shape, double tolerance_m);

/// How high a roof rises whose main slopes are span_m long in plan.
double rise_of(const RoofShape& shape, double span_m);

/// Of a shape with a knee, where that is: how far in and how high, of the span and the rise. Slopes that meet no more
/// before the ridge are one, and so are a knee at the eaves and what is above it.
std::optional<Vec2> knee_of(const RoofShape& shape, double span_m);

}  // namespace citykiln::roofs
