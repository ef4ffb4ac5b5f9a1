// The requested shape of a roof, by the tags of OpenStreetMap's Simple 3D Buildings.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/geometry/vec.h"

namespace citykiln::roofs {

enum class Form : std::uint8_t {
#define ROOF_FORM(name, tag, pitch_deg, method, end, has_eaves) name,
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
  kCount
};

/// How the facets of a form are computed.
enum class Method : std::uint8_t {
  kFlat,
  kStrips,            ///< A section along a line (strips.h).
  kStripsOrSkeleton,  ///< As kStrips, or kSkeleton if the footprint has wings.
  kSkeleton,          ///< A section over an envelope or a straight skeleton (inset_facets.h).
  kApex               ///< Scaled outlines (apex.h), or as kSkeleton if no point sees the whole footprint.
};

/// The form at the end of a wing, over a skeleton. kHipAndGable: a gable at the end that the ridge points to.
enum class End : std::uint8_t { kHip, kHalfHip, kGable, kHipAndGable };

/// A row of roof_forms.inc.
struct FormRow {
  std::string_view name;  ///< The value of roof:shape: "half-hipped".
  double pitch_deg = 0;   ///< The default.
  Method method = Method::kFlat;
  End end = End::kHip;
  bool has_eaves = true;  ///< Eaves may overhang. Curved roofs are vertical at their eaves, and teeth would overlap.
};
const FormRow& form_row(Form form);

/// form_row(form).name.
std::string_view name_of(Form form);
/// The form of a value of roof:shape or a synonym ("crosspitched"); std::nullopt if it is unknown.
std::optional<Form> form_named(std::string_view name);

/// The line where the slopes of a mansard roof meet: its height over the eaves, and the angle above it, below 85.
struct Knee {
  double height_m = 0, upper_angle_deg = 0;
  bool operator==(const Knee&) const = default;
};

/// The height is given by the first of height_m, angle_deg, levels that is above 0, else by the pitch of the form.
struct RoofShape {
  Form form = Form::kFlat;
  double height_m = 0;              ///< Of the highest point over the eaves plane.
  double angle_deg = 0;             ///< Of the main slopes, below 85.
  double levels = 0;                ///< Storeys in the roof.
  std::optional<Vec2> direction{};  ///< Downhill direction of the main roof plane, of any length above 0.
  bool is_ridge_across = false;     ///< roof:orientation=across: the ridge is along the shorter side.
  double overhang_m = 0;            ///< Of the eaves, in plan.
  std::optional<Knee> knee{};       ///< Of a mansard roof whose angle_deg is that of the lower slopes.
  bool operator==(const RoofShape&) const = default;
};

}  // namespace citykiln::roofs
