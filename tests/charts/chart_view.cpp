// Triangles of the ground over the error on one viewer's picture, with tolerances chosen by distance and with one
// tolerance everywhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/view/view_levels.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/spec.h"
#include "tests/charts/chart.h"
#include "tests/charts/rtin.h"

namespace citykiln::charts {
namespace {

/// Requested errors, in pixels of a picture with the preview's size and field of view.
constexpr double kPixels[] = {0.5, 1, 2, 4, 8, 16};
constexpr double kViewFov_deg = 45;
constexpr int kViewHeight_px = 720;

/// Height of the default viewer above the middle of the map.
constexpr double kHeightAbove_m = 100;

/// The number of all faces, vertical ones included.
double triangles_in_cells(const scene::Scene& scene, const scene::Chunk& chunk, double roads_m,
                          std::span<const bake::CellLevel> cells, int threads) {
  Report ignored;
  const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, roads_m);
  const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, roads_m);
  double triangles = 0;
  for (const ground::GroundMesh& cell : bake::generate_cells(graded, cover.surfaces, cells, threads, ignored))
    triangles += static_cast<double>(cell.mesh.triangles.size());
  return triangles;
}

double triangles_seen(const scene::Scene& scene, const bake::View& view, int threads) {
  const bake::ViewLevels levels = bake::levels_for(scene, view);
  double triangles = 0;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const bake::ViewZone& zone : bake::zones_of(levels, scene::box_of(scene.header, chunk.tile)))
      triangles += triangles_in_cells(scene, chunk, zone.roads_m, zone.cells, threads);
  return triangles;
}

double triangles_everywhere(const scene::Scene& scene, double tolerance_m, int threads) {
  double triangles = 0;
  for (const scene::Chunk& chunk : scene.chunks) {
    std::vector<bake::CellLevel> cells;
    for (const Box2& cell : bake::cells_of(scene::box_of(scene.header, chunk.tile)))
      cells.push_back({cell, tolerance_m, ground::all_sides(tolerance_m)});
    triangles += triangles_in_cells(scene, chunk, tolerance_m, cells, threads);
  }
  return triangles;
}

Vec3 over_the_middle(const scene::Scene& scene) {
  const Vec2 middle = scene.header.extent.centre();
  for (const scene::Chunk& chunk : scene.chunks)
    if (chunk.heights.box().contains(middle))
      return at_height(middle, map::height_m_at(chunk.heights, middle) + kHeightAbove_m);
  return at_height(middle, kHeightAbove_m);
}

/// The error on the picture, in pixels, of a deviation by the tolerance at the nearest ground.
double pixels_at_nearest(const scene::Scene& scene, const bake::View& view, double tolerance_m) {
  double away_m = 1e9;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Box2& cell : bake::cells_of(scene::box_of(scene.header, chunk.tile)))
      away_m = std::min(away_m, bake::distance_m(bake::bounds_of(chunk.heights, cell), view.eye));
  return tolerance_m / std::max(away_m, 1.0) * view.focal_px;
}

double seen_height_m(const scene::Scene& scene, Vec2 place) {
  for (const scene::Chunk& chunk : scene.chunks)
    if (chunk.heights.box().contains(place)) return map::height_m_at(chunk.heights, place);
  return 0;
}

/// The scene's heights without roads, in steps of about 8 m.
HeightSquare square_of_heights(const scene::Scene& scene) {
  const Box2& extent = scene.header.extent;
  const double side_m = std::max(extent.width(), extent.height());
  HeightSquare square{std::clamp(static_cast<int>(std::lround(std::log2(side_m / 8))), 4, 12), 0, {}};
  square.step_m = side_m / (1 << square.power);
  for (int row = 0; row < square.samples_per_side(); ++row)
    for (int column = 0; column < square.samples_per_side(); ++column)
      square.heights_m.push_back(seen_height_m(scene, {std::min(extent.min.x + column * square.step_m, extent.max.x),
                                                       std::min(extent.min.y + row * square.step_m, extent.max.y)}));
  return square;
}

double rtin_seen(const scene::Scene& scene, const HeightSquare& square, const bake::View& view) {
  const Vec2 corner = scene.header.extent.min;
  return static_cast<double>(rtin_triangle_count(square, [&](Vec2 sample) {
    const auto i = static_cast<int>(sample.x), j = static_cast<int>(sample.y);
    const Vec3 place = at_height(corner + sample * square.step_m, square.at(i, j));
    return std::max(1.0, length(place - view.eye)) * view.pixel_error / view.focal_px;
  }));
}

}  // namespace

Result<std::vector<Chart>> chart_view(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  bake::View view{request.eye.value_or(over_the_middle(*scene)), bake::focal_length_px(kViewHeight_px, kViewFov_deg)};
  Chart chart{
      "view_triangles",
      fmt::format("Triangles of the ground for one eye at {:.0f}, {:.0f}, {:.0f} m: {:.0f} km²", view.eye.x, view.eye.y,
                  view.eye.z, scene->header.extent.width() * scene->header.extent.height() * 1e-6),
      {"largest error on the picture (pixels)", true},
      {"triangles", true},
      {{"a tolerance a cell, by its distance", {}}, {"one tolerance everywhere", {}}, {"RTIN of the heights", {}}}};
  const HeightSquare square = square_of_heights(*scene);
  for (const double pixels : kPixels) {
    view.pixel_error = pixels;
    chart.series[0].points.emplace_back(pixels, triangles_seen(*scene, view, request.threads));
    chart.series[2].points.emplace_back(pixels, rtin_seen(*scene, square, view));
  }
  for (const double tolerance_m : Outputs{}.tolerances_m)
    chart.series[1].points.emplace_back(pixels_at_nearest(*scene, view, tolerance_m),
                                        triangles_everywhere(*scene, tolerance_m, request.threads));
  return std::vector{chart};
}

}  // namespace citykiln::charts
