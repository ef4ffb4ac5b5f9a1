#include "compiler/invent/invent.h"

#include <cmath>

#include "compiler/invent/country/add_country.h"
#include "compiler/invent/land/make_terrain.h"
#include "compiler/invent/tiles/connect_roads.h"
#include "compiler/invent/tiles/tile_city.h"
#include "compiler/invent/town/add_town.h"

namespace citykiln::invent {
namespace {

Result<Done> add_tiles_of(const InventSettings& settings, const TileSet& set, InventedWorld& world) {
  const int cells = static_cast<int>(std::ceil(settings.side_m / set.cell_m));
  Result<TileGrid> grid = arrange_tiles(set, {.columns = cells,
                                              .rows = cells,
                                              .seed = settings.seed,
                                              .fixed_share = settings.tiles.fixed_share,
                                              .noise_cells = settings.tiles.noise_m / set.cell_m});
  if (!grid) return grid.error();
  const RoadParts parts = connect_roads(set, settings.seed, *grid);
  grid->road_parts = parts.before, grid->road_parts_left = parts.after;
  world.tiles = std::move(*grid);
  add_tile_city(set, world.tiles, settings.seed, world.map);
  return Done{};
}

TownKind town_kind(WorldKind kind) {
  return kind == WorldKind::kVillage ? TownKind::kVillage
         : kind == WorldKind::kCity  ? TownKind::kCity
                                     : TownKind::kTown;
}

}  // namespace

Result<InventedWorld> invent(const InventSettings& settings, const TileSet& tile_set) {
  InventedWorld world;
  world.terrain = make_terrain(settings.terrain, settings.side_m, settings.seed);
  world.spot = find_spot(world.terrain, settings.spot);
  spawn_plants(settings.spawners, world.spot, settings.seed, world.map);
  if (settings.kind == WorldKind::kTiles) {
    if (const Result<Done> done = add_tiles_of(settings, tile_set, world); !done) return done.error();
    return world;
  }
  if (settings.kind != WorldKind::kForest)
    add_town(world.terrain, {.kind = town_kind(settings.kind), .side_m = settings.side_m, .seed = settings.seed},
             world.map);
  add_water(world.terrain, settings.side_m, world.map);
  add_country(world.terrain, settings.country, settings.side_m, settings.seed, world.map);
  return world;
}

}  // namespace citykiln::invent
