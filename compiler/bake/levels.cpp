#include "compiler/bake/levels.h"

#include <algorithm>
#include <array>

#include "compiler/bake/skirt.h"

namespace citykiln::bake {
namespace {

Lamps place_lamps(const scene::Chunk& chunk, const ground::SurfaceMap& map, const Box2& box) {
  Lamps lamps{props::mapped_lamps(chunk.lamps, chunk.roads), chunk.lamps.size()};
  const std::vector<props::StreetLamp> derived = props::lamps_of_streets(chunk.roads, chunk.lamps, map, box);
  lamps.standing.insert(lamps.standing.end(), derived.begin(), derived.end());
  return lamps;
}

// As far as they stand on the ground that the tile knows.
void add_hedges(const scene::Chunk& chunk, const plants::Land& land, plants::Placed& placed) {
  for (const props::Barrier& barrier : chunk.barriers)
    if (barrier.kind == map::BarrierKind::kHedge)
      plants::add_hedge({barrier.axis, barrier.height_m, barrier.id.osm}, land, placed);
}

std::vector<Placement> joined(const plants::Placed& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, placements] : placed) all.insert(all.end(), placements.begin(), placements.end());
  return all;
}

// What levels ask for that not all do.
struct Wanted {
  bool blades = false, hedge_plants = false;
  std::vector<double> canopies_m{};
};

Common common_at(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, const Wanted& wanted) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::Surface> surfaces = scene::surfaces_of(chunk);
  const ground::SurfaceMap map = ground::map_surfaces(surfaces, box.widened(scene::kHalo_m));
  Common common{scene::carving_of(header, chunk, tolerance_m), {}, {}, {}, {}, place_lamps(chunk, map, box), {}, {}};
  const plants::Land land{map, common.carving, box, header.seed, header.origin.lat_deg};
  common.trees =
      plants::expand({chunk.trees, chunk.woods, chunk.plantings, chunk.tree_rows, chunk.lanes}, land, common.of_trees);
  common.pits = props::tree_pits(joined(common.trees), chunk.roads, map);
  if (wanted.hedge_plants) add_hedges(chunk, land, common.trees);
  if (wanted.blades) common.blades = plants::expand_blades(chunk.plantings, land);
  for (const double canopy_m : wanted.canopies_m)
    common.canopies[canopy_m] = plants::canopy_over(chunk.woods, chunk.lanes, land, canopy_m, month_of(header));
  for (const roads::Road& road : chunk.roads)
    if (road.surface == map::SurfaceClass::kSteps)
      common.stairs.push_back(structures::stairs_on(road, map, common.carving, box));
  std::erase_if(common.stairs, [](const structures::Stairs& stairs) { return stairs.mesh.triangles.empty(); });
  return common;
}

bool has_canopy(double tolerance_m) { return tolerance_m >= plants::kCanopyFrom_m; }

// What the tile's levels on either side of kPlainRoads_m have in common, each made when it is first asked for.
struct Commons {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::span<const double> tolerances_m;
  bool is_view = false;
  std::array<std::shared_ptr<const Common>, 2> made{};

  std::shared_ptr<const Common> at(double tolerance_m) {
    std::shared_ptr<const Common>& common = made[tolerance_m < scene::kPlainRoads_m ? 0 : 1];
    const bool is_fine = tolerance_m < scene::kPlainRoads_m;
    Wanted wanted{is_fine && std::ranges::min(tolerances_m) <= plants::kBlades_m,
                  is_view || has_hedge_plants(tolerance_m)};
    if (!is_fine && !is_view) std::ranges::copy_if(tolerances_m, std::back_inserter(wanted.canopies_m), has_canopy);
    if (!common) common = std::make_shared<Common>(common_at(header, chunk, tolerance_m, wanted));
    return common;
  }
};

// All cells of a tile at one tolerance have skirts along the tile's border.
std::vector<SeenCell> cells_at(const Box2& tile, double tolerance_m) {
  std::vector<SeenCell> cells;
  for (const Box2& cell : cells_of(tile))
    cells.push_back({{cell, tolerance_m, ground::all_sides(tolerance_m)}, tile, kSkirt * tolerance_m});
  return cells;
}

// All but the cells.
std::vector<Level> bare_levels(const scene::Header& header, const scene::Chunk& chunk,
                               std::span<const double> ladder_m) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk, ladder_m};
  std::vector<Level> levels;
  for (const double tolerance_m : ladder_m)
    levels.push_back({tolerance_m, commons.at(tolerance_m), scene::cover_of(header, chunk, tolerance_m),
                      cells_at(box, tolerance_m)});
  return levels;
}

void expand_grounds(std::span<Level> levels, const Box2& box, int threads) {
  std::vector<GroundLevel> grounds;
  for (const Level& level : levels) grounds.push_back({level.common->carving, level.cover.surfaces, level.tolerance_m});
  std::vector<Report> reports(levels.size());
  std::vector<std::vector<ground::GroundMesh>> cells = expand_cells(grounds, box, threads, reports);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].cells = std::move(cells[i]), levels[i].of_cells = std::move(reports[i]);
}

// The cells of a tile that a view asks for at a tolerance.
std::vector<SeenCell> cells_seen(const ViewLevels& view, const Box2& tile, double tolerance_m) {
  std::vector<SeenCell> cells = cells_of(view, tile);
  std::erase_if(cells, [&](const SeenCell& cell) { return cell.level.tolerance_m != tolerance_m; });
  return cells;
}

}  // namespace

std::vector<Level> levels_of(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                             int threads) {
  std::vector<Level> levels = bare_levels(header, chunk, ladder_m);
  expand_grounds(levels, scene::box_of(header, chunk.tile), threads);
  return levels;
}

std::vector<Level> levels_seen(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                               std::span<const double> tolerances_m, int threads) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk, tolerances_m, true};
  std::vector<Level> levels;
  for (const double tolerance_m : tolerances_m) {
    Level& level =
        levels.emplace_back(Level{tolerance_m, commons.at(tolerance_m), {}, cells_seen(view, box, tolerance_m)});
    if (level.seen.empty()) continue;
    level.cover = scene::cover_of(header, chunk, roads_tolerance_m(view, tolerance_m));
    std::vector<CellLevel> cells;
    for (const SeenCell& cell : level.seen) cells.push_back(cell.level);
    level.cells = expand_cells(level.common->carving, level.cover.surfaces, cells, threads, level.of_cells);
  }
  return levels;
}

}  // namespace citykiln::bake
