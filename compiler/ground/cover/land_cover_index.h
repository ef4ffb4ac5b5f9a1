// Asks what covers the ground at a place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

inline constexpr std::uint32_t kNoLandCover = 0xffffffffu;

/// A surface in one bucket: how often the bucket's south-west corner is inside of it, and its borders that come near
/// the bucket.
struct BucketEntry {
  std::uint32_t surface = 0;
  std::int32_t winding = 0;
  std::int32_t priority = 0;  ///< Of its class.
  std::uint32_t first_edge = 0, edge_count = 0;
  Box2 edges;  ///< About all those, whole.
};

/// Surfaces sorted into square buckets of a box. Refers to the surfaces it was made from, which must outlive it.
struct LandCoverIndex {
  struct Edge {
    Vec2 a, b;
  };
  std::span<const LandCoverPolygon> surfaces;
  Box2 box;
  Vec2 corner;  ///< South-west corner of the first bucket, off the plane's grid, so that no vertex lies on a bucket's
                ///< side.
  double bucket_m = 0;
  int columns = 0, rows = 0;
  std::vector<std::uint32_t>
      bucket_starts;  ///< columns * rows + 1 offsets into entries, each bucket's from the top down.
  std::vector<BucketEntry> entries;
  std::vector<bool> is_far;  ///< Of buckets from which all surfaces are farther than kIndexNear_m.
  std::vector<Edge> edges;   ///< In the order of entries.
};

/// Smaller buckets repeat large surfaces too often; larger ones ask too many borders a question.
inline constexpr double kIndexBucket_m = 32;

/// Within so much of most places there is nothing of what is rare: water.
inline constexpr double kIndexNear_m = 16;

/// @param bucket_m  Smaller ones for narrow surfaces that are asked about often.
/// Cost: linear in vertices, plus buckets times vertices for the surfaces that reach over many buckets.
LandCoverIndex index_land_cover(std::span<const LandCoverPolygon> surfaces, const Box2& box,
                                double bucket_m = kIndexBucket_m);

/// The index of the surface on top at p, or kNoLandCover. p must lie in the map's box. O(edges in p's bucket).
std::uint32_t land_cover_at(const LandCoverIndex& map, Vec2 p);

/// The distance from p to the nearest border of a surface whose class has at least this priority; at most `reach_m`, 0
/// where such a surface covers p. p must lie in the map's box; borders outside the box do not count. O(edges in the
/// buckets within reach); O(1) where kIndexNear_m is enough and nothing is so near.
double clearance_m(const LandCoverIndex& map, Vec2 p, int priority, double reach_m);

}  // namespace citykiln::ground
