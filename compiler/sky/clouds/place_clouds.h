// Places the clouds of a layer.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

/// One cloud, in the layer's own frame: x along the wind, y across, z up from the layer's base, metres; lengths along
/// the wind and upwards are scaled (LayerFrame), so that its particles are spheres.
struct Cloud {
  Vec2 centre;
  double radius_m = 0;  ///< Of its outline.
  double height_m = 0;  ///< From the base to the top.
  StableId id{};
};

/// The frame in which a layer's particles are spheres.
struct LayerFrame {
  Vec2 along{1, 0};     ///< Unit vector of the wind, plane.
  double stretch = 1;   ///< Plane metres per metre of the frame, along the wind.
  double flatten = 1;   ///< The same for heights.
  double base_m = 0;    ///< Above sea level.
  double height_m = 0;  ///< From base to top, in the frame.

  Vec3 into(Vec3 plane) const;
  Vec3 into_direction(Vec3 plane) const;
  Vec3 out_of(Vec3 own) const;
};

LayerFrame frame_of(const CloudLayer& layer);

/// The clouds of a layer whose centres lie in a box of the plane, the same ones for any box that holds them.
///
/// Method: a grid, in the middle part of each of whose cells one cloud may be. Their number and size grow with the
/// cover, which discs at independent places would have on the average. O(cells).
std::vector<Cloud> clouds_in(const CloudLayer& layer, const Box2& plan);

/// The radius of a layer's largest clouds, in its frame.
double largest_radius_m(const CloudLayer& layer);

/// The most clouds of a layer that are made at once: a layer 20 m thick over a district would have millions.
inline constexpr double kMostClouds = 20000;
/// The middle part of a box that has room for kMostClouds at most; the box itself where it has.
Box2 within_limit(const CloudLayer& layer, const Box2& plan);

}  // namespace citykiln::sky
