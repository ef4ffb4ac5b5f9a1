// Samples a baked tile's ground, the triangles of its ground layers, independently of the code that made it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::verify {

/// A triangle of the ground, in plane metres.
struct GroundFace {
  std::array<Vec3, 3> corners;
  OsmId feature;
};

/// Calls visit(face) for each triangle of the layers ground, roads and water, including vertical ones.
template <typename Visit>
void for_each_ground_face(const bake::BakedTile& tile, Visit visit) {
  for (const bake::Primitive& primitive : tile.primitives) {
    if (!bake::is_terrain(primitive)) continue;
    for (const auto& triangle : primitive.triangles) {
      GroundFace face{{}, tile.features[primitive.features[triangle[0]]]};
      for (std::size_t i = 0; i < 3; ++i) {
        const bake::Float3& p = primitive.positions[triangle[i]];
        face.corners[i] = Vec3{p[0], p[1], p[2]} + tile.origin;
      }
      visit(face);
    }
  }
}

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

/// True for places where ground is expected.
using ExpectsGround = std::function<bool(Vec2 p)>;

/// Samples the ground at one random place in each square of a grid over the box. The ground there is the lowest
/// upward-facing triangle of a ground layer.
/// @param a_side          Squares along each side of the box, > 0.
/// @param expects_ground  Other places without ground do not count. Empty: everywhere.
/// O(triangles + samples).
GroundSamples sample_ground(const bake::BakedTile& tile, const DeviationAt& deviation_m, const Box2& box, int a_side,
                            const ExpectsGround& expects_ground = {});

}  // namespace citykiln::verify
