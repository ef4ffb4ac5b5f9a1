// The land and sea around a scene, out to the horizon.
#pragma once

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

/// Beyond a scene's box the ground goes on at the height of its edge, as a part of a sphere about the Earth's middle,
/// with the edge's colours.
struct Surroundings {
  Box2 box;                ///< Of the scene, plane metres; not empty.
  std::vector<Edge> ring;  ///< By azimuth from the box's centre, counter-clockwise from east; not empty.
};

/// Where a ray meets the ground around.
struct GroundPoint {
  double distance_m;
  Edge edge;  ///< In the direction in which the ray leaves the box.
};

/// The first point of the ground around along a ray that hits nothing in the scene; empty if it passes above the
/// horizon. A ray that leaves the box below the edge's height meets the ground there.
/// @param from  Plane metres; z above sea level.
std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction);

/// The edge in the direction of a place from the centre, interpolated.
Edge edge_at(const Surroundings& around, Vec2 place);

}  // namespace citykiln::preview
