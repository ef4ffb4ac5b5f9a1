// Measures of the ground that are made from a baked tile's own triangles, without trusting who made them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/bake/baked.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"
#include "compiler/ground/carving.h"

namespace citykiln::commands {

/// What looking straight down at a lattice of places found.
struct GroundSamples {
  std::uint64_t count = 0;
  std::uint64_t uncovered = 0;  ///< Places with no ground at all.
  double error_m = 0;           ///< Largest vertical distance between ground and heights.
};

/// Samples the middle of every square of a lattice of `step_m` in the box: the lowest upward triangle of a ground
/// material there is the ground.
/// @param leaving  Sorted: features that leave the ground (bridges), whose decks may be made of the same materials;
/// overlooked. O(triangles + samples).
GroundSamples sample_ground(const bake::BakedTile& tile, std::span<const OsmId> leaving, const ground::Carving& carving,
                            const Box2& box, double step_m);

/// An edge of the ground that runs along a tile's border, in plane metres, lower end first.
using BorderEdge = std::array<Vec3, 2>;

/// The edges of ground triangles that lie in the line x = at (or y = at), sorted. Neighbouring tiles must have the same
/// ones.
std::vector<BorderEdge> border_edges_along_x(const bake::BakedTile& tile, std::span<const OsmId> leaving, double at);
std::vector<BorderEdge> border_edges_along_y(const bake::BakedTile& tile, std::span<const OsmId> leaving, double at);

}  // namespace citykiln::commands
