// Texture coordinates of bark on stems and joints. A joint is a smooth surface between the rings of three or more
// stems; a turn is a full circle about a stem.
#pragma once

#include <array>

#include "lsystems/mesh/joint.h"
#include "lsystems/mesh/joint_stencils.h"

namespace citykiln::lsystems {

/// The mapping from turns around a stem to u in texture periods: `per_turn` (a whole number) periods per turn, from
/// `at` on.
struct BarkWrap {
  double per_turn = 1, at = 0;
  double u(double turn) const { return at + per_turn * turn; }
};

/// The least value of u at the first point of a ring. With it, rings that begin half a side earlier still have u > 0.
inline constexpr double kFirstU = 1;

/// Returns the wrap of the stem that continues above a joint. It begins in [kFirstU, kFirstU + 1).
/// @param turn  The angle about the arriving stem, in turns, at the first point of the joint's lower ring.
BarkWrap continue_wrap(const BarkWrap& arriving, double turn, double per_turn);

/// The texture coordinates of a joint.
struct JointBarkUv {
  const Joint& joint;
  std::array<BarkWrap, 2 + kMostSideStems> wrap{};    ///< In the order of Joint::rings.
  std::array<double, 2 + kMostSideStems> sleeve_m{};  ///< The length from the box to the ring of a side stem.

  /// Returns u in texture periods and v in metres from the root.
  Vec2 at(const JointStencils::Vertex& vertex) const;
};

/// Returns the texture coordinates of a joint.
/// @param wrap  The wraps of the arriving stem, from the lower ring's first point on, of the continuing stem
/// (continue_wrap()) and of the side stems. In the result the first two are equal opposite to side 0, and moved by one
/// whole number so that the smaller one begins in [kFirstU, kFirstU + 1).
JointBarkUv joint_bark_uv(const Joint& joint, const std::array<BarkWrap, 2 + kMostSideStems>& wrap);

}  // namespace citykiln::lsystems
