// Finds the mapped land use at a place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::lots {

/// The areas of land use on which yards are assumed, with an index of their boxes.
struct LandUse {
  std::span<const map::AreaFeature> areas;
  std::vector<std::uint32_t> numbers;  ///< Indices of areas, in the order of the grid's boxes.
  BoxGrid grid;
};

/// Returns the index of a map, which must outlive it. O(n).
LandUse index_land_use(const map::FeatureView& features);

/// Returns the class of the smallest residential, commercial, retail or industrial area at p; kUnknown if there is
/// none. O(areas near).
map::LandCoverClass land_use_at(const LandUse& uses, Vec2 p);

}  // namespace citykiln::lots
