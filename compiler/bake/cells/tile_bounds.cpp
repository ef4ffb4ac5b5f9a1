#include "compiler/bake/cells/tile_bounds.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/cells/bake_cell.h"
#include "compiler/map/locate.h"

namespace citykiln::bake {
namespace {

// So long that every object has the finest tolerance, whatever its distance.
constexpr double kLongest_px = 0x1p60;

ViewLevels uniform_levels(const Box2& box, double tolerance_m) {
  const auto cells_along = [](double length_m) { return static_cast<int>(std::lround(length_m / map::kCell_m)); };
  ViewLevels levels{.view = {.eye = {}, .focal_px = kLongest_px, .finest_m = tolerance_m},
                    .extent = box,
                    .columns = cells_along(box.width()),
                    .rows = cells_along(box.height()),
                    .finest = 0};
  levels.cells.assign(static_cast<std::size_t>(levels.columns) * static_cast<std::size_t>(levels.rows), 0);
  return levels;
}

}  // namespace

Bounds tile_bounds(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m) {
  const ViewLevels levels = uniform_levels(scene::box_of(header, chunk.tile), tolerance_m);
  const std::vector<Bounds> cells = cell_bounds(header, chunk, levels);
  Bounds all = cells.front();
  for (const Bounds& cell : cells) {
    all.plan.grow(cell.plan.min), all.plan.grow(cell.plan.max);
    all.low_m = std::min(all.low_m, cell.low_m), all.high_m = std::max(all.high_m, cell.high_m);
  }
  return all;
}

}  // namespace citykiln::bake
