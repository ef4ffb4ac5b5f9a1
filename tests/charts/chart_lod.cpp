// Levels cut from recipes beside the finest level simplified to as many triangles by OpenMesh and by meshoptimizer, for
// each kind of object of one tile: distance from the finest level, error of the picture, bytes and time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "compiler/bake/bake.h"
#include "compiler/bake/tiles/simplify_tile.h"
#include "compiler/pipeline.h"
#include "exporters/gltf/write/encode_tile.h"
#include "tests/charts/chart.h"
#include "tests/charts/picture_difference.h"
#include "tests/charts/sampled_distance.h"
#include "tests/charts/simplified_meshes.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

using bake::BakedTile;

/// The first is the finest level, which all others are compared with and made from.
constexpr double kLodTolerances_m[] = {0.1, 0.5, 1.2, 2.5, 6, 12.5, 25};
/// Small, so that the finest level can be decimated.
constexpr double kTile_m = 128;
/// A pixel of a picture is as large as the tolerance, within these widths in pixels.
constexpr int kFewestLodPixels = 24, kMostLodPixels = 320;
constexpr int kLodSamples = 48 * 128 * 128, kFewestLodSamples = 32;
constexpr double kLodFov_deg = 30;
/// Numbers of triangles count as equal up to this factor.
constexpr double kLikeness = 1.15;

enum class Kind { kBuildings, kRoads, kGround, kPlants };
constexpr const char* kKindNames[] = {"buildings", "roads", "ground", "plants"};

const char* name_of(Kind kind) { return kKindNames[static_cast<int>(kind)]; }

bool is_of(Kind kind, bake::Layer layer) {
  if (kind == Kind::kBuildings) return layer == bake::Layer::kBuildings;
  if (kind == Kind::kRoads) return layer == bake::Layer::kRoads;
  return kind == Kind::kGround && (layer == bake::Layer::kGround || layer == bake::Layer::kWater);
}

/// The name of the plant that stands most often.
std::string commonest_plant(const BakedTile& tile) {
  std::map<std::string, std::size_t> counts;
  for (const bake::InstancedMesh& mesh : tile.instanced)
    if (bake::layer_of(mesh) == bake::Layer::kPlants) counts[mesh.name] += mesh.scales.size();
  const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  return most == counts.end() ? "" : most->first;
}

/// One plant, upright.
std::vector<bake::InstancedMesh> plant_of(const BakedTile& tile, const std::string& name) {
  for (const bake::InstancedMesh& mesh : tile.instanced)
    if (mesh.name == name) {
      bake::InstancedMesh one = mesh;
      one.translations = {{0, 0, 0}}, one.rotations = {{0, 0, 0, 1}}, one.scales = {1}, one.features = {0};
      return {one};
    }
  return {};
}

/// The part of a tile that belongs to one kind of object.
BakedTile part_of(const BakedTile& tile, Kind kind, const std::string& plant) {
  BakedTile part = tile;
  part.instanced = kind == Kind::kPlants ? plant_of(tile, plant) : std::vector<bake::InstancedMesh>();
  std::erase_if(part.primitives, [&](const bake::Primitive& p) { return !is_of(kind, p.layer); });
  return part;
}

std::vector<bake::Primitive>& primitives_of(BakedTile& part) {
  return part.instanced.empty() ? part.primitives : part.instanced.front().primitives;
}

BakedTile simplified_part(const BakedTile& finest, Simplify simplify, Kind kind, std::size_t triangles) {
  BakedTile made = finest;
  std::vector<bake::Primitive> left = simplify(primitives_of(made), triangles);
  // houses have edges, hills have none
  primitives_of(made) = kind == Kind::kBuildings ? with_flat_normals(std::move(left)) : std::move(left);
  if (primitives_of(made).empty()) made.instanced.clear();
  return made;
}

/// The finest level of one kind, and what measures need.
struct Reference {
  BakedTile tile;
  std::vector<simplify::Corners> triangles;
  simplify::TriangleTree tree;
  const sky::Sky& sky;
  preview::Camera camera;
  double width_m;
};

Reference reference_of(BakedTile&& finest, const sky::Sky& sky) {
  std::vector<simplify::Corners> triangles = triangles_in(finest);
  Vec3 low{1e9, 1e9, 1e9}, high = low * -1;
  for (const simplify::Corners& t : triangles)
    for (const Vec3 p : {t.a, t.b, t.c}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  const Vec3 middle = finest.origin + (low + high) * 0.5;
  const double width_m = length(high - low), away_m = width_m / 2 / 0.26;  // the tangent of half the field of view
  const preview::Camera camera{middle + unit(Vec3{-0.5, -0.7, 0.6}) * away_m, middle, kLodFov_deg};
  simplify::TriangleTree tree(triangles);
  return {std::move(finest), std::move(triangles), std::move(tree), sky, camera, width_m};
}

preview::Image lod_picture(const BakedTile& tile, const Reference& reference, double tolerance_m) {
  preview::Options options;
  const int pixels = std::clamp(static_cast<int>(reference.width_m / tolerance_m), kFewestLodPixels, kMostLodPixels);
  options.width = options.height = pixels;
  options.samples = std::max(kFewestLodSamples, kLodSamples / (pixels * pixels)), options.bounces = 2;
  return preview::render(std::span(&tile, 1), reference.sky, reference.camera, options);
}

struct Measures {
  double triangles, distance_m, picture, bytes, seconds;
};

/// @param ground  The ground of the level, which stands for objects that the level leaves out.
Measures measured_part(const BakedTile& part, const Reference& reference, const std::vector<simplify::Corners>& ground,
                       const scene::Header& header, double tolerance_m, double seconds) {
  const std::vector<simplify::Corners> own = triangles_in(part);
  std::vector<simplify::Corners> with_ground = own;
  with_ground.insert(with_ground.end(), ground.begin(), ground.end());
  const double there_m = sampled_distance_m(reference.triangles, simplify::TriangleTree(std::move(with_ground)));
  const double back_m = sampled_distance_m(own, reference.tree);
  const double error =
      difference(lod_picture(part, reference, tolerance_m), lod_picture(reference.tile, reference, tolerance_m));
  const exporters::EncodedTile encoded = exporters::encode_tile(part, header, {}, 1);
  return {static_cast<double>(own.size()), std::max(there_m, back_m), error, static_cast<double>(encoded.glb.size()),
          seconds};
}

/// The charts of one kind: one for each measure, with a series for each way of making levels.
struct KindCharts {
  std::vector<Chart> charts;
  int levels = 0, nearer_by_openmesh = 0, nearer_by_meshoptimizer = 0, alike_by_openmesh = 0,
      alike_by_meshoptimizer = 0, truer_by_openmesh = 0, truer_by_meshoptimizer = 0;

  explicit KindCharts(Kind kind) {
    const auto add = [&](const char* measure, const char* label, bool is_logarithmic) {
      Chart chart;
      chart.name = fmt::format("lod_{}_{}", name_of(kind), measure);
      chart.x = {"triangles", true}, chart.y = {label, is_logarithmic};
      for (const char* series : {"cut from recipes", "OpenMesh, of the finest", "meshoptimizer, of the finest"})
        chart.series.push_back({series, {}, false});
      charts.push_back(std::move(chart));
    };
    add("distance", "distance from the finest level, both ways (m)", true);
    add("picture", "mean difference of the picture, at a pixel per tolerance", true);
    add("bytes", "bytes of the .glb", true);
    add("time", "seconds; for simplified levels besides the finest", true);
  }

  void add(std::size_t series, const Measures& m) {
    const double values[] = {m.distance_m, m.picture, m.bytes, m.seconds};
    for (std::size_t c = 0; c < charts.size(); ++c)
      charts[c].series[series].points.emplace_back(m.triangles, values[c]);
  }
};

void compare(const Measures& cut, const Measures& other, int& alike, int& nearer, int& truer) {
  if (other.triangles > cut.triangles * kLikeness) return;
  ++alike;
  nearer += other.distance_m < cut.distance_m, truer += other.picture < cut.picture;
}

std::string verdict(const char* name, const KindCharts& all, int alike, int nearer, int truer) {
  return fmt::format(
      "{} reaches the triangles of {} of {} levels, with less distance at {}, a smaller picture error at {}", name,
      alike, all.levels, nearer, truer);
}

/// A tile at one tolerance, and the time of its kinds.
struct Level {
  BakedTile tile;
  std::map<Kind, double> seconds;
};

double seconds_of(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m) {
  const Stopwatch watch;
  Report ignored;
  bake::bake(header, chunk, tolerance_m, 1, ignored);
  return watch.seconds();
}

/// Skirts are not part of the error that a level states.
void remove_skirts(BakedTile& tile, double tile_m) {
  const auto [x, y] = tile.tile;
  bake::remove_inner_skirts(tile, {tile.tile, {x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}, tile_m);
}

/// Kinds are timed by leaving their recipes out. Ground and roads are one mesh, made together.
Level level_at(const scene::Scene& scene, const scene::Chunk& chunk, double tolerance_m) {
  Report ignored;
  const Stopwatch watch;
  Level level{bake::bake(scene.header, chunk, tolerance_m, 1, ignored), {}};
  const double all_s = watch.seconds();
  remove_skirts(level.tile, scene.header.tile_m);
  scene::Chunk no_buildings = chunk, no_plants = chunk;
  no_buildings.buildings.clear();
  no_plants.trees.clear(), no_plants.woods.clear(), no_plants.plantings.clear(), no_plants.tree_rows.clear();
  constexpr double kLeast_s = 1e-3;
  const double without_s = seconds_of(scene.header, no_buildings, tolerance_m);
  const double bare_s = seconds_of(scene.header, no_plants, tolerance_m);
  level.seconds[Kind::kBuildings] = std::max(kLeast_s, all_s - without_s);
  level.seconds[Kind::kPlants] = std::max(kLeast_s, all_s - bare_s);
  level.seconds[Kind::kGround] = level.seconds[Kind::kRoads] = std::max(kLeast_s, without_s - (all_s - bare_s));
  return level;
}

std::vector<simplify::Corners> ground_of(const BakedTile& tile, const BakedTile& finest) {
  BakedTile ground = tile;
  ground.instanced.clear();
  std::erase_if(ground.primitives, [](const bake::Primitive& p) { return !is_terrain(p); });
  std::vector<simplify::Corners> all = triangles_in(ground);
  const Vec3 by = tile.origin - finest.origin;
  for (simplify::Corners& t : all) t = {t.a + by, t.b + by, t.c + by};
  return all;
}

void add_lod_level(KindCharts& charts, Kind kind, const Level& level, const Reference& reference,
                   const std::string& plant, const scene::Header& header, double tolerance_m) {
  const BakedTile part = part_of(level.tile, kind, plant);
  if (triangles_in(part).empty()) return;
  const std::vector<simplify::Corners> ground =
      kind == Kind::kPlants ? std::vector<simplify::Corners>() : ground_of(level.tile, reference.tile);
  const Measures cut = measured_part(part, reference, ground, header, tolerance_m, level.seconds.at(kind));
  charts.add(0, cut), ++charts.levels;
  const auto by = [&](Simplify simplify) {
    const Stopwatch watch;
    const BakedTile made = simplified_part(reference.tile, simplify, kind, static_cast<std::size_t>(cut.triangles));
    return measured_part(made, reference, ground, header, tolerance_m, watch.seconds());
  };
  const Measures openmesh = by(simplified_by_openmesh), meshoptimizer = by(simplified_by_meshoptimizer);
  charts.add(1, openmesh), charts.add(2, meshoptimizer);
  compare(cut, openmesh, charts.alike_by_openmesh, charts.nearer_by_openmesh, charts.truer_by_openmesh);
  compare(cut, meshoptimizer, charts.alike_by_meshoptimizer, charts.nearer_by_meshoptimizer,
          charts.truer_by_meshoptimizer);
}

void add_titles(KindCharts& charts, Kind kind) {
  for (Chart& chart : charts.charts)
    chart.title = fmt::format(
        "{}: {}; {}", name_of(kind),
        verdict("OpenMesh", charts, charts.alike_by_openmesh, charts.nearer_by_openmesh, charts.truer_by_openmesh),
        verdict("meshoptimizer", charts, charts.alike_by_meshoptimizer, charts.nearer_by_meshoptimizer,
                charts.truer_by_meshoptimizer));
}

/// The tile with the most buildings, of the size kTile_m.
Result<scene::Scene> compile_small_tiles(const ChartRequest& request) {
  if (request.maps.empty()) return Error{"chart", "lod needs a map (--map FILE)"};
  CompileSpec spec;
  spec.map_path = request.maps.front(), spec.rasters = request.rasters;
  spec.threads = request.threads, spec.tile_m = kTile_m;
  Result<CompileResult> compiled = compile(spec, [](std::string_view, double) {});
  if (!compiled) return compiled.error();
  return std::move(compiled->scene);
}

}  // namespace

Result<std::vector<Chart>> chart_lod(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_small_tiles(request);
  if (!scene) return scene.error();
  const scene::Chunk& chunk =
      *std::ranges::max_element(scene->chunks, {}, [](const scene::Chunk& c) { return c.buildings.size(); });
  std::vector<Level> levels;
  for (const double tolerance_m : kLodTolerances_m) levels.push_back(level_at(*scene, chunk, tolerance_m));
  const std::string plant = commonest_plant(levels.front().tile);

  std::vector<Chart> charts;
  for (const Kind kind : {Kind::kBuildings, Kind::kRoads, Kind::kGround, Kind::kPlants}) {
    BakedTile finest = part_of(levels.front().tile, kind, plant);
    if (triangles_in(finest).empty()) continue;
    const Reference reference = reference_of(std::move(finest), scene->header.sky);
    KindCharts of_kind(kind);
    for (std::size_t i = 1; i < levels.size(); ++i)
      add_lod_level(of_kind, kind, levels[i], reference, plant, scene->header, kLodTolerances_m[i]);
    add_titles(of_kind, kind);
    std::ranges::move(of_kind.charts, std::back_inserter(charts));
  }
  return charts;
}

}  // namespace citykiln::charts
