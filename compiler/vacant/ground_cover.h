// The cover of the ground of a tile at a place.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/geometry/vec.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/vacant/plots.h"

namespace citykiln::vacant {

/// The number of samples along each side of a plot.
inline constexpr int kSamples = 5;

/// Returns the polygon on top at p; null if there is none, or p is outside of the index.
const ground::LandCoverPolygon* cover_at(const PlotInputs& inputs, Vec2 p);

/// True for urban land use and unmapped land: ground on which the map shows nothing finer.
bool is_left_over(map::LandCoverClass surface);

/// The most frequent land use among the samples of a parallelogram that nothing finer covers (is_left_over()).
struct LeftOver {
  map::LandCoverClass use{};  ///< The class that most of the left-over places have.
  ObjectId area{};            ///< An area of that class; none where nothing is mapped.
  int priority = 0;           ///< The highest priority of areas of that class among the samples.
  double share = 0;           ///< The share of all samples that have this class, from 0 to 1.
};

/// Returns the most frequent left-over land use of a parallelogram, from kSamples² samples. Samples outside of the
/// index count as covered.
/// @param corner  One of its corners.
/// @param right   The vector from there to the next corner.
/// @param back    The vector from there to the other neighbouring corner.
LeftOver left_over_of(const PlotInputs& inputs, Vec2 corner, Vec2 right, Vec2 back);

/// Returns the share of green among the green and the paved ones of 24 samples, at 8, 16 and 24 m from p. Forest,
/// grass, gardens, lawns and scrub are green; paved areas and other surfaces of yards are paved; all else, such as
/// roads, buildings, land use and fields, does not count. Empty if no sample is green or paved.
std::optional<double> green_share_about(const PlotInputs& inputs, Vec2 p);

}  // namespace citykiln::vacant
