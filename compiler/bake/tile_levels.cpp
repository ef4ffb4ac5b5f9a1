#include "compiler/bake/tile_levels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "compiler/bake/ground/ground_beyond.h"
#include "compiler/bake/ground/skirt.h"
#include "compiler/bake/place_generated.h"
#include "compiler/bake/place_people.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/plants/placing/placing_steps.h"

namespace citykiln::bake {
namespace {

// Adds the plants of hedges, where these stand on ground that the chunk holds.
void add_hedges(const scene::Chunk& chunk, const plants::PlacingContext& land, plants::PlacedPlants& placed) {
  for (const props::Barrier& barrier : chunk.barriers)
    if (barrier.kind == map::BarrierKind::kHedge)
      plants::place_hedge(placed, {barrier.axis, barrier.height_m, barrier.id.osm}, land);
}

std::vector<Placement> joined(const plants::PlacedPlants& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, placements] : placed) all.insert(all.end(), placements.begin(), placements.end());
  return all;
}

// Objects that only some levels need.
struct Wanted {
  bool blades = false, hedge_plants = false, people = false;
  WantedThings things = {};
  std::vector<double> canopies_m{};
};

// The people of a tile, who keep clear of its furniture also where a level does not show it.
std::vector<PlacedThing> people_of(const scene::Header& header, const scene::Chunk& chunk, const TileGround& ground,
                                   const Box2& box) {
  const std::vector<PlacedThing> furniture = place_generated(header, chunk, ground, box, {.furniture = true}).placed;
  return place_people(header, chunk, furniture, ground, box);
}

// The plants of a tile. Where they are left out, only the trunks that things keep clear of, and no findings.
plants::GeneratedPlants plants_of(const scene::Header& header, const scene::Chunk& chunk,
                                  std::span<const plants::Tree> trees, const plants::PlacingContext& land,
                                  Report& report) {
  if (shows(header, scene::SceneLayer::kPlants))
    return plants::generate({trees, chunk.woods, chunk.plantings, chunk.tree_rows, chunk.corridors}, land, report);
  if (!shows(header, scene::SceneLayer::kThings)) return {};
  Report left_out;
  plants::GeneratedPlants single = plants::generate({trees, {}, {}, chunk.tree_rows, {}}, land, left_out);
  single.placed.clear();
  return single;
}

// Leaves out what stands beyond the clip. Stairs end there with the ground if their middle is inside.
void leave_out_beyond_clip(const scene::ClipTest& clip, SharedByLevels& shared) {
  const auto is_outside = [&](Vec2 at) { return !clip.is_inside(at); };
  for (plants::PlacedPlants* plants : {&shared.trees, &shared.blades})
    for (auto& [prototype, placements] : *plants)
      std::erase_if(placements, [&](const Placement& p) { return is_outside(in_plan(p.at)); });
  std::vector<props::StreetLamp> lamps;
  std::size_t mapped = 0;
  for (std::size_t i = 0; i < shared.lamps.standing.size(); ++i) {
    if (is_outside(shared.lamps.standing[i].at)) continue;
    lamps.push_back(shared.lamps.standing[i]);
    mapped += i < shared.lamps.mapped;
  }
  shared.lamps = {std::move(lamps), mapped};
  std::erase_if(shared.things, [&](const PlacedThing& thing) { return is_outside(in_plan(thing.placement.at)); });
  std::erase_if(shared.pits, [&](const props::TreePit& pit) { return is_outside(pit.at); });
  std::erase_if(shared.pole_spans, [&](const PlacedPoleSpan& span) {
    return is_outside(in_plan(span.from.at)) || is_outside(in_plan(span.to.at));
  });
  std::erase_if(shared.stairs,
                [&](const structures::Stairs& stairs) { return is_outside(bounds_of(stairs).plan.centre()); });
}

SharedByLevels make_shared_part(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m,
                                const Wanted& wanted) {
  const Box2 box = scene::box_of(header, chunk.tile);
  std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(chunk);
  // polygons are sorted by id, and kBeyondClip comes first
  if (!header.clip.empty())
    surfaces.insert(surfaces.begin(), scene::beyond_clip(header.clip, box.widened(scene::kHalo_m)));
  const ground::LandCoverIndex map = ground::index_land_cover(surfaces, box.widened(scene::kHalo_m));
  SharedByLevels shared{
      .graded = std::make_shared<ground::GradedTerrain>(scene::graded_terrain_of(header, chunk, tolerance_m)),
      .lamps = place_lamps(chunk, map, box)};
  const plants::SpeciesTable species(header.species);
  const plants::PlacingContext land{
      map,    *shared.graded, box, header.seed, header.origin.lat_deg, header.climate, scene::local_month_of(header),
      species};
  const vacant::Plots plots = scene::plots_of(header, chunk);
  std::vector<plants::Tree> trees =
      trees_with_street_trees(header, chunk, {map, *shared.graded, shared.lamps, {}}, box);
  trees.insert(trees.end(), plots.plants.begin(), plots.plants.end());
  plants::GeneratedPlants plants = plants_of(header, chunk, trees, land, shared.tree_report);
  shared.trees = std::move(plants.placed);
  const TileGround on{map, *shared.graded, shared.lamps, plants.trunks, plots.grounds};
  GeneratedThings drawn = place_generated(header, chunk, on, box, wanted.things);
  if (wanted.people && people::has_people(header.people))
    std::ranges::move(people_of(header, chunk, on, box), std::back_inserter(drawn.placed));
  if (shows(header, scene::SceneLayer::kThings)) {
    shared.things = place_things(chunk.things, *shared.graded, std::move(drawn.placed));
    shared.pole_spans = std::move(drawn.pole_spans);
    shared.pits = props::tree_pits(joined(shared.trees), chunk.roads, map);
  } else {
    shared.lamps = {};
  }
  if (wanted.hedge_plants) add_hedges(chunk, land, shared.trees);
  if (wanted.blades) shared.blades = plants::generate_blades(chunk.plantings, land);
  for (const double canopy_m : wanted.canopies_m)
    shared.canopies.push_back(plants::make_canopy(chunk.woods, chunk.corridors, land, canopy_m, month_of(header)));
  const bool has_stairs = shows(header, scene::SceneLayer::kStructures);
  for (const roads::Road& road : chunk.roads)
    if (has_stairs && road.surface == map::LandCoverClass::kSteps)
      shared.stairs.push_back(structures::stairs_on(road, map, *shared.graded, box));
  std::erase_if(shared.stairs, [](const structures::Stairs& stairs) { return stairs.mesh.triangles.empty(); });
  if (!header.clip.empty()) leave_out_beyond_clip(scene::ClipTest(header.clip, box.widened(scene::kHalo_m)), shared);
  return shared;
}

bool has_canopy(double tolerance_m) { return has_detail(Detail::kWoodCanopies, tolerance_m); }

// Makes what the levels with Detail::kRoadSurfaces share, and what those without it do, when a level first needs it.
struct SharedParts {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::span<const double> tolerances_m;
  bool is_view = false;
  std::array<std::shared_ptr<const SharedByLevels>, 2> made{};

  // True if a level with or without road surfaces shows what is as high as this.
  bool shows(double height_m, bool has_roads) const {
    return std::ranges::any_of(tolerances_m, [&](double tolerance_m) {
      return has_detail(Detail::kRoadSurfaces, tolerance_m) == has_roads && tolerance_m < height_m;
    });
  }

  std::shared_ptr<const SharedByLevels> at(double tolerance_m) {
    const bool has_roads = has_detail(Detail::kRoadSurfaces, tolerance_m);
    std::shared_ptr<const SharedByLevels>& shared = made[has_roads ? 0 : 1];
    if (shared) return shared;
    const bool has_plants = scene::shows(header, scene::SceneLayer::kPlants),
               has_things = scene::shows(header, scene::SceneLayer::kThings);
    // in a view a hedge may be near and far, so all of its parts have hedge plants
    Wanted wanted{.blades = has_plants && has_roads && has_detail(Detail::kGrassBlades, std::ranges::min(tolerances_m)),
                  .hedge_plants = has_plants && (is_view || has_detail(Detail::kHedgePlants, tolerance_m)),
                  .people = has_things && shows(kShowsPeople_m, has_roads),
                  .things = {.cars = has_things && shows(kShowsCars_m, has_roads),
                             .furniture = has_things && shows(kShowsFurniture_m, has_roads),
                             .cranes = has_things && shows(kShowsCranes_m, has_roads)}};
    if (has_plants && !has_roads && !is_view)
      std::ranges::copy_if(tolerances_m, std::back_inserter(wanted.canopies_m), has_canopy);
    return shared = std::make_shared<SharedByLevels>(make_shared_part(header, chunk, tolerance_m, wanted));
  }
};

// The cells of a tile at one tolerance, with skirts along the tile's border.
std::vector<ViewCell> cells_at(const Box2& tile, double tolerance_m) {
  std::vector<ViewCell> cells;
  for (const Box2& cell : cells_of(tile))
    cells.push_back({.level = {cell, tolerance_m, ground::all_sides(tolerance_m)},
                     .skirt = tile,
                     .skirt_m = kSkirtDepthTolerances * tolerance_m});
  return cells;
}

void generate_grounds(std::span<TileLevel> levels, const Box2& box, int threads, KeptReferences kept) {
  std::vector<GroundLevel> grounds;
  for (const TileLevel& level : levels)
    grounds.push_back({*level.shared->graded, level.cover->surfaces, level.tolerance_m});
  std::vector<Report> reports(levels.size());
  std::vector<CellReferences> references(kept == KeptReferences::kAll ? levels.size() : 0);
  std::vector<std::vector<ground::GroundMesh>> cells = generate_cells(grounds, box, threads, reports, references);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].cells = std::move(cells[i]), levels[i].cell_report = std::move(reports[i]);
  for (std::size_t i = 0; i < references.size(); ++i) levels[i].references = std::move(references[i]);
}

// The ground under buildings across the extent's border. Each piece has skirts of its own on all sides.
void generate_beyond(TileLevel& level, const Box2& box, int threads) {
  level.seen_beyond.push_back({.level = {box, level.tolerance_m, ground::all_sides(level.tolerance_m)},
                               .skirt = box,
                               .skirt_m = kSkirtDepthTolerances * level.tolerance_m});
  std::vector<ground::GroundMesh> ground =
      generate_cells(*level.shared->graded, level.cover->surfaces, std::array{level.seen_beyond.back().level}, threads,
                     level.cell_report);
  level.beyond.push_back(std::move(ground.front()));
}

}  // namespace

std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> tolerances_m, int threads, KeptReferences kept) {
  const Box2 box = scene::box_of(header, chunk.tile);
  SharedParts shared{header, chunk, tolerances_m};
  const bool has_plants = shows(header, scene::SceneLayer::kPlants);
  std::vector<TileLevel> levels;
  std::size_t canopies = 0;
  for (const double tolerance_m : tolerances_m) {
    assert(tolerance_m > 0);
    TileLevel& level = levels.emplace_back(TileLevel{tolerance_m, shared.at(tolerance_m)});
    level.cover = std::make_shared<scene::LandCover>(scene::land_cover_of(header, chunk, tolerance_m)),
    level.seen = cells_at(box, tolerance_m);
    level.barriers = chunk.barriers;
    if (has_plants && has_canopy(tolerance_m)) level.canopy = canopies++;
  }
  generate_grounds(levels, box, threads, kept);
  const std::vector<Box2> beyond = ground_beyond(header, chunk);
  for (TileLevel& level : levels)
    for (const Box2& outside : beyond) generate_beyond(level, outside, threads);
  return levels;
}

std::vector<TileLevel> bare_levels_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                            const ViewLevels& view, std::span<const int> parts) {
  const std::vector<ViewCell> all = cells_of(view, scene::box_of(header, chunk.tile));
  std::vector<double> tolerances_m;
  for (const int part : parts) tolerances_m.push_back(tolerance_m_of(view.view, part));
  SharedParts shared{header, chunk, tolerances_m, true};
  std::vector<TileLevel> levels;
  std::map<double, std::shared_ptr<const scene::LandCover>> covers;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    TileLevel& level = levels.emplace_back(TileLevel{tolerances_m[i], shared.at(tolerances_m[i])});
    level.barriers = chunk.barriers;
    if (std::ranges::none_of(all, [&](const ViewCell& cell) { return cell.number == parts[i]; })) continue;
    const double roads_m = roads_tolerance_m(view, parts[i]);
    std::shared_ptr<const scene::LandCover>& cover = covers[roads_m];
    if (!cover) cover = std::make_shared<scene::LandCover>(scene::land_cover_of(header, chunk, roads_m));
    level.cover = cover;
  }
  return levels;
}

std::size_t cell_beside(std::span<const ViewCell> cells, const Box2& box) {
  const auto cell = std::ranges::find_if(cells, [&](const ViewCell& c) { return c.level.cell.touches(box); });
  return cell == cells.end() ? 0 : static_cast<std::size_t>(cell - cells.begin());
}

void generate_ground(TileLevel& level, std::vector<ViewCell> seen, std::span<const Box2> beyond, int threads) {
  level.seen = std::move(seen);
  std::vector<CellLevel> cells;
  for (const ViewCell& cell : level.seen) cells.push_back(cell.level);
  level.cells = generate_cells(*level.shared->graded, level.cover->surfaces, cells, threads, level.cell_report);
  for (const Box2& outside : beyond) generate_beyond(level, outside, threads);
}

std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const int> parts, int threads) {
  const std::vector<ViewCell> all = cells_of(view, scene::box_of(header, chunk.tile));
  const std::vector<Box2> beyond = ground_beyond(header, chunk);
  std::vector<TileLevel> levels = bare_levels_for_view(header, chunk, view, parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<ViewCell> seen;
    std::ranges::copy_if(all, std::back_inserter(seen), [&](const auto& cell) { return cell.number == parts[i]; });
    std::vector<Box2> beside;
    std::ranges::copy_if(beyond, std::back_inserter(beside),
                         [&](const Box2& box) { return all[cell_beside(all, box)].number == parts[i]; });
    if (!seen.empty()) generate_ground(levels[i], std::move(seen), beside, threads);
  }
  return levels;
}

}  // namespace citykiln::bake
