// The land and sea around a scene, out to the horizon: continued from the ground at the edge of the scene.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// The ground at the edge of a scene in one direction.
struct Edge {
  Rgb albedo{};         ///< Albedo of the land.
  double sea = 0;       ///< Share of sea, 0 to 1.
  double height_m = 0;  ///< Above sea level.
};

/// The ground beyond a scene's box. It continues with the heights and colours at the edge, which fade into their means
/// far from it, and follows the Earth's curve.
struct Surroundings {
  Box2 box;  ///< Box of the scene, plane metres; not empty.
  /// The edges in equally spaced directions from the box's centre, counter-clockwise from east; not empty.
  std::vector<Edge> ring;
  Edge mean{};  ///< Mean of the ring (mean_of).
  /// The lowest and the highest height of the ring (bound_heights). Rays are followed only between them.
  double lowest_m = -std::numeric_limits<double>::infinity(), highest_m = std::numeric_limits<double>::infinity();
};

/// Sets lowest_m and highest_m to the lowest and the highest height of the ring.
void bound_heights(Surroundings& around);

/// Returns the mean of all edges. The mean albedo is weighted by the share of land.
Edge mean_of(const std::vector<Edge>& ring);

/// A point where a ray meets the ground around.
struct GroundPoint {
  double distance_m;
  Edge edge;
};

/// Returns the first point of the ground around along a ray that hits nothing in the scene; empty if the ray passes
/// above the horizon. A ray that leaves the box less than 1.5 m above the ground at the edge meets the ground at once.
/// @param from        Plane metres; z above sea level.
/// @param direction  Unit.
std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction);

/// The distance from the box at which the mean of all edges has half of the weight (edge_at).
inline constexpr double kFade_m = 2000;
/// Returns the ground at a place outside of the box: the edge in the direction of the place from the box's centre,
/// interpolated, mixed with the mean of all edges.
/// @param place  Plane metres.
Edge edge_at(const Surroundings& around, Vec2 place);

}  // namespace citykiln::preview
