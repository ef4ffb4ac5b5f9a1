#include "compiler/bake/cells/bake_cell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "compiler/bake/bake.h"
#include "compiler/pipeline.h"
#include "compiler/source/read_raster.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

scene::Scene scene_from_files(const std::string& map, const std::string& heights, const std::string& time) {
  CompileSpec spec;
  spec.map_path = map;
  if (!time.empty()) spec.time = *sky::parse_time(time);
  Result<source::RasterSpec> raster = source::parse_raster_spec(heights);
  EXPECT_TRUE(raster);
  if (raster) spec.rasters.push_back(std::move(*raster));
  Result<CompileResult> compiled = compile(spec, [](auto&&...) {});
  EXPECT_TRUE(compiled) << map;
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

scene::Scene town() {
  return scene_from_files(source_file("examples/town/town.osm"),
                          source_file("examples/town/town_heights.png").string() +
                              ",bounds=12.2871378/48.6926888/12.3128622/48.7073471,scale=0.02",
                          "2026-06-21T15:20");
}

bake::View view_above(const scene::Scene& scene, Vec2 place, double above_m) {
  for (const scene::Chunk& chunk : scene.chunks)
    if (scene::box_of(scene.header, chunk.tile).contains(place))
      return {at_height(place, map::height_m_at(chunk.heights, place) + above_m), 900, 1};
  return {};
}

using Shown = std::tuple<materials::Material, bake::Layer, std::array<bake::Float3, 3>, OsmId>;
using Instance = std::tuple<std::string, bake::Float3, bake::Float4, float, OsmId, std::size_t>;

// Baked triangles and instances, in any order.
struct Content {
  std::vector<Shown> triangles;
  std::vector<Instance> instances;

  void add(const bake::BakedTile& tile) {
    for (const bake::Primitive& p : tile.primitives)
      for (const auto& t : p.triangles) {
        std::array<bake::Float3, 3> at = {p.positions[t[0]], p.positions[t[1]], p.positions[t[2]]};
        std::ranges::rotate(at, std::ranges::min_element(at));
        triangles.emplace_back(p.material, p.layer, at, tile.features[p.features[t[0]]]);
      }
    for (const bake::InstancedMesh& mesh : tile.instanced) add(tile, mesh, mesh.primitives);
  }
  void add(const bake::BakedTile& tile, const bake::InstancedMesh& mesh, const std::vector<bake::Primitive>& shown) {
    std::size_t count = 0;
    for (const bake::Primitive& p : shown) count += p.triangles.size();
    for (std::size_t i = 0; i < mesh.translations.size(); ++i)
      instances.emplace_back(mesh.name, mesh.translations[i], mesh.rotations[i], mesh.scales[i],
                             tile.features[mesh.features[i]], count);
  }
  void sort() { std::ranges::sort(triangles), std::ranges::sort(instances); }
};

Content of_parts(const scene::Scene& scene, const scene::Chunk& chunk, const bake::ViewLevels& levels) {
  Content content;
  for (const bake::BakedTile& part : bake::bake(scene.header, chunk, levels, 0)) content.add(part);
  content.sort();
  return content;
}

// How far a point of a cell lies outside of its bounds.
double outside_m(const bake::Bounds& bounds, Vec3 p) { return distance_m(bounds, p); }

struct OfCells {
  Content content;
  double outside_m = 0;
};

OfCells of_cells(const scene::Scene& scene, const scene::Chunk& chunk, const bake::ViewLevels& levels) {
  const auto tile =
      bake::prepare_cells(scene.header, chunk, levels, std::make_shared<bake::PrototypeCache>(scene.header));
  const std::vector<bake::Bounds> bounds = bake::cell_bounds(scene.header, chunk, levels);
  EXPECT_EQ(bounds.size(), bake::cells_of(scene::box_of(scene.header, chunk.tile)).size());
  EXPECT_GT(bake::bytes_of(*tile), 0u);
  OfCells of;
  for (std::size_t cell = 0; cell < bounds.size(); ++cell)
    for (const bake::BakedCellPart& part : bake::bake_cell(*tile, cell).parts) {
      of.content.add(part.tile);
      for (const bake::PlacedPrototype& plants : part.plants)
        of.content.add(part.tile, plants.instances, plants.prototype->primitives);
      for (const bake::Primitive& p : part.tile.primitives)
        for (const bake::Float3& at : p.positions)
          of.outside_m = std::max(of.outside_m, outside_m(bounds[cell], part.tile.origin + bake::widened(at)));
    }
  of.content.sort();
  return of;
}

void expect_same(const scene::Scene& scene, const bake::View& view, std::size_t least_instances,
                 std::size_t least_buildings = 0) {
  const bake::ViewLevels levels = bake::levels_for(scene, view);
  std::size_t triangles = 0, instances = 0;
  for (const scene::Chunk& chunk : scene.chunks) {
    if (chunk.buildings.size() < least_buildings) continue;
    const Content parts = of_parts(scene, chunk, levels);
    const OfCells cells = of_cells(scene, chunk, levels);
    EXPECT_EQ(cells.content.triangles.size(), parts.triangles.size()) << scene::to_string(chunk.tile);
    EXPECT_TRUE(cells.content.triangles == parts.triangles) << scene::to_string(chunk.tile);
    EXPECT_EQ(cells.content.instances.size(), parts.instances.size()) << scene::to_string(chunk.tile);
    EXPECT_TRUE(cells.content.instances == parts.instances) << scene::to_string(chunk.tile);
    EXPECT_EQ(cells.outside_m, 0) << scene::to_string(chunk.tile);
    triangles += parts.triangles.size(), instances += parts.instances.size();
  }
  EXPECT_GT(triangles, 100'000u);
  EXPECT_GT(instances, least_instances);
}

// By night, seen from a roof: fine and coarse levels, grass, lamps, facade textures.
TEST(BakeCell, CellsTogetherAreTheTownForAView) {
  const scene::Scene scene = town();
  expect_same(scene, view_above(scene, scene.header.extent.centre(), 12), 1000);
}

// Bridges, a tunnel, woods, a river, ground under buildings at the edge of the extent.
TEST(BakeCellReal, CellsTogetherAreAVillageForAView) {
  if (!std::filesystem::exists(real_data("andorra/N42E001.hgt"))) GTEST_SKIP() << "no real data";
  const scene::Scene scene =
      scene_from_files(real_data("andorra/cut-canillo-village.osm.pbf"), real_data("andorra/N42E001.hgt"), "");
  expect_same(scene, view_above(scene, scene.header.extent.centre(), 50), 1000, 30);
}

}  // namespace
}  // namespace citykiln
