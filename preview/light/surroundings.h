// The land and sea around a scene, out to the horizon.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/vec.h"
#include "preview/rgb.h"

namespace citykiln::preview {

/// What is at the edge of a scene in one direction.
struct Edge {
  Rgb albedo{};    ///< Of its land.
  double sea = 0;  ///< Share of sea, 0 to 1.
};

/// A sphere about the Earth's middle at one height, with the colours of the scene's edge.
struct Surroundings {
  Vec2 centre;             ///< Of the scene, plane metres.
  double height_m = 0;     ///< Above sea level.
  std::vector<Edge> ring;  ///< By azimuth, counter-clockwise from east; not empty.
};

/// Where a ray meets the ground around.
struct GroundPoint {
  double distance_m;
  Vec2 place;  ///< Plane metres.
};

/// The first point of the sphere along a ray; empty if it passes above the horizon. An eye below the sphere meets one
/// that is just below it.
/// @param from  Plane metres; z above sea level.
std::optional<GroundPoint> meet_ground(const Surroundings& around, Vec3 from, Vec3 direction);

/// The edge in the direction of a place from the centre, interpolated.
Edge edge_at(const Surroundings& around, Vec2 place);

}  // namespace citykiln::preview
