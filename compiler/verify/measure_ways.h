// Measures ways that run into walls. A box as wide as the carriageway and as high as its users need moves along each
// way on the ground; it must not meet a triangle of a building.
//
//      ________      ________
//     |        |  __|        |     in an opening for the way the box ends below the ceiling
//     | - - - -|-|__|- - - - |--   a box in front of a wall meets it
//     |________|    |________|
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The largest tolerance of a level of detail that is measured.
inline constexpr double kOpenUpTo_m = 2.5;

/// A straight box in the space over a way, beside one building.
struct WayBox {
  OsmId way, building;
  Vec2 from, along;                ///< Its beginning on the axis of the way, and its direction, of length 1.
  double length_m = 0;             ///< From the beginning along the axis.
  double left_m = 0, right_m = 0;  ///< From the axis to the sides.
  /// Its lower end at the beginning (plane metres), the slope of its lower end, and its height.
  double low_m = 0, rise = 0, height_m = 0;
  bool is_in_opening = false;  ///< The building has a passageway for the way there.
};

/// Returns the height of the ground at a place, at full detail.
using LandAt = std::function<double(Vec2)>;

/// Returns the boxes of roads and paths beside the chunk's buildings, sorted by building. A box begins 0.5 m above the
/// way, over kerbs and thresholds, and ends 2 m above a path, 3.5 m above a road, or below the ceiling of an opening.
/// At a dead end boxes stop half a width earlier, since ways end at doors. Cost: O(n log n) in buildings and lengths of
/// ways.
/// @param land_m  The ground, for ways without a profile.
std::vector<WayBox> way_boxes_of(const scene::Chunk& chunk, const LandAt& land_m);

/// A way that meets a building.
struct WayIntoWall {
  OsmId way, building;
  double area_m2 = 0;  ///< Area of the building's triangles inside the boxes of the way.
  Vec2 at;             ///< The beginning of one of these boxes.
  bool is_in_opening = false;
};

/// Returns the ways that meet a building of a tile, by building, then way. A way can have two entries for a building,
/// one inside and one outside openings. O(triangles of buildings + triangles near boxes).
/// @param boxes  The boxes of the tile's chunk.
std::vector<WayIntoWall> measure_ways(std::span<const WayBox> boxes, const bake::BakedTile& tile);

/// Merges lists of several levels or tiles: keeps the largest area of each entry. The largest come first.
std::vector<WayIntoWall> combined(std::vector<WayIntoWall> all);

}  // namespace citykiln::verify
