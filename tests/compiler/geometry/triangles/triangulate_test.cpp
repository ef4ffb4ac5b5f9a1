#include "compiler/geometry/triangles/triangulate.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln {
namespace {

double triangles_area_m2(const PlaneTriangles& t) {
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles) sum += cross(t.points[b] - t.points[a], t.points[c] - t.points[a]) / 2;
  return sum;
}

// A star-shaped ring about a centre, counter-clockwise.
Ring star(Vec2 centre, double radius_m, int corners, std::uint64_t seed) {
  const RandomSequence draw(seed, StableId{1}, "star");
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(
        snapped(centre + direction_of(i / static_cast<double>(corners)) * (radius_m * draw.between(0.4, 1, i))));
  return ring;
}

Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(Triangulate, CoversTheAreaOfAPolygonWithHoles) {
  for (int seed = 0; seed < 50; ++seed) {
    const Polygon polygon{star({3000, -2000}, 60, 5 + seed, seed), {reversed(star({3000, -2000}, 12, 7, seed + 100))}};
    const PlaneTriangles t = triangulate(polygon);
    EXPECT_NEAR(triangles_area_m2(t), area_m2(polygon), 1e-9);
    // no point is added, and Euler: n + 2 holes - 2 triangles
    EXPECT_EQ(t.points.size(), polygon.outer.size() + 7);
    EXPECT_EQ(t.triangles.size(), t.points.size() + 2 - 2);
  }
}

TEST(Triangulate, KeepsTheRingsPointsInOrder) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
  const PlaneTriangles t = triangulate(polygon);
  ASSERT_EQ(t.points.size(), 8u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(t.points[i], polygon.outer[i]);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(t.points[4 + i], polygon.holes[0][i]);
}

TEST(Triangulate, TakesCrossingRingsByTheEvenOddRule) {
  const PlaneTriangles bow = triangulate({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, {}});
  EXPECT_EQ(bow.points.size(), 5u);
  EXPECT_NEAR(triangles_area_m2(bow), 8, 1e-9);
  // a hole that reaches out of the outer ring is inside where only it is
  const PlaneTriangles out = triangulate({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{3, 1}, {3, 2}, {6, 2}, {6, 1}}}});
  EXPECT_NEAR(triangles_area_m2(out), 16 - 1 + 2, 1e-9);
}

TEST(Triangulate, CancelsEdgesSharedByTwoRings) {
  // the hole takes the right half away along three sides of the outer ring
  const PlaneTriangles t = triangulate({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{2, 0}, {2, 4}, {4, 4}, {4, 0}}}});
  EXPECT_NEAR(triangles_area_m2(t), 8, 1e-9);
}

TEST(Triangulate, IsTotalOnDegenerateRings) {
  EXPECT_TRUE(triangulate({}).triangles.empty());
  EXPECT_TRUE(triangulate({{{1, 1}}, {}}).triangles.empty());
  EXPECT_TRUE(triangulate({{{1, 1}, {2, 2}, {3, 3}}, {}}).triangles.empty());
  EXPECT_TRUE(triangulate({{{1, 1}, {2, 2}, {1, 1}, {2, 2}}, {{}, {{5, 5}}}}).triangles.empty());
  EXPECT_NEAR(triangles_area_m2(triangulate({{{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {}})), 16, 1e-12);
}

TEST(Triangulate, TriangulatesRandomScribblesOnTheGrid) {
  for (int seed = 0; seed < 200; ++seed) {
    const RandomSequence draw(seed, StableId{2}, "scribble");
    Polygon polygon;
    for (int i = 0; i < 30; ++i)
      polygon.outer.push_back(snapped(Vec2{draw.between(0, 9, 2 * i), draw.between(0, 9, 2 * i + 1)}));
    const PlaneTriangles t = triangulate(polygon);
    EXPECT_GE(t.points.size(), 30u);
    for (const Vec2 p : t.points) EXPECT_EQ(p, snapped(p));
    EXPECT_GT(triangles_area_m2(t), 0);
    EXPECT_LE(triangles_area_m2(t), 81);
  }
}

}  // namespace
}  // namespace citykiln
