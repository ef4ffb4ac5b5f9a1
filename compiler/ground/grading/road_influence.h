// Road influence: the heights of roads as functions of the place. Near one road: its profile at the nearest point of
// the axis, tilted as the profile says. Where strips overlap the heights are blended, so roads have no steps.
//
//        A's own height     blended     B's own height
//     |---------------------|=======|---------------------|
//     weights: 1 on a road's own axis, 0 at its edge
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/profile.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The top of a kerb above the carriageway; 10 to 15 cm are built.
inline constexpr double kKerbRise_m = 0.125;

/// A road influences the ground up to this distance from its edge; every cut and bank has met the terrain there.
inline constexpr double kGrading_m = 16;

/// Beside its edge a road's height is blended with those of others over this distance.
inline constexpr double kBlend_m = 1.5;

/// Where one of two adjacent roads is higher, a wall stands between them: distances of its top and foot from the higher
/// road's edge.
inline constexpr double kWallTop_m = 0.125, kWallFoot_m = 0.375;

/// A straight piece of a road that has a profile, kerbs, or both.
struct GradedSegment {
  Vec2 from, to;                   ///< Of the axis, plane metres.
  double from_m = 0, to_m = 0;     ///< Along the whole way.
  double left_m = 0, right_m = 0;  ///< From the axis to the outer edges, with pavements.
  double kerb_m = 0;               ///< Depth of the carriageway below the edges.
  std::uint32_t road = 0;          ///< Index into profiles.
};

/// What every query needs of a segment.
struct SegmentLine {
  Vec2 along;  ///< From its beginning to its end.
  double length2_m2 = 0, length_m = 0;
  std::uint32_t first_knot = 0, knot_count = 0;  ///< The knots of the road's profile along the segment.
};

struct RoadInfluenceIndex {
  std::vector<GradedSegment> segments;  ///< In the order of roads.
  std::vector<SegmentLine> lines;       ///< One per segment.
  std::vector<Profile> profiles;        ///< One per road with segments; empty: the road follows the terrain.
  std::vector<Box2> reaches;            ///< Per segment: it influences nothing outside.
  BoxGrid grid;                         ///< Of the boxes.
  BoxGrid near;                         ///< Of the boxes, in smaller buckets, without segments too far from a bucket.
};

/// Returns height and tilt of the segment's road at a share of the segment's length. The road has a profile. O(log
/// knots there).
Knot knot_on(const RoadInfluenceIndex& field, std::uint32_t segment, double share);

/// Indexes the segments of roads that have a profile or kerbs.
/// @param has_kerbs  False for tolerances that see no kerbs: carriageways then lie level with what is beside them.
RoadInfluenceIndex index_road_influence(std::span<const roads::Road> roads, bool has_kerbs);

/// The influence of one segment at a place.
struct RoadInfluence {
  double z_m = 0;          ///< Height of the road there, at the top of its kerbs.
  double kerb_m = 0;       ///< Depth of the carriageway below that.
  double weight = 0;       ///< Largest on the axis, close to 0 far from the edge.
  double beyond_m = 0;     ///< From the edge; 0 on the road.
  bool is_graded = false;  ///< False where the road follows the terrain.

  bool operator==(const RoadInfluence&) const = default;
};

/// Returns the influences of segments whose edge is nearer than kGrading_m, in the order of the index's segments.
/// @param terrain_m  The terrain's height at p.
/// @param memory     For the result: most places are asked once, so the heap should not be used.
std::pmr::vector<RoadInfluence> road_influences_at(const RoadInfluenceIndex& field, Vec2 p, double terrain_m,
                                                   std::pmr::memory_resource* memory);

/// Blends influences by their weights into one continuous height; there must be one at least. Roads of about one height
/// are blended over kBlend_m beside their edges. A road that is higher by more keeps its height, to a decimetre, up to
/// kWallTop_m beyond its edge; the lower one has its own from kWallFoot_m on.
struct RoadHeight {
  double z_m = 0, kerb_m = 0;
};
RoadHeight blend(std::span<const RoadInfluence> influences);

}  // namespace citykiln::ground
