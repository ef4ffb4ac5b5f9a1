// Whether the ground lies where its roads do: its height on their axes against their profiles.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::verify {

struct RoadFaces {
  std::uint64_t places = 0;
  double largest_gap_m = 0;  ///< Between the road's profile and the ground, kerbs and all.
  OsmId worst{};
  Vec2 at;
};

/// Of both, counted together.
RoadFaces combined(const RoadFaces& a, const RoadFaces& b);

/// The heights at which the road's face lies at a place of it; none where something else covers it.
using RoadSurfaceAt = std::function<std::vector<double>(const roads::Road& road, Vec2 p)>;

/// Every few metres along the axes of all roads with profiles, in the box: as far as no other road is near, with which
/// heights are mixed. O(n log n).
/// @param has_kerbs  As a tolerance sees them.
RoadFaces measure_road_faces(const scene::Chunk& chunk, const Box2& box, bool has_kerbs, const RoadSurfaceAt& faces_at);

}  // namespace citykiln::verify
