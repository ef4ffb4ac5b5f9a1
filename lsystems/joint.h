// Places joints of three or more stems: computes the positions of their control cages.
#pragma once

#include <array>
#include <span>

#include "lsystems/ring.h"

namespace citykiln::lsystems {

/// A stem at a joint.
struct Stem {
  Vec3 direction;         ///< Unit vector, away from the root.
  double radius = 0;      ///< The radius at the joint.
  double slope = 0;       ///< The decrease of the radius per metre, away from the root.
  double room_m = 0;      ///< The length of the stem that the joint may use.
  std::int32_t name = 0;  ///< The caller's index.
};

inline constexpr std::size_t kMostSideStems = 4;

struct Joint {
  std::array<Vec3, 8> box;
  /// The rings of the arriving stem, of the continuing stem, and of open sides in order. Ring::sides is not set.
  std::array<Ring, 2 + kMostSideStems> rings;
  std::array<std::int32_t, 2 + kMostSideStems> names{};
  std::size_t stems = 2;
  unsigned open = 0;    ///< Bit k: a stem leaves side k.
  double extent_m = 0;  ///< The largest distance of a cage point from the box's centre.
};

/// Places the cage of a joint. Rings lie where stems no longer overlap, or nearer if room_m requires. O(1).
///
/// @param node  The common point of the axes.
/// @param parent  The arriving stem. Its direction is that at the node.
/// @param upper    The continuing stem.
/// @param sides    One to kMostSideStems others; the first, which should be the thickest, orients the box.
Joint place_joint(Vec3 node, const Stem& parent, const Stem& upper, std::span<const Stem> sides);

}  // namespace citykiln::lsystems
