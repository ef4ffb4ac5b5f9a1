#include "compiler/bake/view/view_levels.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/bake/ground/skirt.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/map/locate.h"
#include "compiler/plants/generate.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {
namespace {

constexpr double kFar_m = std::numeric_limits<double>::infinity();

Bounds ground_bounds(const map::Heightfield& terrain, const Box2& box) {
  Bounds bounds = bounds_of(terrain, box);
  bounds.low_m -= kGraded_m, bounds.high_m += kGraded_m;
  return bounds;
}

// The bounds of a thing or lamp before the ground below it is known.
Bounds standing_bounds(const map::Heightfield& terrain, Vec2 at, double half_m, double height_m) {
  Bounds bounds = ground_bounds(terrain, Box2{at, at}.widened(half_m));
  bounds.high_m += height_m;
  return bounds;
}

// The level of the cell at a place; kNoLevel outside the extent.
int level_at(const ViewLevels& levels, Vec2 within) {
  const int column = static_cast<int>(std::floor((within.x - levels.extent.min.x) / map::kCell_m)),
            row = static_cast<int>(std::floor((within.y - levels.extent.min.y) / map::kCell_m));
  if (column < 0 || column >= levels.columns || row < 0 || row >= levels.rows) return kNoLevel;
  return levels.cells[static_cast<std::size_t>(column) * levels.rows + row];
}

bool has_road_surfaces(const View& view, int level) {
  return has_detail(Detail::kRoadSurfaces, tolerance_m_of(view, level));
}

ViewCell view_cell(const ViewLevels& levels, const Box2& cell) {
  const View& view = levels.view;
  const Vec2 centre = cell.centre();
  const int own = level_at(levels, centre);
  ViewCell seen{{cell, tolerance_m_of(view, own), {}}, own, {{-kFar_m, -kFar_m}, {kFar_m, kFar_m}}, 0};
  int coarsest = own;
  // returns the side's tolerance; a skirt hangs where the neighbour's roads are made differently
  const auto side = [&](Vec2 towards, double& skirt, double at) {
    const int other = level_at(levels, centre + towards * map::kCell_m);
    if (other != kNoLevel && own != kNoLevel && has_road_surfaces(view, own) != has_road_surfaces(view, other))
      skirt = at, coarsest = std::max(coarsest, other);
    return tolerance_m_of(view, std::min(own, other));
  };
  seen.level.sides_m = {side({-1, 0}, seen.skirt.min.x, cell.min.x), side({1, 0}, seen.skirt.max.x, cell.max.x),
                        side({0, -1}, seen.skirt.min.y, cell.min.y), side({0, 1}, seen.skirt.max.y, cell.max.y)};
  seen.skirt_m = kSkirtDepthTolerances * tolerance_m_of(view, coarsest);
  return seen;
}

// A level that is fine enough for every object of a tile.
int finest_needed(const View& view, const scene::Chunk& chunk, const Box2& box) {
  Bounds low = ground_bounds(chunk.heights, box.widened(scene::kHalo_m));
  low.high_m += plants::kTallestPlant_m;
  int finest = level_for(view, low);
  const auto need = [&](const Bounds& bounds) { finest = std::min(finest, level_for(view, bounds)); };
  for_each_bounded(chunk, [&](const auto&, const Bounds& bounds) { need(bounds); });
  for (const things::Thing& thing : chunk.things) {
    Bounds bounds = standing_bounds(chunk.heights, thing.at, length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2,
                                    thing.form.height_m);
    if (thing.foot_m) bounds.high_m = std::max(bounds.high_m, *thing.foot_m + thing.form.height_m);
    need(bounds);
  }
  // low.high_m allows for others
  for (const props::Lamp& lamp : chunk.lamps)
    if (lamp.height_m > plants::kTallestPlant_m)
      need(standing_bounds(chunk.heights, lamp.at, plants::kCrownReach * lamp.height_m, lamp.height_m));
  return finest;
}

}  // namespace

ViewLevels levels_for(const scene::Scene& scene, const View& view) {
  assert(view.focal_px > 0 && view.pixel_error > 0 && view.finest_m > 0);
  const Box2& extent = scene.header.extent;
  ViewLevels levels{.view = view,
                    .extent = extent,
                    .columns = static_cast<int>(extent.width() / map::kCell_m),
                    .rows = static_cast<int>(extent.height() / map::kCell_m)};
  levels.cells.assign(static_cast<std::size_t>(levels.columns) * levels.rows, kNoLevel);
  for (const scene::Chunk& chunk : scene.chunks)
    for (const Box2& cell : cells_of(scene::box_of(scene.header, chunk.tile))) {
      const int level = level_for(view, ground_bounds(chunk.heights, cell));
      const auto column = static_cast<std::size_t>((cell.min.x - extent.min.x) / map::kCell_m),
                 row = static_cast<std::size_t>((cell.min.y - extent.min.y) / map::kCell_m);
      levels.cells[column * static_cast<std::size_t>(levels.rows) + row] = level;
      levels.finest = std::min(levels.finest, level);
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
  for (const bool has_roads : {true, false}) {
    ViewZone zone;
    for (const ViewCell& cell : cells_of(levels, tile)) {
      if (has_road_surfaces(levels.view, cell.number) != has_roads) continue;
      if (zone.cells.empty()) zone.roads_m = roads_tolerance_m(levels, cell.number);
      zone.cells.push_back(cell.level);
    }
    if (!zone.cells.empty()) zones.push_back(std::move(zone));
  }
  return zones;
}

std::vector<int> levels_of_parts(const ViewLevels& levels, const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  std::vector<int> parts{finest_needed(levels.view, chunk, box)};
  for (const ViewCell& cell : cells_of(levels, box)) parts.push_back(cell.number);
  sort_unique(parts);
  return parts;
}

std::size_t part_at(const std::vector<int>& of_tile, int level) {
  assert(!of_tile.empty());
  const auto coarser = std::ranges::upper_bound(of_tile, level) - of_tile.begin();
  return coarser == 0 ? 0 : static_cast<std::size_t>(coarser - 1);
}

bool is_in_part(const TilePart& part, const Bounds& bounds) {
  return part.level == part.of_tile[part_at(part.of_tile, level_for(part.levels.view, bounds))];
}

double roads_tolerance_m(const ViewLevels& levels, int level) {
  return tolerance_m_of(levels.view, has_road_surfaces(levels.view, level) ? levels.finest : level);
}

}  // namespace citykiln::bake
