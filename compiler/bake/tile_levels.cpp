#include "compiler/bake/tile_levels.h"

#include <algorithm>
#include <array>

#include "compiler/bake/skirt.h"

namespace citykiln::bake {
namespace {

Lamps place_lamps(const scene::Chunk& chunk, const ground::LandCoverIndex& map, const Box2& box) {
  Lamps lamps{props::mapped_lamps(chunk.lamps, chunk.roads), chunk.lamps.size()};
  const std::vector<props::StreetLamp> derived = props::lamps_of_streets(chunk.roads, chunk.lamps, map, box);
  lamps.standing.insert(lamps.standing.end(), derived.begin(), derived.end());
  return lamps;
}

// As far as they stand on the ground that the tile knows.
void add_hedges(const scene::Chunk& chunk, const plants::PlacingContext& land, plants::PlacedPlants& placed) {
  for (const props::Barrier& barrier : chunk.barriers)
    if (barrier.kind == map::BarrierKind::kHedge)
      plants::add_hedge({barrier.axis, barrier.height_m, barrier.id.osm}, land, placed);
}

std::vector<Placement> joined(const plants::PlacedPlants& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, placements] : placed) all.insert(all.end(), placements.begin(), placements.end());
  return all;
}

// What levels ask for that not all do.
struct Wanted {
  bool blades = false, hedge_plants = false;
  std::vector<double> canopies_m{};
};

SharedByLevels common_at(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m,
                         const Wanted& wanted) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(chunk);
  const ground::LandCoverIndex map = ground::index_land_cover(surfaces, box.widened(scene::kHalo_m));
  SharedByLevels common{
      scene::graded_terrain_of(header, chunk, tolerance_m), {}, {}, {}, {}, place_lamps(chunk, map, box), {}, {}};
  const plants::PlacingContext land{map, common.graded, box, header.seed, header.origin.lat_deg};
  common.trees = plants::generate({chunk.trees, chunk.woods, chunk.plantings, chunk.tree_rows, chunk.corridors}, land,
                                  common.tree_report);
  common.pits = props::tree_pits(joined(common.trees), chunk.roads, map);
  if (wanted.hedge_plants) add_hedges(chunk, land, common.trees);
  if (wanted.blades) common.blades = plants::generate_blades(chunk.plantings, land);
  for (const double canopy_m : wanted.canopies_m)
    common.canopies[canopy_m] = plants::make_canopy(chunk.woods, chunk.corridors, land, canopy_m, month_of(header));
  for (const roads::Road& road : chunk.roads)
    if (road.surface == map::LandCoverClass::kSteps)
      common.stairs.push_back(structures::stairs_on(road, map, common.graded, box));
  std::erase_if(common.stairs, [](const structures::Stairs& stairs) { return stairs.mesh.triangles.empty(); });
  return common;
}

bool has_canopy(double tolerance_m) { return has_detail(Detail::kWoodCanopies, tolerance_m); }

// What the tile's levels with and without Detail::kRoadSurfaces have in common, each made when it is first asked for.
struct Commons {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::span<const double> tolerances_m;
  bool is_view = false;
  std::array<std::shared_ptr<const SharedByLevels>, 2> made{};

  std::shared_ptr<const SharedByLevels> at(double tolerance_m) {
    std::shared_ptr<const SharedByLevels>& common = made[has_detail(Detail::kRoadSurfaces, tolerance_m) ? 0 : 1];
    const bool is_fine = has_detail(Detail::kRoadSurfaces, tolerance_m);
    Wanted wanted{is_fine && has_detail(Detail::kGrassBlades, std::ranges::min(tolerances_m)),
                  is_view || has_hedge_plants(tolerance_m)};
    if (!is_fine && !is_view) std::ranges::copy_if(tolerances_m, std::back_inserter(wanted.canopies_m), has_canopy);
    if (!common) common = std::make_shared<SharedByLevels>(common_at(header, chunk, tolerance_m, wanted));
    return common;
  }
};

// All cells of a tile at one tolerance have skirts along the tile's border.
std::vector<ViewCell> cells_at(const Box2& tile, double tolerance_m) {
  std::vector<ViewCell> cells;
  for (const Box2& cell : cells_of(tile))
    cells.push_back({{cell, tolerance_m, ground::all_sides(tolerance_m)}, tile, kSkirtDepthTolerances * tolerance_m});
  return cells;
}

// All but the cells.
std::vector<TileLevel> bare_levels(const scene::Header& header, const scene::Chunk& chunk,
                                   std::span<const double> ladder_m) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk, ladder_m};
  std::vector<TileLevel> levels;
  for (const double tolerance_m : ladder_m)
    levels.push_back({tolerance_m, commons.at(tolerance_m), scene::land_cover_of(header, chunk, tolerance_m),
                      cells_at(box, tolerance_m)});
  return levels;
}

void generate_grounds(std::span<TileLevel> levels, const Box2& box, int threads) {
  std::vector<GroundLevel> grounds;
  for (const TileLevel& level : levels)
    grounds.push_back({level.common->graded, level.cover.surfaces, level.tolerance_m});
  std::vector<Report> reports(levels.size());
  std::vector<std::vector<ground::GroundMesh>> cells = generate_cells(grounds, box, threads, reports);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].cells = std::move(cells[i]), levels[i].cell_report = std::move(reports[i]);
}

// The cells of a tile that a view asks for at a tolerance.
std::vector<ViewCell> cells_of_view(const ViewLevels& view, const Box2& tile, double tolerance_m) {
  std::vector<ViewCell> cells = cells_of(view, tile);
  std::erase_if(cells, [&](const ViewCell& cell) { return cell.level.tolerance_m != tolerance_m; });
  return cells;
}

}  // namespace

std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> ladder_m, int threads) {
  std::vector<TileLevel> levels = bare_levels(header, chunk, ladder_m);
  generate_grounds(levels, scene::box_of(header, chunk.tile), threads);
  return levels;
}

std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const double> tolerances_m, int threads) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Commons commons{header, chunk, tolerances_m, true};
  std::vector<TileLevel> levels;
  for (const double tolerance_m : tolerances_m) {
    TileLevel& level =
        levels.emplace_back(TileLevel{tolerance_m, commons.at(tolerance_m), {}, cells_of_view(view, box, tolerance_m)});
    if (level.seen.empty()) continue;
    level.cover = scene::land_cover_of(header, chunk, roads_tolerance_m(view, tolerance_m));
    std::vector<CellLevel> cells;
    for (const ViewCell& cell : level.seen) cells.push_back(cell.level);
    level.cells = generate_cells(level.common->graded, level.cover.surfaces, cells, threads, level.cell_report);
  }
  return levels;
}

}  // namespace citykiln::bake
