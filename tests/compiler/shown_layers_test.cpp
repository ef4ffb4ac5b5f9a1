// Tests of layers, of the density of woods, and of the ground inside of a clip, on a baked town.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake_scene.h"
#include "compiler/contract/derived_id.h"
#include "compiler/pipeline.h"
#include "compiler/scene/shown_chunk.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

constexpr double kShownLevel_m = 0.5;

CompileSpec town_spec() {
  CompileSpec spec;
  spec.map_path = source_file("examples/town/town.osm");
  return spec;
}

scene::Scene shown_town() {
  Result<CompileResult> compiled = compile(town_spec(), [](auto&&...) {});
  EXPECT_TRUE(compiled);
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

bake::BakedTile baked_without(scene::Scene scene, scene::SceneLayers left_out) {
  scene.header.shown.left_out = left_out;
  return bake_tiles(scene, kShownLevel_m, 2).front();
}

using Corners = std::vector<bake::Float3>;

// The corners of all triangles of a layer, and the places of its instances.
Corners shown_of(const bake::BakedTile& tile, bake::Layer layer) {
  Corners corners;
  for (const bake::Primitive& p : tile.primitives)
    if (p.layer == layer)
      for (const auto& t : p.triangles)
        for (const std::uint32_t v : t) corners.push_back(p.positions[v]);
  for (const bake::InstancedMesh& mesh : tile.instanced)
    if (!mesh.primitives.empty() && mesh.primitives.front().layer == layer)
      corners.insert(corners.end(), mesh.translations.begin(), mesh.translations.end());
  return corners;
}

double plan_area_m2(const bake::BakedTile& tile) {
  double area = 0;
  for (const bake::Primitive& p : tile.primitives) {
    if (!bake::is_terrain(p)) continue;
    for (const auto& t : p.triangles) {
      const auto at = [&](std::size_t i) { return Vec2{p.positions[t[i]][0], p.positions[t[i]][1]}; };
      area += cross(at(1) - at(0), at(2) - at(0)) / 2;
    }
  }
  return area;
}

TEST(ShownLayers, ALayerThatIsLeftOutIsGoneAndChangesNoOther) {
  const scene::Scene scene = shown_town();
  ASSERT_FALSE(scene.chunks.empty());
  const bake::BakedTile all = baked_without(scene, scene::kNoLayers);
  for (const bake::Layer out : {bake::Layer::kBuildings, bake::Layer::kStructures, bake::Layer::kProps,
                                bake::Layer::kPlants, bake::Layer::kGround}) {
    const bake::BakedTile rest = baked_without(scene, bit_of(scene_layer_of(out)));
    EXPECT_TRUE(shown_of(rest, out).empty()) << name_of(out);
    for (int i = 0; i < static_cast<int>(bake::Layer::kCount); ++i) {
      const auto other = static_cast<bake::Layer>(i);
      // tree pits go with their trees
      if (other == out || (out == bake::Layer::kPlants && other == bake::Layer::kProps)) continue;
      // the ground below buildings has another material without them
      if (out == bake::Layer::kBuildings && other == bake::Layer::kGround) continue;
      EXPECT_EQ(shown_of(rest, other), shown_of(all, other)) << name_of(out) << " changes " << name_of(other);
    }
  }
}

TEST(ShownLayers, WhereRoadsOrWaterAreLeftOutThereIsLandAtTheSameHeights) {
  const scene::Scene scene = shown_town();
  const bake::BakedTile all = baked_without(scene, scene::kNoLayers);
  const bake::BakedTile bare =
      baked_without(scene, bit_of(scene::SceneLayer::kRoads) | bit_of(scene::SceneLayer::kWater));
  EXPECT_TRUE(shown_of(bare, bake::Layer::kRoads).empty());
  EXPECT_TRUE(shown_of(bare, bake::Layer::kWater).empty());
  EXPECT_NEAR(plan_area_m2(bare), plan_area_m2(all), 1e-3 * plan_area_m2(all));
  EXPECT_EQ(bare.error_m, all.error_m);
}

TEST(ShownLayers, YardsAreLeftOutWithWhatTheyGenerate) {
  const scene::Scene scene = shown_town();
  ASSERT_FALSE(scene.chunks.front().yards.empty());
  const bake::BakedTile all = baked_without(scene, scene::kNoLayers),
                        rest = baked_without(scene, bit_of(scene::SceneLayer::kYards));
  EXPECT_LT(shown_of(rest, bake::Layer::kPlants).size(), shown_of(all, bake::Layer::kPlants).size());
  EXPECT_EQ(shown_of(rest, bake::Layer::kBuildings), shown_of(all, bake::Layer::kBuildings));
}

std::size_t trees_at(scene::Scene scene, double density) {
  scene.header.shown.wood_density = density;
  return shown_of(bake_tiles(scene, kShownLevel_m, 2).front(), bake::Layer::kPlants).size();
}

TEST(ShownLayers, TrimmedSurfacesOfYardsAreLeftOutToo) {
  const scene::Scene scene = shown_town();
  ASSERT_FALSE(scene.chunks.empty());
  scene::Header header = scene.header;
  header.shown.left_out = bit_of(scene::SceneLayer::kYards);
  scene::Chunk chunk = scene.chunks.front();
  ASSERT_FALSE(chunk.yards.empty());
  const OsmId building = chunk.yards.front().building.osm;
  const auto is_of_yard = [&](const ground::LandCoverPolygon& surface) {
    return surface.id.osm == building && is_derived(surface.id);
  };
  const auto trimmed = std::ranges::find_if(chunk.surfaces, is_of_yard);
  ASSERT_NE(trimmed, chunk.surfaces.end());
  trimmed->rings.front().front().x += 0.25;
  EXPECT_TRUE(std::ranges::none_of(scene::shown_chunk(header, chunk).surfaces, is_of_yard));
}

TEST(ShownLayers, WoodsHaveMoreTreesWithAHigherDensity) {
  const scene::Scene scene = shown_town();
  ASSERT_FALSE(scene.chunks.front().woods.empty());
  const std::size_t none = trees_at(scene, 0), half = trees_at(scene, 0.5), usual = trees_at(scene, 1),
                    more = trees_at(scene, 2);
  EXPECT_LT(none, half);
  EXPECT_LT(half, usual);
  EXPECT_LT(usual, more);
}

// A polygon in the middle of the town, with a hole.
source::Outline outline_in(const scene::Scene& scene) {
  const map::Plane plane(scene.header.origin);
  const Vec2 middle = scene.header.extent.centre();
  const auto square = [&](double half_m) {
    source::LonLatRing ring;
    for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1.2}, Vec2{1, 1}, Vec2{-1.1, 1}})
      ring.push_back(plane.backward(middle + corner * half_m));
    return ring;
  };
  return {"made", {{square(150), {square(40)}}}};
}

TEST(Clips, EndTheGroundAndAllThatStandsOnIt) {
  const scene::Scene whole = shown_town();
  CompileSpec spec = town_spec();
  clip_to(outline_in(whole), spec);
  spec.map.origin = whole.header.origin;
  const Result<CompileResult> compiled = compile(spec, [](auto&&...) {});
  ASSERT_TRUE(compiled);
  const scene::Scene& scene = compiled->scene;
  ASSERT_EQ(scene.header.clip.size(), 1u);
  EXPECT_EQ(scene.header.extent.width(), std::ceil(scene.header.extent.width() / map::kCell_m) * map::kCell_m);
  double ground_m2 = 0;
  const scene::ClipTest clip(scene.header.clip, scene.header.extent.widened(1000));
  for (const bake::BakedTile& tile : bake_tiles(scene, kShownLevel_m, 2)) {
    ground_m2 += plan_area_m2(tile);
    for (const bake::InstancedMesh& mesh : tile.instanced)
      for (const bake::Float3& at : mesh.translations)
        EXPECT_TRUE(clip.is_inside({at[0] + tile.origin.x, at[1] + tile.origin.y})) << mesh.name;
  }
  EXPECT_NEAR(ground_m2, area_m2(scene.header.clip.front()), 0.01 * ground_m2);
  std::size_t buildings = 0;
  for (const scene::Chunk& chunk : scene.chunks) buildings += chunk.buildings.size();
  EXPECT_GT(buildings, 0u);
}

}  // namespace
}  // namespace citykiln
