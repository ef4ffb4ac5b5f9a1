// Texture coordinates of bark on stems and joints.
#pragma once

#include <array>

#include "lsystems/joint.h"
#include "lsystems/joint_stencils.h"

namespace citykiln::lsystems {

/// u around a stem in texture periods: `per_turn` periods (a whole number) a turn, beginning at `at`.
struct BarkWrap {
  double per_turn = 1, at = 0;
  double u(double turn) const { return at + per_turn * turn; }
};

/// Start of u, so that rings that begin half a side earlier still have u > 0.
inline constexpr double kFirst = 1;

/// The wrap of the stem that continues above a joint.
/// @param turn  Of the arriving stem, at the first point of the joint's lower ring.
BarkWrap continue_wrap(const BarkWrap& arriving, double turn, double per_turn);

/// Wraps of a joint's stems in the order of its rings.
struct JointBarkUv {
  const Joint& joint;
  std::array<BarkWrap, 2 + kMostSideStems> wrap{};
  std::array<double, 2 + kMostSideStems> sleeve_m{};  ///< Length from the box to the ring of a side stem.

  /// u in texture periods, v in metres from the root.
  Vec2 at(const JointStencils::Vertex& vertex) const;
};

/// @param wrap  Of the arriving stem, beginning at the lower ring's first point; of continue_wrap(); of the side stems.
///              Both first ones are moved by the same whole number to begin at kFirst.
JointBarkUv joint_bark_uv(const Joint& joint, const std::array<BarkWrap, 2 + kMostSideStems>& wrap);

}  // namespace citykiln::lsystems
