#include "grammars/roofs/roof_input.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/geometry/trig.h"
#include "grammars/roofs/outline.h"

namespace citykiln::roofs {
namespace {

// The height of a storey under a roof.
constexpr double kStorey_m = 3;
// The greatest height by default pitch, except for domes and spires: wide halls have flatter roofs than houses.
constexpr double kMostDefault_m = 9;
bool may_tower(RoofForm form) { return form == RoofForm::kDome || form == RoofForm::kOnion || form == RoofForm::kCone; }
// Steeper is a wall.
constexpr double kSteepest_deg = 85;

double tangent(double angle_deg) {
  const Vec2 d = direction_of(std::min(angle_deg, kSteepest_deg) / 360);
  return d.y / d.x;
}

// Eaves are left out if they take at most this share of the tolerance; the rest is for curves. kSharpest: corners of
// eaves are farther out than walls by at most this factor.
constexpr double kMostLeftOut = 0.9, kSharpest = 2;

// The extent of eaves sideways, with corners, and upward; those of a skillion roof continue upward at its back.
Vec2 size_of_eaves_m(const RoofInput& input) {
  const double overhang_m = input.shape.overhang_m, width_m = std::min(input.box.width_m(), input.box.length_m());
  const bool goes_on = input.shape.form == RoofForm::kSkillion && width_m > 0;
  const double up_m = goes_on ? overhang_m * rise_of(input.shape, width_m) / width_m : 0;
  return {kSharpest * overhang_m, kThickness_m + up_m};
}

bool has_knee(const RoofShape& shape) { return shape.knee && shape.height_m <= 0 && shape.angle_deg > 0; }

double lower_rise_m(const RoofShape& shape, double span_m) {
  return std::clamp(shape.knee->height_m, 0.0, span_m * tangent(shape.angle_deg));
}

double upper_rise_m(const RoofShape& shape, double span_m) {
  const double in_m = lower_rise_m(shape, span_m) / tangent(shape.angle_deg);
  return (span_m - in_m) * tangent(std::max(shape.knee->upper_angle_deg, 0.0));
}

}  // namespace

RoofInput roof_input(Polygon footprint, const RoofShape& shape, double tolerance_m) {
  assert(!footprint.outer.empty() && tolerance_m > 0);
  RoofInput input{std::move(footprint), {}, {}, shape, tolerance_m, {}};
  input.box = oriented_box(input.footprint.outer, shape.direction, shape.is_ridge_across);
  if (!form_row(shape.form).has_eaves || shape.overhang_m <= 0) return input;
  const Vec2 size_m = size_of_eaves_m(input);
  if (length(size_m) > kMostLeftOut * tolerance_m)
    input.eaves = offset_eaves(input.footprint, shape.overhang_m);
  else
    input.left_out_m = size_m, input.tolerance_m -= length(size_m);
  return input;
}

double rise_of(const RoofShape& shape, double span_m) {
  if (shape.height_m > 0) return shape.height_m;
  if (has_knee(shape)) return lower_rise_m(shape, span_m) + upper_rise_m(shape, span_m);
  if (shape.angle_deg > 0) return span_m * tangent(shape.angle_deg);
  if (shape.levels > 0) return shape.levels * kStorey_m;
  const double rise_m = span_m * tangent(form_row(shape.form).pitch_deg);
  return may_tower(shape.form) ? rise_m : std::min(kMostDefault_m, rise_m);
}

std::optional<Vec2> knee_of(const RoofShape& shape, double span_m) {
  assert(span_m > 0);
  if (!has_knee(shape)) return std::nullopt;
  const double lower_m = lower_rise_m(shape, span_m), rise_m = rise_of(shape, span_m);
  if (rise_m <= 0) return std::nullopt;
  return Vec2{lower_m / tangent(shape.angle_deg) / span_m, lower_m / rise_m};
}

}  // namespace citykiln::roofs
