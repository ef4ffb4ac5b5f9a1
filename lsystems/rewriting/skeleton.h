// The skeleton of a plant: segments (straight pieces of stems), polygons, and instances of named shapes such as leaves.
// A turtle draws it: a moving position with three directions. So does grow_tree() (weber_penn.h).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/vec.h"
#include "lsystems/rewriting/derive.h"

namespace citykiln::lsystems {

/// The turtle's position and orthonormal directions; heading × left = up.
struct TurtleFrame {
  Vec3 at;
  Vec3 heading{0, 0, 1}, left{-1, 0, 0}, up{0, -1, 0};
};

inline constexpr std::int32_t kNoParent = -1;

/// A straight piece of a stem, drawn by F or G, or by grow_tree().
struct Segment {
  TurtleFrame start;
  double length = 0;
  /// The turtle: the parent's end_radius if the segment continues the parent's axis, else end_radius of this segment.
  /// grow_tree(): the radius of the stem there.
  double start_radius = 0;
  double end_radius = 0;
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;  ///< The previous segment of this branch, or the one from which it branches.
  std::int32_t order = 0;           ///< The branching order; 0: trunk.

  TurtleFrame end() const { return {start.at + start.heading * length, start.heading, start.left, start.up}; }
};

/// A polygon between { and }, nearly flat.
struct FlatPolygon {
  std::uint32_t first = 0, count = 0;  ///< The range in Skeleton::vertices, at least three.
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;  ///< The last segment before the polygon's {.
  std::int32_t order = 0;           ///< The order of the branch with its {.
};

/// A named shape with a frame: ~X, @O, @o.
struct Instance {
  Kind kind = 0;  ///< Index into LSystem::kinds, whose name is the name of the shape.
  TurtleFrame frame;
  double size = 1;
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;
  std::int32_t order = 0;
};

/// The most segments and leaves of a tree by Weber and Penn, and of a user-defined plant.
inline constexpr std::size_t kMostPlantParts = 400'000;

/// A skeleton, in the file's units or scaled to its `height`. The plant stands at the origin, z up. Parents precede
/// their children.
struct Skeleton {
  std::vector<Segment> segments;
  std::vector<FlatPolygon> polygons;
  std::vector<Vec3> vertices;
  std::vector<Instance> instances;
  std::vector<Warning> warnings;  ///< Without positions.
};

}  // namespace citykiln::lsystems
