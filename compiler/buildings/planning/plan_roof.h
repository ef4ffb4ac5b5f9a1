// Plans roofs: decides form, rise, direction and overhang.
#pragma once

#include <optional>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// The surroundings of a footprint that affect its roof.
struct RoofContext {
  bool is_attached = false;    ///< The building shares walls with a neighbour.
  std::optional<Vec2> street;  ///< The outward normal of the longest wall that faces a street.
};

/// Returns the roof of a footprint.
///
/// The form is the tagged one, else by class and size: houses have gabled and hipped roofs, halls low gables, large
/// buildings and parts flat roofs. height_m is the tagged height, else it follows from the pitch
/// (roofs::expected_rise_m). It is limited by the building's height if that includes the roof; a multiple of 2^-10 m, >
/// 0 unless the roof is flat. Ridges of attached houses run along the street. Detached small buildings have overhanging
/// eaves. Random draws depend only on the footprint's id. O(n²) in the footprint's vertices.
roofs::RoofShape plan_roof(const map::Footprint& footprint, const RoofContext& context);

}  // namespace citykiln::buildings
