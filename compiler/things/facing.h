// Directions of things: as numbers of a recipe, and towards roads.
#pragma once

#include <optional>
#include <span>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/roads/recipe.h"
#include "compiler/things/recipe.h"

namespace citykiln::things {

/// Returns the unit vector of a recipe's direction.
Vec2 unit_vector(std::uint16_t direction);
/// Returns the direction nearest to a vector; 0 for the zero vector. No trigonometric function is used, so every CPU
/// gives the same number.
std::uint16_t nearest_direction(Vec2 v);

/// The farthest road that things face.
inline constexpr double kMaxFacing_m = 30;

/// The segments of roads, paths and railways, with a spatial index.
struct Axes {
  struct Segment {
    Vec2 a, b;
    map::LandCoverGroup group{};
    map::DrivingSide side{};
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};
Axes axes_of(std::span<const roads::Road> roads);

/// The point of an axis that is nearest to a place.
struct NearestAxis {
  Vec2 at;
  Vec2 along;  ///< The direction of the axis there, length 1.
  map::DrivingSide side{};
};
/// Which axes count.
enum class AxisKind : std::uint8_t { kRoadsAndPaths, kRoads, kRoadsAndRails };
/// Returns the nearest axis within kMaxFacing_m; on a tie the first one. O(segments near p).
std::optional<NearestAxis> nearest_axis(const Axes& axes, Vec2 p, AxisKind kind);

/// Returns the direction of the traffic for which a thing on a way is: along the way, or against it. Without
/// thing.facing it is along a oneway, else towards the nearer end of the way, where a junction is likely.
Vec2 traffic_of(const map::ThingFeature& thing);

/// Returns the direction in which a thing at p looks, by its tags, else by its row. A thing with an outline looks
/// across it, to the side nearer to this direction.
Vec2 facing_of(const map::ThingFeature& thing, map::Facing facing, Vec2 p, const Axes& axes, std::uint64_t seed);

}  // namespace citykiln::things
