#include "compiler/commands/load_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/bake/bake.h"
#include "compiler/pipeline.h"
#include "compiler/source/read_raster.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

const std::string kTown = std::string(CITYKILN_SOURCE) + "/examples/town/";

scene::Scene scene_of(const std::string& map, const std::string& heights) {
  CompileSpec spec;
  spec.map_path = map;
  Result<source::RasterSpec> raster = source::parse_raster_spec(heights);
  EXPECT_TRUE(raster);
  if (raster) spec.rasters.push_back(std::move(*raster));
  Result<CompileResult> compiled = compile(spec, [](auto&&...) {});
  EXPECT_TRUE(compiled) << map;
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

scene::Scene town() {
  return scene_of(kTown + "town.osm",
                  kTown + "town_heights.png,bounds=12.2871378/48.6926888/12.3128622/48.7073471,scale=0.02");
}

preview::Camera camera_above(const scene::Scene& scene, double above_m) {
  const Vec2 place = scene.header.region.centre();
  double ground_m = 0;
  for (const scene::Chunk& chunk : scene.chunks)
    if (scene::box_of(scene.header, chunk.tile).contains(place)) ground_m = map::height_m_at(chunk.heights, place);
  return {at_height(place, ground_m + above_m), at_height(place + Vec2{300, 80}, ground_m), 50};
}

struct Rendered {
  preview::Image image;
  preview::CellCounters counters;
};

Rendered rendered(const scene::Scene& scene, const preview::Camera& camera, const preview::Options& options,
                  std::size_t budget_bytes) {
  const preview::World world(cells_for(scene, camera, options.height, 0.5), camera.eye, budget_bytes);
  const preview::Lights lights(sky::generate(scene.header.sky));
  return {preview::render(world, lights, camera, options), *world.counters()};
}

std::int64_t bytes_of(const preview::CellCounters& c) { return c.geometry_bytes + c.hierarchy_bytes + c.texture_bytes; }

void expect_equal_for_any_budget(const scene::Scene& scene, double above_m) {
  const preview::Camera camera = camera_above(scene, above_m);
  preview::Options options;
  options.width = 8, options.height = 5, options.samples = 1, options.threads = 2;
  const Rendered whole = rendered(scene, camera, options, 4'000'000'000);
  ASSERT_GT(whole.counters.generated, 10u);
  EXPECT_EQ(whole.counters.regenerated, 0u);
  EXPECT_EQ(whole.counters.outside_m, 0);
  for (const auto& [threads, percent] : {std::pair{1, 10}, {2, 10}}) {
    options.threads = threads;
    const auto budget = static_cast<std::size_t>(bytes_of(whole.counters) * percent / 100);
    const Rendered part = rendered(scene, camera, options, budget);
    EXPECT_EQ(part.image.rgb, whole.image.rgb) << percent << " %, " << threads << " threads";
    EXPECT_GT(part.counters.regenerated, 0u);
  }
}

TEST(Cells, PicturesOfATownAreEqualForAnyBudgetAndThreads) { expect_equal_for_any_budget(town(), 15); }

// The baked form at the same tolerances, but for facades with textures, whose atlases are laid out differently: about
// 1.3 % of the pixels here, some of which differ in one path.
TEST(Cells, PicturesAreThoseOfTheBakedForm) {
  const scene::Scene scene = town();
  const preview::Camera camera = camera_above(scene, 40);
  preview::Options options;
  options.width = 192, options.height = 108, options.samples = 2;
  const Rendered cells = rendered(scene, camera, options, 4'000'000'000);
  const auto source = cells_for(scene, camera, options.height, 0.5);
  std::vector<bake::BakedTile> tiles;
  for (const scene::Chunk& chunk : scene.chunks)
    for (bake::BakedTile& part : bake::bake(scene.header, chunk, source->levels(), 0)) tiles.push_back(std::move(part));
  const preview::Image baked = preview::render(tiles, scene.header.sky, camera, options);
  ASSERT_EQ(baked.rgb.size(), cells.image.rgb.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < baked.rgb.size(); i += 3) {
    double most = 0;
    for (std::size_t c = i; c < i + 3; ++c) most = std::max<double>(most, std::abs(baked.rgb[c] - cells.image.rgb[c]));
    different += most > 1.0 / 255 ? 1 : 0;
  }
  EXPECT_LE(different, baked.rgb.size() / 3 / 50);
}

TEST(MemoryBudget, IsANumberWithAUnit) {
  std::size_t bytes = 0;
  EXPECT_TRUE(store_bytes(bytes)("200MB"));
  EXPECT_EQ(bytes, 200'000'000u);
  EXPECT_TRUE(store_bytes(bytes)("1.5GiB"));
  EXPECT_EQ(bytes, 1'610'612'736u);
  for (const char* wrong : {"", "200", "MB", "-1GB", "nanGB", "infGB", "1e30GB", "0MB", "200 MB", "200mb", "1kB"}) {
    EXPECT_FALSE(store_bytes(bytes)(wrong)) << wrong;
  }
  EXPECT_EQ(bytes, 1'610'612'736u);
  EXPECT_GT(default_budget_bytes(), 1'000'000u);
}

}  // namespace
}  // namespace citykiln::commands
