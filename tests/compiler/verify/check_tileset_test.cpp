#include "compiler/verify/check_tileset.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "compiler/map/plane/globe.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::verify {
namespace {

using exporters::OrientedBox;
using exporters::TilesetFile;
using exporters::TilesetTile;
using nlohmann::json;

OrientedBox cube(Vec3 low, double side_m) {
  OrientedBox box;
  box.grow(low);
  box.grow(low + Vec3{side_m, side_m, side_m});
  return box;
}

/// A tile with four children at each of some depths below.
TilesetTile made_tree(int depth, Vec3 low, double side_m, const std::string& name = "t") {
  TilesetTile tile{.box = cube(low, side_m), .error_m = 0.5 + depth, .content = name + ".glb", .tolerance_m = 1};
  for (int i = 0; depth > 0 && i < 4; ++i)
    tile.children.push_back(made_tree(depth - 1, low + Vec3{i % 2 * side_m / 2, i / 2 * side_m / 2, 0}, side_m / 2,
                                      name + std::to_string(i)));
  return tile;
}

std::vector<TilesetFile> made_files(int depth) {
  return exporters::encode_tileset(made_tree(depth, {-512, 512, 300}, 1024),
                                   {.to_earth = map::Globe({1.52, 42.5}).to_earth(),
                                    .origin = {1.52, 42.5},
                                    .attributions = {"© OpenStreetMap contributors", "a survey"}});
}

std::size_t failures(const CheckResults& results) {
  return results.tileset.failures.size() + results.tileset_boxes.failures.size() +
         results.tileset_errors.failures.size();
}

TEST(CheckTilesetFile, FindsNoFaultInWhatIsWritten) {
  for (const int depth : {0, 1, 3}) {
    CheckResults results;
    const auto files = made_files(depth);
    ASSERT_EQ(files.size(), 1u);
    const CheckedTileset read = check_tileset_file(files[0].json, files[0].name, results);
    EXPECT_EQ(failures(results), 0u);
    EXPECT_EQ(read.contents.size(), depth == 0 ? 1u : depth == 1 ? 5u : 85u);
    EXPECT_EQ(read.transform.size(), 16u);
    EXPECT_EQ(read.attribution, "© OpenStreetMap contributors; a survey");
  }
}

TEST(CheckTilesetFile, LargeTreesAreInSeveralFilesThatNameEachTileOnce) {
  const auto files = made_files(6);  // 5,461 tiles
  EXPECT_EQ(files.back().name, "3dtiles/tileset.json");
  std::set<std::string> contents, external, names;
  CheckResults results;
  for (const TilesetFile& file : files) {
    const CheckedTileset read = check_tileset_file(file.json, file.name, results);
    EXPECT_LE(read.contents.size() + read.external.size(), exporters::kMostTilesInFile);
    EXPECT_EQ(read.transform.empty(), file.name != "3dtiles/tileset.json");
    for (const ContentReference& content : read.contents) EXPECT_TRUE(contents.insert(content.uri).second);
    for (const ContentReference& other : read.external) EXPECT_TRUE(external.insert("3dtiles/" + other.uri).second);
    names.insert(file.name);
  }
  EXPECT_EQ(failures(results), 0u);
  EXPECT_EQ(contents.size(), 5461u);
  names.erase("3dtiles/tileset.json");
  EXPECT_EQ(external, names);
}

TEST(CheckTilesetFile, FindsWhatIsBroken) {
  const std::string good = made_files(2)[0].json;
  const auto found = [&](auto make_wrong) {
    json tileset = json::parse(good);
    make_wrong(tileset);
    CheckResults results;
    (void)check_tileset_file(tileset.dump(), "x", results);
    return failures(results);
  };
  EXPECT_EQ(found([](json&) {}), 0u);
  EXPECT_GT(found([](json& t) { t["asset"]["version"] = "1.0"; }), 0u);
  EXPECT_GT(found([](json& t) { t["asset"].erase("extras"); }), 0u);
  EXPECT_GT(found([](json& t) { t["root"].erase("refine"); }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["children"][0].erase("boundingVolume"); }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["children"][0]["boundingVolume"]["box"].push_back(1); }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["children"][2]["boundingVolume"]["box"][0] = 5000; }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["children"][3]["geometricError"] = t["root"]["geometricError"]; }), 0u);
  EXPECT_GT(found([](json& t) { t["geometricError"] = 0; }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["content"]["uri"] = "../other.glb"; }), 0u);
  EXPECT_GT(found([](json& t) { t["root"]["content"] = 7; }), 0u);
  CheckResults results;
  (void)check_tileset_file(good.substr(0, good.size() / 2), "x", results);
  EXPECT_EQ(failures(results), 1u);
}

}  // namespace
}  // namespace citykiln::verify
