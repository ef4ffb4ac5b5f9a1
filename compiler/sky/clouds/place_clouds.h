// The places of a layer's clouds.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

/// A cloud in the layer's own frame, in metres: x along the wind, y across, z up from the layer's base. Lengths along
/// the wind and upwards are scaled (LayerFrame), so that its particles are spheres.
struct Cloud {
  Vec2 centre;
  double radius_m = 0;  ///< Radius of its outline.
  double height_m = 0;  ///< Height from the base to the top.
  StableId id{};
};

/// The frame in which a layer's particles are spheres.
struct LayerFrame {
  Vec2 along{1, 0};     ///< Unit vector of the wind in the plane.
  double stretch = 1;   ///< Plane metres per metre of the frame, along the wind.
  double flatten = 1;   ///< Plane metres per metre of the frame, upwards.
  double base_m = 0;    ///< Above sea level.
  double height_m = 0;  ///< Height from base to top, in the frame.

  Vec3 into(Vec3 plane) const;
  Vec3 into_direction(Vec3 plane) const;
  Vec3 out_of(Vec3 own) const;
};

LayerFrame frame_of(const CloudLayer& layer);

/// Returns the clouds of a layer whose centres lie in a box of the plane. A cloud does not depend on the box. O(cells).
///
/// Method: a grid with at most one cloud in the middle part of each cell. The number and the size of clouds grow with
/// the cover: discs of their radii at independent places would cover that share on average.
std::vector<Cloud> clouds_in(const CloudLayer& layer, const Box2& plan);

/// The radius of a layer's largest clouds, in its frame.
double largest_radius_m(const CloudLayer& layer);

/// The largest number of clouds of a layer that are made at once. A layer 20 m thick over a district would have
/// millions.
inline constexpr double kMostClouds = 20000;
/// Returns the middle part of a box that has room for at most kMostClouds; the box itself if it has no more.
Box2 within_limit(const CloudLayer& layer, const Box2& plan);

}  // namespace citykiln::sky
