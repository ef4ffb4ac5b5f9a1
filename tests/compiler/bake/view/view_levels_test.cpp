#include "compiler/bake/view/view_levels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/map/locate.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {
namespace {

constexpr double kHillyTile_m = 512;

map::Heightfield random_hills() {
  map::Heightfield field{{-64, -64}, {16, 16}, 73, 73, {}, 0};
  const RandomSequence draw(1, StableId{2}, "hills");
  for (std::uint32_t i = 0; i < 73 * 73; ++i)
    field.heights.push_back(static_cast<std::int32_t>(draw.unit(i) * 40 / map::kHeightQuantum_m));
  return field;
}

// Two by two tiles of four by four cells.
scene::Scene scene_of_four_tiles() {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {2 * kHillyTile_m, 2 * kHillyTile_m}};
  scene.header.tile_m = kHillyTile_m;
  for (const scene::TileKey tile : scene::tiles_of(scene.header)) {
    scene.chunks.emplace_back().tile = tile;
    scene.chunks.back().heights = random_hills();
  }
  return scene;
}

View made_view(double pixel_error) {
  View view{{200, 200, 60}, 900};
  view.pixel_error = pixel_error;
  return view;
}

Bounds somewhere(const RandomSequence& draw, std::uint32_t i) {
  const Vec2 at{draw.between(-3000, 3000, 4 * i), draw.between(-3000, 3000, 4 * i + 1)};
  const double low_m = draw.between(-100, 400, 4 * i + 2);
  return {Box2{at, at}.widened(draw.between(0, 200, 4 * i + 3)), low_m, low_m + 20};
}

std::vector<ViewCell> all_cells(const scene::Scene& scene, const ViewLevels& levels) {
  std::vector<ViewCell> all;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const ViewCell& cell : cells_of(levels, scene::box_of(scene.header, chunk.tile))) all.push_back(cell);
  return all;
}

TEST(ViewLevels, AnErrorIsNoLongerThanThePixelsAskedFor) {
  const RandomSequence draw(3, StableId{4}, "bounds");
  const View view = made_view(0.75);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Bounds bounds = somewhere(draw, i);
    const double tolerance_m = tolerance_m_of(view, level_for(view, bounds));
    EXPECT_GE(tolerance_m, view.finest_m);
    const double pixels = tolerance_m / distance_m(bounds, view.eye) * view.focal_px;
    EXPECT_TRUE(pixels <= view.pixel_error || tolerance_m == view.finest_m);
    EXPECT_GT(2 * pixels, view.pixel_error) << "finer than it needs to be";
    EXPECT_LE(pixels_of(view, tolerance_m, bounds), view.pixel_error);
  }
}

TEST(ViewLevels, EachObjectIsInOnePart) {
  const scene::Scene scene = scene_of_four_tiles();
  const ViewLevels levels = levels_for(scene, made_view(1));
  const std::vector<int> of_tile = levels_of_parts(levels, scene.header, scene.chunks[0]);
  const RandomSequence draw(5, StableId{6}, "bounds");
  for (std::uint32_t i = 0; i < 500; ++i) {
    int parts = 0;
    for (const int level : of_tile)
      if (is_in_part({levels, of_tile, level}, somewhere(draw, i))) ++parts;
    EXPECT_EQ(parts, 1);
  }
}

// A flat tile of four by four cells at height 0, seen from 140 m above one of its places.
struct TileFromAbove {
  scene::Scene scene{};
  View view{{200, 200, 140}, 900};

  TileFromAbove() {
    scene.header.extent = {{0, 0}, {kHillyTile_m, kHillyTile_m}}, scene.header.tile_m = kHillyTile_m;
    scene.chunks.emplace_back().heights = {{-64, -64}, {16, 16}, 41, 41, std::vector<std::int32_t>(41 * 41), 0};
  }
  scene::Chunk& chunk() { return scene.chunks[0]; }
  // the finest of the levels in which the tile is baked
  int finest_part() const {
    const ViewLevels levels = levels_for(scene, view);
    return levels_of_parts(levels, scene.header, scene.chunks[0]).front();
  }
};

TEST(ViewLevels, APartIsFineEnoughForATallThing) {
  TileFromAbove tile;
  EXPECT_GT(tile.finest_part(), 0);
  tile.chunk().things = {{.at = {200, 200}, .form = {.kind = "wind_turbine", .height_m = 140}}};
  EXPECT_EQ(tile.finest_part(), 0);
}

TEST(ViewLevels, APartIsFineEnoughForATallLamp) {
  TileFromAbove tile;
  tile.chunk().lamps = {{.at = {200, 200}, .height_m = 140}};
  EXPECT_EQ(tile.finest_part(), 0);
}

TEST(ViewLevels, APartIsFineEnoughForWires) {
  TileFromAbove tile;
  tile.chunk().wire_spans = {{.wires = {{.from = {200, 100, 140}, .to = {200, 300, 140}, .sag_m = 2, .radius_mm = 9}}}};
  EXPECT_EQ(tile.finest_part(), 0);
}

TEST(ViewLevels, BothCellsOfASideHaveOneToleranceThere) {
  for (const double pixel_error : {0.25, 1.0, 8.0}) {
    const scene::Scene scene = scene_of_four_tiles();
    const std::vector<ViewCell> cells = all_cells(scene, levels_for(scene, made_view(pixel_error)));
    int sides = 0;
    for (const ViewCell& a : cells)
      for (const ViewCell& b : cells) {
        const CellLevel &own = a.level, &other = b.level;
        if (own.cell.max.x != other.cell.min.x || own.cell.min.y != other.cell.min.y) continue;
        ++sides;
        EXPECT_EQ(own.sides_m.east_m, other.sides_m.west_m);
        EXPECT_EQ(own.sides_m.east_m, std::min(own.tolerance_m, other.tolerance_m));
        const bool are_alike =
            has_detail(Detail::kRoadSurfaces, own.tolerance_m) == has_detail(Detail::kRoadSurfaces, other.tolerance_m);
        EXPECT_EQ(a.skirt.max.x != own.cell.max.x, are_alike) << "a skirt hangs where roads look different, only there";
        EXPECT_EQ(b.skirt.min.x != other.cell.min.x, are_alike);
      }
    EXPECT_EQ(sides, 8 * 7);
  }
}

TEST(ViewLevels, ZonesHoldEveryCellOnce) {
  const scene::Scene scene = scene_of_four_tiles();
  const ViewLevels levels = levels_for(scene, made_view(1));
  ASSERT_FALSE(scene.chunks.empty());
  for (const scene::Chunk& chunk : scene.chunks) {
    const Box2 tile = scene::box_of(scene.header, chunk.tile);
    double area_m2 = 0;
    for (const ViewZone& zone : zones_of(levels, tile)) area_m2 += map::kCell_m * map::kCell_m * zone.cells.size();
    EXPECT_EQ(area_m2, tile.width() * tile.height());
  }
}

}  // namespace
}  // namespace citykiln::bake
