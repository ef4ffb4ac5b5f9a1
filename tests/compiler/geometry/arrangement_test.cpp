#include "compiler/geometry/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "compiler/contract/random_sequence.h"

namespace citykiln {
namespace {

constexpr Box2 kCell{{0, 0}, {128, 128}};

// Random closed triangles, some far larger than the cell, with corners crowded onto a coarse lattice so that many
// coincide.
std::vector<OwnedSegment> random_triangles(std::uint64_t seed, int count, double reach_m, int lattice) {
  const RandomSequence draw(seed, StableId{1}, "triangles");
  std::vector<OwnedSegment> segments;
  for (int t = 0; t < count; ++t) {
    GridPoint corner[3];
    for (int i = 0; i < 3; ++i) {
      const auto coordinate = [&](int k) {
        return static_cast<std::int64_t>(
                   draw.between(-reach_m, 128 + reach_m, static_cast<std::uint32_t>(t * 6 + i * 2 + k)) * 1024) /
               lattice * lattice;
      };
      corner[i] = {coordinate(0), coordinate(1)};
    }
    for (int i = 0; i < 3; ++i) segments.push_back({corner[i], corner[(i + 1) % 3], static_cast<std::uint32_t>(t), 1});
  }
  return segments;
}

int sign(std::int64_t v) { return (v > 0) - (v < 0); }

bool on_segment(GridPoint a, GridPoint b, GridPoint p) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

// Do two edges meet elsewhere than at a common end?
bool conflict(const Arrangement& r, const ArrangedEdge& e, const ArrangedEdge& f) {
  const GridPoint a = r.vertices[e.a], b = r.vertices[e.b], c = r.vertices[f.a], d = r.vertices[f.b];
  for (const auto p : {f.a, f.b})
    if (p != e.a && p != e.b && on_segment(a, b, r.vertices[p])) return true;
  for (const auto p : {e.a, e.b})
    if (p != f.a && p != f.b && on_segment(c, d, r.vertices[p])) return true;
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

int conflicts(const Arrangement& r) {
  int count = 0;
  for (std::size_t i = 0; i < r.edges.size(); ++i)
    for (std::size_t j = i + 1; j < r.edges.size(); ++j) count += conflict(r, r.edges[i], r.edges[j]);
  return count;
}

TEST(Arrangement, EdgesMeetOnlyAtTheirEnds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const int lattice = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 1024 : 8192;
    const Arrangement r = arrange(random_triangles(seed, 25, seed % 2 ? 400 : 0, lattice), {}, kCell);
    ASSERT_FALSE(r.edges.empty()) << "seed " << seed;
    EXPECT_EQ(conflicts(r), 0) << "seed " << seed;
  }
}

TEST(Arrangement, EdgesMeetOnlyAtTheirEndsWithinAFewGridSteps) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<OwnedSegment> segments = random_triangles(seed, 8, 0, 1);
    for (OwnedSegment& s : segments)
      for (GridPoint* p : {&s.a, &s.b}) p->x = 60000 + p->x % 12, p->y = 60000 + p->y % 12;
    const Arrangement r = arrange(segments, {}, kCell);
    EXPECT_GT(r.edges.size(), 4u) << "seed " << seed;  // more than the cell's border
    EXPECT_EQ(conflicts(r), 0) << "seed " << seed;
  }
}

// Rings are closed and the windings of an inner vertex' edges cancel, owner by owner.
TEST(Arrangement, WindingsCancelAroundEachInnerVertex) {
  const Arrangement r = arrange(random_triangles(5, 40, 200, 1), {}, kCell);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> out;  // vertex, owner
  for (const ArrangedEdge& e : r.edges)
    for (std::uint32_t s = e.first; s < e.first + e.count; ++s) {
      out[{e.a, r.steps[s].owner}] += r.steps[s].winding;
      out[{e.b, r.steps[s].owner}] -= r.steps[s].winding;
    }
  int inner_count = 0;
  for (const auto& [key, sum] : out) {
    const GridPoint p = r.vertices[key.first];
    const bool inner = p.x > 0 && p.y > 0 && p.x < 128 * 1024 && p.y < 128 * 1024;
    EXPECT_TRUE(!inner || sum == 0);
    inner_count += inner;
  }
  EXPECT_GT(inner_count, 100);
}

std::vector<GridPoint> on_line_x(const Arrangement& r, std::int64_t x) {
  std::vector<GridPoint> points;
  for (const GridPoint p : r.vertices)
    if (p.x == x) points.push_back(p);
  return points;
}

TEST(Arrangement, NeighbouringCellsShareTheirBorderVertices) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto segments = random_triangles(seed, 40, 100, seed % 2 ? 1 : 512);
    const Arrangement west = arrange(segments, {}, kCell), east = arrange(segments, {}, {{128, 0}, {256, 128}});
    EXPECT_GT(on_line_x(west, 128 * 1024).size(), 2u) << "seed " << seed;  // more than the cell's corners
    EXPECT_EQ(on_line_x(west, 128 * 1024), on_line_x(east, 128 * 1024)) << "seed " << seed;
  }
}

TEST(Arrangement, TheOrderOfSegmentsDoesNotMatter) {
  auto segments = random_triangles(3, 40, 50, 1);
  const Arrangement forth = arrange(segments, {}, kCell);
  std::reverse(segments.begin(), segments.end());
  const Arrangement back = arrange(segments, {}, kCell);
  EXPECT_EQ(forth.vertices, back.vertices);
  EXPECT_EQ(forth.edges.size(), back.edges.size());
}

// Triangles that run along the cell's western border within a few grid steps.
std::vector<OwnedSegment> triangles_by_the_border(std::uint64_t seed) {
  std::vector<OwnedSegment> segments = random_triangles(seed, 12, 0, 1);
  for (OwnedSegment& s : segments)
    for (GridPoint* p : {&s.a, &s.b}) p->x = p->x % 9 - 3, p->y = 60000 + p->y % 40;
  return segments;
}

std::vector<OwnedSegment> segments_of(const Arrangement& r) {
  std::vector<OwnedSegment> segments;
  for (const ArrangedEdge& e : r.edges)
    for (const WindingStep& step : std::span(r.steps).subspan(e.first, e.count))
      segments.push_back({r.vertices[e.a], r.vertices[e.b], step.owner, step.winding});
  return segments;
}

// The edges on the line x = 0 with what they enter and leave.
using Along = std::vector<std::tuple<GridPoint, GridPoint, std::uint32_t, std::int32_t>>;

Along along_border(const Arrangement& r) {
  Along along;
  for (const ArrangedEdge& e : r.edges) {
    const GridPoint a = r.vertices[e.a], b = r.vertices[e.b];
    if (a.x != 0 || b.x != 0) continue;
    along.emplace_back(a, b, 0, 0);
    for (const WindingStep& step : std::span(r.steps).subspan(e.first, e.count))
      along.emplace_back(a, b, step.owner, step.winding);
  }
  return along;
}

TEST(ArrangementInside, LeavesWhatLiesAlongTheCellsBorder) {
  std::size_t most = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Arrangement once = arrange(triangles_by_the_border(seed), {}, kCell);
    const std::optional<Arrangement> twice = arrange_inside(segments_of(once), on_line_x(once, 0), kCell);
    ASSERT_TRUE(twice) << "seed " << seed;
    EXPECT_EQ(along_border(*twice), along_border(once)) << "seed " << seed;
    EXPECT_EQ(conflicts(*twice), 0) << "seed " << seed;
    most = std::max(most, along_border(once).size());
  }
  EXPECT_GT(most, 20u);
}

// Two borders that leave the cell's a step apart, as one of them was rounded: it passes within half a step of the
// other's end.
TEST(ArrangementInside, BendsNoSegmentThroughAVertexOfTheBorderWhereItDoesNotEnd) {
  const std::vector<OwnedSegment> segments = {{{0, 100}, {22, 124}, 0, 1}, {{0, 101}, {22, 124}, 1, 1}};
  ASSERT_TRUE(passes(segments[0], {0, 101}));
  const std::optional<Arrangement> arranged = arrange_inside(segments, {}, kCell);
  ASSERT_TRUE(arranged);
  EXPECT_EQ(arranged->edges.size(), 6u + 2u);  // the cell's border in six pieces
  const auto along = along_border(*arranged);
  EXPECT_TRUE(std::ranges::all_of(along, [](const auto& edge) { return std::get<3>(edge) == 0; }));
}

TEST(ArrangementInside, BendsSegmentsThroughVerticesInTheCell) {
  const std::vector<OwnedSegment> segments = {{{0, 100}, {20, 101}, 0, 1}, {{9, 100}, {9, 90}, 1, 1}};
  const std::optional<Arrangement> arranged = arrange_inside(segments, {}, kCell);
  ASSERT_TRUE(arranged);
  EXPECT_EQ(arranged->edges.size(), 5u + 2u + 1u);
}

TEST(ArrangementExactly, LeavesSegmentsThatMeetAtVerticesWhereTheyAre) {
  // the second passes a fifth of a step beside an end of the first, the third ends on the fourth
  const std::vector<OwnedSegment> segments = {{{100, 100}, {104, 102}, 0, 1},
                                              {{100, 101}, {110, 104}, 1, 1},
                                              {{90, 90}, {94, 94}, 2, 1},
                                              {{94, 90}, {94, 98}, 3, 1}};
  ASSERT_TRUE(passes(segments[1], {104, 102}));
  const std::optional<Arrangement> arranged = arrange_exactly(segments, {}, kCell);
  ASSERT_TRUE(arranged);
  EXPECT_EQ(arranged->edges.size(), 4u + 5u);
  EXPECT_EQ(conflicts(*arranged), 0);
}

TEST(ArrangementExactly, IsEmptyHandedWhereSegmentsCross) {
  EXPECT_FALSE(
      arrange_exactly(std::vector<OwnedSegment>{{{10, 10}, {20, 20}, 0, 1}, {{10, 20}, {20, 10}, 1, 1}}, {}, kCell));
}

TEST(ArrangementInside, IsEmptyHandedWhereSegmentsCrossAtTheBorder) {
  EXPECT_FALSE(
      arrange_inside(std::vector<OwnedSegment>{{{0, 100}, {1, 110}, 0, 1}, {{0, 101}, {1, 102}, 1, 1}}, {}, kCell));
  EXPECT_TRUE(
      arrange_inside(std::vector<OwnedSegment>{{{0, 100}, {1, 103}, 0, 1}, {{0, 101}, {1, 102}, 1, 1}}, {}, kCell));
}

}  // namespace
}  // namespace citykiln
