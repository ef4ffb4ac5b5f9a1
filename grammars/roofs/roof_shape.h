// What a roof is asked to be: the shapes of OpenStreetMap's Simple 3D Buildings.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/geometry/vec.h"

namespace citykiln::roofs {

enum class Form : std::uint8_t {
#define ROOF_FORM(name, tag, pitch_deg) name,
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
  kCount
};

/// The value of roof:shape: "half-hipped".
std::string_view name_of(Form form);
/// Also by names that mean the same ("crosspitched"); nothing where no row has it.
std::optional<Form> form_named(std::string_view name);

/// Where the slopes of a mansard meet: how high over the eaves, and the angle of the upper ones, below 85.
struct Knee {
  double height_m = 0, upper_angle_deg = 0;
  bool operator==(const Knee&) const = default;
};

/// Height is told by the first of height_m, angle_deg, levels that is above 0; else the form has its pitch.
struct RoofShape {
  Form form = Form::kFlat;
  double height_m = 0;              ///< Of the highest point over the eaves plane.
  double angle_deg = 0;             ///< Of the main slopes, below 85.
  double levels = 0;                ///< Storeys in the roof.
  std::optional<Vec2> direction{};  ///< Where the main face looks, downhill, in plan; any length above 0.
  bool is_ridge_across = false;     ///< roof:orientation=across: the ridge along the shorter side.
  double overhang_m = 0;            ///< How far the eaves stand out, measured in plan.
  std::optional<Knee> knee{};       ///< Of a mansard whose angle_deg is that of the lower slopes; else it has its own.
  bool operator==(const RoofShape&) const = default;
};

}  // namespace citykiln::roofs
