// A coarse grid of a scene: the heights and the built area of each column. Named views are chosen from it.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::preview {

/// True for materials of walls and roofs.
bool is_built(materials::Material material);
/// True for materials of streets.
bool is_street(materials::Material material);

/// A grid of 96 by 96 columns over the positions of all primitives, without instances. A scene without positions has a
/// grid of 200 m by 200 m about (0, 0). O(n).
class SceneGrid {
 public:
  explicit SceneGrid(std::span<const bake::BakedTile> tiles);

  /// Returns the lowest and the highest point of every column that contains positions. So all land has the same weight,
  /// however dense its mesh is.
  std::vector<Vec3> points() const;
  /// A point of a column, and the area of walls and roofs in it.
  struct BuiltPoint {
    Vec3 at;
    double built_m2;
  };
  /// Returns the lowest and the highest point of every column in which something is built.
  std::vector<BuiltPoint> built_points() const;
  /// Returns the highest z of all columns; 0 without positions.
  double top_m() const;
  /// Returns the core: the middle of the square of some 300 m with the most walls and roofs of buildings, at the height
  /// of the ground. If nothing is built, the middle of the scene.
  Vec3 core_point() const { return core_; }
  /// True if a map element has a building: not a garden wall, a rampart or a bridge.
  bool has_building(OsmId feature) const { return buildings_.contains(feature); }
  /// Returns the highest z of the column at a place (plane metres); -infinity outside the scene.
  double highest_m(Vec2 at) const;
  /// Returns the lowest z of the column at a place (plane metres); -infinity outside the scene.
  double lowest_m(Vec2 at) const;

 private:
  struct Column {
    double low_m, high_m;
    double built_m2 = 0;
  };
  static constexpr int kAcross = 96;

  std::size_t column_at(Vec2 at) const;
  Vec2 middle_of(std::size_t column) const;
  void add(const bake::BakedTile& tile, const bake::Primitive& primitive);
  void add_buildings(const bake::BakedTile& tile, const bake::Primitive& primitive);
  // Adds the area of a triangle with the sides u and v from a to the columns that it is in.
  void add_built(Vec3 a, Vec3 u, Vec3 v);
  void find_core();
  double built_about(std::size_t column, int radius) const;

  Box2 box_;
  std::vector<Column> columns_;
  std::set<OsmId> buildings_;
  Vec3 core_;
};

}  // namespace citykiln::preview
