// The clip of a scene: polygons of the plane beyond which there is no ground and nothing stands.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/polygon.h"
#include "compiler/ground/cover/inside_rings.h"
#include "compiler/ground/recipe.h"

namespace citykiln::scene {

/// Polygons that do not overlap, in plane metres on the grid of map::kMapStep_m. Outer rings run counter-clockwise,
/// holes clockwise. Empty: nothing is clipped.
using Clip = std::vector<Polygon>;

/// The id of the land cover beyond a clip, which no element has. Its faces of the ground are not written.
inline constexpr ObjectId kBeyondClip{OsmId{}, 0xffffffffu};

/// Returns the land beyond a clip in a box, as a polygon that lies on top of all others; without rings if the clip is
/// empty or the box lies inside of it. O(vertices of the clip).
ground::LandCoverPolygon beyond_clip(const Clip& clip, const Box2& box);

/// Answers whether places are inside of a clip.
class ClipTest {
 public:
  /// Places in `box` can be asked for.
  ClipTest(const Clip& clip, const Box2& box);

  /// Tests whether a place is inside; true if nothing is clipped. A place on an edge may count as either. Cost: O(edges
  /// in the place's horizontal band of the plan).
  bool is_inside(Vec2 place) const { return !is_clipped_ || !ground::is_inside(beyond_, place); }

 private:
  bool is_clipped_;
  ground::BandedRings beyond_;
};

/// Tests whether at least 1 m² of a box is inside of a clip; true if nothing is clipped. Cost: O(vertices of the clip),
/// and a union of its rings near the box.
bool touches_clip(const Clip& clip, const Box2& box);

}  // namespace citykiln::scene
