// The land and sea around a scene, out to the horizon.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// What is at the edge of a scene in one direction.
struct Edge {
  Rgb albedo{};         ///< Of its land.
  double sea = 0;       ///< Share of sea, 0 to 1.
  double height_m = 0;  ///< Above sea level.
};

/// Beyond a scene's box the ground goes on with the height and the colours of its edge, which fade into their means far
/// from it, and follows the Earth's curve.
struct Surroundings {
  Box2 box;                ///< Of the scene, plane metres; not empty.
  std::vector<Edge> ring;  ///< By azimuth from the box's centre, counter-clockwise from east; not empty.
  Edge mean{};             ///< Of the ring.
  /// The lowest and the highest of the ring; rays are followed only in between.
  double lowest_m = -std::numeric_limits<double>::infinity(), highest_m = std::numeric_limits<double>::infinity();
};

/// Sets the lowest and the highest height of the ring.
void bound_heights(Surroundings& around);

/// The mean of all edges; the albedo is that of the land among them.
Edge mean_of(const std::vector<Edge>& ring);

/// Where a ray meets the ground around.
struct GroundPoint {
  double distance_m;
  Edge edge;
};

/// The first point of the ground around along a ray that hits nothing in the scene; empty if it passes above the
/// horizon. A ray that leaves the box below the edge's height meets the ground there.
/// @param from  Plane metres; z above sea level.
std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction);

/// The ground around at a place outside of the box: the edge in the direction of the place from the centre,
/// interpolated, and the mean of all, which has half of the weight at kFade_m from the box.
inline constexpr double kFade_m = 2000;
Edge edge_at(const Surroundings& around, Vec2 place);

}  // namespace citykiln::preview
