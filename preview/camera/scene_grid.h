// A coarse grid of a scene: heights and built area of columns, from which named views are chosen.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/geometry/box.h"

namespace citykiln::preview {

/// Whether a material is that of walls or roofs.
bool is_built(materials::Material material);
/// Whether a material is that of streets.
bool is_street(materials::Material material);

/// 96 by 96 columns over all positions that are not instanced. Without any, one column of 200 m about (0, 0). O(n).
class SceneGrid {
 public:
  explicit SceneGrid(std::span<const bake::BakedTile> tiles);

  /// The lowest and the highest point of every column that has any: all land has the same weight, however dense.
  std::vector<Vec3> points() const;
  /// The middle of the most densely built place of some 300 m, at the height of its ground; the middle of the scene
  /// where nothing is built.
  Vec3 core_point() const { return core_; }
  /// The highest point near a place; -infinity outside the scene.
  double highest_m(Vec2 at) const;
  /// The lowest point near a place; -infinity outside the scene.
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
