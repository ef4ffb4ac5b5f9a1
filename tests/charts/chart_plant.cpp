// Costs and looks of plants over the tolerance: triangles, bytes and time of a prototype (mean of the shipped trees),
// the error of the picture of a tree and of a wood at the distance where the tolerance is one pixel, and the distance
// of a branch joint's mesh from its limit surface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/prototype_cache.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"
#include "compiler/sky/plan.h"
#include "exporters/gltf/glb.h"
#include "lsystems/mesh/tubes.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/turtle.h"
#include "preview/render.h"
#include "tests/charts/chart.h"
#include "tests/charts/picture_difference.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

using plants::Species;

constexpr double kPlantTolerances_m[] = {0.02, 0.05, 0.1, 0.25, 0.5, 1.2, 2.5, 5, 12.5};
constexpr double kFinestPlant_m = 0.02;
constexpr Species kTrees[] = {Species::kOak, Species::kBeech, Species::kBirch, Species::kSpruce, Species::kPine};
/// The width of scene in a picture, equal for all tolerances as in chart_facade.cpp.
constexpr double kTreeWindow_m = 40, kWoodWindow_m = 120;
constexpr int kFewestPlantPixels = 6, kMostPlantPixels = 160;
constexpr int kPlantSamples = 16 * 128 * 128, kFewestPlantSamples = 24;
constexpr double kDegrees = 57.29577951308232;
constexpr int kWoodSide = 9;
constexpr double kWoodSpacing_m = 7;

bake::Primitive lawn() {
  constexpr float kHalf_m = 400;
  bake::Primitive lawn{materials::Material::kGrass, {}, {}, {}, {}, {}};
  for (const auto& [x, y] :
       {std::pair{-kHalf_m, -kHalf_m}, {kHalf_m, -kHalf_m}, {kHalf_m, kHalf_m}, {-kHalf_m, kHalf_m}}) {
    lawn.positions.push_back({x, y, 0}), lawn.normals.push_back({0, 0, 1});
    lawn.colours.push_back(materials::kNoTint), lawn.features.push_back(0);
  }
  lawn.triangles = {{0, 1, 2}, {0, 2, 3}};
  return lawn;
}

struct PlacedPlant {
  plants::Prototype prototype;
  Vec2 at;
  double height_m = 0, turns = 0;
};

bake::BakedTile planted(const bake::PrototypeCache& prototypes, const std::vector<PlacedPlant>& trees,
                        double tolerance_m) {
  bake::BakedTile tile;
  tile.features = {OsmId{}}, tile.primitives = {lawn()};
  for (const PlacedPlant& tree : trees) {
    const double mesh_m = bake::prototype_height_m(plants::values_of(tree.prototype.species).height_m);
    const bake::BakedPrototype& shape = prototypes.prototype(tree.prototype, mesh_m, tolerance_m);
    if (shape.primitives.empty()) continue;
    const Vec2 half = direction_of(tree.turns / 2);
    tile.instanced.push_back({std::string(plants::values_of(tree.prototype.species).file),
                              shape.primitives,
                              {{static_cast<float>(tree.at.x), static_cast<float>(tree.at.y), 0}},
                              {{0, 0, static_cast<float>(half.y), static_cast<float>(half.x)}},
                              {static_cast<float>(tree.height_m / mesh_m)},
                              {0},
                              shape.cutout});
  }
  return tile;
}

std::vector<PlacedPlant> one_tree(Species species) {
  return {{{species, 0}, {0, 0}, plants::values_of(species).height_m, 0.1}};
}

/// Trees of all species on a jittered grid.
std::vector<PlacedPlant> wood() {
  std::vector<PlacedPlant> trees;
  const RandomSequence draw(1, StableId{}, "wood");
  for (int i = 0; i < kWoodSide * kWoodSide; ++i) {
    const auto dice = static_cast<std::uint32_t>(8 * i);
    const Species species = kTrees[draw.below(std::size(kTrees), dice)];
    const Vec2 at =
        Vec2{i % kWoodSide - kWoodSide / 2 + draw.unit(dice + 1), i / kWoodSide - kWoodSide / 2 + draw.unit(dice + 2)} *
        kWoodSpacing_m;
    const auto variant = static_cast<std::uint8_t>(draw.below(2, dice + 3));
    trees.push_back({{species, variant},
                     at,
                     plants::values_of(species).height_m * draw.between(0.7, 1, dice + 4),
                     draw.unit(dice + 5)});
  }
  return trees;
}

preview::Image plant_picture(const bake::BakedTile& tile, const sky::Sky& sky, double window_m, double tolerance_m,
                             std::uint64_t seed) {
  preview::Options options;
  options.width = options.height =
      std::clamp(static_cast<int>(std::lround(window_m / tolerance_m)), kFewestPlantPixels, kMostPlantPixels);
  options.samples = std::max(kFewestPlantSamples, kPlantSamples / (options.width * options.height));
  options.bounces = 2, options.seed = seed;
  // the distance at which the tolerance is one pixel, but at least the distance at which the window fits the picture
  const double away_m = kChartFocal_px * std::max(tolerance_m, window_m / kMostPlantPixels);
  const Vec3 middle{0, 0, window_m / 5};
  const preview::Camera camera{middle + unit(Vec3{0.25, -1, 0.35}) * away_m, middle,
                               2 * kDegrees * std::atan(window_m / 2 / away_m)};
  return preview::render(std::span(&tile, 1), sky, camera, options);
}

/// The mean signed difference of brightness.
double lighter(const preview::Image& a, const preview::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::min(a.rgb[i], 1.f) - std::min(b.rgb[i], 1.f);
  return sum / static_cast<double>(a.rgb.size());
}

std::vector<Chart> empty_plant_charts() {
  std::vector<Chart> charts(3);
  for (Chart& chart : charts) chart.x.label = "tolerance (m)", chart.x.is_logarithmic = true;
  charts[0].name = "plant_costs", charts[0].title = fmt::format("A prototype, mean of {} species", std::size(kTrees));
  charts[0].y.label = "triangles; bytes of .glb; microseconds", charts[0].y.is_logarithmic = true;
  charts[0].series = {{"triangles", {}}, {"bytes", {}}, {"microseconds", {}}};
  charts[1].name = "plant_picture", charts[1].title = "Error of the picture from where the tolerance is one pixel";
  charts[1].y.label = "mean difference (share of white)";
  charts[1].series = {
      {"a tree", {}}, {"noise", {}}, {"a wood", {}}, {"noise of the wood", {}}, {"the wood is lighter by", {}}};
  charts[2].name = "plant_joint", charts[2].title = "A joint's mesh, from its limit surface";
  charts[2].x = {"sides of a stem"};
  charts[2].y = {"distance (share of the stem's radius)", true};
  charts[2].series = {{"measured", {}}, {"stated", {}}};
  return charts;
}

void add_prototype_costs(const bake::PrototypeCache& prototypes, const scene::Header& header, double tolerance_m,
                         Chart& chart) {
  double triangles = 0, bytes = 0, us = 0;
  for (const Species species : kTrees) {
    prototypes.prototype({species, 0}, 1000, 999);  // derives the prototype before the clock starts
    const Stopwatch watch;
    const bake::BakedPrototype& shape =
        prototypes.prototype({species, 0}, bake::prototype_height_m(plants::values_of(species).height_m), tolerance_m);
    us += watch.microseconds();
    for (const bake::Primitive& p : shape.primitives) triangles += static_cast<double>(p.triangles.size());
    const auto size = [&](const bake::BakedTile& tile) {
      return static_cast<double>(exporters::encode_glb(tile, header, {}).size());
    };
    bytes += size(planted(prototypes, one_tree(species), tolerance_m)) - size(planted(prototypes, {}, tolerance_m));
  }
  const double count = std::size(kTrees);
  chart.series[0].points.emplace_back(tolerance_m, triangles / count);
  chart.series[1].points.emplace_back(tolerance_m, bytes / count);
  chart.series[2].points.emplace_back(tolerance_m, us / count);
}

void add_pictures(const bake::PrototypeCache& prototypes, const sky::Sky& sky, double tolerance_m, Chart& chart) {
  double error = 0, noise = 0;
  for (const Species species : kTrees) {
    const bake::BakedTile truth = planted(prototypes, one_tree(species), kFinestPlant_m);
    const preview::Image finest = plant_picture(truth, sky, kTreeWindow_m, tolerance_m, 1);
    noise += difference(finest, plant_picture(truth, sky, kTreeWindow_m, tolerance_m, 2));
    error += difference(
        finest, plant_picture(planted(prototypes, one_tree(species), tolerance_m), sky, kTreeWindow_m, tolerance_m, 2));
  }
  const bake::BakedTile truth = planted(prototypes, wood(), kFinestPlant_m);
  const preview::Image finest = plant_picture(truth, sky, kWoodWindow_m, tolerance_m, 1);
  const preview::Image coarse =
      plant_picture(planted(prototypes, wood(), tolerance_m), sky, kWoodWindow_m, tolerance_m, 2);
  const double values[] = {error / std::size(kTrees), noise / std::size(kTrees), difference(finest, coarse),
                           difference(finest, plant_picture(truth, sky, kWoodWindow_m, tolerance_m, 2)),
                           lighter(coarse, finest)};
  for (std::size_t s = 0; s < std::size(values); ++s) chart.series[s].points.emplace_back(tolerance_m, values[s]);
}

constexpr Vec3 kFork{0, 0, 6};
constexpr double kAboutFork = 3;

Vec3 middle_of(const lsystems::PartMesh& mesh, const Triangle& t) {
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) * (1.0 / 3);
}

/// The largest distance from triangle centres of a coarse mesh near the fork to the plane of the nearest fine triangle.
double distance_between(const lsystems::PartMesh& coarse, const lsystems::PartMesh& fine) {
  double farthest = 0;
  for (const Triangle& t : coarse.triangles) {
    const Vec3 p = middle_of(coarse, t);
    if (length(p - kFork) > kAboutFork) continue;
    double nearest = 1e300, off = 0;
    for (const Triangle& f : fine.triangles) {
      const Vec3 d = p - middle_of(fine, f);
      if (dot(d, d) >= nearest) continue;
      const Vec3 a = fine.positions[f[0]];
      nearest = dot(d, d);
      off = std::abs(dot(d, unit(cross(fine.positions[f[1]] - a, fine.positions[f[2]] - a))));
    }
    farthest = std::max(farthest, off);
  }
  return farthest;
}

/// Adds the series of a forking stem of radius 1.
void add_joint(Chart& chart) {
  const auto system = lsystems::read_lsystem("n: 1\naxiom: !(2)F(6)[+(35)!(1.6)F(6)]-(25)F(6)\n", "fork.lsys");
  const lsystems::Skeleton fork = lsystems::grow(*system).skeleton;
  lsystems::TubeOptions options;
  options.flare = 0, options.tolerance_m = 1e-6;
  const lsystems::PlantMesh fine = lsystems::mesh_plant(fork, options);
  for (const double tolerance : {0.5, 0.2, 0.06, 0.025, 0.01}) {
    options.tolerance_m = tolerance;
    const lsystems::PlantMesh mesh = lsystems::mesh_plant(fork, options);
    // counts the first ring of the stem
    std::size_t sides = 0;
    while (sides + 1 < mesh.bark.positions.size() && mesh.bark.positions[sides + 1].z == mesh.bark.positions[0].z &&
           !(length(mesh.bark.positions[sides + 1] - mesh.bark.positions[0]) < 1e-9 && sides > 0))
      ++sides;
    chart.series[0].points.emplace_back(static_cast<double>(sides + 1), distance_between(mesh.bark, fine.bark));
    chart.series[1].points.emplace_back(static_cast<double>(sides + 1), mesh.error_m);
  }
}

}  // namespace

Result<std::vector<Chart>> chart_plant(const ChartRequest&) {
  const scene::Header header;
  const bake::PrototypeCache prototypes(header);
  const sky::Sky sky = sky::plan({11, 48}, sky::moment_of(std::chrono::year(2026) / 6 / 21, 9 * 60 + 30));
  std::vector<Chart> charts = empty_plant_charts();
  for (const double tolerance_m : kPlantTolerances_m) {
    add_prototype_costs(prototypes, header, tolerance_m, charts[0]);
    add_pictures(prototypes, sky, tolerance_m, charts[1]);
  }
  add_joint(charts[2]);
  return charts;
}

}  // namespace citykiln::charts
