// Measures ways that run into walls: a box of the way's width and of the height that its users need, moved along the
// way on the ground, must meet no triangle of a building.
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

/// The coarsest level at which openings are measured, in metres.
inline constexpr double kOpenUpTo_m = 2.5;

/// A straight piece of the space over a way beside one building.
struct WayBox {
  OsmId way, building;
  Vec2 from, along;                          ///< The beginning on the axis, and the direction, of length 1.
  double length_m = 0;                       ///< From the beginning along the axis.
  double left_m = 0, right_m = 0;            ///< From the axis to the sides.
  double low_m = 0, rise = 0, height_m = 0;  ///< The lower end at the beginning, metres per metre, and the height.
  bool is_in_opening = false;                ///< The building has a passageway for the way there.
};

/// Returns the height of the ground at full detail.
using LandAt = std::function<double(Vec2)>;

/// Returns the boxes beside the chunk's buildings, sorted by building: 2 m high over paths, 3.5 m over roads, or up to
/// the ceiling of an opening. A way's box ends before a dead end by half its width, since ways end at doors.
/// Cost: O(n log n) in buildings and lengths of ways.
std::vector<WayBox> way_boxes_of(const scene::Chunk& chunk, const LandAt& land_m);

/// A way that meets a building.
struct WayIntoWall {
  OsmId way, building;
  double area_m2 = 0;  ///< The area of the triangles in its boxes.
  Vec2 at;             ///< One place.
  bool is_in_opening = false;
};

/// Returns the ways that meet a building of a tile, by building, then way, those in openings apart. O(triangles of
/// buildings + triangles near boxes).
/// @param boxes  The boxes of the tile's chunk.
std::vector<WayIntoWall> measure_ways(std::span<const WayBox> boxes, const bake::BakedTile& tile);

/// Merges lists of several levels or tiles: keeps the largest area of each way and building. The largest come first.
std::vector<WayIntoWall> combined(std::vector<WayIntoWall> all);

}  // namespace citykiln::verify
