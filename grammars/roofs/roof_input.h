// The common input of all roof methods: a cleaned footprint with its box and eaves.
#pragma once

#include <optional>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/oriented_box.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// The thickness of overhanging eaves, by which the roof is lifted: about the thickness of rafters and tiles.
inline constexpr double kThickness_m = 0.1875;

/// The input of all roof methods.
struct RoofInput {
  Polygon footprint;  ///< The result of cleaned().
  Polygon eaves;      ///< The outline of the eaves; empty: no overhang.
  OrientedBox box;
  RoofShape shape;
  double tolerance_m = 0;  ///< The tolerance of the caller less the error of eaves that were left out.
  Vec2 left_out_m;  ///< The overhang (x) and the thickness (y) of eaves that were left out, being below the tolerance.
};

/// Returns the input for a cleaned footprint: computes the box, and the eaves if the form can have them.
/// @param footprint  Not empty.
RoofInput roof_input(Polygon footprint, const RoofShape& shape, double tolerance_m);

/// Returns the height of a roof over the eaves plane, in metres.
/// @param span_m  The distance from the eaves to the ridge, in plan.
double rise_of(const RoofShape& shape, double span_m);

/// Returns the knee of a shape, x as a share of the span and y as a share of the rise; std::nullopt for a shape without
/// knee. A knee beyond the ridge is moved to the ridge, and a knee below the eaves to the eaves, which leaves one
/// slope.
std::optional<Vec2> knee_of(const RoofShape& shape, double span_m);

}  // namespace citykiln::roofs
