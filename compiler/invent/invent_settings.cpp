#include "compiler/invent/invent_settings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::invent {
namespace {

constexpr std::array<std::string_view, 5> kKindNames = {"village", "town", "city", "tiles", "forest"};

void name_terrain(TerrainSettings& t, std::vector<NamedSetting>& all) {
  constexpr std::string_view kSection = "terrain";
  all.insert(all.end(), {{kSection, "power", &t.fractal.power, 0, 12},
                         {kSection, "size", &t.size_m, 0, 262144},
                         {kSection, "initial_height", &t.fractal.initial_height_m, -400, 5000},
                         {kSection, "corner_spread", &t.fractal.corner_spread_m, 0, 5000},
                         {kSection, "spread", &t.fractal.spread_m, 0, 5000},
                         {kSection, "reduction", &t.fractal.reduction, 0, 1},
                         {kSection, "ridges", &t.ridges_m, 0, 5000},
                         {kSection, "ridge_length", &t.ridge_length_m, 10, 100000},
                         {kSection, "erosion_steps", &t.erosion.steps, 0, 200},
                         {kSection, "erosion", &t.erosion.strength, 0, 10},
                         {kSection, "creep", &t.erosion.creep, 0, 0.5},
                         {kSection, "coast", &t.has_coast, 0, 1},
                         {kSection, "coast_fall", &t.coast_fall_m, 1, 5000},
                         {kSection, "lakes", &t.lakes, 0, 1000},
                         {kSection, "river_from", &t.river_from_km2, 0.001, 1e6},
                         {kSection, "river_width", &t.river_width_m, 0, 100}});
}

void name_country(CountrySettings& c, std::vector<NamedSetting>& all) {
  constexpr std::string_view kSection = "country";
  all.insert(all.end(), {{kSection, "woods", &c.wood_share, 0, 1},
                         {kSection, "wood_size", &c.wood_size_m, 20, 10000},
                         {kSection, "rock_slope", &c.rock_slope, 0.05, 10},
                         {kSection, "heath_share", &c.heath_share, 0, 1},
                         {kSection, "fields", &c.has_farm_fields, 0, 1},
                         {kSection, "field_size", &c.farm_field_ha, 0.05, 100},
                         {kSection, "field_slope", &c.farm_field_slope, 0, 10},
                         {kSection, "hedges", &c.hedge_share, 0, 1},
                         {kSection, "orchards", &c.orchard_share, 0, 1},
                         {kSection, "tree_rows", &c.tree_row_share, 0, 1},
                         {kSection, "tracks", &c.tracks_per_km2, 0, 20}});
}

}  // namespace

std::string_view name_of(WorldKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<WorldKind> world_kind_named(std::string_view name) {
  const auto found = std::ranges::find(kKindNames, name);
  if (found == kKindNames.end()) return std::nullopt;
  return static_cast<WorldKind>(found - kKindNames.begin());
}

InventSettings usual_settings(WorldKind kind) {
  InventSettings settings;
  settings.kind = kind;
  TerrainSettings& terrain = settings.terrain;
  if (kind == WorldKind::kVillage) {
    terrain.fractal.spread_m = 90;
  } else if (kind == WorldKind::kCity) {
    settings.side_m = 2048;
    terrain.fractal.spread_m = 35;
  } else if (kind == WorldKind::kTiles) {
    terrain.fractal.spread_m = 12;
    terrain.erosion.steps = 2;
    // cells are drawn over rivers, so that there are none
    terrain.river_from_km2 = 1e6;
  } else if (kind == WorldKind::kForest) {
    terrain.fractal.spread_m = 220;
    terrain.fractal.initial_height_m = 700;
    terrain.ridges_m = 120;
    settings.country.wood_share = 0.55;
    settings.country.has_farm_fields = false;
    settings.country.heath_share = 0.25;
    settings.country.tracks_per_km2 = 3;
  }
  return settings;
}

std::vector<NamedSetting> named_settings(InventSettings& settings) {
  std::vector<NamedSetting> all;
  name_terrain(settings.terrain, all);
  name_country(settings.country, all);
  all.push_back({"spot", "height", &settings.spot.height_m, -500, 9000});
  all.push_back({"spot", "edge", &settings.spot.edge_m, 0, 100000});
  all.push_back({"tiles", "fixed", &settings.tiles.fixed_share, 0, 1});
  all.push_back({"tiles", "noise", &settings.tiles.noise_m, 1, 100000});
  return all;
}

std::vector<NamedSetting> named_settings(Spawner& s) {
  constexpr std::string_view kSection = "spawners";
  return {{kSection, "species", &s.species, 0, 0},
          {kSection, "x", &s.x_m, -32768, 32768},
          {kSection, "y", &s.y_m, -32768, 32768},
          {kSection, "columns", &s.columns, 1, 1000},
          {kSection, "rows", &s.rows, 1, 1000},
          {kSection, "cell", &s.cell_m, 0.01, 1000},
          {kSection, "probability", &s.probability, 0, 1},
          {kSection, "jitter", &s.jitter, 0, 1},
          {kSection, "height", &s.height_m, 0.01, 150},
          {kSection, "low", &s.low_scale, 0.01, 100},
          {kSection, "high", &s.high_scale, 0.01, 100}};
}

double whole_side_m(double side_m) { return std::max(1.0, std::ceil(side_m / kSideStep_m)) * kSideStep_m; }

}  // namespace citykiln::invent
