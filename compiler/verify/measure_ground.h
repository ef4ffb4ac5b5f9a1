// Measures a baked tile's ground by its triangles, independently of the code that made them.
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

/// Returns all triangles of the layers ground, roads and water, including vertical ones.
std::vector<GroundFace> ground_faces(const bake::BakedTile& tile);

/// The limits of the number of squares along each side of a tile's sampling grid: 4,096 to 1,048,576 samples.
inline constexpr int kFewestSamplesASide = 64, kMostSamplesASide = 1024;

/// Returns the number of squares along each side of a sampling grid that has two samples per face, within the limits
/// above.
/// @param faces  Number of faces that are compared. Fewer faces have fewer places at which they can differ.
int samples_a_side(std::size_t faces);

/// The result of sampling the ground from above.
struct GroundSamples {
  std::uint64_t count = 0;
  std::uint64_t uncovered = 0;  ///< Samples without ground.
  Vec2 hole;                    ///< The first sample without ground.
  double error_m = 0;           ///< The largest vertical deviation, in metres.
  Vec2 at;                      ///< The place of the largest deviation.
};

/// Returns the deviation, in metres, of a height from the expected one at a place that a feature covers.
using DeviationAt = std::function<double(Vec2 p, double z_m, OsmId feature)>;

/// Samples the ground at one random place in each square of a grid over the box. The ground there is the lowest
/// upward-facing triangle of a ground layer.
/// @param a_side  Squares along each side of the box, > 0.
/// O(triangles + samples).
GroundSamples sample_ground(const bake::BakedTile& tile, const DeviationAt& deviation_m, const Box2& box, int a_side);

/// An edge of a ground triangle on the border of a tile, in plane metres, lower end first.
using BorderEdge = std::array<Vec3, 2>;

/// The border edges on one side of a tile, sorted.
struct BorderEdges {
  std::vector<BorderEdge> ground;    ///< Edges of triangles that are visible from above.
  std::vector<BorderEdge> vertical;  ///< Edges of vertical triangles in the border plane: walls and skirts.
};

/// Returns the edges of ground triangles on the line x = at (or y = at), without vertical edges.
BorderEdges border_edges_along_x(const bake::BakedTile& tile, double at);
BorderEdges border_edges_along_y(const bake::BakedTile& tile, double at);

/// True if the ground of two neighbouring tiles meets without gaps: both have the same edges on their common side or,
/// where a border between surfaces runs along that side, a vertical face of one tile closes the difference.
bool borders_match(const BorderEdges& own, const BorderEdges& other);

}  // namespace citykiln::verify
