// Finds the outline that a building part belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// Outlines in square buckets. Refers to the footprints it was made from, which must outlive it.
struct OutlineIndex {
  const std::vector<map::Footprint>* footprints = nullptr;
  Box2 box;
  double bucket_m = 0;
  int columns = 0, rows = 0;
  std::vector<std::vector<std::uint32_t>> buckets;  ///< Footprints that are no parts, by the buckets their box touches.
};

/// O(n) for outlines not much larger than a bucket.
OutlineIndex index_outlines(const std::vector<map::Footprint>& footprints);

/// The smallest outline that contains the point (then the lowest id), or nullptr. O(vertices in the bucket).
const map::Footprint* outline_at(const OutlineIndex& index, Vec2 p);

}  // namespace citykiln::buildings
