// Costs and looks of a closed wood over the tolerance, in each form that it may have: trees as instances, trees merged
// to stands, and a canopy. Pictures are taken where the tolerance is one pixel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>

#include "compiler/bake/bake.h"
#include "compiler/bake/parts/bake_instances.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/trig.h"
#include "compiler/pipeline.h"
#include "compiler/plants/generate.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "exporters/gltf/write/encode_tile.h"
#include "preview/render.h"
#include "tests/charts/chart.h"
#include "tests/charts/picture_difference.h"

namespace citykiln::charts {
namespace {

constexpr double kCanopyTolerances_m[] = {0.1, 0.25, 0.4, 0.5, 1.2, 2.5, 5, 12.5};
// The tolerance of the reference pictures: half a pixel of the finest level.
constexpr double kFinestWood_m = 0.05;

// The side of the wood's tile, and of the wood, whose border lies outside of it. The tile is in the first quadrant, so
// that it is one tile.
constexpr double kWoodTile_m = 256;
constexpr LonLat kWoodOrigin{12.3, 48.7};

// The largest width of wood in a picture, so that the view does not leave the tile, and of a picture.
constexpr double kCanopyWindow_m = 128;
constexpr int kMostCanopyPixels = 128;
constexpr int kCanopySamples = 12 * 128 * 128;
// Views from the south-west and the north-east, 35 degrees downwards.
constexpr std::array kCanopyViews = {Vec3{-0.58, -0.58, 0.57}, Vec3{0.58, 0.58, 0.57}};

enum class WoodForm { kTrees, kStands, kCanopy };
constexpr std::array kWoodForms = {WoodForm::kTrees, WoodForm::kStands, WoodForm::kCanopy};
constexpr std::array kWoodFormNames = {"trees", "stands", "canopy"};

/// The tile of a wood with all that its levels share.
struct WoodTile {
  scene::Header header;
  scene::Chunk chunk;
  scene::Chunk bare{};  ///< Without the recipe of the wood: its ground alone.
  std::shared_ptr<const bake::PrototypeCache> prototypes{};
};

/// Degrees of a place in the plane, to a few centimetres.
LonLat degrees_near_wood(double x_m, double y_m) {
  constexpr double kLonDegree_m = 73620, kLatDegree_m = 111210;
  return {kWoodOrigin.lon_deg + x_m / kLonDegree_m, kWoodOrigin.lat_deg + y_m / kLatDegree_m};
}

/// Writes a map of one wood, which extends 400 m beyond the tile.
void write_wood_map(const std::string& path) {
  constexpr double kBeyond_m = 400;
  std::ofstream out(path);
  out << "<osm version=\"0.6\">\n";
  for (int i = 0; i < 4; ++i) {
    const bool is_east = i == 1 || i == 2, is_north = i >= 2;
    const auto at = [&](bool is_far) { return is_far ? kWoodTile_m + kBeyond_m : -kBeyond_m; };
    const LonLat corner = degrees_near_wood(at(is_east), at(is_north));
    out << fmt::format("<node id=\"{}\" version=\"1\" lon=\"{:.7f}\" lat=\"{:.7f}\"/>\n", i + 1, corner.lon_deg,
                       corner.lat_deg);
  }
  out << "<way id=\"1\" version=\"1\">";
  for (const int node : {1, 2, 3, 4, 1}) out << fmt::format("<nd ref=\"{}\"/>", node);
  out << "<tag k=\"natural\" v=\"wood\"/></way>\n</osm>\n";
}

Result<scene::Scene> compile_wood(const std::string& folder) {
  constexpr double kInside_m = 6;
  CompileSpec spec;
  spec.map_path = folder + "/wood.osm";
  write_wood_map(spec.map_path);
  const LonLat low = degrees_near_wood(kInside_m, kInside_m);
  const LonLat high = degrees_near_wood(kWoodTile_m - kInside_m, kWoodTile_m - kInside_m);
  spec.map.bbox = source::LonLatBox{low.lon_deg, low.lat_deg, high.lon_deg, high.lat_deg};
  spec.map.origin = kWoodOrigin;
  spec.tile_m = kWoodTile_m;
  Result<CompileResult> compiled = compile(spec, [](std::string_view, double) {});
  if (!compiled) return compiled.error();
  return std::move(compiled->scene);
}

plants::PlacedPlants trees_in(const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(chunk);
  const ground::LandCoverIndex map = ground::index_land_cover(surfaces, box.widened(scene::kHalo_m));
  const ground::GradedTerrain graded =
      scene::graded_terrain_of(header, chunk, tolerances_with(Detail::kWoodCanopies).from_m);
  const plants::SpeciesTable species(header.species);
  Report ignored;
  return plants::generate({.trees = {}, .woods = chunk.woods, .plantings = {}, .rows = {}, .corridors = {}},
                          {.surfaces = map,
                           .ground = graded,
                           .box = box,
                           .seed = header.seed,
                           .latitude_deg = header.origin.lat_deg,
                           .climate = header.climate,
                           .month = scene::local_month_of(header),
                           .species = species},
                          ignored)
      .placed;
}

WoodTile wood_tile_of(const scene::Scene& scene) {
  WoodTile wood{.header = scene.header, .chunk = scene.chunks.front()};
  wood.bare = wood.chunk, wood.bare.woods.clear();
  wood.prototypes = std::make_shared<bake::PrototypeCache>(wood.header);
  return wood;
}

bake::BakedTile baked_wood(const WoodTile& wood, const scene::Chunk& chunk, double tolerance_m) {
  Report ignored;
  return bake::bake(wood.header, chunk, tolerance_m, 1, ignored, wood.prototypes);
}

/// Trees at any tolerance, also where bake() has a canopy in their place.
/// @param most_instances  0: the trees are stands.
bake::BakedTile with_trees(const WoodTile& wood, double tolerance_m, std::size_t most_instances) {
  Report ignored;
  if (!has_detail(Detail::kWoodCanopies, tolerance_m)) {
    const auto prepared =
        bake::prepare(wood.header, wood.chunk, std::array{tolerance_m}, 1, wood.prototypes, most_instances);
    return bake::bake_prepared(*prepared, 0, 1, ignored);
  }
  bake::BakedTile tile = baked_wood(wood, wood.bare, tolerance_m);
  bake::Baking baking{wood.header, wood.bare, tolerance_m, tile};
  bake::bake_trees(baking, {.trees = trees_in(wood.header, wood.chunk), .lamps = {}}, *wood.prototypes, most_instances);
  return tile;
}

/// A canopy at any tolerance: where bake() has none, its finest.
bake::BakedTile in_form(const WoodTile& wood, WoodForm form, double tolerance_m) {
  if (form != WoodForm::kCanopy)
    return with_trees(wood, tolerance_m, form == WoodForm::kStands ? 0 : bake::kAnyInstances);
  return baked_wood(wood, wood.chunk, std::max(tolerance_m, tolerances_with(Detail::kWoodCanopies).from_m));
}

preview::Image wood_picture(const WoodTile& wood, const bake::BakedTile& tile, Vec3 from, double tolerance_m,
                            std::uint64_t seed) {
  preview::Options options;
  const int pixels = std::min(kMostCanopyPixels, static_cast<int>(std::lround(kCanopyWindow_m / tolerance_m)));
  options.width = options.height = pixels;
  options.samples = kCanopySamples / (pixels * pixels);
  options.bounces = 2, options.seed = seed;
  const Vec3 middle{kWoodTile_m / 2, kWoodTile_m / 2, tile.origin.z + 10};
  const preview::Camera camera{middle + unit(from) * (kChartFocal_px * tolerance_m), middle,
                               2 * 180 / kPi * std::atan(pixels / 2.0 / kChartFocal_px)};
  return preview::render(std::span(&tile, 1), wood.header.sky, camera, options);
}

/// Pictures of the finest level from all views, for one tolerance.
struct WoodReference {
  std::vector<preview::Image> pictures;
  double noise = 0;  ///< The difference of two of them, as LuminanceDifference::rms.
};

WoodReference reference_at(const WoodTile& wood, const bake::BakedTile& finest, double tolerance_m) {
  WoodReference reference;
  for (const Vec3 from : kCanopyViews) {
    reference.pictures.push_back(wood_picture(wood, finest, from, tolerance_m, 1));
    reference.noise +=
        luminance_difference(wood_picture(wood, finest, from, tolerance_m, 2), reference.pictures.back()).rms /
        kCanopyViews.size();
  }
  return reference;
}

LuminanceDifference mean_difference(const WoodTile& wood, const bake::BakedTile& tile, const WoodReference& reference,
                                    double tolerance_m) {
  LuminanceDifference mean;
  mean.ratio = 0;
  for (std::size_t i = 0; i < kCanopyViews.size(); ++i) {
    const LuminanceDifference one =
        luminance_difference(wood_picture(wood, tile, kCanopyViews[i], tolerance_m, 2), reference.pictures[i]);
    mean.ratio += one.ratio / kCanopyViews.size(), mean.rms += one.rms / kCanopyViews.size();
  }
  return mean;
}

struct WoodCost {
  double bytes = 0, triangles = 0, seconds = 0;
};

double triangles_drawn(const bake::BakedTile& tile) {
  double sum = 0;
  const auto add = [&](const std::vector<bake::Primitive>& primitives, std::size_t copies) {
    for (const bake::Primitive& p : primitives) sum += static_cast<double>(p.triangles.size() * copies);
  };
  add(tile.primitives, 1);
  for (const bake::InstancedMesh& mesh : tile.instanced) add(mesh.primitives, mesh.translations.size());
  return sum;
}

/// Makes a tile and its .glb, and measures both. Seconds are those of all threads; prototypes are made already.
template <typename Make>
WoodCost wood_cost(const WoodTile& wood, Make make) {
  const std::clock_t begin = std::clock();
  bake::BakedTile tile = make();
  WoodCost cost{.triangles = triangles_drawn(tile)};
  cost.bytes = static_cast<double>(
      exporters::encode_tile(tile, wood.header, {.target = Target::kCesium, .compression = Compression::kLean}, 1)
          .glb.size());
  cost.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return cost;
}

std::vector<Chart> empty_canopy_charts() {
  std::vector<Chart> charts(5);
  constexpr std::array kNames = {"canopy_rms", "canopy_luminance", "canopy_bytes", "canopy_triangles",
                                 "canopy_seconds"};
  constexpr std::array kLabels = {"RMS difference of luminance (share of the mean)", "luminance (share of the trees')",
                                  "bytes of .glb", "triangles", "processor seconds"};
  for (std::size_t i = 0; i < charts.size(); ++i) {
    charts[i].name = kNames[i], charts[i].title = "A wood of 256 m";
    charts[i].x = {"tolerance (m)", true}, charts[i].y = {kLabels[i], i >= 2};
    for (const char* form : kWoodFormNames) charts[i].series.push_back({form, {}});
  }
  charts[0].title += " from where the tolerance is one pixel";
  charts[0].series.push_back({"noise", {}});
  charts[0].notes = {"| tolerance (m) | form | RMS | luminance | kB | triangles | seconds |",
                     "|--:|---|--:|--:|--:|--:|--:|"};
  return charts;
}

void add_form(const WoodTile& wood, WoodForm form, const WoodReference& reference, double tolerance_m,
              std::vector<Chart>& charts) {
  const bake::BakedTile tile = in_form(wood, form, tolerance_m);
  const LuminanceDifference look = mean_difference(wood, tile, reference, tolerance_m);
  const double ground_m =
      form == WoodForm::kCanopy ? std::max(tolerance_m, tolerances_with(Detail::kWoodCanopies).from_m) : tolerance_m;
  const WoodCost bare = wood_cost(wood, [&] { return baked_wood(wood, wood.bare, ground_m); });
  const WoodCost whole = wood_cost(wood, [&] { return in_form(wood, form, tolerance_m); });
  // the picture's noise is no difference
  const double rms = std::sqrt(std::max(0.0, look.rms * look.rms - reference.noise * reference.noise));
  const std::array values = {rms, look.ratio, whole.bytes - bare.bytes, whole.triangles - bare.triangles,
                             whole.seconds - bare.seconds};
  const auto series = static_cast<std::size_t>(form);
  for (std::size_t i = 0; i < values.size(); ++i) charts[i].series[series].points.emplace_back(tolerance_m, values[i]);
  charts[0].notes.push_back(fmt::format("| {} | {} | {:.3f} | {:.2f} | {:.0f} | {:.0f} | {:.2f} |", tolerance_m,
                                        kWoodFormNames[series], values[0], values[1], values[2] / 1000, values[3],
                                        values[4]));
}

}  // namespace

Result<std::vector<Chart>> chart_canopy(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_wood(request.folder);
  if (!scene) return scene.error();
  const WoodTile wood = wood_tile_of(*scene);
  const bake::BakedTile finest = baked_wood(wood, wood.chunk, kFinestWood_m);
  std::vector<Chart> charts = empty_canopy_charts();
  for (const double tolerance_m : kCanopyTolerances_m) {
    const WoodReference reference = reference_at(wood, finest, tolerance_m);
    charts[0].series.back().points.emplace_back(tolerance_m, reference.noise);
    for (const WoodForm form : kWoodForms) add_form(wood, form, reference, tolerance_m, charts);
  }
  return charts;
}

}  // namespace citykiln::charts
