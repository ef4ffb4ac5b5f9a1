// A spatial index of land cover polygons: finds the topmost polygon at a place and the distance to the nearest border.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/bucket_grid.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The index of a polygon where there is none.
inline constexpr std::uint32_t kNoLandCover = 0xffffffffu;

/// A polygon in one bucket: its winding number at the bucket's south-west corner, and its edges near the bucket.
struct BucketEntry {
  std::uint32_t polygon = 0;                     ///< Index of the polygon in LandCoverIndex::surfaces.
  std::int32_t winding = 0;                      ///< Winding number of its rings about that corner.
  std::int32_t priority = 0;                     ///< Priority of its class.
  bool is_raised = false;                        ///< True if it covers polygons of higher priority that it lies in.
  std::uint32_t first_edge = 0, edge_count = 0;  ///< Range in LandCoverIndex::edges.
  Box2 edges;                                    ///< The box of these edges, not cut to the bucket.
};

/// Polygons sorted into buckets, the squares of a grid over a box. Refers to the polygons, which must outlive it. The
/// sides of buckets do not lie on the plane's grid, so that no vertex lies on them.
struct LandCoverIndex : BucketGrid {
  struct Edge {
    Vec2 a, b;
  };
  std::span<const LandCoverPolygon> surfaces;  ///< The polygons.
  Box2 box;                                    ///< The box in which queries are allowed.
  /// columns · rows + 1 offsets into `entries`, which go from the top down in each bucket.
  std::vector<std::uint32_t> bucket_starts;
  std::vector<BucketEntry> entries;  ///< Bucket by bucket.
  std::vector<bool> is_far;          ///< Per bucket: true if all polygons are farther away than kIndexNear_m.
  std::vector<Edge> edges;           ///< Edges of all entries, in the order of `entries`.
};

/// The default side of buckets. Smaller buckets repeat large polygons too often; larger ones have too many edges.
inline constexpr double kIndexBucket_m = 32;

/// Buckets that are farther than this from all polygons are marked (LandCoverIndex::is_far). In them, clearance_m()
/// takes O(1) for search radii up to this distance. Most buckets of an index of water alone are so.
inline constexpr double kIndexNear_m = 16;

/// Builds the index.
/// O(vertices), plus buckets times vertices for polygons that span many buckets.
/// @param surfaces  The polygons, which must outlive the index.
/// @param box       The box in which queries are allowed, plane metres.
/// @param bucket_m  Side of the buckets; smaller ones suit narrow polygons with many queries.
LandCoverIndex index_land_cover(std::span<const LandCoverPolygon> surfaces, const Box2& box,
                                double bucket_m = kIndexBucket_m);

/// Returns the index in LandCoverIndex::surfaces of the polygon on top at p, or kNoLandCover if none covers p. p must
/// lie in the box. O(edges in p's bucket).
std::uint32_t land_cover_at(const LandCoverIndex& land_cover, Vec2 p);

/// Returns the distance from p to the nearest border of a polygon whose class has at least this priority, at most
/// `search_radius_m`; 0 if such a polygon covers p.
/// O(edges in the buckets within search_radius_m); O(1) if no polygon lies within kIndexNear_m of p's bucket and
/// search_radius_m is no larger.
/// @param p                A place in the box; borders outside of the box do not count.
/// @param search_radius_m  Largest distance that is searched.
double clearance_m(const LandCoverIndex& land_cover, Vec2 p, int priority, double search_radius_m);

}  // namespace citykiln::ground
