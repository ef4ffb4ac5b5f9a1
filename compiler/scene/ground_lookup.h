// Looks up the height and the land cover of the ground at single places of a scene, without generating the ground.
#pragma once

#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The ground at a place.
struct GroundPlace {
  double height_m = 0;  ///< The height of standing water, else that of the terrain before grading.
  map::LandCoverClass cover{};
  const ground::LandCoverPolygon* polygon = nullptr;  ///< The topmost one; null: none.
};

/// Answers queries for a scene with at least one chunk (the recipes of one tile). Refers to the scene, which must
/// outlive it.
class GroundLookup {
 public:
  explicit GroundLookup(const Scene& scene);

  /// Returns the ground at a place, in plane metres, from the nearest tile: the topmost land cover polygon there, or
  /// kUnknown. Outside all tiles, the height is that of the nearest point of that tile's terrain. O(polygons of the
  /// chunk).
  GroundPlace at(Vec2 place) const;
  /// True if the tile of a chunk covers the place.
  bool is_in_tile(Vec2 place) const;
  /// Returns the box around the tiles of all chunks.
  const Box2& box() const { return box_; }

 private:
  struct Tile {
    const Chunk* chunk;
    Box2 box;
    std::vector<Box2> areas;  ///< The boxes of the chunk's surfaces.
  };
  const Tile& nearest(Vec2 place) const;

  std::vector<Tile> tiles_;
  Box2 box_;
};

/// Returns `count` places on a box that is 0.2 % smaller about the same centre, so that they lie inside the given one.
/// They are at equal steps, counter-clockwise from the middle of the eastern side.
std::vector<Vec2> places_on_border(const Box2& box, int count);

}  // namespace citykiln::scene
