// Nothing is built outside of the extent, on boxes in the middle of cities and at coasts.
#include <algorithm>
#include <map>

#include "compiler/bake/bake.h"
#include "compiler/bake/ground/ground_beyond.h"
#include "tests/compiler/real_scenes.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

struct Case {
  const char *map, *heights;
  std::optional<source::LonLatBox> bbox;
};

// Monaco's box cuts the railway's tunnel and viaducts, Boston's lies in the middle of a town; Nice is whole.
const Case kCases[] = {
    {"monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt", source::LonLatBox{7.410, 43.725, 7.425, 43.737}},
    {"boston-back-bay/back_bay.osm.pbf", nullptr, source::LonLatBox{-71.085, 42.348, -71.075, 42.354}},
    {"nice-old-town/nice.osm.pbf", "monaco/N43E007.hgt", std::nullopt},
    {"niteroi/niteroi.osm.pbf", nullptr, source::LonLatBox{-43.13, -22.90, -43.11, -22.88}}};

constexpr double kTolerance_m = 2.5;
// Balconies, eaves and chimneys stand out so far from a building's footprint.
constexpr double kBuildingMargin_m = 3;

CompileSpec spec_of(const Case& place) {
  CompileSpec spec;
  spec.map_path = real_data(place.map);
  spec.map.bbox = place.bbox;
  spec.tile_m = 512;
  if (place.heights) spec.rasters.emplace_back().path = real_data(place.heights);
  return spec;
}

// The boxes of a tile's buildings, by OSM id, with what stands out from them.
std::map<OsmId, Box2> building_boxes(const scene::Chunk& chunk) {
  std::map<OsmId, Box2> boxes;
  for (const buildings::Building& building : chunk.buildings)
    for (const Vec2 p : building.footprint.outer) boxes[building.id.osm].grow(p);
  for (auto& [id, box] : boxes) box = box.widened(kBuildingMargin_m);
  return boxes;
}

struct Count {
  std::size_t vertices = 0, instances = 0, overhanging = 0, on_border = 0;
};

bool is_on_border(const Box2& box, Vec2 p) {
  return p.x == box.min.x || p.x == box.max.x || p.y == box.min.y || p.y == box.max.y;
}

bool is_in_any(const std::vector<Box2>& boxes, Vec2 p) {
  return std::ranges::any_of(boxes, [&](const Box2& box) { return box.contains(p); });
}

void check_tile(const bake::BakedTile& tile, const scene::Header& header, const scene::Chunk& chunk, Count& count) {
  const std::map<OsmId, Box2> boxes = building_boxes(chunk);
  const std::vector<Box2> beyond = bake::ground_beyond(header, chunk);
  const Box2& extent = header.extent;
  for (const bake::Primitive& primitive : tile.primitives)
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
      const Vec2 p = in_plan(tile.origin + bake::widened(primitive.positions[i]));
      const OsmId feature = tile.features[primitive.features[i]];
      ++count.vertices, count.on_border += is_on_border(extent, p);
      if (extent.contains(p)) continue;
      ++count.overhanging;
      const auto building = boxes.find(feature);
      EXPECT_TRUE(building != boxes.end() ? building->second.contains(p) : is_in_any(beyond, p))
          << to_string(feature) << " at " << p.x << " " << p.y;
    }
  for (const bake::InstancedMesh& mesh : tile.instanced)
    for (const bake::Float3& at : mesh.translations) {
      ++count.instances;
      EXPECT_TRUE(extent.contains(in_plan(tile.origin + bake::widened(at)))) << mesh.name;
    }
}

TEST(ExtentReal, EverythingButOverhangingBuildingsLiesInIt) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  std::size_t overhanging = 0, spans = 0;
  for (const Case& place : kCases) {
    const auto compiled = compile(spec_of(place), [](auto&&...) {});
    ASSERT_TRUE(compiled) << place.map;
    const scene::Scene& scene = compiled->scene;
    Count count;
    for (const scene::Chunk& chunk : scene.chunks) {
      Report report;
      check_tile(bake::bake(scene.header, chunk, kTolerance_m, 2, report), scene.header, chunk, count);
      for (const structures::Span& span : chunk.bridges)
        spans += !std::ranges::all_of(span.axis, [&](Vec2 p) { return scene.header.extent.contains(p); });
    }
    EXPECT_GT(count.vertices, 10000u) << place.map;
    EXPECT_GT(count.on_border, 100u) << place.map;
    EXPECT_GT(compiled->report.counts()[Code::kCutAtBounds], 0u) << place.map;
    EXPECT_TRUE(compiled->report.balances()) << place.map;
    overhanging += count.overhanging;
  }
  EXPECT_GT(overhanging, 0u);
  EXPECT_GT(spans, 0u);
}

TEST(ExtentReal, ABuildingBelongsToItByTheCentroidOfItsOutline) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  const auto compiled = compile(spec_of(kCases[1]), [](auto&&...) {});
  ASSERT_TRUE(compiled);
  const Box2 extent = compiled->scene.header.extent;
  std::size_t across = 0;
  for (const scene::Chunk& chunk : compiled->scene.chunks)
    for (const buildings::Building& building : chunk.buildings) {
      const Box2 box = box_of(building.footprint.outer);
      across += !extent.contains(box.min) || !extent.contains(box.max);
      // a part may lie farther out than the centroid of its outline
      EXPECT_TRUE(extent.widened(64).touches(box)) << to_string(building.id.osm);
    }
  EXPECT_GT(across, 10u);
  EXPECT_GT(compiled->report.ledger().at("buildings/footprint").dropped.at(Code::kOutsideBounds), 10u);
}

TEST(ExtentReal, TheGroundGoesOnUnderBuildingsAcrossItsBorder) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  const auto compiled = compile(spec_of(kCases[1]), [](auto&&...) {});
  ASSERT_TRUE(compiled);
  const scene::Header& header = compiled->scene.header;
  std::vector<Box2> beyond;
  for (const scene::Chunk& chunk : compiled->scene.chunks)
    for (const Box2& box : bake::ground_beyond(header, chunk)) {
      EXPECT_FALSE(is_in_any(beyond, box.centre()));
      beyond.push_back(box);
    }
  std::size_t outside = 0;
  for (const scene::Chunk& chunk : compiled->scene.chunks)
    for (const buildings::Building& building : chunk.buildings)
      for (const Vec2 p : building.footprint.outer) {
        if (header.extent.contains(p) || !building.stands_on_ground) continue;
        ++outside;
        const bool is_near = header.extent.widened(bake::kBeyond_m).contains(p);
        EXPECT_TRUE(!is_near || is_in_any(beyond, p)) << to_string(building.id.osm);
      }
  EXPECT_GT(outside, 20u);
}

TEST(ExtentReal, TilesMadeApartEqualThoseOfTheWhole) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  CompileSpec spec = spec_of(kCases[0]);
  const auto whole = compile(spec, [](auto&&...) {});
  ASSERT_TRUE(whole);
  ASSERT_GT(whole->scene.chunks.size(), 3u);
  for (const scene::Chunk& chunk : whole->scene.chunks) {
    spec.only = {chunk.tile};
    const auto apart = compile(spec, [](auto&&...) {});
    ASSERT_TRUE(apart);
    ASSERT_EQ(apart->scene.chunks.size(), 1u);
    EXPECT_TRUE(apart->scene.chunks[0] == chunk) << to_string(chunk.tile);
  }
}

}  // namespace
}  // namespace citykiln
