// The requested shape of a roof, in the terms of OpenStreetMap's Simple 3D Buildings tags.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/geometry/vec.h"

namespace citykiln::roofs {

/// The form of a roof: a value of roof:shape. roof_forms.inc lists the forms.
enum class RoofForm : std::uint8_t {
#define ROOF_FORM(name, tag, pitch_deg, method, end, has_eaves) name,
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
  kCount
};

/// The method that computes the facets of a form.
enum class Method : std::uint8_t {
  kFlat,
  kStrips,            ///< A section extruded along a line (strips.h).
  kStripsOrSkeleton,  ///< kStrips; kSkeleton if the footprint has wings.
  kSkeleton,          ///< A section raised inward from all edges of the footprint (inset_facets.h).
  kApex  ///< Outlines scaled towards an apex (apex.h); kSkeleton if the whole footprint is visible from no point.
};

/// The form of a roof at the end of a wing, for roofs by kSkeleton. kHipAndGable: a gable at the end to which
/// RoofShape::direction points, hips at the others.
enum class WingEnd : std::uint8_t { kHip, kHalfHip, kGable, kHipAndGable };

/// A row of roof_forms.inc.
struct FormRow {
  std::string_view name;  ///< The value of roof:shape: "half-hipped".
  double pitch_deg = 0;   ///< The default pitch.
  Method method = Method::kFlat;
  WingEnd end = WingEnd::kHip;
  /// Eaves may overhang. False for curved roofs, which are vertical at their eaves, and for saw-tooth roofs, whose
  /// teeth would overlap each other.
  bool has_eaves = true;
};
/// Returns the row of a form.
const FormRow& form_row(RoofForm form);

/// Returns the value of roof:shape of a form: form_row(form).name.
std::string_view name_of(RoofForm form);
/// Returns the form of a value of roof:shape or a synonym of roof_names.inc, in any capitals ("Gabled", "lean-to
/// roof"); std::nullopt if it is unknown.
std::optional<RoofForm> form_named(std::string_view name);

/// The line where the lower and the upper slopes of a mansard roof meet: its height over the eaves, and the angle of
/// the upper slopes; above 85 counts as 85.
struct Knee {
  double height_m = 0, upper_angle_deg = 0;
  bool operator==(const Knee&) const = default;
};

/// The requested shape of a roof. The first of height_m, angle_deg and levels that is above 0 gives the height of the
/// roof; if all are 0, the default pitch of the form does.
struct RoofShape {
  RoofForm form = RoofForm::kFlat;
  double height_m = 0;              ///< The height of the highest point over the eaves plane.
  double angle_deg = 0;             ///< The angle of the main slopes; above 85 counts as 85.
  double levels = 0;                ///< Storeys in the roof.
  std::optional<Vec2> direction{};  ///< Downhill direction of the main roof plane, of any length above 0.
  /// roof:orientation=across: the ridge is along the shorter side. `direction` takes precedence.
  bool is_ridge_across = false;
  double overhang_m = 0;  ///< The overhang of the eaves, in plan.
  /// The knee of a mansard roof. angle_deg is then the angle of the lower slopes. Ignored if height_m is given or
  /// angle_deg is 0.
  std::optional<Knee> knee{};
  bool operator==(const RoofShape&) const = default;
};

}  // namespace citykiln::roofs
