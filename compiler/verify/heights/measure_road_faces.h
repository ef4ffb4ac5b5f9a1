// Measures the deviation of the ground from road profiles along the axes of roads.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

/// The gaps between road profiles and the ground.
struct RoadFaces {
  std::uint64_t places = 0;  ///< Number of sampled places.
  double largest_gap_m = 0;  ///< Between the road's profile and the ground, with kerbs taken into account.
  OsmId worst{};             ///< The road with the largest gap.
  Vec2 at;                   ///< The place of the largest gap.
};

/// Combines two measurements: adds counts and keeps the larger gap.
RoadFaces combined(const RoadFaces& a, const RoadFaces& b);

/// Returns the heights of a road's surface at a place; empty where another object covers it.
using RoadSurfaceAt = std::function<std::vector<double>(const roads::Road& road, Vec2 p)>;

/// Samples the axes of all roads with profiles every few metres inside the box, except near other roads, where heights
/// are blended. O(n log n).
/// @param has_kerbs  True if the tolerance has kerbs.
/// @param faces_at   Gives the heights of the ground to compare with.
RoadFaces measure_road_faces(const scene::Chunk& chunk, const Box2& box, bool has_kerbs, const RoadSurfaceAt& faces_at);

}  // namespace citykiln::verify
