// The heights of roads as functions of the place: near a road, its profile at the nearest point of its axis, tilted as
// the profile says; where strips overlap, blended, so that nothing on the roads ever jumps.
//
//        A's own height     blended     B's own height
//     |---------------------|=======|---------------------|
//     weight of A: 1 on its axis, 0 at its edge; B's likewise
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/profile.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The top of a kerb lies this high above the carriageway: 10 to 15 cm are built.
inline constexpr double kKerbRise_m = 0.125;

/// No road is felt farther from its edge than this: there every cut and every bank has met the terrain.
inline constexpr double kGrading_m = 16;

/// Where edges of two roads come closer than this their heights are mixed.
inline constexpr double kBlend_m = 1.5;

/// Where a road lies higher than the one beside it a wall stands between them: so far from its edge is the top, so far
/// the foot.
inline constexpr double kWallTop_m = 0.125, kWallFoot_m = 0.375;

/// A straight piece of a road that has a profile, or kerbs, or both.
struct GradedSegment {
  Vec2 from, to;                   ///< Of the axis, plane metres.
  double from_m = 0, to_m = 0;     ///< Along the whole way.
  double left_m = 0, right_m = 0;  ///< From the axis to the outer edges, pavements and all.
  double kerb_m = 0;               ///< How far its carriageway lies below its edges.
  std::uint32_t road = 0;          ///< Into profiles.
};

/// What of a segment every place asks for.
struct SegmentLine {
  Vec2 along;  ///< From its beginning to its end.
  double length2_m2 = 0, length_m = 0;
  std::uint32_t first_knot = 0, knot_count = 0;  ///< Of its road's profile: those that say it here.
};

struct RoadInfluenceIndex {
  std::vector<GradedSegment> segments;  ///< In the order of roads.
  std::vector<SegmentLine> lines;       ///< Of the segments.
  std::vector<Profile> profiles;        ///< One a road that has segments; empty: it follows the terrain.
  std::vector<Box2> reaches;            ///< Of the segments: farther off none is felt.
  BoxGrid grid;                         ///< Of those.
  BoxGrid near;  ///< Of those too, in small buckets, without the corners that the segments do not reach.
};

/// The height and tilt of a segment's road at a share of its length; the road must have a profile. O(log knots there).
Knot knot_on(const RoadInfluenceIndex& field, std::uint32_t segment, double share);

/// @param has_kerbs  False where the tolerance sees none: carriageways then lie level with what is beside them.
RoadInfluenceIndex index_road_influence(std::span<const roads::Road> roads, bool has_kerbs);

/// One segment as a place sees it.
struct RoadInfluence {
  double z_m = 0;          ///< Height of the road there, at the top of its kerbs.
  double kerb_m = 0;       ///< How far the carriageway lies below that.
  double weight = 0;       ///< Among all strands of a place: most on its axis, next to none far from its edge.
  double beyond_m = 0;     ///< From the edge; 0 on the road.
  bool is_graded = false;  ///< False where it follows the terrain.

  bool operator==(const RoadInfluence&) const = default;
};

/// Those whose edge is nearer than kGrading_m, in the order of the field's segments.
/// @param terrain_m  The terrain's height at p.
/// @param memory     For what is returned: most places are asked once, so no heap should be.
std::pmr::vector<RoadInfluence> road_influences_at(const RoadInfluenceIndex& field, Vec2 p, double terrain_m,
                                                   std::pmr::memory_resource* memory);

/// What the strands agree on, by their weights: continuous. Roads of about one height are mixed over kBlend_m beside
/// their edges; one that is higher by more keeps its height, to a decimetre, to kWallTop_m beyond its edge, and the
/// lower one has its own from kWallFoot_m on. There must be one at least.
struct RoadHeight {
  double z_m = 0, kerb_m = 0;
};
RoadHeight blend(std::span<const RoadInfluence> influences);

}  // namespace citykiln::ground
