// A spatial index of land cover polygons: what covers a place, and how far the next polygon is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/bucket_grid.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

inline constexpr std::uint32_t kNoLandCover = 0xffffffffu;

/// A polygon in one bucket: its winding number at the bucket's south-west corner, and its edges near the bucket.
struct BucketEntry {
  std::uint32_t surface = 0;
  std::int32_t winding = 0;
  std::int32_t priority = 0;  ///< Of its class.
  std::uint32_t first_edge = 0, edge_count = 0;
  Box2 edges;  ///< The box of these edges, whole.
};

/// Polygons sorted into square buckets of a box. Refers to the polygons, which must outlive it.
/// The lattice lies off the plane's grid, so that no vertex lies on a bucket's side.
struct LandCoverIndex : BucketGrid {
  struct Edge {
    Vec2 a, b;
  };
  std::span<const LandCoverPolygon> surfaces;
  Box2 box;
  std::vector<std::uint32_t>
      bucket_starts;  ///< columns · rows + 1 offsets into entries, which are sorted from the top down in each bucket.
  std::vector<BucketEntry> entries;
  std::vector<bool> is_far;  ///< Per bucket: all polygons are farther than kIndexNear_m.
  std::vector<Edge> edges;   ///< In the order of entries.
};

/// Smaller buckets repeat large polygons too often; larger ones hold too many edges.
inline constexpr double kIndexBucket_m = 32;

/// Rare cover (water) is farther than this from most places, which clearance_m() then sees in O(1).
inline constexpr double kIndexNear_m = 16;

/// Builds the index.
/// @param bucket_m  Choose smaller ones for narrow polygons that are asked about often.
/// O(vertices), plus buckets times vertices for polygons that span many buckets.
LandCoverIndex index_land_cover(std::span<const LandCoverPolygon> surfaces, const Box2& box,
                                double bucket_m = kIndexBucket_m);

/// Returns the index of the polygon on top at p, or kNoLandCover. p must lie in the box. O(edges in p's bucket).
std::uint32_t land_cover_at(const LandCoverIndex& map, Vec2 p);

/// Returns the distance from p to the nearest border of a polygon whose class has at least this priority: at most
/// `reach_m`; 0 where such a polygon covers p. p must lie in the box; borders outside it do not count. O(edges in the
/// buckets within reach); O(1) where nothing lies within kIndexNear_m and reach_m is no larger.
double clearance_m(const LandCoverIndex& map, Vec2 p, int priority, double reach_m);

}  // namespace citykiln::ground
