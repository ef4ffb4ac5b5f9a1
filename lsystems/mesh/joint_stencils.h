// Stencils of joints: the mesh of a joint, with each vertex as a weighted sum of cage points (control points). They
// depend only on the number of sides and on which sides of the box have stems.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// The cage of a joint is a box with open faces: below towards the parent, above towards the continuing stem, and at
/// sides 0 to 3 towards other stems. Its points are the four lower and the four upper corners of the box; then for each
/// stem (lower, upper, sides in order) eight points around its ring and four farther out at the angles of every other
/// one. Side k lies between corners k and k + 1. Rings begin at corner 0; the ring of side k begins at lower corner k.
inline constexpr int kRingPoints = 12;
inline constexpr int kMostPoints = 8 + 6 * kRingPoints;

/// The distance of a ring's eight points from its centre, in radii. The limit curve is then the circle to within
/// kRoundness.
inline constexpr double kRingScale = 1 / 0.9019;
/// The distance for a ring of four points and for the box. The limit curve is the circle to within 0.014 radii.
inline constexpr double kCornerScale = 1 / 0.6574;
inline constexpr double kRoundness = 0.0006;

/// The range of v on the box.
inline constexpr double kBoxLow = 1 / 3.0, kBoxHigh = 2 / 3.0;

/// The stencils for one number of sides and one combination of side stems.
struct JointStencils {
  /// The share of a cage point in a vertex's position and in the two tangents there.
  struct Weight {
    std::uint32_t point = 0;
    double position = 0, tangent_1 = 0, tangent_2 = 0;
  };
  struct Vertex {
    std::int32_t stem = -1;   ///< The stem on whose ring the vertex lies, or -1.
    std::uint32_t index = 0;  ///< Its position on the ring, or its row in `starts`.
    /// u in turns about the continuing stem, v from 0 on the lower ring to 1 on the upper; on a side stem's sleeve u is
    /// about the side stem, and v from 0 on the box to 1 on its ring.
    Vec2 uv;
    int uv_stem = 0;  ///< The stem to which uv refers. 0: the continuing stem; else the ring of a side stem, ≥ 2.
  };
  std::vector<Weight> weights;
  std::vector<std::uint32_t> starts;  ///< Row i has weights[starts[i]] … weights[starts[i + 1] - 1].
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  int stems = 2;
};

/// Computes the stencils with OpenSubdiv: uniform Catmull-Clark refinement of rows of weights in doubles, then limit
/// masks, so that vertices lie on the limit surface. The points of rings at level 1 are replaced by the eight given
/// ones, which makes rings round. Tangent weights are rounded to 2^-24, because OpenSubdiv computes them with cosines
/// of libm. O(sides²).
///
/// @param sides  The sides of the rings: 4, 8, … kMostSides.
/// @param open   Bit k: a stem leaves side k.
JointStencils make_joint_stencils(int sides, unsigned open);

}  // namespace citykiln::lsystems
