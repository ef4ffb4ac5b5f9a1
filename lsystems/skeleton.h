// What a plant is made of before it has a surface: segments, polygons, and places for what is shaped elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/vec.h"
#include "lsystems/derive.h"

namespace citykiln::lsystems {

/// A turtle: where it is, and three directions of length 1 that stand square to each other; heading × left = up.
struct TurtleFrame {
  Vec3 at;
  Vec3 heading{0, 0, 1}, left{-1, 0, 0}, up{0, -1, 0};
};

inline constexpr std::int32_t kNoParent = -1;

/// What F and G draw. It keeps its directions from end to end; what turns, turns between segments.
struct Segment {
  TurtleFrame start;
  double length = 0;
  double start_radius = 0;  ///< The parent's end radius where the axis goes on, so that it tapers; else end_radius.
  double end_radius = 0;
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;  ///< The segment drawn before on this branch, or the one it branches from.
  std::int32_t order = 0;           ///< 0 of the trunk, one more at each branch.

  TurtleFrame end() const { return {start.at + start.heading * length, start.heading, start.left, start.up}; }
};

/// What { and } enclose; flat or nearly so, as the rules make it.
struct FlatPolygon {
  std::uint32_t first = 0, count = 0;  ///< Into Skeleton::vertices; at least three.
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;  ///< The segment before its {.
  std::int32_t order = 0;           ///< Of that segment's branch, or of the one that began since.
};

/// ~X, @O, @o: something of a name, here.
struct Instance {
  Kind kind = 0;  ///< Into LSystem::kinds: its name says what.
  TurtleFrame frame;
  double size = 1;
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;
  std::int32_t order = 0;
};

/// Lengths are the file's; the plant stands at the origin, z up. Parents come before their children.
struct Skeleton {
  std::vector<Segment> segments;
  std::vector<FlatPolygon> polygons;
  std::vector<Vec3> vertices;
  std::vector<Instance> instances;
  std::vector<Warning> warnings;  ///< Without a place: what a string asked for that cannot be.
};

}  // namespace citykiln::lsystems
