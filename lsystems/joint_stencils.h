// What joints of one kind have in common: the topology, and the weights by which the cage's points make the surface.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// The cage of a joint is a box whose open faces lead to stems: below to the parent, above to the one that goes on, and
/// at the sides to the others. Points: the box's lower four corners, its upper four; then for each stem, lower, upper,
/// sides 0 to 3, eight about its ring, and four farther out, at the same angles as every other one. Side k lies between
/// corners k and k + 1; first points of rings lie at corner 0, those of side k at its lower corner k.
inline constexpr int kRingPoints = 12;
inline constexpr int kMostPoints = 8 + 6 * kRingPoints;

/// So far outside of the circle lie a ring's eight points that the limit curve is the circle, within kRoundness radii.
inline constexpr double kRingScale = 1 / 0.9019;
/// And four points, as on the box, within 0.014 radii.
inline constexpr double kCornerScale = 1 / 0.6574;
inline constexpr double kRoundness = 0.0006;

/// Between which v the box lies.
inline constexpr double kBoxLow = 1 / 3.0, kBoxHigh = 2 / 3.0;

struct JointStencils {
  struct Weight {
    std::uint32_t point = 0;
    double position = 0, tangent_1 = 0, tangent_2 = 0;
  };
  struct Vertex {
    std::int32_t stem = -1;   ///< On this one's ring, or on none.
    std::uint32_t index = 0;  ///< On the ring, or into `starts`.
    /// u in turns about the stem that goes on, v from 0 on the lower ring to 1 on the upper; on the sleeve of a side
    /// stem of its own, v from 0 on the box to 1 on its ring.
    Vec2 uv;
    int uv_stem = 0;  ///< 0: the stem that goes on; else 2 and more, in the order of rings.
  };
  std::vector<Weight> weights;
  std::vector<std::uint32_t> starts;  ///< Row i is weights starts[i] … starts[i + 1].
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  int stems = 2;
};

/// @param sides  Of its rings: 4, 8, … kMostSides.
/// @param open   Bit k: a stem leaves from side k.
///
/// By OpenSubdiv's topology and masks: uniform Catmull-Clark of rows of weights in doubles, then its limit masks, so
/// that vertices lie on the limit surface. The level-1 points on rings are the eight given ones, which makes rings
/// round. Weights of tangents are rounded to 2^-24, for OpenSubdiv asks libm for cosines there. O(sides²).
JointStencils make_joint_stencils(int sides, unsigned open);

}  // namespace citykiln::lsystems
