#include "compiler/geometry/triangles/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/point_buckets.h"

namespace citykiln {
namespace {

std::vector<GridPoint> grid(int columns, int rows, std::int64_t east, std::int64_t north) {
  std::vector<GridPoint> points;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) points.push_back({i * east, j * north});
  return points;
}

// Every face is counter-clockwise, and neighbours know each other across the edge they share.
void expect_whole(const Delaunay& d) {
  const auto& faces = d.faces();
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto& v = faces[f].vertices;
    EXPECT_GT(turn(d.vertices()[v[0]], d.vertices()[v[1]], d.vertices()[v[2]]), 0);
    for (int i = 0; i < 3; ++i) {
      if (faces[f].neighbours[i] == kNoFace) continue;
      const DelaunayFace& beyond = faces[faces[f].neighbours[i]];
      const auto k = std::ranges::find(beyond.neighbours, f) - beyond.neighbours.begin();
      ASSERT_LT(k, 3);
      EXPECT_EQ(beyond.vertices[(k + 1) % 3], v[(i + 2) % 3]);
      EXPECT_EQ(beyond.vertices[(k + 2) % 3], v[(i + 1) % 3]);
    }
  }
}

// The edge of a face that may be turned round; 3 if there is none.
int free_edge(const Delaunay& d, std::uint32_t f) {
  const auto& face = d.faces()[f];
  for (int i = 0; i < 3; ++i)
    if (!face.is_constrained[i] && face.neighbours[i] != kNoFace) return i;
  return 3;
}

TEST(Delaunay, RectanglesGetTheDiagonalFromSouthWest) {
  for (const auto& [east, north] : {std::pair<std::int64_t, std::int64_t>{68, 92}, {64, 64}, {1, 40}}) {
    Delaunay d(grid(7, 5, east, north), {});
    // rectangles of points that come one by one too
    for (std::int64_t k = 0; k < 4; ++k) {
      const GridPoint p{k * east, 5 * north};
      if (const std::uint32_t f = d.face_to_split(p, 0); f != kNoFace) d.insert(p, f);
    }
    EXPECT_GE(d.faces().size(), 48u);
    for (const DelaunayFace& face : d.faces())
      for (int i = 0; i < 3; ++i) {
        const GridPoint a = d.vertices()[face.vertices[i]], b = d.vertices()[face.vertices[(i + 1) % 3]];
        EXPECT_GE((b.x - a.x) * (b.y - a.y), 0);
      }
  }
}

TEST(Delaunay, AFlippedEdgeJoinsTheOtherCorners) {
  Delaunay d(std::vector<GridPoint>{{0, 0}, {100, 10}, {110, 90}, {-10, 80}}, {});
  const int i = free_edge(d, 0);
  ASSERT_LT(i, 3);
  const std::uint32_t apex = d.faces()[0].vertices[i];
  const auto changed = d.flip(0, i);
  EXPECT_EQ(changed.size(), 2u);
  expect_whole(d);
  for (const DelaunayFace& face : d.faces()) EXPECT_NE(std::ranges::find(face.vertices, apex), face.vertices.end());
}

TEST(Delaunay, TakesPointsAfterFlips) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const RandomSequence draw(seed, StableId{3}, "points");
    Delaunay d(std::vector<GridPoint>{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, {});
    for (std::uint32_t n = 0; n < 900; n += 3) {
      const GridPoint p{static_cast<std::int64_t>(draw.between(1, 999, n)),
                        static_cast<std::int64_t>(draw.between(1, 999, n + 1))};
      if (const std::uint32_t f = d.face_to_split(p, 0); f != kNoFace) d.insert(p, f);
      const auto f = static_cast<std::uint32_t>(draw.unit(n + 2) * static_cast<double>(d.faces().size()));
      const DelaunayFace face = d.faces()[f];
      const int i = free_edge(d, f);
      if (i == 3) continue;
      const DelaunayFace& beyond = d.faces()[face.neighbours[i]];
      const auto k = std::ranges::find(beyond.neighbours, f) - beyond.neighbours.begin();
      const auto place = [&](std::uint32_t v) { return d.vertices()[v]; };
      const GridPoint a = place(face.vertices[i]), b = place(face.vertices[(i + 1) % 3]),
                      c = place(face.vertices[(i + 2) % 3]), e = place(beyond.vertices[k]);
      if (turn(a, b, e) > 0 && turn(a, e, c) > 0) d.flip(f, i);
    }
    expect_whole(d);
    // no point came onto a side
    EXPECT_EQ(d.faces().size(), 2 * d.vertices().size() - 2 - 4);
  }
}

}  // namespace
}  // namespace citykiln
