// How closely the triangulated reference follows the graded terrain it stands for.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "compiler/geometry/box.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"

namespace citykiln::verify {

struct ReferenceErrors {
  std::uint64_t places = 0;
  std::uint64_t over = 0;  ///< Off by more than twice what is allowed where the ground is looked at.
  double largest_m = 0;    ///< At steps of the ground itself, by as much as they are high.
  Vec2 at;
};

/// Of both, counted together.
ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b);

/// The reference at a place.
using ReferenceAt = std::function<const ground::Reference&(Vec2)>;

/// At a random place in every square of a lattice over the box, on the layer of what covers it; standing water is left
/// out. O(samples).
ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side);

}  // namespace citykiln::verify
