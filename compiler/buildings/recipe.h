// A building: a footprint between two heights.
#pragma once

#include <optional>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"
#include "compiler/materials/material.h"

namespace citykiln::buildings {

struct Building {
  ObjectId id;
  Polygon footprint;             ///< Plane metres, snapped. Where stands_on_ground, a surface of class kBuilding too.
  double bottom_m = 0;           ///< Lower end of the walls: under the lowest ground for what stands on it. Snapped.
  double top_m = 0;              ///< > bottom_m. Snapped.
  bool stands_on_ground = true;  ///< False where min_height lifts it.
  materials::Material wall{}, roof{};
  std::optional<map::Srgb> wall_colour, roof_colour;  ///< As tagged; else the material's, varied by the seed.
  bool operator==(const Building&) const = default;
};

}  // namespace citykiln::buildings
