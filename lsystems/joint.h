// Where stems part: the cage of one joint, placed.
#pragma once

#include <array>
#include <span>

#include "lsystems/ring.h"

namespace citykiln::lsystems {

/// A stem as its joint sees it.
struct Stem {
  Vec3 direction;         ///< Of length 1, away from the root.
  double radius = 0;      ///< At the joint.
  double slope = 0;       ///< How much a metre it narrows, away from the root.
  double room_m = 0;      ///< How much of its length the joint may take.
  std::int32_t name = 0;  ///< The caller's.
};

inline constexpr std::size_t kMostSideStems = 4;

struct Joint {
  std::array<Vec3, 8> box;
  std::array<Ring, 2 + kMostSideStems> rings;  ///< Lower, upper, those of open sides from 0 to 3; sides are not set.
  std::array<std::int32_t, 2 + kMostSideStems> names{};
  std::size_t stems = 2;
  unsigned open = 0;    ///< As in make_joint_stencils.
  double extent_m = 0;  ///< All points of the cage are so near to the box's middle.
};

/// @param node     Where the axes meet; the parent arrives here.
/// @param parent   Its direction is that in which it arrives.
/// @param upper    The stem that goes on.
/// @param sides    One to four others; the first decides how the box is turned, and should be the thickest.
///
/// Rings lie where stems no longer touch, if there is room. O(1).
Joint place_joint(Vec3 node, const Stem& parent, const Stem& upper, std::span<const Stem> sides);

}  // namespace citykiln::lsystems
