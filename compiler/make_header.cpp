#include "compiler/make_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "compiler/buildings/plan.h"
#include "compiler/geometry/trig.h"
#include "compiler/make_clip.h"
#include "compiler/map/heights/fit_heightmaps.h"
#include "compiler/map/plane/lonlat_box.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/inside/plan_inside.h"
#include "compiler/sky/plan.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/read_texts.h"
#include "compiler/surroundings/grid_lines.h"
#include "compiler/surroundings/plan.h"
#include "lsystems/plant_file.h"

namespace citykiln {
namespace {

constexpr std::string_view kOsmCredit = "© OpenStreetMap contributors";

std::string file_name_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The heightmaps of the run; those with offset=auto have the shifts by which they fit others in the region, so that
/// the land around it continues it.
Result<std::vector<source::RasterSpec>> fitted_heightmaps(const CompileSpec& spec, const map::Plane& plane,
                                                          const Box2& extent) {
  std::vector<source::RasterSpec> specs = spec.rasters;
  if (std::ranges::none_of(specs, &source::RasterSpec::is_fitted)) return specs;
  const source::LonLatBox window = map::lonlat_box_of(extent, plane);
  Report repeated;
  Result<std::vector<source::Raster>> rasters = source::read_heightmaps(specs, &window, repeated);
  if (!rasters) return rasters.error();
  rasters = map::fit_heightmaps(std::move(*rasters), plane, extent, repeated);
  if (!rasters) return rasters.error();
  for (source::RasterSpec& each : specs) {
    const auto raster = std::ranges::find(*rasters, file_name_of(each.path), &source::Raster::file_name);
    if (each.is_fitted && raster != rasters->end()) each.offset_m += raster->shift_m;
    each.is_fitted = false;
  }
  return specs;
}

/// The sea, the coast, and the lakes that go on around the extent.
surroundings::MappedWater mapped_water(const HeaderInputs& recipes, const Box2& extent) {
  surroundings::MappedWater water{.coast = surroundings::CoastSides(recipes.coasts)};
  const auto is_sea = [](const ground::LandCoverPolygon& cover) { return cover.surface == map::LandCoverClass::kSea; };
  std::ranges::copy_if(recipes.surfaces, std::back_inserter(water.sea), is_sea);
  std::ranges::copy_if(recipes.surfaces, std::back_inserter(water.lakes),
                       [&](const auto& cover) { return surroundings::reaches_beyond(cover, extent); });
  return water;
}

/// The land around the region; empty if it is not wanted, in a cylinder, or around a clip unless it is asked for.
Result<surroundings::Surroundings> plan_surroundings(const CompileSpec& spec, const map::Plane& plane,
                                                     const HeaderInputs& recipes, const Box2& extent) {
  const bool is_left_out = spec.clip && spec.outputs.surroundings != AroundWish::kYes;
  if (is_left_out || spec.outputs.surroundings == AroundWish::kNo || spec.world == World::kCylinder)
    return surroundings::Surroundings();
  const source::LonLatBox window = map::lonlat_box_of(extent.widened(surroundings::kReach_m), plane);
  Report repeated;  // discarded: diagnosed for the region already, or lies beyond it
  const Result<std::vector<source::RasterSpec>> fitted = fitted_heightmaps(spec, plane, extent);
  if (!fitted) return fitted.error();
  const Result<std::vector<source::Raster>> rasters =
      source::read_heightmaps(*fitted, &window, repeated, surroundings::kSampleSpacing_m);
  if (!rasters) return rasters.error();
  return surroundings::plan(
      *rasters, plane,
      {.extent = extent, .tile_m = spec.tile_m, .water = mapped_water(recipes, extent), .heights = &recipes.heights});
}

/// Checks that a clip leaves ground, and that all tiles of `only` are tiles of the map.
Result<Done> are_tiles_of(const scene::Header& header, const CompileSpec& spec) {
  const std::vector<scene::TileKey>& only = spec.only;
  std::vector<scene::TileKey> tiles = scene::tiles_of(header);
  std::erase_if(tiles, [&](scene::TileKey tile) { return !scene::touches_clip(header.clip, box_of(header, tile)); });
  if (tiles.empty() && spec.clip) return Error{spec.clip->where, "leaves no ground of the map inside"};
  for (const scene::TileKey tile : only) {
    if (std::ranges::binary_search(tiles, tile)) continue;
    return Error{"--only", fmt::format("the map has no tile {}; its tiles are {} to {}", to_string(tile),
                                       to_string(tiles.front()), to_string(tiles.back()))};
  }
  return Done{};
}

// The mean height, rounded down to whole metres.
double mean_height_m(const map::Heightfield& heights) {
  if (heights.heights.empty()) return 0;
  std::int64_t sum = 0;
  for (const std::int32_t height : heights.heights) sum += height;
  return std::floor(static_cast<double>(sum) / static_cast<double>(heights.heights.size()) * map::kHeightQuantum_m);
}

/// The highest point of ground, buildings and bridges, in the heightmaps' datum.
double highest_m(const HeaderInputs& recipes) {
  double high_m = 0;
  for (const std::int32_t height : recipes.heights.heights) high_m = std::max(high_m, height * map::kHeightQuantum_m);
  for (const buildings::Building& building : recipes.buildings) high_m = std::max(high_m, building.top_m);
  return high_m;
}

/// Checks that a map fits into a cylinder.
Result<Done> fits_into(const map::Cylinder& cylinder, const Box2& extent, const HeaderInputs& recipes) {
  const double around_m = map::circumference_m(cylinder);
  // an extent of exactly one circumference has been rounded to whole cells
  constexpr double kRounding = 1 + 1e-9;
  if (extent.height() > around_m * kRounding)
    return Error{"--world", fmt::format("the map is {:.0f} m long from south to north, and the cylinder {:.0f} m "
                                        "around; expected a radius of at least {:.0f} m",
                                        extent.height(), around_m, std::ceil(extent.height() / (2 * kPi)))};
  const double high_m = highest_m(recipes);
  if (high_m >= cylinder.radius_m)
    return Error{"--world", fmt::format("the map is up to {:.0f} m high, and the axis of the cylinder {:.0f} m; "
                                        "expected a larger radius",
                                        high_m, cylinder.radius_m)};
  return Done{};
}

climate::ClimateField climate_of(const map::Plane& plane, const Box2& extent) {
  return climate::make_climate_field(extent, [&](Vec2 at) { return plane.backward(at); });
}

// The snow line where all land is under snow.
constexpr double kBelowAllLand_m = -1000;

}  // namespace

Result<scene::Header> make_header(const CompileSpec& spec, const map::Plane& plane, const Box2& extent,
                                  const HeaderInputs& recipes) {
  const map::Heightfield& heights = recipes.heights;
  Result<surroundings::Surroundings> around = plan_surroundings(spec, plane, recipes, extent);
  if (!around) return around.error();
  sky::Sky sky = sky::plan(plane.origin(), spec.time);
  sky::set_air(spec.air, sky);
  sky.ground_m = mean_height_m(heights);
  if (spec.world == World::kCylinder) {
    if (const Result<Done> fits = fits_into(spec.cylinder, extent, recipes); !fits) return fits.error();
    sky.inside = sky::plan_inside(spec.cylinder, extent);
  }
  sky.clouds_are_default = !spec.clouds && spec.world != World::kCylinder;
  if (spec.world != World::kCylinder)
    sky.clouds = sky::requested_clouds(spec.clouds.value_or(sky::fair_clouds()), sky.ground_m, spec.seed);
  scene::Header header{.origin = plane.origin(),
                       .extent = extent,
                       .tile_m = spec.tile_m,
                       .seed = spec.seed,
                       .resampling_error_m = heights.resampling_error_m,
                       .sky = std::move(sky),
                       .sources = {file_name_of(spec.map_path)},
                       .attributions = {std::string(kOsmCredit)},
                       .snow_line_m = spec.snow_line_m,
                       .around = std::move(*around),
                       .climate = climate_of(plane, extent),
                       .has_wild_slopes = has(spec.assume, Assumption::kSurfaces),
                       .cars = car_share_of(spec),
                       .has_street_furniture = has(spec.assume, Assumption::kRoadsides),
                       .people = spec.people,
                       .traffic = spec.traffic,
                       .shown = scene::with_request({}, spec.shown),
                       .clip = make_clip(spec, plane)};
  if (!header.snow_line_m && climate::is_under_snow(header.climate.origin_class, scene::local_month_of(header)))
    header.snow_line_m = kBelowAllLand_m;
  if (spec.edits) header.sources.push_back(edits::source_text(*spec.edits));
  for (const source::RasterSpec& raster : spec.rasters) header.sources.push_back(file_name_of(raster.path));
  for (const source::RasterSpec& raster : spec.rasters) {
    const bool is_new = std::ranges::find(header.attributions, raster.credit) == header.attributions.end();
    if (!raster.credit.empty() && is_new) header.attributions.push_back(raster.credit);
  }
  if (const Result<Done> done = are_tiles_of(header, spec); !done) return done.error();
  return header;
}

namespace {

// The shipped rules, less those that the spec's folder replaces, and the folder's.
Result<std::vector<buildings::RuleText>> available_rules(const CompileSpec& spec) {
  std::vector<buildings::RuleText> available;
  if (!spec.rules_folder.empty()) {
    Result<std::vector<source::TextFile>> own = source::read_texts(spec.rules_folder, ".cga");
    if (!own) return own.error();
    for (source::TextFile& file : *own) available.push_back({std::move(file.name), std::move(file.text)});
  }
  for (const buildings::RuleText& rule : buildings::shipped_rules()) {
    const auto has_its_name = [&](const buildings::RuleText& own) { return own.name == rule.name; };
    if (std::ranges::none_of(available, has_its_name)) available.push_back(rule);
  }
  return available;
}

}  // namespace

Result<lots::HouseRules> house_rules_for(const CompileSpec& spec) {
  const Result<std::vector<buildings::RuleText>> available = available_rules(spec);
  if (!available) return available.error();
  return lots::read_house_rules([&](const std::string& file) -> Result<std::string> {
    const auto found = std::ranges::find(*available, file, &buildings::RuleText::name);
    if (found == available->end()) return Error{file, "there is no such rule file"};
    return found->text;
  });
}

Result<std::vector<buildings::RuleText>> rules_for(const CompileSpec& spec,
                                                   const std::vector<buildings::Building>& buildings) {
  const Result<std::vector<buildings::RuleText>> available = available_rules(spec);
  if (!available) return available.error();
  return buildings::rules_for(buildings::styles_of(buildings), *available);
}

Result<plants::UserSpecies> read_species(const std::string& folder) {
  if (folder.empty()) return plants::UserSpecies{};
  std::vector<plants::SpeciesText> own;
  std::vector<std::string_view> endings(lsystems::kPlantEndings.begin(), lsystems::kPlantEndings.end());
  endings.push_back(".txt");
  for (const std::string_view ending : endings) {
    Result<std::vector<source::TextFile>> files = source::read_texts(folder, ending);
    if (!files) return files.error();
    for (source::TextFile& file : *files) {
      const bool is_table = file.name == plants::kUserSpeciesName || file.name == plants::kSpawnersName;
      if (file.name.find('/') == std::string::npos && (ending != ".txt" || is_table))
        own.push_back({std::move(file.name), std::move(file.text)});
    }
  }
  if (own.empty())
    return Error{folder, fmt::format("expected species.txt, spawners.txt or files {}, found none",
                                     fmt::join(lsystems::kPlantEndings, ", "))};
  return plants::read_species_folder(own, folder);
}

Result<things::Catalogue> read_things(const CompileSpec& spec) {
  std::vector<buildings::RuleText> own;
  for (const char* ending : {".cga", ".txt"}) {
    if (spec.things_folder.empty()) break;
    Result<std::vector<source::TextFile>> files = source::read_texts(spec.things_folder, ending);
    if (!files) return files.error();
    for (source::TextFile& file : *files) own.push_back({std::move(file.name), std::move(file.text)});
  }
  Result<things::Catalogue> catalogue = things::read_catalogue(own, spec.things_folder);
  if (catalogue && !cars::has_cars(car_share_of(spec)) && !cars::has_cars(spec.traffic))
    std::erase_if(catalogue->table, [](const auto& row) { return map::role_of(row.name) == map::ThingRole::kCar; });
  return catalogue;
}

}  // namespace citykiln
