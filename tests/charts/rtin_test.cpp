#include "tests/charts/rtin.h"

#include <gtest/gtest.h>

#include <cmath>

namespace citykiln::charts {
namespace {

HeightSquare made_square(int power, const std::function<double(int, int)>& height_m) {
  HeightSquare square{power, 1, {}};
  for (int row = 0; row < square.samples_per_side(); ++row)
    for (int column = 0; column < square.samples_per_side(); ++column)
      square.heights_m.push_back(height_m(column, row));
  return square;
}

TEST(Rtin, APlaneIsTwoTriangles) {
  const HeightSquare square = made_square(5, [](int column, int row) { return 2.0 * column - row; });
  EXPECT_EQ(rtin_triangle_count(square, [](Vec2) { return 1e-9; }), 2);
}

TEST(Rtin, WithoutToleranceRoughLandIsWhole) {
  const HeightSquare square = made_square(4, [](int column, int row) { return std::sin(column * 1.7) + row * row; });
  EXPECT_EQ(rtin_triangle_count(square, [](Vec2) { return 1e-12; }), 2 * 16 * 16);
}

TEST(Rtin, APeakIsRefinedAroundItAlone) {
  const HeightSquare square = made_square(6, [](int column, int row) { return column == 5 && row == 7 ? 10.0 : 0.0; });
  const std::int64_t triangles = rtin_triangle_count(square, [](Vec2) { return 1; });
  EXPECT_GT(triangles, 12);
  EXPECT_LT(triangles, 100);
}

}  // namespace
}  // namespace citykiln::charts
