// A coarse grid of a scene: the heights and the built area of each column. Named views are chosen from it.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::preview {

/// True if a material is that of walls or roofs.
bool is_built(materials::Material material);
/// True if a material is that of streets.
bool is_street(materials::Material material);

/// A grid of 96 by 96 columns over the positions of all primitives, without instances. A scene without positions has a
/// grid of 200 m by 200 m about (0, 0). O(n).
class SceneGrid {
 public:
  explicit SceneGrid(std::span<const bake::BakedTile> tiles);

  /// The lowest and the highest point of every column that has any. All land has the same weight, however dense its
  /// mesh is.
  std::vector<Vec3> points() const;
  /// The core: the middle of the most densely built place of some 300 m, at the height of its ground. Where nothing is
  /// built, it is the middle of the scene.
  Vec3 core_point() const { return core_; }
  /// The highest point of the column at a place; -infinity outside the scene.
  double highest_m(Vec2 at) const;
  /// The lowest point of the column at a place; -infinity outside the scene.
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
  void find_core();
  double built_about(std::size_t column, int radius) const;

  Box2 box_;
  std::vector<Column> columns_;
  Vec3 core_;
};

}  // namespace citykiln::preview
