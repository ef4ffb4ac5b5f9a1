// Two forms of a scene for rendering: stored tiles, baked for the camera and read from .glb, and recipes, whose cells
// are generated when rays meet them. Both have equal tolerances, except for surfaces that the picture does not show.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/bake.h"
#include "compiler/bake_scene.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/snap.h"
#include "exporters/gltf/glb.h"
#include "preview/camera/cell_view.h"
#include "preview/render.h"
#include "preview/scene/cell_cache.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr double kCoarse_m = 2.5;
constexpr int kStreetWidth_px = 320, kStreetHeight_px = 180, kStreetSamples = 4;

// Budgets are reduced until rendering takes this many times as long as with all cells in memory.
constexpr double kLongest = 20;
constexpr std::size_t kPlenty_bytes = 16'000'000'000;

/// Seconds, and megabytes at the end.
struct RenderCost {
  double seconds = 0, megabytes = 0;
};

/// The scene and cameras to render, in both forms.
struct RenderedStreet {
  scene::Scene scene;
  preview::Camera camera;
  int threads = 0;
  int samples = kStreetSamples;
  int shrunk = 1;  ///< The factor by which the picture's sides have fewer pixels.
};

preview::Options street_options(const RenderedStreet& place) {
  preview::Options options;
  options.width = kStreetWidth_px / place.shrunk, options.height = kStreetHeight_px / place.shrunk;
  options.samples = place.samples, options.threads = place.threads;
  return options;
}

bake::View view_of(const RenderedStreet& place, double unseen_deg) {
  const preview::CellFineness fineness{
      .width_px = kStreetWidth_px, .height_px = kStreetHeight_px, .unseen_deg = unseen_deg};
  return preview::cell_view(place.scene, std::span(&place.camera, 1), fineness);
}

double megabytes(double bytes) { return bytes * 1e-6; }

template <typename T>
double bytes_in(const std::vector<T>& all) {
  return static_cast<double>(all.size() * sizeof(T));
}

double bytes_of(const std::vector<bake::Primitive>& primitives) {
  double bytes = 0;
  for (const bake::Primitive& p : primitives)
    bytes += bytes_in(p.positions) + bytes_in(p.normals) + bytes_in(p.colours) + bytes_in(p.features) +
             bytes_in(p.triangles) + bytes_in(p.uvs);
  return bytes;
}

double bytes_of(const bake::BakedTile& tile) {
  double bytes = bytes_of(tile.primitives) + bytes_in(tile.features);
  for (const bake::InstancedMesh& mesh : tile.instanced)
    bytes += bytes_of(mesh.primitives) + bytes_in(mesh.translations) + bytes_in(mesh.rotations) +
             bytes_in(mesh.scales) + bytes_in(mesh.features);
  return bytes;
}

/// Files of all tiles, as `bake --eye` writes them.
struct StoredScene {
  std::vector<std::vector<std::byte>> files;
  double baking_s = 0;
};

StoredScene store(const RenderedStreet& place) {
  const Stopwatch watch;
  const bake::ViewLevels levels = bake::levels_for(place.scene, view_of(place, 0));
  StoredScene stored;
  for (const scene::Chunk& chunk : place.scene.chunks)
    for (const bake::BakedTile& part : bake::bake(place.scene.header, chunk, levels, place.threads))
      stored.files.push_back(exporters::encode_glb(part, place.scene.header, {}, place.threads));
  stored.baking_s = watch.seconds();
  return stored;
}

/// Reads the files and renders them.
RenderCost cost_of_stored(const RenderedStreet& place, const StoredScene& stored) {
  const Stopwatch watch;
  std::vector<bake::BakedTile> tiles;
  for (const std::vector<std::byte>& file : stored.files)
    if (Result<bake::BakedTile> tile = exporters::decode_glb(file, "tile")) tiles.push_back(std::move(*tile));
  const preview::World world(tiles, place.camera.eye);
  preview::render(world, preview::Lights(sky::generate(place.scene.header.sky)), place.camera, street_options(place));
  double bytes = static_cast<double>(world.bytes());
  for (const bake::BakedTile& tile : tiles) bytes += bytes_of(tile);
  return {watch.seconds(), megabytes(bytes)};
}

RenderCost cost_of_recipes(const RenderedStreet& place, std::size_t budget_bytes) {
  const Stopwatch watch;
  const auto cells = std::make_shared<preview::CellSource>(place.scene, view_of(place, 1));
  const preview::World world(cells, place.camera.eye, budget_bytes);
  preview::render(world, preview::Lights(sky::generate(place.scene.header.sky)), place.camera, street_options(place));
  return {watch.seconds(), megabytes(static_cast<double>(world.bytes()))};
}

/// The scene's tiles that are nearest to a place.
RenderedStreet with_tiles(const RenderedStreet& all, std::size_t count) {
  RenderedStreet some = all;
  const Vec2 eye = in_plan(all.camera.eye);
  std::ranges::stable_sort(some.scene.chunks, {}, [&](const scene::Chunk& chunk) {
    return distance(scene::box_of(all.scene.header, chunk.tile).centre(), eye);
  });
  some.scene.chunks.resize(std::min(count, some.scene.chunks.size()));
  std::ranges::sort(some.scene.chunks, {}, &scene::Chunk::tile);
  return some;
}

/// Buildings are a whole number of times as high, with as many more storeys.
RenderedStreet with_heights(const RenderedStreet& place, int factor) {
  RenderedStreet higher = place;
  for (scene::Chunk& chunk : higher.scene.chunks)
    for (buildings::Building& building : chunk.buildings) {
      const double added_m = (buildings::eaves_m(building) - building.floor_m) * (factor - 1);
      building.top_m += added_m;
      building.levels = static_cast<std::uint8_t>(std::min(building.levels * factor, 255));
      for (buildings::PartyWall& wall : building.party_walls)
        wall.top_m += (wall.top_m - building.floor_m) * (factor - 1);
    }
  return higher;
}

Result<RenderedStreet> read_street(const ChartRequest& request) {
  Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  const Result<preview::Camera> camera = preview::named_view(bake_tiles(*scene, kCoarse_m, request.threads), "street");
  if (!camera) return camera.error();
  return RenderedStreet{std::move(*scene), *camera, request.threads};
}

/// A chart of time and one of memory, with the same series.
struct TimeAndMemory {
  Chart time, memory;

  TimeAndMemory(const std::string& name, const std::string& title, const Axis& x)
      : time{name + "_time", title + ": time", x, {"time (s)", true}, {}},
        memory{name + "_memory", title + ": memory", x, {"memory (MB)", true}, {}} {}
  void add(const std::string& series, double x, const RenderCost& cost) {
    add(time, series, x, cost.seconds), add(memory, series, x, cost.megabytes);
  }
  static void add(Chart& chart, const std::string& series, double x, double y) {
    auto own = std::ranges::find(chart.series, series, &Series::name);
    if (own == chart.series.end()) own = chart.series.insert(own, Series{.name = series, .points = {}});
    own->points.emplace_back(x, y);
  }
  /// Both forms of a place.
  void add_forms(double x, const RenderedStreet& place) {
    const StoredScene stored = store(place);
    const RenderCost cost = cost_of_stored(place, stored);
    add("stored", x, cost);
    add(time, "stored, with baking", x, cost.seconds + stored.baking_s);
    add("recipes", x, cost_of_recipes(place, kPlenty_bytes));
  }
};

std::size_t buildings_in(const RenderedStreet& place) {
  std::size_t count = 0;
  for (const scene::Chunk& chunk : place.scene.chunks) count += chunk.buildings.size();
  return count;
}

TimeAndMemory over_size(const RenderedStreet& place) {
  TimeAndMemory charts(
      "forms_size",
      fmt::format("A street, {} x {} pixels, {} paths each", kStreetWidth_px, kStreetHeight_px, kStreetSamples),
      {"buildings", true});
  std::size_t before = 0;
  for (const std::size_t count : {std::size_t{1}, std::size_t{4}, std::size_t{16}, place.scene.chunks.size()}) {
    if (std::min(count, place.scene.chunks.size()) <= before) continue;
    const RenderedStreet some = with_tiles(place, count);
    before = some.scene.chunks.size();
    charts.add_forms(static_cast<double>(buildings_in(some)), some);
  }
  return charts;
}

TimeAndMemory over_height(const RenderedStreet& place) {
  TimeAndMemory charts("forms_heights", "One tile with higher buildings", {"times as high", false});
  for (const int factor : {1, 2, 3}) charts.add_forms(factor, with_heights(with_tiles(place, 1), factor));
  return charts;
}

/// Few paths: with a small budget each of them may need cells again.
Chart over_budget(const RenderedStreet& place) {
  RenderedStreet one = with_tiles(place, 1);
  one.samples = 1, one.shrunk = 10;
  Chart chart{"forms_budget",
              "One tile from recipes, 32 x 18 pixels, one path each, cells as for 320 x 180",
              {"budget (% of what all cells take)", true},
              {"time (s)", true},
              {}};
  const RenderCost whole = cost_of_recipes(one, kPlenty_bytes);
  for (const double percent : {100, 50, 20, 10, 5, 1}) {
    const auto budget = static_cast<std::size_t>(std::max(whole.megabytes * percent * 1e4, 1e6));
    const double seconds = cost_of_recipes(one, budget).seconds;
    TimeAndMemory::add(chart, "recipes", percent, seconds);
    if (seconds > kLongest * whole.seconds) break;
  }
  TimeAndMemory::add(chart, "stored", 100, cost_of_stored(one, store(one)).seconds);
  return chart;
}

}  // namespace

Result<std::vector<Chart>> chart_forms(const ChartRequest& request) {
  const Result<RenderedStreet> place = read_street(request);
  if (!place) return place.error();
  TimeAndMemory size = over_size(*place), heights = over_height(*place);
  return std::vector{std::move(size.time), std::move(size.memory), std::move(heights.time), std::move(heights.memory),
                     over_budget(*place)};
}

}  // namespace citykiln::charts
