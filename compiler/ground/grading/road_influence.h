// Road influence: the height that roads give to the ground near them. The profile of a road states its height along its
// axis, and its tilt across. The height that one road gives to a place is that of its profile at the nearest point of
// the axis, tilted.
//
// Where several roads are near, their heights are averaged with weights. So roads of similar height join without a
// step. If one road is clearly higher (blend() states the measure; two roads of equal weight by 1 m), both keep their
// own heights, and a wall joins them beside the higher road's edge (kWallTop_m, kWallFoot_m).
//
//        A's own height     blended     B's own height
//     |---------------------|=======|---------------------|
//
// The weight of a road is about 1 on its axis and falls smoothly to below 0.001 at kBlend_m beyond its edge. Beyond
// that the small rest falls with the cube of the distance, so the nearest road decides.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/profile.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// The height of a kerb's top above the carriageway; 10 to 15 cm are usual.
inline constexpr double kKerbRise_m = 0.125;

/// The distance from a road's edge within which the road changes the ground: every cut and bank meets the terrain
/// there.
inline constexpr double kGrading_m = 16;

/// The distance beyond a road's edge up to which its height is blended with those of other roads.
inline constexpr double kBlend_m = 1.5;

/// If one of two adjacent roads is higher, a wall stands between them. These are the distances of its top and its foot
/// from the higher road's edge.
inline constexpr double kWallTop_m = 0.125, kWallFoot_m = 0.375;

/// In a cutting the slopes beside a road start this much higher, so that its sides are walls. At an end of the cutting
/// that no other way continues, this height grows from 0 along kCuttingEnd_m.
inline constexpr double kCuttingWall_m = 12, kCuttingEnd_m = 4;

/// A straight piece of a road that has a profile, kerbs, or both.
struct GradedSegment {
  Vec2 from, to;                   ///< Ends on the axis, plane metres.
  double from_m = 0, to_m = 0;     ///< Distances of the ends along the whole way.
  double left_m = 0, right_m = 0;  ///< From the axis to the outer edges, pavements included.
  double kerb_m = 0;               ///< Depth of the carriageway below the edges.
  std::uint32_t road = 0;          ///< Index into RoadInfluenceIndex::profiles.
};

/// Precomputed values of a segment.
struct SegmentLine {
  Vec2 along;                                    ///< Vector from its beginning to its end.
  double length2_m2 = 0, length_m = 0;           ///< The length in plan, squared and as it is.
  std::uint32_t first_knot = 0, knot_count = 0;  ///< The knots of the road's profile along the segment.
};

/// The segments of all roads that have a profile or kerbs, with a spatial index.
struct RoadInfluenceIndex {
  std::vector<GradedSegment> segments;  ///< In the order of roads.
  std::vector<SegmentLine> lines;       ///< One per segment.
  std::vector<Profile> profiles;        ///< One per road with segments; empty: the road follows the terrain.
  std::vector<std::vector<roads::Cutting>> cuttings;  ///< One list per road with segments.
  std::vector<Box2> influence_boxes;                  ///< Per segment the box in which it influences heights.
  BoxGrid grid;                                       ///< Grid of these boxes.
  BoxGrid near;  ///< Finer grid of these boxes. A bucket (square of the grid) lists only segments whose edges are
                 ///< within kGrading_m of the bucket.
};

/// Returns height and tilt of the segment's road, which must have a profile. O(log knots of the segment).
/// @param index    The index.
/// @param segment  Index into index.segments.
/// @param share    Position along the segment, 0 to 1.
Knot knot_on(const RoadInfluenceIndex& index, std::uint32_t segment, double share);

/// Indexes the segments of roads that have a profile or kerbs.
/// @param has_kerbs  False for tolerances at which kerbs are left out: carriageways are then as high as pavements.
RoadInfluenceIndex index_road_influence(std::span<const roads::Road> roads, bool has_kerbs);

/// The influence of one segment at a place.
struct RoadInfluence {
  double z_m = 0;          ///< Height of the road there, at the top of its kerbs.
  double kerb_m = 0;       ///< Depth of the carriageway below z_m.
  double weight = 0;       ///< Largest on the axis (1.128), below 0.001 from kBlend_m beyond the edge on.
  double beyond_m = 0;     ///< Distance from the road's edge; 0 on the road.
  double wall_m = 0;       ///< In a cutting: height above z_m from which slopes start, up to kCuttingWall_m.
  bool is_graded = false;  ///< False if the road follows the terrain.

  bool operator==(const RoadInfluence&) const = default;
};

/// Returns the influences of the segments whose edge is nearer to p than kGrading_m, in the order of index.segments.
/// @param index      The index.
/// @param terrain_m  The terrain's height at p.
/// @param memory     Memory for the result, so that the many queries do not allocate on the heap.
std::pmr::vector<RoadInfluence> road_influences_at(const RoadInfluenceIndex& index, Vec2 p, double terrain_m,
                                                   std::pmr::memory_resource* memory);

/// The height of roads at a place.
struct RoadHeight {
  double z_m = 0, kerb_m = 0;  ///< Height of the kerbs' tops; depth of the carriageway below them.
};
/// Blends influences (at least one) by their weights into one continuous height. The measure is the weighted mean
/// distance d of the heights from their weighted mean. Up to d = 0.0625 m the result is that mean. From d = 0.5 m on,
/// the higher road keeps its height, within a decimetre, up to kWallTop_m beyond its edge, and the lower road has its
/// own height from kWallFoot_m on. Between these two cases the result is interpolated.
RoadHeight blend(std::span<const RoadInfluence> influences);

}  // namespace citykiln::ground
