// Joints of three or more stems: positions of the control cage.
#pragma once

#include <array>
#include <span>

#include "lsystems/ring.h"

namespace citykiln::lsystems {

/// A stem at a joint.
struct Stem {
  Vec3 direction;         ///< Unit, away from the root.
  double radius = 0;      ///< At the joint.
  double slope = 0;       ///< Decrease of the radius a metre, away from the root.
  double room_m = 0;      ///< Length that the joint may use.
  std::int32_t name = 0;  ///< The caller's index.
};

inline constexpr std::size_t kMostSideStems = 4;

struct Joint {
  std::array<Vec3, 8> box;
  std::array<Ring, 2 + kMostSideStems> rings;  ///< Lower, upper, open sides in order. Ring::sides is not set.
  std::array<std::int32_t, 2 + kMostSideStems> names{};
  std::size_t stems = 2;
  unsigned open = 0;    ///< Bit k: a stem leaves side k.
  double extent_m = 0;  ///< Largest distance of a cage point from the box's centre.
};

/// Places a joint's cage. Rings lie where stems no longer overlap, as far as room_m allows. O(1).
///
/// @param node     Common point of the axes.
/// @param parent   Its direction is that of its arrival at the node.
/// @param upper    The continuing stem.
/// @param sides    One to kMostSideStems others; the first, which should be the thickest, orients the box.
Joint place_joint(Vec3 node, const Stem& parent, const Stem& upper, std::span<const Stem> sides);

}  // namespace citykiln::lsystems
