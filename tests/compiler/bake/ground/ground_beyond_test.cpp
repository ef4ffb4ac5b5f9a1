#include "compiler/bake/ground/ground_beyond.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace citykiln::bake {
namespace {

scene::Header header_of_region(Box2 extent) {
  scene::Header header;
  header.extent = extent, header.tile_m = 1024;
  return header;
}

buildings::Building building(Box2 box) {
  buildings::Building building;
  building.footprint.outer = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  building.stands_on_ground = true;
  return building;
}

// Footprints about the place (0, -512), where the border of the extent meets the line between two tiles.
std::vector<Box2> footprints(std::mt19937& dice) {
  std::uniform_real_distribution<double> offset(-40, 40), side(0.5, 25);
  std::vector<Box2> all;
  for (unsigned i = dice() % 12; i > 0; --i) {
    const Vec2 min{offset(dice), -512 + offset(dice)};
    all.push_back({min, min + Vec2{side(dice), side(dice)}});
  }
  return all;
}

scene::Chunk chunk_of(scene::TileKey tile, const std::vector<Box2>& footprints) {
  scene::Chunk chunk;
  chunk.tile = tile;
  for (const Box2& box : footprints) chunk.buildings.push_back(building(box));
  return chunk;
}

double box_area_m2(const Box2& box) { return box.width() * box.height(); }

// The sides of boxes on the line x = 0, from south to north.
std::vector<std::pair<double, double>> sides_on_line(const std::vector<Box2>& boxes) {
  std::vector<std::pair<double, double>> sides;
  for (const Box2& box : boxes)
    if (box.min.x == 0 || box.max.x == 0) sides.emplace_back(box.min.y, box.max.y);
  std::ranges::sort(sides);
  return sides;
}

Box2 with_swapped_axes(const Box2& box) { return {{box.min.y, box.min.x}, {box.max.y, box.max.x}}; }

std::vector<Box2> with_swapped_axes(std::vector<Box2> boxes) {
  for (Box2& box : boxes) box = with_swapped_axes(box);
  return boxes;
}

TEST(GroundBeyond, OfTwoTilesMeetsOnTheLineBetweenThem) {
  std::mt19937 dice(5);
  const Box2 extent{{-1024, -512}, {1024, 1024}};
  std::size_t met = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<Box2> all = footprints(dice);
    const auto west = sides_on_line(ground_beyond(header_of_region(extent), chunk_of({-1, -1}, all))),
               east = sides_on_line(ground_beyond(header_of_region(extent), chunk_of({0, -1}, all)));
    EXPECT_EQ(west, east);
    met += west.size();
    // the same with x and y exchanged
    const scene::Header sideways = header_of_region(with_swapped_axes(extent));
    EXPECT_EQ(sides_on_line(with_swapped_axes(ground_beyond(sideways, chunk_of({-1, -1}, with_swapped_axes(all))))),
              west);
    EXPECT_EQ(sides_on_line(with_swapped_axes(ground_beyond(sideways, chunk_of({-1, 0}, with_swapped_axes(all))))),
              west);
  }
  EXPECT_GT(met, 100u);
}

TEST(GroundBeyond, HoldsWhatStandsOutsideInBoxesThatDoNotOverlap) {
  std::mt19937 dice(6);
  const scene::Header header = header_of_region({{-1024, -512}, {1024, 1024}});
  std::size_t corners = 0;
  for (int round = 0; round < 100; ++round) {
    const std::vector<Box2> all = footprints(dice), boxes = ground_beyond(header, chunk_of({0, -1}, all));
    for (const Box2& footprint : all)
      for (const Vec2 corner : {footprint.min, Vec2{footprint.max.x, footprint.min.y}}) {
        if (corner.y >= -512 || corner.x <= 0) continue;
        EXPECT_TRUE(std::ranges::any_of(boxes, [&](const Box2& box) { return box.contains(corner); }));
        ++corners;
      }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_GT(box_area_m2(boxes[i]), 0);
      EXPECT_LE(boxes[i].max.y, -512);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(boxes[i].min.x < boxes[j].max.x && boxes[j].min.x < boxes[i].max.x &&
                     boxes[i].min.y < boxes[j].max.y && boxes[j].min.y < boxes[i].max.y);
    }
  }
  EXPECT_GT(corners, 200u);
}

TEST(GroundBeyond, IsEmptyWhereBuildingsStandInside) {
  const scene::Header header = header_of_region({{-1024, -512}, {1024, 1024}});
  EXPECT_TRUE(ground_beyond(header, chunk_of({0, -1}, {{{5, -511.5}, {20, -490}}})).empty());
}

}  // namespace
}  // namespace citykiln::bake
