// Which roof a building has, and how high.
#pragma once

#include <optional>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// What a roof is decided from, besides tags.
struct RoofContext {
  bool is_attached = false;    ///< Walls are shared with a neighbour.
  std::optional<Vec2> street;  ///< Outward from the longest wall at a street.
};

/// Form as tagged; of untagged ones by class and size: houses have gables and hips, halls low gables, blocks flat
/// roofs; parts are flat.
///
/// height_m is decided, snapped, > 0 unless flat: as told, else by pitch (roofs::expected_rise_m); where the building's
/// height includes it, no more than that leaves of it. Attached houses have their eaves towards the street. Eaves stand
/// out where nobody stands near. Drawn from the footprint's id alone. O(n²) in the footprint's corners.
roofs::RoofShape plan_roof(const map::Footprint& footprint, const RoofContext& place);

/// Small buildings have tiles and pitched roofs, where nothing is tagged.
bool is_small(const map::Footprint& footprint);

}  // namespace citykiln::buildings
