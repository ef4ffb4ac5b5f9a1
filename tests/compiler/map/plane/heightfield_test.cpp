#include "compiler/map/plane/heightfield.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

// Deterministic hills.
Heightfield hills(int columns, int rows) {
  Heightfield field{{-64, 32}, {16, 16}, columns, rows, {}, 0};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) field.heights.push_back((i * i * 37 + j * 101 + i * j * 53) % 4096 - 500);
  return field;
}

TEST(Heightfield, IsExactAtItsVertices) {
  const Heightfield field = hills(7, 5);
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      EXPECT_EQ(height_m_at(field, {field.min.x + i * 16, field.min.y + j * 16}), field.height_m_at_vertex(i, j));
}

TEST(Heightfield, IsThePlaneThroughTheCornersOfEachTriangle) {
  const Heightfield field = hills(7, 5);
  for (int j = 0; j + 1 < field.rows; ++j)
    for (int i = 0; i + 1 < field.columns; ++i) {
      const double sw = field.height_m_at_vertex(i, j), se = field.height_m_at_vertex(i + 1, j);
      const double nw = field.height_m_at_vertex(i, j + 1), ne = field.height_m_at_vertex(i + 1, j + 1);
      const Vec2 corner{field.min.x + i * 16, field.min.y + j * 16};
      // the two triangles' centres, and the middle of the diagonal that both share
      EXPECT_NEAR(height_m_at(field, corner + Vec2{32.0 / 3, 16.0 / 3}), (sw + se + ne) / 3, 1e-9);
      EXPECT_NEAR(height_m_at(field, corner + Vec2{16.0 / 3, 32.0 / 3}), (sw + nw + ne) / 3, 1e-9);
      EXPECT_EQ(height_m_at(field, corner + Vec2{8, 8}), (sw + ne) / 2);
      EXPECT_EQ(height_m_at(field, corner + Vec2{8, 0}), (sw + se) / 2);
      EXPECT_EQ(height_m_at(field, corner + Vec2{16, 4}), se + (ne - se) / 4);
    }
}

TEST(Heightfield, OutsideIsAsHighAsTheNearestPointInside) {
  const Heightfield field = hills(7, 5);
  const Box2 box = field.box();
  EXPECT_EQ(height_m_at(field, {box.min.x - 500, box.min.y - 1}), height_m_at(field, box.min));
  EXPECT_EQ(height_m_at(field, {box.max.x + 1, box.max.y + 900}), height_m_at(field, box.max));
  EXPECT_EQ(height_m_at(field, {-20, box.max.y + 3}), height_m_at(field, {-20, box.max.y}));
}

TEST(Heightfield, NormalOfASlopeStandsOnIt) {
  Heightfield field{{0, 0}, {8, 8}, 6, 6, {}, 0};
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i)
      field.heights.push_back(64 * (2 * i - 3 * j));  // 2 m a step east, 3 m down a step north
  const Vec3 normal = normal_at(field, {17, 23}), expected = unit(Vec3{-2.0 / 8, 3.0 / 8, 1});
  EXPECT_NEAR(normal.x, expected.x, 1e-12);
  EXPECT_NEAR(normal.y, expected.y, 1e-12);
  EXPECT_NEAR(normal.z, expected.z, 1e-12);
}

TEST(Heightfield, WindowHasTheSameHeightsAndNormals) {
  const Heightfield field = hills(40, 30);
  const Box2 box{{50, 100}, {301, 333}};
  const Heightfield window = window_of(field, box);
  EXPECT_LT(window.heights.size(), field.heights.size());
  for (double x = box.min.x; x <= box.max.x; x += 3.7)
    for (double y = box.min.y; y <= box.max.y; y += 4.1) {
      const Vec2 p = snapped(Vec2{x, y});
      EXPECT_EQ(height_m_at(window, p), height_m_at(field, p));
      EXPECT_EQ(normal_at(window, p), normal_at(field, p));
    }
}

// Steps that are no powers of two: what is divided is never the distance to where the field begins.
TEST(Heightfield, HeightsDoNotDependOnWhereTheFieldBegins) {
  for (const Vec2 step_m : {Vec2{68, 92}, {13.5, 11}, {1.875, 1.125}, {120, 104}}) {
    Heightfield field = hills(90, 70);
    field.min = {-31 * step_m.x, 17 * step_m.y}, field.step_m = step_m;
    // its western and southern part is far away from what is asked for
    const Vec2 sw = field.vertex(55, 40), ne = field.vertex(80, 60);
    const Heightfield window = window_of(field, {sw, ne});
    ASSERT_LT(window.columns, 40);
    const RandomSequence draw(1, StableId{1}, "places");
    for (std::uint32_t i = 0; i < 20000; ++i) {
      Vec2 p{draw.between(sw.x, ne.x, 2 * i), draw.between(sw.y, ne.y, 2 * i + 1)};
      if (i % 2 == 0) p = snapped(p);
      ASSERT_EQ(height_m_at(window, p), height_m_at(field, p));
      ASSERT_EQ(normal_at(window, p), normal_at(field, p));
      ASSERT_EQ(nearest_vertex(window, p), nearest_vertex(field, p));
    }
    for (int j = 40; j <= 60; ++j)
      for (int i = 55; i <= 80; ++i) {
        EXPECT_EQ(height_m_at(window, field.vertex(i, j)), field.height_m_at_vertex(i, j));
        EXPECT_EQ(nearest_vertex(window, field.vertex(i, j)), field.vertex(i, j));
      }
  }
}

TEST(Heightfield, TheCellHoldsThePoint) {
  Heightfield field = hills(40, 30);
  field.min = {-21 * 1.875, 5 * 92.0}, field.step_m = {1.875, 92};
  const Box2 box = field.box();
  const RandomSequence draw(2, StableId{1}, "places");
  for (std::uint32_t i = 0; i < 20000; ++i) {
    Vec2 p{draw.between(box.min.x, box.max.x, 2 * i), draw.between(box.min.y, box.max.y, 2 * i + 1)};
    // beside the lines too
    if (i % 4 == 1) p.x = std::nextafter(field.vertex(static_cast<int>(i % 39) + 1, 0).x, -1e9);
    if (i % 4 == 2) p.x = field.vertex(static_cast<int>(i % 40), 0).x;
    const CellPosition in = cell_at(field, p);
    const Vec2 low = field.vertex(in.i, in.j), high = field.vertex(in.i + 1, in.j + 1);
    ASSERT_TRUE((Box2{low, high}).contains(p));
    ASSERT_GE(in.i, 0);
    ASSERT_LE(in.i, field.columns - 2);
    ASSERT_GE(in.u, 0);
    ASSERT_LE(in.u, 1);
    ASSERT_GE(in.v, 0);
    ASSERT_LE(in.v, 1);
  }
}

TEST(Heightfield, WindowBeyondTheFieldIsClampedAndWhole) {
  const Heightfield field = hills(7, 5);
  EXPECT_EQ(window_of(field, field.box().widened(1000)), field);
  for (const Vec2 far : {Vec2{5000, 5000}, Vec2{-5000, 40}, Vec2{0, -9000}}) {
    const Heightfield window = window_of(field, {far, far + Vec2{1, 1}});
    EXPECT_GE(window.columns, 2);
    EXPECT_GE(window.rows, 2);
    EXPECT_EQ(window.heights.size(), static_cast<std::size_t>(window.columns) * window.rows);
    EXPECT_EQ(height_m_at(window, far), height_m_at(field, far));
  }
}

}  // namespace
}  // namespace citykiln::map
