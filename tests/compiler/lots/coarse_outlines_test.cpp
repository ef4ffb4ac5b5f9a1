#include "compiler/lots/coarse_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/lots/recipe.h"

namespace citykiln::lots {
namespace {

// Borders between lots of a grid of 20 m: each is a line of many points that are up to `off_m` off it.
struct LotGrid {
  std::mt19937_64 dice;
  double off_m;

  double random() { return static_cast<double>(dice() % 2001) / 1000 - 1; }

  Polyline border(Vec2 a, Vec2 b) {
    Polyline line{a};
    for (int i = 1; i < 16; ++i)
      line.push_back(snapped(a + (b - a) * (i / 16.0) + left_of(unit(b - a)) * (off_m * random())));
    line.push_back(b);
    return line;
  }

  std::vector<Polygon> lots(int count) {
    const auto corner = [](int x, int y) { return Vec2{20.0 * x, 20.0 * y}; };
    std::vector<std::vector<Polyline>> east(count + 1), north(count + 1);
    for (int x = 0; x <= count; ++x)
      for (int y = 0; y <= count; ++y) {
        east[x].push_back(border(corner(x, y), corner(x + 1, y)));
        north[x].push_back(border(corner(x, y), corner(x, y + 1)));
      }
    std::vector<Polygon> all;
    for (int x = 0; x < count; ++x)
      for (int y = 0; y < count; ++y) {
        Ring ring(east[x][y].begin(), east[x][y].end() - 1);
        ring.insert(ring.end(), north[x + 1][y].begin(), north[x + 1][y].end() - 1);
        ring.insert(ring.end(), east[x][y + 1].rbegin(), east[x][y + 1].rend() - 1);
        ring.insert(ring.end(), north[x][y].rbegin(), north[x][y].rend() - 1);
        all.push_back({ring, {}});
      }
    return all;
  }
};

std::multiset<std::pair<Vec2, Vec2>> edges_of(const std::vector<Polygon>& polygons) {
  std::multiset<std::pair<Vec2, Vec2>> edges;
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
      edges.insert(std::minmax(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()]));
  return edges;
}

TEST(CoarseOutlines, CommonBordersStayCommon) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto coarse = coarse_outlines(LotGrid{std::mt19937_64(seed), 1}.lots(4));
    const auto edges = edges_of(coarse);
    // an edge of one polygon only lies on the border of the whole grid
    for (const auto& [a, b] : edges)
      if (edges.count({a, b}) == 1) {
        const Vec2 middle = (a + b) * 0.5;
        EXPECT_LT(std::min({std::abs(middle.x), std::abs(middle.y), std::abs(middle.x - 80), std::abs(middle.y - 80)}),
                  1.5)
            << seed;
      }
  }
}

TEST(CoarseOutlines, BordersStayNearWhereTheyWere) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<Polygon> fine = LotGrid{std::mt19937_64(seed), 1}.lots(3), coarse = coarse_outlines(fine);
    for (std::size_t i = 0; i < fine.size(); ++i)
      for (const Vec2 p : fine[i].outer)
        EXPECT_LE(distance_to_ring(coarse[i].outer, p), kOutlineTolerance_m + 0.71 * kOutlineStep_m) << seed;
  }
}

TEST(CoarseOutlines, StraightBordersKeepTheirEndsAlone) {
  const auto coarse = coarse_outlines(LotGrid{std::mt19937_64(1), 0.05}.lots(3));
  for (const Polygon& polygon : coarse) {
    EXPECT_EQ(polygon.outer.size(), 4u);
    EXPECT_EQ(area_m2(polygon), 400);
  }
}

TEST(CoarseOutlines, AreOnTheGridAndSmallRingsVanish) {
  const Ring hole = {{10.1, 10.1}, {10.2, 10.1}, {10.1, 10.2}};
  const auto coarse =
      coarse_outlines(std::vector<Polygon>{{{{-0.1, 0}, {20.2, 0.3}, {20, 20}, {0, 20.4}}, {hole}}, {hole, {}}, {}});
  ASSERT_EQ(coarse.size(), 3u);
  EXPECT_EQ(coarse[0], (Polygon{{{0, 0}, {20.25, 0.25}, {20, 20}, {0, 20.5}}, {}}));
  EXPECT_TRUE(coarse[1].outer.empty());
  EXPECT_TRUE(coarse[2].outer.empty());
}

// The share of one lot must not change with lots that do not touch it.
TEST(CoarseOutlines, DependOnNeighboursOnly) {
  const std::vector<Polygon> all = LotGrid{std::mt19937_64(3), 1}.lots(4);
  std::vector<Polygon> some;
  for (const std::size_t i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) some.push_back(all[i]);
  EXPECT_EQ(coarse_outlines(some)[4], coarse_outlines(all)[5]);
}

}  // namespace
}  // namespace citykiln::lots
