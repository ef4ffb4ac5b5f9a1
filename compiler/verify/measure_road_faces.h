// Deviation of the ground from road profiles along the axes of roads.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

struct RoadFaces {
  std::uint64_t places = 0;
  double largest_gap_m = 0;  ///< Between the road's profile and the ground, kerbs included.
  OsmId worst{};
  Vec2 at;
};

/// The counts added, and the larger of the gaps.
RoadFaces combined(const RoadFaces& a, const RoadFaces& b);

/// The heights of a road's surface at a place; empty where another object covers it.
using RoadSurfaceAt = std::function<std::vector<double>(const roads::Road& road, Vec2 p)>;

/// Samples the axes of all roads with profiles every few metres inside the box, except near other roads, where heights
/// are blended. O(n log n).
/// @param has_kerbs  Whether the tolerance has kerbs.
RoadFaces measure_road_faces(const scene::Chunk& chunk, const Box2& box, bool has_kerbs, const RoadSurfaceAt& faces_at);

}  // namespace citykiln::verify
