// The cover of the ground of a tile at a place.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/geometry/vec.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// The number of places in a row across a plot at which its ground is looked at.
inline constexpr int kSamples = 5;

/// Returns the polygon on top at p; null if there is none, or p is outside of the index.
const ground::LandCoverPolygon* cover_at(const PlotInputs& inputs, Vec2 p);

/// True for classes of land use, of which the map says no more: towns, industry, unmapped land.
bool is_left_over(map::LandCoverClass surface);

/// The ground of a parallelogram.
struct LeftOver {
  map::LandCoverClass use{};  ///< The class that most of the left-over places have.
  ObjectId area{};            ///< An area of that class; none where nothing is mapped.
  double share = 0;           ///< The share of places of that class.
};

/// Returns what is left over of a parallelogram, from kSamples² places.
/// @param corner  One of its corners.
/// @param right   From there to the next corner.
/// @param back    From there to the other.
LeftOver left_over_of(const PlotInputs& inputs, Vec2 corner, Vec2 right, Vec2 back);

/// Returns the share of green among the places within 24 m of p that no road, water or building covers; grass of land
/// use does not count. Empty if all are covered.
std::optional<double> green_share_about(const PlotInputs& inputs, Vec2 p);

}  // namespace citykiln::vacant
