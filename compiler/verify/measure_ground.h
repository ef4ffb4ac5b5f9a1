// Measures of a baked tile's ground by its triangles, independently of the code that made them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::verify {

/// A triangle of the ground, in plane metres.
struct GroundFace {
  std::array<Vec3, 3> corners;
  OsmId feature;
};

/// All triangles of the layers ground, roads and water, including vertical ones.
std::vector<GroundFace> ground_faces(const bake::BakedTile& tile);

/// The fewest and the most squares along each side of a tile's lattice of samples: 4096 to 1,048,576 samples.
inline constexpr int kFewestSamplesASide = 64, kMostSamplesASide = 1024;

/// Returns the squares along each side of a lattice that has two samples for each of the compared faces, within the
/// limits above: tiles of few faces have few places that differ.
int samples_a_side(std::size_t faces);

/// The result of sampling the ground from above.
struct GroundSamples {
  std::uint64_t count = 0;
  std::uint64_t uncovered = 0;  ///< Samples without any ground.
  Vec2 hole;                    ///< The first sample without ground.
  double error_m = 0;           ///< Largest vertical deviation.
  Vec2 at;                      ///< Place of the largest deviation.
};

/// The deviation of a height from the expected one at a place covered by a feature, metres.
using DeviationAt = std::function<double(Vec2 p, double z_m, OsmId feature)>;

/// Samples the ground at one random place in every square of a lattice over the box. The ground is the lowest
/// upward-facing triangle of a ground layer.
/// @param a_side      Squares along each side of the box, > 0.
/// O(triangles + samples).
GroundSamples sample_ground(const bake::BakedTile& tile, const DeviationAt& deviation_m, const Box2& box, int a_side);

/// An edge of a ground triangle on the border of a tile, in plane metres, lower end first.
using BorderEdge = std::array<Vec3, 2>;

/// The border edges on one side of a tile, sorted.
struct BorderEdges {
  std::vector<BorderEdge> ground;   ///< Of triangles visible from above.
  std::vector<BorderEdge> upright;  ///< Of vertical triangles in the border plane: steps and skirts.
};

/// The edges of ground triangles on the line x = at (or y = at), without vertical edges.
BorderEdges border_edges_along_x(const bake::BakedTile& tile, double at);
BorderEdges border_edges_along_y(const bake::BakedTile& tile, double at);

/// True if the ground of neighbouring tiles fits: both have the same edges, or a vertical face of one of them closes
/// the difference where a border between surfaces runs along the tile border.
bool borders_match(const BorderEdges& own, const BorderEdges& other);

}  // namespace citykiln::verify
