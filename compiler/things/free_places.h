// Free places for things: beside carriageways, outside of walls and water.
//
//     =====carriageway======       a node of the way: across the axis to the side of its traffic,
//     - - - - - o - - - - ->       to the first free place at most 20 m away
//     =========:|===========
//     ___kerb___x___________       another node: the nearest free place within 3 m
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::things {

/// The largest distance by which a thing is moved that does not belong to a way, and that by which one is moved off the
/// axis of its way.
inline constexpr double kMaxMove_m = 3, kMaxOffAxis_m = 20;
/// The largest distance to the wall that a thing is put on.
inline constexpr double kMaxWall_m = 5;

/// A place on a wall and the direction that it faces, length 1.
struct WallPlace {
  Vec2 at, out;
};

/// Finds free places on the land cover of a map, in plane metres. Barred land cover is where nothing stands unless it
/// is mapped there: carriageways other than pedestrian streets, parking lanes, cycle paths, steps, rails, water and
/// buildings. Polygons are sorted into blocks when a place in these is asked for, so the object is not thread-safe.
class FreePlaces {
 public:
  /// @param cover  The land cover of the map, with buildings; must outlive the object.
  explicit FreePlaces(std::span<const ground::LandCoverPolygon> cover);

  /// Returns the land cover at a place; nothing where there is none.
  std::optional<map::LandCoverClass> surface_at(Vec2 at);
  /// Returns the polygon on top at a place, trimmed to the surroundings of the place; nullptr where there is none. It
  /// is valid as long as the object.
  const ground::LandCoverPolygon* polygon_at(Vec2 at);
  /// True if a disc is outside of barred land cover, as far as its centre and eight points of its border say.
  bool is_free(Vec2 at, double radius_m);
  /// Returns `at` if it is free for a disc of this radius, else the nearest free one of places on circles around it, up
  /// to kMaxMove_m away. Empty: none is free.
  std::optional<Vec2> nearest_free(Vec2 at, double radius_m);
  /// Returns the first free place from `from` on in a direction (a unit vector), at most kMaxOffAxis_m away. Empty:
  /// none is free.
  std::optional<Vec2> first_free(Vec2 from, Vec2 direction, double radius_m);
  /// Returns the nearest place on the wall of a building, less than kMaxWall_m away. A place counts only if the place
  /// `before_m` in front of the wall is free. Empty: there is none.
  std::optional<WallPlace> nearest_wall(Vec2 at, double before_m);

 private:
  struct Block {
    std::vector<ground::LandCoverPolygon> surfaces;
    ground::LandCoverIndex index;
  };
  const Block& block_at(Vec2 at);
  bool is_barred_at(Vec2 at);

  std::span<const ground::LandCoverPolygon> cover_;
  BoxGrid near_;
  std::map<std::pair<int, int>, std::unique_ptr<Block>> blocks_;
};

}  // namespace citykiln::things
