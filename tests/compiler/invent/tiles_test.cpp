#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "compiler/invent/tiles/arrange_tiles.h"
#include "compiler/invent/tiles/connect_roads.h"
#include "compiler/invent/tiles/join_covers.h"
#include "compiler/invent/tiles/join_lines.h"
#include "compiler/invent/tiles/tile_city.h"
#include "compiler/invent/tiles/tile_set.h"

namespace citykiln::invent {
namespace {

TileSet shipped() {
  Result<TileSet> set = read_tile_set(shipped_tile_set(), "city.tiles");
  EXPECT_TRUE(set) << to_string(set.error());
  return *set;
}

std::string error_of(std::string_view text) {
  const Result<TileSet> set = read_tile_set(text, "a.tiles");
  return set ? "" : to_string(set.error());
}

int unequal_sides(const TileSet& set, const TileGrid& grid) {
  int unequal = 0;
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x) {
      const TurnedTile& here = set.turned[grid.at(x, y)];
      if (x + 1 < grid.columns) unequal += here.sides[kEast] != set.turned[grid.at(x + 1, y)].sides[kWest] ? 1 : 0;
      if (y + 1 < grid.rows) unequal += here.sides[kNorth] != set.turned[grid.at(x, y + 1)].sides[kSouth] ? 1 : 0;
    }
  return unequal;
}

TEST(TileSet, ATurnBringsTheNorthernSideToTheWest) {
  const Result<TileSet> set = read_tile_set("tile a\n turns 4\n sides n w s e\n", "a.tiles");
  ASSERT_TRUE(set);
  ASSERT_EQ(set->turned.size(), 4U);
  EXPECT_EQ(set->labels[set->turned[1].sides[kWest]], "n");
  EXPECT_EQ(set->labels[set->turned[1].sides[kNorth]], "e");
}

TEST(TileSet, BadTextsGiveOneLine) {
  EXPECT_EQ(error_of(""), "a.tiles: expected at least one tile, such as: tile grass");
  EXPECT_EQ(error_of("tile a\ntile b\n"), "a.tiles:2: tile \"a\" has no line \"sides\"");
  EXPECT_EQ(error_of("weight 3"), "a.tiles:1: expected \"tile NAME\" before \"weight\"");
  EXPECT_EQ(error_of("tile a\nsids . . . ."), "a.tiles:2: unknown word \"sids\"; did you mean sides?");
  EXPECT_EQ(error_of("tile a\nsides . . ."),
            "a.tiles:2: expected the labels of four sides after \"sides\": north, west, south, east");
  EXPECT_EQ(error_of("cell 4"), "a.tiles:1: expected cell M, with 8 to 256 metres, found \"4\"");
  EXPECT_EQ(error_of("tile a\nweight -1"), "a.tiles:2: expected a number above 0 and up to 1000000 after \"weight\"");
  EXPECT_EQ(error_of("tile a\nturns 3"), "a.tiles:2: expected 1, 2 or 4 after \"turns\"");
  EXPECT_EQ(error_of("tile a\nnoise 1 0"), "a.tiles:2: expected two rising numbers after \"noise\", such as -0.2 1");
  EXPECT_EQ(error_of("tile a\narea building=yes 0,0 1,0"),
            "a.tiles:2: expected 3 to 64 places x,y after the tags, found 2");
  EXPECT_EQ(error_of("tile a\npoint natural 0,0"),
            "a.tiles:2: expected key=value or key=value|value, found \"natural\"");
  EXPECT_EQ(error_of("tile a\npoint natural=tree 0,2"), "a.tiles:2: expected x,y from 0 to 1, found \"0,2\"");
  EXPECT_EQ(error_of("tile a\npoint a=b,a=c 0,0"), "a.tiles:2: the key \"a\" stands twice");
  EXPECT_EQ(error_of("tile a\nsides . . . .\ntile a"), "a.tiles:3: there are two tiles \"a\"");
}

TEST(ArrangeTiles, NeighboursHaveEqualSides) {
  const TileSet set = shipped();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Result<TileGrid> grid = arrange_tiles(set, {.columns = 40, .rows = 30, .seed = seed});
    ASSERT_TRUE(grid) << to_string(grid.error());
    EXPECT_EQ(grid->tiles.size(), 1200U);
    EXPECT_GT(grid->fixed, 0U);
    EXPECT_EQ(unequal_sides(set, *grid), 0) << "seed " << seed;
  }
}

// A street that enters a cell may only go straight on or bend to the left, and districts of a and b touch only there.
constexpr const char* kHard =
    "tile a\n sides a a a a\ntile b\n sides b b b b\n"
    "tile ab\n turns 4\n sides s a s b\n"
    "tile bend\n turns 4\n sides s s b a\n";

TEST(ArrangeTiles, ContradictionsAreSolvedByBacktracking) {
  const Result<TileSet> set = read_tile_set(kHard, "hard.tiles");
  ASSERT_TRUE(set);
  std::size_t contradictions = 0, arranged = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Result<TileGrid> grid = arrange_tiles(*set, {.columns = 12, .rows = 12, .seed = seed, .fixed_share = 0.05});
    if (!grid) continue;
    ++arranged;
    contradictions += grid->contradictions;
    EXPECT_GE(grid->backtracks, grid->contradictions);
    EXPECT_EQ(unequal_sides(*set, *grid), 0) << "seed " << seed;
  }
  EXPECT_EQ(arranged, 20U);
  EXPECT_GT(contradictions, 0U) << "the set is too easy for this test";
}

TEST(ArrangeTiles, ASetWithoutArrangementIsAnError) {
  const Result<TileSet> set = read_tile_set("tile a\n sides n w s e\n", "a.tiles");
  ASSERT_TRUE(set);
  const Result<TileGrid> grid = arrange_tiles(*set, {.columns = 3, .rows = 3});
  ASSERT_FALSE(grid);
  EXPECT_EQ(grid.error().message.find("no arrangement of 3 x 3 tiles was found"), 0U);
}

TEST(ArrangeTiles, AFunctionOfTheSeed) {
  const TileSet set = shipped();
  const TileGridRequest request{.columns = 25, .rows = 25, .seed = 8};
  EXPECT_EQ(arrange_tiles(set, request)->tiles, arrange_tiles(set, request)->tiles);
  EXPECT_NE(arrange_tiles(set, request)->tiles, arrange_tiles(set, {.columns = 25, .rows = 25, .seed = 9})->tiles);
}

TEST(ConnectRoads, AllRoadsAreOneNetworkAndSidesStayEqual) {
  const TileSet set = shipped();
  std::size_t before = 0, joined = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Result<TileGrid> grid = arrange_tiles(set, {.columns = 30, .rows = 30, .seed = seed});
    ASSERT_TRUE(grid);
    const RoadParts parts = connect_roads(set, seed, *grid);
    before += parts.before;
    // a part that grass encloses wholly may stay apart
    EXPECT_LE(parts.after, 2U) << "seed " << seed;
    joined += parts.after == 1;
    EXPECT_EQ(unequal_sides(set, *grid), 0) << "seed " << seed;
    EXPECT_EQ(connect_roads(set, seed, *grid).before, parts.after) << "counted again, seed " << seed;
  }
  EXPECT_GT(before, 20U) << "there was nothing to connect";
  EXPECT_GE(joined, 16U);
}

TEST(JoinCovers, AreasAddUpAndTouchAtCornersOnly) {
  //   1 1 1 0
  //   1 2 1 1
  //   1 1 1 2
  const std::vector<std::uint32_t> labels = {1, 1, 1, 2, 1, 2, 1, 1, 1, 1, 1, 0};
  const auto covers = join_covers(labels, 4, 3);
  ASSERT_EQ(covers[1].size(), 1U);
  EXPECT_EQ(covers[1][0].holes.size(), 1U);
  EXPECT_EQ(area_m2(covers[1][0]), 9);
  ASSERT_EQ(covers[2].size(), 2U);
  EXPECT_EQ(area_m2(covers[2][0]) + area_m2(covers[2][1]), 2);
  for (const Polygon& polygon : covers[2]) EXPECT_EQ(polygon.outer.size(), 4U);
}

TEST(JoinCovers, CellsThatTouchAtACornerAreApart) {
  const auto covers = join_covers({1, 0, 0, 1}, 2, 2);
  EXPECT_EQ(covers[1].size(), 2U);
}

TEST(JoinLines, StraightOnIsJoinedAndJunctionsStay) {
  const Tags street = {{"highway", "residential"}}, path = {{"highway", "footway"}};
  const std::vector<InventedLine> lines = {{{{0, 0}, {10, 0}}, street},
                                           {{{10, 0}, {20, 0}}, street},
                                           {{{20, 0}, {30, 0}}, street},
                                           {{{20, 0}, {20, 9}}, street},
                                           {{{10, 0}, {10, 5}}, path}};
  const std::vector<InventedLine> joined = join_lines(lines, {});
  ASSERT_EQ(joined.size(), 3U);
  // 10,0 stays, as the path ends there, and 20,0 as the other street does
  EXPECT_EQ(joined[0].axis, (Polyline{{0, 0}, {10, 0}, {20, 0}, {30, 0}}));
  EXPECT_EQ(joined[1].axis, (Polyline{{20, 0}, {20, 9}}));
}

TEST(TileCity, StreetsOfNeighboursShareAPoint) {
  const TileSet set = shipped();
  const Result<TileGrid> grid = arrange_tiles(set, {.columns = 20, .rows = 20, .seed = 3});
  ASSERT_TRUE(grid);
  InventedMap map;
  add_tile_city(set, *grid, 3, map);
  std::map<Vec2, int> uses;
  for (const InventedLine& line : map.lines)
    for (const Vec2 p : line.axis) ++uses[p];
  // an end of a street lies on another line, on the border, or is a dead end of the set: a turning circle
  int loose = 0, ends = 0;
  for (const InventedLine& line : map.lines)
    for (const Vec2 p : {line.axis.front(), line.axis.back()}) {
      if (line.tags.front().second == "hedge" || line.tags.front().second == "fence") continue;
      ++ends;
      const bool is_on_border = std::max(std::abs(p.x), std::abs(p.y)) > 20 * set.cell_m / 2 - 1e-6;
      const bool is_in_cell =
          std::abs(std::remainder(p.x, set.cell_m)) > 0.1 && std::abs(std::remainder(p.y, set.cell_m)) > 0.1;
      loose += uses[p] < 2 && !is_on_border && !is_in_cell ? 1 : 0;
    }
  EXPECT_GT(ends, 20);
  EXPECT_EQ(loose, 0);
}

}  // namespace
}  // namespace citykiln::invent
