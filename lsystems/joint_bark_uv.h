// How the bark's picture lies around stems, and on the joints between them.
#pragma once

#include <array>

#include "lsystems/joint.h"
#include "lsystems/joint_stencils.h"

namespace citykiln::lsystems {

/// What u is around a stem, in sides of the bark's picture: how much more after a turn, a whole number, and where turns
/// begin.
struct BarkWrap {
  double per_turn = 1, at = 0;
  double u(double turn) const { return at + per_turn * turn; }
};

/// Where u begins, so that rings may begin up to half a side before their stem.
inline constexpr double kFirst = 1;

/// BarkWrap the stem that goes on from a joint.
/// @param turn  On the arriving stem, where the joint's lower ring begins.
BarkWrap continue_wrap(const BarkWrap& arriving, double turn, double per_turn);

/// One joint's bark: what arrives, what goes on, and the side stems, in the order of rings.
struct JointBarkUv {
  const Joint& joint;
  std::array<BarkWrap, 2 + kMostSideStems> wrap{};
  std::array<double, 2 + kMostSideStems> sleeve_m{};  ///< From the box to the ring of a side stem.

  /// u of a vertex in sides of the picture, v in metres from the root.
  Vec2 at(const JointStencils::Vertex& vertex) const;
};

/// @param around  What arrives from where the lower ring begins; as continue_wrap() says; those of side stems. Below
/// and
///                above the joint u is moved by the same whole number, to begin at kFirst.
JointBarkUv joint_bark_uv(const Joint& joint, const std::array<BarkWrap, 2 + kMostSideStems>& wrap);

}  // namespace citykiln::lsystems
