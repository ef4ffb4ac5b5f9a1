// The ground of a scene at single places: height and land cover, without generating it.
#pragma once

#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The ground at a place.
struct GroundPlace {
  double height_m = 0;  ///< Of the terrain, which is not graded, or of standing water.
  map::LandCoverClass cover{};
};

/// Refers to the scene, which must outlive it. Its scene has chunks.
class GroundLookup {
 public:
  explicit GroundLookup(const Scene& scene);

  /// The ground in the chunk whose tile is nearest: of the topmost area, or kUnknown. O(areas of the chunk).
  GroundPlace at(Vec2 place) const;
  /// Whether a chunk's tile covers a place.
  bool is_in_tile(Vec2 place) const;
  /// The box of all chunks' tiles.
  const Box2& box() const { return box_; }

 private:
  struct Tile {
    const Chunk* chunk;
    Box2 box;
    std::vector<Box2> areas;  ///< Of the chunk's surfaces.
  };
  const Tile& nearest(Vec2 place) const;

  std::vector<Tile> tiles_;
  Box2 box_;
};

/// `count` places on the border of a box, at equal shares of the way around, counter-clockwise from the middle of the
/// eastern side; a little inside of it.
std::vector<Vec2> places_on_border(const Box2& box, int count);

}  // namespace citykiln::scene
