// Costs and looks of facades over the tolerance: triangles, bytes and time of some houses of a map, and the error of
// their picture at the distance where the tolerance is one pixel, and at 100 m, and how bright the picture is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/bake/bake.h"
#include "compiler/map/locate.h"
#include "exporters/gltf/glb.h"
#include "preview/render.h"
#include "tests/charts/chart.h"
#include "tests/charts/picture_difference.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

constexpr double kFacadeTolerances_m[] = {0.02, 0.05, 0.1, 0.25, 0.5, 1, 2.5};
/// The tolerance of the reference pictures.
constexpr double kFinestFacade_m = 0.01;
constexpr std::size_t kHouses = 4;
/// The width of wall in a picture, equal for all tolerances, since more sky around a wall would lower the error. A
/// pixel is as large as the tolerance, except at the finest tolerances.
constexpr double kWindow_m = 12.8;
constexpr int kFewestFacadePixels = 5, kMostFacadePixels = 128;
/// Samples of all pixels together, so that small pictures have the same noise as large ones.
constexpr int kFacadeSamples = 12 * 128 * 128, kFewestFacadeSamples = 8;
/// Distance and width in pixels of the second picture.
constexpr double kPictureDistance_m = 100;
constexpr int kPictureSize_px = 160;

int pixels_at(double tolerance_m) {
  return std::clamp(static_cast<int>(std::lround(kWindow_m / tolerance_m)), kFewestFacadePixels, kMostFacadePixels);
}

/// A building in a tile of its own, of the smallest size, so that nothing hides it.
struct House {
  scene::Header header;
  scene::Chunk chunk;
};

House alone(scene::Header header, const scene::Chunk& chunk, const buildings::Building& building) {
  header.tile_m = map::kCell_m;
  House house{std::move(header), {}};
  const Vec2 corner = building.footprint.outer.front();
  house.chunk.tile = {static_cast<std::int32_t>(std::floor(corner.x / map::kCell_m)),
                      static_cast<std::int32_t>(std::floor(corner.y / map::kCell_m))};
  const Box2 near = scene::box_of(house.header, house.chunk.tile).widened(scene::kHalo_m);
  house.chunk.heights = map::window_of(chunk.heights, near);
  house.chunk.buildings = {building};
  house.chunk.buildings.front().party_walls.clear();
  return house;
}

/// Buildings with rules, evenly spread over the map's order.
std::vector<House> houses_of(const scene::Scene& scene) {
  std::vector<std::pair<const scene::Chunk*, const buildings::Building*>> all;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const buildings::Building& building : chunk.buildings)
      if (building.style != buildings::Style::kPlain && building.stands_on_ground) all.emplace_back(&chunk, &building);
  std::vector<House> some;
  const std::size_t count = std::min(kHouses, all.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [chunk, building] = all[i * all.size() / count];
    some.push_back(alone(scene.header, *chunk, *building));
  }
  return some;
}

bake::BakedTile baked(const House& house, double tolerance_m, int threads) {
  Report ignored;
  return bake::bake(house.header, house.chunk, tolerance_m, threads, ignored);
}

struct Wall {
  Vec2 middle, along, out;  ///< `along` and `out` have length 1.
};

/// The first wall that faces a street, or the first wall.
Wall front_of(const buildings::Building& building) {
  const Ring& ring = building.footprint.outer;
  std::size_t front = 0;
  for (std::size_t i = 0; i < building.facade_edges.size(); ++i)
    if (building.facade_edges[i].faces_street && !building.facade_edges[front].faces_street) front = i;
  const Vec2 from = ring[front], to = ring[(front + 1) % ring.size()], along = unit(to - from);
  return {(from + to) * 0.5, along, left_of(along) * -1};
}

/// A camera in front of the wall, slightly above the ground.
preview::Camera camera_before(const buildings::Building& building, double away_m, int pixels) {
  const auto [middle, along, out] = front_of(building);
  const double height_m = (building.floor_m + building.top_m) / 2;
  // slightly from the side, so that reveals and balconies show
  const Vec2 eye = middle + out * away_m + along * (0.2 * away_m);
  constexpr double kDegrees = 57.29577951308232;
  return {at_height(eye, height_m), at_height(middle, height_m),
          2 * kDegrees * std::atan(pixels / 2.0 / kChartFocal_px)};
}

/// A sun 20 degrees high and close to the wall's plane, so that reveals cast long shadows.
sky::Sky sun_along(const buildings::Building& building, sky::Sky sky) {
  const Wall front = front_of(building);
  sky.to_sun = unit(at_height(front.along * 0.8 + front.out * 0.6, 0.364));
  return sky;
}

preview::Image facade_picture(const bake::BakedTile& tile, const sky::Sky& sky, const preview::Camera& camera,
                              int pixels, std::uint64_t seed) {
  preview::Options options;
  options.width = options.height = pixels;
  options.samples = std::max(kFewestFacadeSamples, kFacadeSamples / (pixels * pixels));
  options.bounces = 2, options.seed = seed;
  return preview::render(std::span(&tile, 1), sky, camera, options);
}

struct Costs {
  double triangles = 0, bytes = 0, ms = 0, error = 0, error_by_low_sun = 0, noise = 0, error_at_100_m = 0,
         noise_at_100_m = 0, brightness = 0;
};

double triangles_in_tile(const bake::BakedTile& tile) {
  double sum = 0;
  for (const bake::Primitive& primitive : tile.primitives) sum += static_cast<double>(primitive.triangles.size());
  return sum;
}

/// Adds the building's share of its tile.
void add_house_costs(const House& house, double tolerance_m, int threads, Costs& costs) {
  House empty = house;
  empty.chunk.buildings.clear();
  const Stopwatch of_bare;
  const bake::BakedTile bare = baked(empty, tolerance_m, threads);
  const double bare_s = of_bare.seconds();
  const Stopwatch of_tile;
  const bake::BakedTile tile = baked(house, tolerance_m, threads);
  costs.ms += 1000 * (of_tile.seconds() - bare_s);
  costs.triangles += triangles_in_tile(tile) - triangles_in_tile(bare);
  const auto bytes = [&](const bake::BakedTile& t) {
    return static_cast<double>(exporters::encode_glb(t, house.header, {}).size());
  };
  costs.bytes += bytes(tile) - bytes(bare);
}

void add_picture_error(const House& house, const bake::BakedTile& finest, double tolerance_m, int threads,
                       Costs& costs) {
  const sky::Sky& sky = house.header.sky;
  const int pixels = pixels_at(tolerance_m);
  const preview::Camera camera = camera_before(house.chunk.buildings.front(), kChartFocal_px * tolerance_m, pixels);
  const preview::Image truth = facade_picture(finest, sky, camera, pixels, 1);
  costs.noise += difference(truth, facade_picture(finest, sky, camera, pixels, 2));
  const bake::BakedTile tile = baked(house, tolerance_m, threads);
  const preview::Image picture = facade_picture(tile, sky, camera, pixels, 2);
  costs.error += difference(truth, picture);
  costs.brightness += luminance_difference(picture, truth).ratio;
  const sky::Sky low = sun_along(house.chunk.buildings.front(), sky);
  costs.error_by_low_sun +=
      difference(facade_picture(finest, low, camera, pixels, 1), facade_picture(tile, low, camera, pixels, 2));
}

preview::Image picture_from_100_m(const House& house, const bake::BakedTile& tile, std::uint64_t seed) {
  const preview::Camera camera = camera_before(house.chunk.buildings.front(), kPictureDistance_m, kPictureSize_px);
  return facade_picture(tile, house.header.sky, camera, kPictureSize_px, seed);
}

/// The reference pictures of a building.
struct Finest {
  bake::BakedTile tile;
  preview::Image across_the_square;
  double noise = 0;  ///< The noise of the reference picture.
};

Finest finest_of(const House& house, int threads) {
  Finest finest{baked(house, kFinestFacade_m, threads), {}};
  finest.across_the_square = picture_from_100_m(house, finest.tile, 1);
  finest.noise = difference(finest.across_the_square, picture_from_100_m(house, finest.tile, 2));
  return finest;
}

void add_error_across_the_square(const House& house, const Finest& finest, double tolerance_m, int threads,
                                 Costs& costs) {
  const bake::BakedTile tile = baked(house, tolerance_m, threads);
  costs.noise_at_100_m += finest.noise;
  costs.error_at_100_m += difference(finest.across_the_square, picture_from_100_m(house, tile, 2));
}

std::vector<Chart> empty_facade_charts(std::size_t houses) {
  std::vector<Chart> charts(4);
  for (Chart& chart : charts) chart.x.label = "tolerance (m)", chart.x.is_logarithmic = true;
  charts[0].name = "facade_costs", charts[0].title = fmt::format("A house, mean of {}", houses);
  charts[0].y.label = "triangles; bytes of .glb; microseconds", charts[0].y.is_logarithmic = true;
  charts[0].series = {{"triangles", {}}, {"bytes", {}}, {"microseconds", {}}};
  charts[1].name = "facade_picture";
  charts[1].title = "Error of the picture from where the tolerance is one pixel";
  charts[1].y.label = "mean difference (share of white)";
  charts[1].series = {{"against 0.01 m", {}}, {"noise: 0.01 m twice", {}}, {"by low sun along the wall", {}}};
  charts[2].name = "facade_picture_100_m";
  charts[2].title = "Error of the picture from 100 m";
  charts[2].y.label = charts[1].y.label;
  charts[2].series = {{"against 0.01 m", {}}, {"noise: 0.01 m twice", {}}};
  charts[3].name = "facade_brightness", charts[3].title = "Brightness from where the tolerance is one pixel";
  charts[3].y.label = "share of that at 0.01 m";
  charts[3].series = {{"mean of the picture", {}}};
  return charts;
}

void add_points(double tolerance_m, const Costs& costs, double houses, std::vector<Chart>& charts) {
  charts[0].series[0].points.emplace_back(tolerance_m, costs.triangles / houses);
  charts[0].series[1].points.emplace_back(tolerance_m, costs.bytes / houses);
  charts[0].series[2].points.emplace_back(tolerance_m, 1000 * costs.ms / houses);
  charts[1].series[0].points.emplace_back(tolerance_m, costs.error / houses);
  charts[1].series[1].points.emplace_back(tolerance_m, costs.noise / houses);
  charts[1].series[2].points.emplace_back(tolerance_m, costs.error_by_low_sun / houses);
  charts[2].series[0].points.emplace_back(tolerance_m, costs.error_at_100_m / houses);
  charts[2].series[1].points.emplace_back(tolerance_m, costs.noise_at_100_m / houses);
  charts[3].series[0].points.emplace_back(tolerance_m, costs.brightness / houses);
}

}  // namespace

Result<std::vector<Chart>> chart_facade(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  const std::vector<House> houses = houses_of(*scene);
  if (houses.empty()) return Error{request.maps.front(), "has no buildings with rules"};
  std::vector<Chart> charts = empty_facade_charts(houses.size());
  std::vector<Finest> finest;
  for (const House& house : houses) finest.push_back(finest_of(house, request.threads));
  for (const double tolerance_m : kFacadeTolerances_m) {
    Costs costs;
    for (std::size_t i = 0; i < houses.size(); ++i) {
      add_house_costs(houses[i], tolerance_m, request.threads, costs);
      add_picture_error(houses[i], finest[i].tile, tolerance_m, request.threads, costs);
      add_error_across_the_square(houses[i], finest[i], tolerance_m, request.threads, costs);
    }
    add_points(tolerance_m, costs, static_cast<double>(houses.size()), charts);
  }
  return charts;
}

}  // namespace citykiln::charts
