#include "grammars/roofs/outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/random_sequence.h"
#include "tests/grammars/roofs/footprints.h"

namespace citykiln::roofs {
namespace {

std::size_t corners_of_polygon(const Polygon& polygon) {
  std::size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
}

TEST(OffsetEaves, HaveTheCornersOfTheirWalls) {
  int tested = 0;
  for (const char* name : {"rectangle", "L", "T", "U", "cross", "courtyard", "two courtyards", "circle", "sliver"})
    for (const NamedFootprint& footprint : made_footprints())
      if (footprint.name == name) {
        EXPECT_EQ(corners_of_polygon(offset_eaves(footprint.polygon, 0.5)), corners_of_polygon(footprint.polygon))
            << name;
        ++tested;
      }
  EXPECT_EQ(tested, 9);
}

TEST(OffsetEaves, CutOffWhatIsSharp) {
  // the tip of 28 degrees gets two corners, the others one
  EXPECT_EQ(offset_eaves({{{0, 0}, {16, -4}, {16, 4}}, {}}, 0.5).outer.size(), 4u);
}

TEST(OffsetEaves, CloseWhereWallsFaceEachOtherNearer) {
  // a yard with an entry 0.75 m wide
  const Ring ring = {{0, 0}, {12, 0}, {12, 12}, {6.75, 12}, {6.75, 9}, {9, 9},
                     {9, 3}, {3, 3},  {3, 9},   {6, 9},     {6, 12},   {0, 12}};
  const Polygon eaves = offset_eaves({ring, {}}, 0.5);
  ASSERT_EQ(eaves.holes.size(), 1u);
  EXPECT_NEAR(area_m2(eaves), 13.0 * 13.0 - 5.0 * 5.0, 1e-9);
}

// The distance from the walls with their corners, and from the walls that p is in front of.
struct Distances {
  double any_m = 1e9, before_m = 1e9;
};

Distances distances_from(Vec2 p, const Ring& ring) {
  Distances least;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 wall = ring[i] - ring[j];
    const double along = dot(p - ring[j], wall) / dot(wall, wall);
    const double far_m = distance(p, ring[j] + wall * std::clamp(along, 0.0, 1.0));
    least.any_m = std::min(least.any_m, far_m);
    if (along >= 0 && along <= 1 && cross(wall, p - ring[j]) <= 0) least.before_m = std::min(least.before_m, far_m);
  }
  return least;
}

// A star with random radii.
Ring random_star(const RandomSequence& draw, std::uint32_t corners) {
  Ring ring;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const Vec2 ray = direction_of((i + draw.between(0, 0.9, 2 * i)) / corners);
    ring.push_back(snapped_to(0x1p-7, ray * draw.between(3, 15, 2 * i + 1)));
  }
  return ring;
}

TEST(OffsetEaves, CoverAllThatIsNearBeforeWallsAndNothingFarFromThem) {
  int with_eaves = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const RandomSequence draw(seed, {}, "eaves");
    const Polygon footprint{random_star(draw, 3 + draw.below(9, 100)), {}};
    const double overhang_m = draw.between(0.1, 1.5, 101), rounding_m = 0.002;
    const Polygon eaves = offset_eaves(footprint, overhang_m);
    if (eaves.outer.empty()) continue;
    ++with_eaves;
    ASSERT_TRUE(is_simple_polygon(eaves)) << seed;
    for (std::uint32_t i = 0; i < 500; ++i) {
      const Vec2 p{draw.between(-17, 17, 200 + 2 * i), draw.between(-17, 17, 201 + 2 * i)};
      const Distances walls = distances_from(p, footprint.outer);
      const bool is_near = contains(footprint, p) || walls.before_m < overhang_m - rounding_m;
      const bool is_far = !contains(footprint, p) && walls.any_m > 2 * overhang_m + rounding_m;
      if (!is_near && !is_far) continue;
      ASSERT_EQ(contains(eaves, p), is_near) << seed << ": " << p.x << " " << p.y;
    }
  }
  EXPECT_GT(with_eaves, 900);
}

}  // namespace
}  // namespace citykiln::roofs
