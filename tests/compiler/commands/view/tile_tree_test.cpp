#include "compiler/commands/view/tile_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "compiler/commands/view/read_tileset_tree.h"
#include "tests/scratch_folder.h"

namespace citykiln::commands {
namespace {

exporters::OrientedBox box_about(Vec3 middle, double half_m) {
  exporters::OrientedBox box;
  box.grow(middle - Vec3{half_m, half_m, half_m}), box.grow(middle + Vec3{half_m, half_m, half_m});
  return box;
}

// Two tiles side by side, each with levels of 8, 2 and 0.5 m.
TileNode two_tiles() {
  TileNode root{.error_m = INFINITY};
  for (const double x : {0.0, 1000.0}) {
    TileNode chain;
    for (const double error_m : {0.5, 2.0, 8.0}) {
      TileNode node{.box = box_about({x, 0, 0}, 100), .error_m = error_m};
      node.path = (x > 0 ? "b" : "a") + std::to_string(static_cast<int>(error_m));
      if (!chain.path.empty()) node.children.push_back(std::move(chain));
      chain = std::move(node);
    }
    root.box.grow(chain.box);
    root.children.push_back(std::move(chain));
  }
  return root;
}

std::vector<std::string> seen_from(const std::vector<Vec3>& eyes) {
  const Viewers viewers{.eyes = eyes, .focal_px = 900, .pixel_error = 2};
  return contents_of(two_tiles(), [&](const TileNode& node) { return is_fine_for(viewers, node); });
}

TEST(TileTree, ATileHasTheCoarsestLevelWhoseErrorIsShortEnough) {
  using Paths = std::vector<std::string>;
  EXPECT_EQ(seen_from({{0, 0, 0}}), (Paths{"a0", "b2"}));
  // 900 m from the second box an error of 2 m is two pixels
  EXPECT_EQ(seen_from({{0, 0, 200}}), (Paths{"a0", "b2"}));
  EXPECT_EQ(seen_from({{500, 0, 4000}}), (Paths{"a8", "b8"}));
  // the nearest eye counts
  EXPECT_EQ(seen_from({{500, 0, 4000}, {1000, 0, 50}}), (Paths{"a2", "b0"}));
}

TEST(TileTree, DistancesAreThoseToTheBox) {
  EXPECT_EQ(distance_m(box_about({0, 0, 0}, 10), {3, 0, -9}), 0);
  EXPECT_EQ(distance_m(box_about({0, 0, 0}, 10), {13, 14, 0}), 5);
  EXPECT_EQ(finest_contents_at(two_tiles(), {1050, 20}), std::vector<std::string>{"b0"});
  EXPECT_TRUE(finest_contents_at(two_tiles(), {500, 0}).empty());
}

// A tileset of one tile, or what a test makes of it.
std::string tileset(const std::string& root) { return R"({"asset": {"version": "1.1"}, "root": )" + root + "}"; }
const std::string kBox =
    R"("boundingVolume": {"box": [0,0,0, 9,0,0, 0,9,0, 0,0,9]}, "refine": "REPLACE", "extras": {"tolerance_m": 1, "plant_error_m": 0}, )";

Result<TileNode> tree_of_tileset(const std::string& json) {
  const ScratchFolder folder;
  std::ofstream(folder.at("tileset.json")) << json;
  return read_tileset_tree(folder.path());
}

TEST(TilesetTree, ReadsTilesOfItsOwnFolderAlone) {
  const auto good =
      tree_of_tileset(tileset("{" + kBox + R"("geometricError": 4, "content": {"uri": "a.glb"}, "children": [{)" +
                              kBox + R"("geometricError": 1, "content": {"uri": "b.glb"}}]})"));
  ASSERT_TRUE(good);
  EXPECT_EQ(good->error_m, 4);
  ASSERT_EQ(good->children.size(), 1u);
  EXPECT_TRUE(good->children[0].path.ends_with("/b.glb"));
  EXPECT_EQ(distance_m(good->box, {0, 0, 12}), 3);
  for (const char* wrong :
       {R"("geometricError": 4, "content": {"uri": "../a.glb"})",
        R"("geometricError": 4, "content": {"uri": "/a.glb"})", R"("geometricError": -1)", R"("geometricError": "x")",
        R"("geometricError": 4, "refine": "ADD")", R"("geometricError": 4, "content": {"uri": "tileset.json"})",
        R"("geometricError": 4, "children": 3)"}) {
    const auto bad = tree_of_tileset(tileset("{" + kBox + wrong + "}"));
    ASSERT_FALSE(bad) << wrong;
    EXPECT_EQ(to_string(bad.error()).find('\n'), std::string::npos);
  }
  EXPECT_FALSE(tree_of_tileset("{"));
  EXPECT_FALSE(read_tileset_tree("/nowhere"));
}

}  // namespace
}  // namespace citykiln::commands
