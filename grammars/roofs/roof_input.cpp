#include "grammars/roofs/roof_input.h"

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/geometry/trig.h"
#include "grammars/roofs/outline.h"

namespace citykiln::roofs {
namespace {

constexpr std::array<double, static_cast<std::size_t>(Form::kCount)> kPitch_deg = {
#define ROOF_FORM(name, tag, pitch_deg) pitch_deg,
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
};

// A storey under a roof.
constexpr double kStorey_m = 3;
// Roofs of unknown height rise no higher, but for domes and spires: wide halls have flatter roofs than houses.
constexpr double kMostUntold_m = 9;
bool may_tower(Form form) { return form == Form::kDome || form == Form::kOnion || form == Form::kCone; }
// Steeper is a wall.
constexpr double kSteepest_deg = 85;

double tangent(double angle_deg) {
  const Vec2 d = direction_of(std::min(angle_deg, kSteepest_deg) / 360);
  return d.y / d.x;
}

// Curves stand upright at their eaves, teeth would cover each other, and a body over a pole ends where it stands.
bool may_stand_out(Form form) {
  return form != Form::kDome && form != Form::kOnion && form != Form::kRound && form != Form::kSawtooth;
}

// Eaves that take more of the tolerance stay: the rest is for curves. Corners of eaves are so much farther out.
constexpr double kMostLeftOut = 0.9, kSharpest = 2;

// How far they reach sideways, corners and all, and up: a skillion's go on upward behind.
Vec2 size_of_eaves_m(const RoofInput& site) {
  const double overhang_m = site.shape.overhang_m, width_m = std::min(site.frame.width_m(), site.frame.length_m());
  const bool goes_on = site.shape.form == Form::kSkillion && width_m > 0;
  const double up_m = goes_on ? overhang_m * rise_of(site.shape, width_m) / width_m : 0;
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
  RoofInput site{std::move(footprint), {}, {}, shape, tolerance_m, {}};
  site.frame = frame_of(site.footprint.outer, shape.direction, shape.is_ridge_across);
  if (!may_stand_out(shape.form) || shape.overhang_m <= 0) return site;
  const Vec2 size_m = size_of_eaves_m(site);
  if (length(size_m) > kMostLeftOut * tolerance_m)
    site.eaves = offset_eaves(site.footprint, shape.overhang_m);
  else
    site.left_out_m = size_m, site.tolerance_m -= length(size_m);
  return site;
}

double rise_of(const RoofShape& shape, double span_m) {
  if (shape.height_m > 0) return shape.height_m;
  if (has_knee(shape)) return lower_rise_m(shape, span_m) + upper_rise_m(shape, span_m);
  if (shape.angle_deg > 0) return span_m * tangent(shape.angle_deg);
  if (shape.levels > 0) return shape.levels * kStorey_m;
  const double rise_m = span_m * tangent(kPitch_deg[static_cast<std::size_t>(shape.form)]);
  return may_tower(shape.form) ? rise_m : std::min(kMostUntold_m, rise_m);
}

std::optional<Vec2> knee_of(const RoofShape& shape, double span_m) {
  if (!has_knee(shape)) return std::nullopt;
  const double lower_m = lower_rise_m(shape, span_m), rise_m = rise_of(shape, span_m);
  if (rise_m <= 0) return std::nullopt;
  return Vec2{lower_m / tangent(shape.angle_deg) / span_m, lower_m / rise_m};
}

}  // namespace citykiln::roofs
