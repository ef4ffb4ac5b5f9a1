#include "compiler/bake/view_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/bake/skirt.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/locate.h"
#include "compiler/plants/generate.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {
namespace {

constexpr double kNone_m = std::numeric_limits<double>::infinity();

// Cuts and banks meet the terrain within 16 m; what they differ from it there is hardly ever more.
constexpr double kCarved_m = 16;

Bounds ground_bounds(const map::Heightfield& terrain, const Box2& box) {
  Bounds bounds = bounds_of(terrain, box);
  bounds.low_m -= kCarved_m, bounds.high_m += kCarved_m;
  return bounds;
}

// Outside the region, or in no tile of the scene: infinity.
double cell_m(const ViewLevels& levels, Vec2 within) {
  const int column = static_cast<int>(std::floor((within.x - levels.region.min.x) / map::kCell_m)),
            row = static_cast<int>(std::floor((within.y - levels.region.min.y) / map::kCell_m));
  if (column < 0 || column >= levels.columns || row < 0 || row >= levels.rows) return kNone_m;
  return levels.cells_m[static_cast<std::size_t>(column) * levels.rows + row];
}

// Whether two cells see roads alike.
bool are_alike(double a_m, double b_m) {
  return has_detail(Detail::kRoadSurfaces, a_m) == has_detail(Detail::kRoadSurfaces, b_m) || std::isinf(a_m) ||
         std::isinf(b_m);
}

// A cell's tolerance and those of the cells around it.
struct Neighbours {
  double own_m;
  ground::SideTolerances around_m;
};

Neighbours neighbours_of(const ViewLevels& levels, const Box2& cell) {
  constexpr Vec2 kEast{map::kCell_m, 0}, kNorth{0, map::kCell_m};
  const Vec2 p = cell.centre();
  return {
      cell_m(levels, p),
      {cell_m(levels, p - kEast), cell_m(levels, p + kEast), cell_m(levels, p - kNorth), cell_m(levels, p + kNorth)}};
}

ground::SideTolerances smaller(const Neighbours& n) {
  const ground::SideTolerances& a = n.around_m;
  return {std::min(n.own_m, a.west_m), std::min(n.own_m, a.east_m), std::min(n.own_m, a.south_m),
          std::min(n.own_m, a.north_m)};
}

ViewCell view_cell(const ViewLevels& levels, const Box2& cell) {
  const Neighbours n = neighbours_of(levels, cell);
  ViewCell seen{{cell, n.own_m, smaller(n)}, {{-kNone_m, -kNone_m}, {kNone_m, kNone_m}}, 0};
  double coarsest_m = n.own_m;
  const auto hang = [&](double other_m, double& side, double at) {
    if (are_alike(n.own_m, other_m)) return;
    side = at, coarsest_m = std::max(coarsest_m, other_m);
  };
  hang(n.around_m.west_m, seen.skirt.min.x, cell.min.x), hang(n.around_m.east_m, seen.skirt.max.x, cell.max.x);
  hang(n.around_m.south_m, seen.skirt.min.y, cell.min.y), hang(n.around_m.north_m, seen.skirt.max.y, cell.max.y);
  seen.skirt_m = kSkirtDepthTolerances * coarsest_m;
  return seen;
}

// Fine enough for all that stands in a tile or is part of it.
double finest_needed_m(const View& view, const scene::Chunk& chunk, const Box2& box) {
  Bounds low = ground_bounds(chunk.heights, box.widened(scene::kHalo_m));
  low.high_m += plants::kTallestPlant_m;
  double finest_m = tolerance_m_for(view, low);
  const auto need = [&](const Bounds& bounds) { finest_m = std::min(finest_m, tolerance_m_for(view, bounds)); };
  for (const auto& building : chunk.buildings) need(bounds_of(building));
  for (const auto& barrier : chunk.barriers) need(bounds_of(barrier, chunk.heights));
  for (const auto* spans : {&chunk.bridges, &chunk.tunnels})
    for (const structures::Span& span : *spans) need(bounds_of(span));
  return finest_m;
}

}  // namespace

double focal_length_px(int height_px, double vertical_fov_deg) {
  return snapped(height_px / 2.0 / tangent(vertical_fov_deg / 2));
}

double tolerance_m_for(const View& view, const Bounds& bounds) {
  const double most_m = view.pixel_error * distance_m(bounds, view.eye) / view.focal_px;
  double tolerance_m = view.finest_m;
  while (2 * tolerance_m <= most_m) tolerance_m *= 2;
  return tolerance_m;
}

double pixels_of(const View& view, double error_m, const Bounds& bounds) {
  const double away_m = distance_m(bounds, view.eye);
  if (view.pixel_error * away_m < view.finest_m * view.focal_px) return 0;
  return error_m / away_m * view.focal_px;
}

ViewLevels levels_for(const scene::Scene& scene, const View& view) {
  const Box2& region = scene.header.region;
  ViewLevels levels{
      view, region, static_cast<int>(region.width() / map::kCell_m), static_cast<int>(region.height() / map::kCell_m),
      {},   kNone_m};
  levels.cells_m.assign(static_cast<std::size_t>(levels.columns) * levels.rows, kNone_m);
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Box2& cell : cells_of(scene::box_of(scene.header, chunk.tile))) {
      const double here_m = tolerance_m_for(view, ground_bounds(chunk.heights, cell));
      const auto column = static_cast<std::size_t>((cell.min.x - region.min.x) / map::kCell_m),
                 row = static_cast<std::size_t>((cell.min.y - region.min.y) / map::kCell_m);
      levels.cells_m[column * static_cast<std::size_t>(levels.rows) + row] = here_m;
      levels.finest_m = std::min(levels.finest_m, here_m);
    }
  return levels;
}

std::vector<ViewCell> cells_of(const ViewLevels& levels, const Box2& tile) {
  std::vector<ViewCell> cells;
  for (const Box2& cell : cells_of(tile)) cells.push_back(view_cell(levels, cell));
  return cells;
}

std::vector<ViewZone> zones_of(const ViewLevels& levels, const Box2& tile) {
  std::vector<ViewZone> zones;
  for (const bool sees_kerbs : {true, false}) {
    ViewZone zone;
    for (const ViewCell& cell : cells_of(levels, tile))
      if (has_detail(Detail::kRoadSurfaces, cell.level.tolerance_m) == sees_kerbs) zone.cells.push_back(cell.level);
    if (zone.cells.empty()) continue;
    zone.roads_m = roads_tolerance_m(levels, zone.cells.front().tolerance_m);
    zones.push_back(std::move(zone));
  }
  return zones;
}

std::vector<double> tolerances_of(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  std::vector<double> tolerances{finest_needed_m(levels.view, chunk, box)};
  for (const ViewCell& cell : cells_of(levels, box)) tolerances.push_back(cell.level.tolerance_m);
  std::ranges::sort(tolerances);
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  return tolerances;
}

bool is_in(const TilePart& part, const Bounds& bounds) {
  const double own_m = tolerance_m_for(part.levels.view, bounds);
  const auto finer = std::ranges::upper_bound(part.tolerances_m, own_m);
  return part.tolerance_m == (finer == part.tolerances_m.begin() ? *finer : *std::prev(finer));
}

double roads_tolerance_m(const ViewLevels& levels, double tolerance_m) {
  return has_detail(Detail::kRoadSurfaces, tolerance_m) ? levels.finest_m : tolerance_m;
}

}  // namespace citykiln::bake
