#include "compiler/commands/view/load_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/bake/bake.h"
#include "compiler/pipeline.h"
#include "compiler/sky/plan.h"
#include "compiler/source/read_raster.h"
#include "preview/camera/camera_rays.h"
#include "preview/camera/cell_view.h"
#include "preview/render.h"
#include "preview/scene/lit_panes.h"
#include "tests/test_files.h"

namespace citykiln::commands {
namespace {

scene::Scene scene_from_files(const std::string& map, const std::string& heights) {
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
  return scene_from_files(source_file("examples/town/town.osm"),
                          source_file("examples/town/town_heights.png").string() +
                              ",bounds=12.2871378/48.6926888/12.3128622/48.7073471,scale=0.02");
}

preview::Camera camera_above(const scene::Scene& scene, double above_m) {
  const Vec2 place = scene.header.extent.centre();
  double ground_m = 0;
  for (const scene::Chunk& chunk : scene.chunks)
    if (scene::box_of(scene.header, chunk.tile).contains(place)) ground_m = map::height_m_at(chunk.heights, place);
  return {at_height(place, ground_m + above_m), at_height(place + Vec2{300, 80}, ground_m), 50};
}

// The cells of a picture. Errors of cells that it does not show may be up to `unseen_deg`; 0: they are as fine as the
// rest.
std::shared_ptr<const preview::CellSource> cells_of(const scene::Scene& scene, const preview::Camera& camera,
                                                    const preview::Options& options, double unseen_deg = 0) {
  return cells_for(scene, {std::span(&camera, 1), options.width, options.height}, {.unseen_deg = unseen_deg});
}

struct Rendered {
  preview::Image image;
  preview::CellCounters counters;
};

Rendered rendered(const scene::Scene& scene, const preview::Camera& camera, const preview::Options& options,
                  std::size_t budget_bytes) {
  const preview::World world(cells_of(scene, camera, options), camera.eye, budget_bytes);
  const preview::Lights lights(sky::generate(scene.header.sky));
  return {preview::render(world, lights, camera, options), *world.counters()};
}

std::int64_t bytes_of(const preview::CellCounters& c) { return c.geometry_bytes + c.hierarchy_bytes + c.texture_bytes; }

void expect_equal_for_any_budget(const scene::Scene& scene, double above_m, std::int64_t least_cells) {
  const preview::Camera camera = camera_above(scene, above_m);
  preview::Options options;
  options.width = 8, options.height = 5, options.samples = 1, options.threads = 2;
  const Rendered whole = rendered(scene, camera, options, 4'000'000'000);
  ASSERT_GE(whole.counters.generated, least_cells);
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

TEST(Cells, PicturesOfAGladeAreEqualForAnyBudgetAndThreads) {
  const scene::Scene glade =
      scene_from_files(source_file("examples/glade/glade.osm"),
                       source_file("examples/glade/glade_heights.png").string() +
                           ",bounds=17.0256908/51.1072928/17.0343092/51.1127072,scale=0.01,offset=-200");
  expect_equal_for_any_budget(glade, 15, 4);
}

TEST(CellsFull, PicturesOfATownAreEqualForAnyBudgetAndThreads) { expect_equal_for_any_budget(town(), 15, 11); }

// The baked form at the same tolerances. A facade looks the same on the atlas of its cell and on that of its tile.
TEST(Cells, PicturesAreThoseOfTheBakedForm) {
  const scene::Scene scene = town();
  const preview::Camera camera = camera_above(scene, 40);
  preview::Options options;
  options.width = 192, options.height = 108, options.samples = 2;
  const Rendered cells = rendered(scene, camera, options, 4'000'000'000);
  const auto source = cells_of(scene, camera, options);
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
  EXPECT_LE(different, baked.rgb.size() / 3 / 5'000);
}

// How many of the picture's middle rays meet a surface that looks different.
struct DifferentHits {
  std::size_t rays = 0, places = 0, colours = 0, normals = 0, gloss = 0;
};

DifferentHits different_hits(const preview::World& a, const preview::World& b, const preview::Camera& camera, int width,
                             int height) {
  const preview::CameraRays rays(camera, width, height);
  const preview::PixelSamples none(0, 0, 0, {});
  preview::PathDraw draw(none, 0);
  DifferentHits count;
  const auto off = [](double x, double y) { return std::abs(x - y) > 0.5 / 255; };
  for (int pixel = 0; pixel < width * height; ++pixel) {
    const preview::CameraRay ray = rays.through(pixel % width + 0.5, pixel / width + 0.5, draw);
    const auto hit = [&](const preview::World& world) {
      return world.first_hit(ray.from - world.origin(), ray.direction, rays.pixel_rad());
    };
    const auto one = hit(a), other = hit(b);
    ++count.rays;
    if (one.has_value() != other.has_value()) ++count.places;
    if (!one || !other) continue;
    if (one->distance_m != other->distance_m || one->material != other->material) ++count.places;
    if (off(one->albedo[0], other->albedo[0]) || off(one->albedo[1], other->albedo[1]) ||
        off(one->albedo[2], other->albedo[2]))
      ++count.colours;
    if (length(one->shading_normal - other->shading_normal) > 1e-3) ++count.normals;
    if (off(one->roughness, other->roughness) || off(one->metallic, other->metallic)) ++count.gloss;
  }
  return count;
}

TEST(Cells, RaysSeeTheSurfacesOfTheBakedForm) {
  const scene::Scene scene = town();
  const preview::Camera camera = camera_above(scene, 40);
  preview::Options options;
  options.width = 640, options.height = 360;
  const auto source = cells_of(scene, camera, options);
  std::vector<bake::BakedTile> tiles;
  for (const scene::Chunk& chunk : scene.chunks)
    for (bake::BakedTile& part : bake::bake(scene.header, chunk, source->levels(), 0)) tiles.push_back(std::move(part));
  const preview::World cells(source, camera.eye, 4'000'000'000), baked(tiles, camera.eye);
  const DifferentHits count = different_hits(cells, baked, camera, options.width, options.height);
  EXPECT_LE(count.places, count.rays / 10'000);
  EXPECT_LE(count.colours, count.rays / 10'000);
  EXPECT_LE(count.normals, count.rays / 10'000);
  EXPECT_LE(count.gloss, count.rays / 10'000);
}

double mean_of_image(const preview::Image& image) {
  double sum = 0;
  for (const float v : image.rgb) sum += v;
  return sum / static_cast<double>(image.rgb.size());
}

// Boxes in the picture, and those whose shadows may fall there, are never coarser.
TEST(Cells, WhatAPictureShowsIsSeen) {
  const preview::Camera camera{{10, 20, 30}, {110, 20, 30}, 45};
  bake::Sight sight = preview::sight_of(camera, 400, 200);
  const auto is_seen = [&](Vec3 at) { return bake::is_seen(sight, {Box2{in_plan(at), in_plan(at)}, at.z, at.z}); };
  const double up = std::tan(45 * std::numbers::pi / 360), right = 2 * up;
  for (const double far_m : {1.0, 80.0, 3000.0})
    for (const double x : {-1.0, -0.3, 0.9, 1.0})
      for (const double y : {-1.0, 0.2, 1.0}) {
        EXPECT_TRUE(is_seen(camera.eye + Vec3{1, -x * right, y * up} * far_m));
        EXPECT_FALSE(is_seen(camera.eye + Vec3{1, 1.1 * right, y * up} * far_m));
        EXPECT_FALSE(is_seen(camera.eye + Vec3{1, x * right, -1.1 * up} * far_m));
        EXPECT_FALSE(is_seen(camera.eye + Vec3{-1, x, y} * far_m));
      }
  // 100 m to the left, outside; its shadow falls to the right
  const Vec3 aside = camera.eye + Vec3{50, 100, 0};
  EXPECT_FALSE(is_seen(aside));
  sight.to_sun = unit(Vec3{0, 1, 0.2}), sight.lowest_m = 0;
  EXPECT_TRUE(is_seen(aside));
  sight.to_sun = unit(Vec3{0, -1, 0.2});
  EXPECT_FALSE(is_seen(aside));
}

// The cells of a film are as fine as those of each of its frames.
TEST(Cells, OfAFilmAreAsFineAsTheNearestFrameNeeds) {
  const scene::Scene scene = town();
  std::vector<preview::Camera> film;
  for (int i = 0; i < 150; ++i) film.push_back({{-400.0 + 5 * i, 20, 400}, {0, 0, 360}});
  const preview::CellFineness fineness{.width_px = 320, .height_px = 180, .unseen_deg = 0};
  const bake::View all = preview::cell_view(scene, film, fineness);
  EXPECT_LE(all.more_eyes.size(), 65u);
  const bake::ViewLevels levels = bake::levels_for(scene, all);
  std::vector<int> finest(levels.cells.size(), bake::kNoLevel);
  for (const preview::Camera& camera : film) {
    const auto own = bake::levels_for(scene, preview::cell_view(scene, std::span(&camera, 1), fineness));
    for (std::size_t i = 0; i < finest.size(); ++i) finest[i] = std::min(finest[i], own.cells[i]);
  }
  std::size_t equal = 0;
  for (std::size_t i = 0; i < finest.size(); ++i) {
    EXPECT_LE(levels.cells[i], finest[i]);
    equal += levels.cells[i] == finest[i] ? 1 : 0;
  }
  EXPECT_GT(equal * 10, finest.size() * 9);
}

// Means of many small pictures by night, lit by windows alone, with and without sampling of panes.
TEST(Cells, SampledPanesAreAsBrightAsThoseFoundByChance) {
  scene::Scene scene = town();
  scene.header.sky = sky::plan(scene.header.origin, sky::moment_of(std::chrono::year(2026) / 12 / 21, 22 * 60));
  const preview::Camera camera = camera_above(scene, 8);
  preview::Options options;
  options.width = 24, options.height = 16, options.samples = 16, options.bounces = 1;
  options.has_caustics = true, options.roulette = 0;
  const preview::World world(cells_of(scene, camera, options), camera.eye, 4'000'000'000);
  const preview::Lights lights(sky::generate(scene.header.sky));
  const auto panes = preview::lit_panes_of(scene, std::span(&camera.eye, 1), 0);
  ASSERT_GT(panes.size(), 100u);
  const preview::LocalLights chance(world, {}, 0), sampled(world, {}, 0, panes);
  const auto mean = [&](const preview::LocalLights& local, std::uint64_t seed) {
    options.seed = seed;
    const preview::Image image = preview::render(world, lights, local, camera, options);
    return mean_of_image(image);
  };
  const int seeds = quick_or_full(24, 64);
  double sum = 0, squares = 0, of_chance = 0, of_sampled = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(seeds); ++seed) {
    const double a = mean(sampled, seed), b = mean(chance, seed + 1000), difference = a - b;
    sum += difference, squares += difference * difference;
    of_sampled += a, of_chance += b;
  }
  const double t = sum / seeds / std::sqrt((squares - sum * sum / seeds) / (seeds - 1) / seeds);
  EXPECT_GT(of_chance, 0);
  // Student's t for 63 degrees of freedom; with 23 it is 3.77, two-sided 99.9 %
  EXPECT_LT(std::abs(t), 3.45) << of_sampled / of_chance;
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
