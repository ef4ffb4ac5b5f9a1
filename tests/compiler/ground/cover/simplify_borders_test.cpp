#include "compiler/ground/cover/simplify_borders.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"
#include "compiler/contract/tolerance.h"
#include "tests/compiler/ground/cover/border_claims.h"
#include "tests/compiler/ground/wavy_surfaces.h"

namespace citykiln::ground {
namespace {

bool nowhere(GridPoint) { return false; }

TEST(SimplifyBorders, KeepsEveryPromiseOnWavyRings) {
  std::size_t before = 0, after = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 25, 0.2), kWavyCell);
    ASSERT_TRUE(no_two_cross(borders));
    for (const double tolerance_m : {0.01, 0.25, 1.0, 8.0}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << tolerance_m << " m");
      const SimplifiedBorders now = simplify_borders(borders, tolerance_m, nowhere);
      expect_simplified(borders, now, tolerance_m, kWavyCell);
      if (tolerance_m >= 1) before += borders.size(), after += now.borders.size();
    }
  }
  EXPECT_LT(after, before / 2);
}

// Random segments leave faces of all shapes, some a grid step thin.
TEST(SimplifyBorders, KeepsEveryPromiseOnTangles) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 60, 6), kWavyCell);
    for (const double tolerance_m : {0.1, 2.0}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << tolerance_m << " m");
      expect_simplified(borders, simplify_borders(borders, tolerance_m, nowhere), tolerance_m, kWavyCell);
    }
  }
}

using GridEdge = std::pair<GridPoint, GridPoint>;

std::set<GridEdge> arranged_again(std::span<const Border> borders) {
  std::vector<OwnedSegment> segments;
  std::vector<GridPoint> points;
  for (const Border& b : borders) {
    if (!b.is_cell_border) segments.push_back({b.a, b.b, b.left, 1}), segments.push_back({b.a, b.b, b.right, -1});
    points.insert(points.end(), {b.a, b.b});
  }
  const Arrangement arrangement = arrange(segments, points, kWavyCell);
  std::set<GridEdge> edges;
  for (const ArrangedEdge& e : arrangement.edges) edges.insert({arrangement.vertices[e.a], arrangement.vertices[e.b]});
  return edges;
}

// A border from arrange() may pass so close to a vertex that it would be bent if it were arranged again.
TEST(SimplifyBorders, ArrangedAgainNewOnesAreTheSame) {
  int made = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 60, 6), kWavyCell);
    const auto now = simplify_borders(borders, 2, nowhere).borders;
    std::set<GridEdge> old;
    for (const Border& b : borders) old.insert({b.a, b.b});
    const std::set<GridEdge> again = arranged_again(now);
    for (const Border& b : now) {
      if (old.contains({b.a, b.b})) continue;
      ++made;
      EXPECT_TRUE(again.contains({b.a, b.b})) << seed;
    }
  }
  EXPECT_GT(made, 1000);
}

TEST(SimplifyBorders, OrderDoesNotCount) {
  auto borders = borders_of(wavy_surfaces(3, 40, 1), kWavyCell);
  const SimplifiedBorders once = simplify_borders(borders, 0.7, nowhere);
  const RandomSequence draw(1, StableId{4}, "shuffle");
  for (std::uint32_t i = 1; i < borders.size(); ++i) std::swap(borders[i], borders[draw.below(i + 1, i)]);
  const SimplifiedBorders again = simplify_borders(borders, 0.7, nowhere);
  EXPECT_EQ(once.borders, again.borders);
  EXPECT_EQ(once.error_m, again.error_m);
}

TEST(SimplifyBorders, WhatIsFixedStays) {
  const auto borders = borders_of(wavy_surfaces(5, 40, 1), kWavyCell);
  const auto is_pinned = [](GridPoint p) { return p.x % 5 == 0; };
  std::set<GridPoint> fixed, left;
  std::map<GridPoint, int> degree;
  for (const Border& b : borders)
    for (const GridPoint p : {b.a, b.b})
      if (++degree[p], b.is_cell_border || is_pinned(p)) fixed.insert(p);
  for (const auto& [p, borders_here] : degree)
    if (borders_here != 2) fixed.insert(p);
  for (const Border& b : simplify_borders(borders, 50, is_pinned).borders) left.insert({b.a, b.b});
  EXPECT_TRUE(std::ranges::includes(left, fixed));
  EXPECT_LT(left.size(), degree.size());
}

// Every vertex left that is not fixed would make too large an error, or has another in its way.
TEST(SimplifyBorders, NothingMoreCouldGo) {
  constexpr double kTolerance_m = 1;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const auto borders = borders_of(wavy_surfaces(seed, 40, 1), kWavyCell);
    const auto now = simplify_borders(borders, kTolerance_m, nowhere).borders;
    const std::vector<OldRun> runs = runs_behind(borders, now);
    std::map<GridPoint, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < now.size(); ++i) at[now[i].a].push_back(i), at[now[i].b].push_back(i);
    int checked = 0;
    for (const auto& [v, here] : at) {
      if (here.size() != 2 || now[here[0]].is_cell_border) continue;
      const auto other_end = [&, v = v](std::size_t i) { return now[i].a == v ? now[i].b : now[i].a; };
      const GridPoint a = other_end(here[0]), b = other_end(here[1]);
      double error_m = 0;
      for (const std::size_t i : here)
        for (const GridPoint p : runs[i].points)
          error_m = std::max(error_m, distance_m(plane_point(p), plane_point(a), plane_point(b)));
      bool is_blocked = std::ranges::any_of(at[a], [&](std::size_t i) { return now[i].a == b || now[i].b == b; });
      for (const auto& [p, unused] : at) {
        if (p == a || p == b || p == v) continue;
        const auto s = turn(a, v, p), t = turn(v, b, p), u = turn(b, a, p);
        if ((s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0)) is_blocked = true;
        if (distance_m(plane_point(p), plane_point(a), plane_point(b)) < 2 * kQuantum_m) is_blocked = true;
      }
      EXPECT_TRUE(is_blocked || error_m > kTolerance_m - 1e-9);
      ++checked;
    }
    EXPECT_GT(checked, 100);
  }
}

// The cell's border and further rings with 1 inside and 0 outside.
std::vector<Border> borders_with(const std::vector<std::vector<Vec2>>& rings) {
  std::vector<Border> borders;
  const auto add = [&](Vec2 from, Vec2 to, std::uint32_t left, std::uint32_t right, bool is_cell_border) {
    const GridPoint a = grid_point(from), b = grid_point(to);
    borders.push_back(a < b ? Border{a, b, left, right, is_cell_border} : Border{b, a, right, left, is_cell_border});
  };
  const std::vector<Vec2> corners = {{-128, 0}, {0, 0}, {0, 128}, {-128, 128}};
  for (int i = 0; i < 4; ++i) add(corners[i], corners[(i + 1) % 4], 0, 0, true);
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()], 1, 0, false);
  return borders;
}

TEST(SimplifyBorders, AtNoToleranceOnlyStraightLinesAreJoined) {
  const auto borders = borders_with({{{-100, 20}, {-90, 20}, {-80, 20}, {-70, 20}, {-70, 50}, {-85, 35}}});
  const SimplifiedBorders now = simplify_borders(borders, 0, nowhere);
  EXPECT_EQ(now.borders.size(), 4u + 3u);
  EXPECT_EQ(now.error_m, 0);
  EXPECT_EQ(simplify_borders(now.borders, 0, nowhere).borders, now.borders);
}

TEST(SimplifyBorders, ARingKeepsThreeVertices) {
  const auto borders = borders_with({{{-100, 20}, {-99.9, 20}, {-99.8, 20.1}, {-99.9, 20.2}, {-100, 20.2}}});
  const SimplifiedBorders now = simplify_borders(borders, 64, nowhere);
  EXPECT_EQ(now.borders.size(), 4u + 3u);
  expect_simplified(borders, now, 64, kWavyCell);
}

// The tip of one ring reaches into the notch of another: the notch may only close when the tip is gone.
TEST(SimplifyBorders, AVertexWaitsForTheOneInItsWay) {
  const std::vector<Vec2> notched = {{-100, 20}, {-60, 20}, {-60, 60}, {-79, 60}, {-80, 58.5}, {-81, 60}, {-100, 60}};
  const std::vector<Vec2> tipped = {{-100, 61}, {-81, 61}, {-80, 59.9}, {-79, 61}, {-60, 61}, {-60, 90}, {-100, 90}};
  EXPECT_EQ(simplify_borders(borders_with({notched, tipped}), 2, nowhere).borders.size(), 4u + 4u + 4u);
  const auto tip = [&](GridPoint p) { return p == grid_point({-80, 59.9}); };
  const auto held = borders_with({notched, tipped});
  const SimplifiedBorders now = simplify_borders(held, 2, tip);
  expect_simplified(held, now, 2, kWavyCell);
  EXPECT_TRUE(std::ranges::any_of(now.borders, [&](const Border& b) {
    return b.b == grid_point({-80, 58.5}) || b.a == grid_point({-80, 58.5});
  }));
}

TEST(SimplifyBorders, AnIslandStaysInItsLake) {
  const std::vector<Vec2> lake = {{-100, 20}, {-60, 20}, {-59, 40}, {-60, 60}, {-100, 60}};
  // clockwise: 0 inside
  const std::vector<Vec2> island = {{-59.5, 39.9}, {-59.5, 40.1}, {-59.3, 40}};
  const auto borders = borders_with({lake, {island[0], island[1], island[2]}});
  const SimplifiedBorders now = simplify_borders(borders, 30, nowhere);
  expect_simplified(borders, now, 30, kWavyCell);
  EXPECT_EQ(border_faces_between(now.borders).size(), 3u);
}

TEST(SimplifyBorders, NothingInNothingOut) { EXPECT_TRUE(simplify_borders({}, 1, nowhere).borders.empty()); }

// The tests of slivers rely on this.
TEST(BorderClaims, SurfaceBetweenIsThatOfTheFace) {
  const auto surfaces = wavy_surfaces(7, 30, 0.5);
  const Partition all = partition_all_rings(land_cover_near(surfaces, kWavyCell), {}, {}, kWavyCell);
  const auto borders =
      visible_borders(all, ring_joints(land_cover_near(surfaces, kWavyCell), all.arrangement, kWavyCell));
  const auto at = [&](std::uint32_t v) { return plane_point(all.triangulation.vertices()[v]); };
  ASSERT_FALSE(all.face_cover.empty());
  for (std::size_t f = 0; f < all.face_cover.size(); ++f) {
    const auto& v = all.triangulation.faces()[f].vertices;
    EXPECT_EQ(surface_between(borders, (at(v[0]) + at(v[1]) + at(v[2])) * (1.0 / 3)), all.face_cover[f]);
  }
}

}  // namespace
}  // namespace citykiln::ground
