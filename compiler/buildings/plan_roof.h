// Plans roofs: form, rise, direction and overhang.
#pragma once

#include <optional>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// What a roof depends on apart from the footprint's tags.
struct RoofContext {
  bool is_attached = false;    ///< The building shares walls with a neighbour.
  std::optional<Vec2> street;  ///< Outward normal of the longest wall that faces a street.
};

/// Returns the roof of a footprint.
///
/// The form is as tagged; otherwise by class and size: houses have gabled and hipped roofs, halls low gables, large
/// buildings and parts flat roofs. height_m is as tagged, otherwise by pitch (roofs::expected_rise_m), at most what the
/// building's height leaves if that includes the roof; snapped, > 0 unless flat. Ridges of attached houses run along
/// the street. Detached small buildings have overhanging eaves. Random draws depend on the footprint's id alone. O(n²)
/// in the footprint's vertices.
roofs::RoofShape plan_roof(const map::Footprint& footprint, const RoofContext& context);

}  // namespace citykiln::buildings
