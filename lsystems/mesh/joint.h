// Places joints of three or more stems of a plant. A joint is a smooth surface given by a cage of control points: a box
// in the middle, and a ring of points on each stem.
#pragma once

#include <array>
#include <span>

#include "lsystems/mesh/ring.h"

namespace citykiln::lsystems {

/// A stem at a joint.
struct Stem {
  Vec3 direction;       ///< Unit vector, away from the root.
  double radius = 0;    ///< The radius at the joint.
  double slope = 0;     ///< The decrease of the radius per metre, away from the root.
  double room_m = 0;    ///< The length of the stem that the joint may use.
  std::int32_t id = 0;  ///< A number of the caller, copied to Joint::ids.
};

inline constexpr std::size_t kMostSideStems = 4;

/// The control cage of a joint.
struct Joint {
  /// The corners of the box: four lower, four upper.
  std::array<Vec3, 8> box;
  /// The rings of the arriving stem, of the continuing stem, and of the side stems; only the first `stems` are set.
  /// Side stems are in the order of the box sides through which they leave (bits of `open`). Ring::sides is not set.
  std::array<Ring, 2 + kMostSideStems> rings;
  std::array<std::int32_t, 2 + kMostSideStems> ids{};  ///< The Stem::id of each ring's stem.
  std::size_t stems = 2;
  unsigned open = 0;    ///< Bit k: a side stem leaves the box through side k.
  double extent_m = 0;  ///< An upper bound of the distance of cage points from the box's centre.
};

/// Places the cage of a joint, in the frame and units of `node`. Rings lie where stems no longer overlap, or nearer to
/// the node if Stem::room_m requires. Each side stem leaves through the free side of the box that is nearest to its
/// direction. Cannot fail. O(1).
///
/// @param node    The common point of the axes.
/// @param parent  The arriving stem, with its direction at the node.
/// @param upper   The stem that continues the arriving one.
/// @param sides   One to kMostSideStems other stems; the first, which should be the thickest, orients the box.
Joint place_joint(Vec3 node, const Stem& parent, const Stem& upper, std::span<const Stem> sides);

}  // namespace citykiln::lsystems
