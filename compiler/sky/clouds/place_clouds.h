// Places the clouds of a layer, and converts between the plane and the layer's frame. The layer's frame is a coordinate
// system in metres, with x along the wind, y across and z up from the layer's base. It is scaled along the wind and
// upwards so that the particles of clouds are spheres.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/sky/clouds/recipe.h"

namespace citykiln::sky {

/// A cloud of a layer, in the layer's frame: a place and a size, from which particles are generated.
struct Cloud {
  Vec2 centre;
  double radius_m = 0;  ///< Radius of its outline, a circle.
  double height_m = 0;  ///< Height from the base to the top.
  StableId id{};
};

/// The layer's frame, relative to the plane. The origin is the plane's origin at the height of the layer's base.
struct LayerFrame {
  Vec2 along{1, 0};     ///< Direction of x in the plane: a unit vector along the wind.
  double stretch = 1;   ///< Plane metres per metre of the frame, along the wind.
  double flatten = 1;   ///< Plane metres per metre of the frame, upwards.
  double base_m = 0;    ///< Height of z = 0 above sea level.
  double height_m = 0;  ///< Height of the layer from base to top, in metres of the frame.

  /// Converts a point from plane metres (z above sea level) to the frame, a direction to the frame, and a point of the
  /// frame to the plane. A unit direction of the plane becomes the motion in the frame for one metre of the plane.
  Vec3 into(Vec3 plane) const;
  Vec3 into_direction(Vec3 plane) const;
  Vec3 out_of(Vec3 own) const;
};

/// Returns the frame of a layer.
LayerFrame frame_of(const CloudLayer& layer);

/// Returns the clouds of a layer whose centres lie in a box of the plane. Each cloud is the same for any box that
/// contains it. O(cells).
///
/// Method: a grid with at most one cloud in the middle part of each cell. The number and the size of clouds grow with
/// the cover: discs of their radii at independent places would cover the share CloudLayer::cover on average. Their
/// areas differ by a factor of up to 10, small ones are more frequent, and they stand in groups of some cells.
std::vector<Cloud> clouds_in(const CloudLayer& layer, const Box2& plan);

/// Returns the radius of a layer's largest clouds, in metres of its frame.
double largest_radius_m(const CloudLayer& layer);

/// The largest number of clouds of a layer that are generated for an output. A layer 20 m thick over a district would
/// have millions.
inline constexpr double kMostClouds = 20000;
/// Returns the middle part of a box that contains at most about kMostClouds clouds; the whole box if it contains no
/// more.
Box2 within_limit(const CloudLayer& layer, const Box2& plan);

}  // namespace citykiln::sky
