#include "compiler/spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/contract/code_names.h"
#include "compiler/contract/nearest_name.h"
#include "compiler/contract/parse.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/plan.h"
#include "compiler/source/read_raster.h"

namespace citykiln {
namespace {

using nlohmann::json;

Error expected(std::string_view what, std::string_view found) {
  return {"", fmt::format("expected {}, found \"{}\"", what, found)};
}

/// Stores the value of a result in `target`, or returns its error.
template <typename T, typename Target>
Result<Done> put(Result<T> result, Target& target) {
  if (!result) return result.error();
  target = std::move(*result);
  return Done{};
}

// ---- one function for each setting, in the order of the table ----

template <std::string CompileSpec::*kMember>
Result<Done> set_text(CompileSpec& spec, std::string_view text) {
  spec.*kMember = text;
  return Done{};
}

/// The heightmaps in a folder, sorted by name.
std::vector<std::string> heightmaps_in(const std::string& folder) {
  constexpr std::string_view kSuffixes[] = {".hgt", ".hgt.zip", ".hgt.gz", ".tif", ".tiff", ".asc", ".asc.gz"};
  std::vector<std::string> paths;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (std::ranges::any_of(kSuffixes, [&](std::string_view end) { return entry.path().native().ends_with(end); }))
      paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

Result<Done> set_dem(CompileSpec& spec, std::string_view text) {
  if (std::error_code none; std::filesystem::is_directory(text, none)) {
    const std::vector<std::string> paths = heightmaps_in(std::string(text));
    if (paths.empty()) return expected("a folder with heightmaps (.hgt, .tif, .asc)", text);
    for (const std::string& path : paths)
      if (Result<Done> done = set_dem(spec, path); !done) return done;
    return Done{};
  }
  Result<source::RasterSpec> raster = source::parse_raster_spec(text);
  if (!raster) return raster.error();
  spec.rasters.push_back(std::move(*raster));
  return Done{};
}

bool is_box_on_earth(const source::LonLatBox& box) {
  const bool is_on_earth = box.west >= -180 && box.east <= 180 && box.south >= -90 && box.north <= 90;
  return is_on_earth && box.west < box.east && box.south < box.north;
}

Result<Done> set_bbox(CompileSpec& spec, std::string_view text) {
  Result<std::vector<double>> n = parse_numbers(text, 4);
  if (!n) return n.error();
  source::LonLatBox box{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  const bool is_across_180 = box.west <= 180 && box.east >= -180 && box.west - box.east > 180;
  if (!is_box_on_earth(is_across_180 ? source::LonLatBox{-180, box.south, box.east, box.north} : box)) {
    Error error = expected(
        "west,south,east,north in degrees with west < east and south < north, such as 7.40,43.72,7.44,43.75", text);
    if (is_box_on_earth({box.south, box.west, box.north, box.east}))
      error.message +=
          fmt::format("; latitude and longitude swapped? Try {},{},{},{}", box.south, box.west, box.north, box.east);
    return error;
  }
  if (is_across_180) box.east += 360;
  spec.map.bbox = box;
  return Done{};
}

Result<Done> set_origin(CompileSpec& spec, std::string_view text) {
  Result<std::vector<double>> n = parse_numbers(text, 2);
  if (!n) return n.error();
  if (std::abs((*n)[0]) > 180 || std::abs((*n)[1]) > 89)
    return expected("longitude,latitude in degrees, such as 7.42,43.73", text);
  spec.map.origin = map::LonLat{(*n)[0], (*n)[1]};
  return Done{};
}

Result<Done> set_tile(CompileSpec& spec, std::string_view text) {
  Result<double> tile_m = parse_number(text);
  // offsets inside a chunk are float32, which is exact up to 16 km (kQuantum_m)
  if (!tile_m || *tile_m < map::kCell_m || *tile_m > 16384 || std::fmod(*tile_m, map::kCell_m) != 0) {
    return expected("a multiple of 128 from 128 to 16384 (metres), such as 512", text);
  }
  spec.tile_m = *tile_m;
  return Done{};
}

/// A format that --emit names.
struct OutputFormat {
  std::string_view name;
  bool Outputs::*is_written;
};
constexpr std::array kOutputFormats = {OutputFormat{"kiln", &Outputs::manifest}, OutputFormat{"glb", &Outputs::glb},
                                       OutputFormat{"usd", &Outputs::usd}, OutputFormat{"3dtiles", &Outputs::tiles3d},
                                       OutputFormat{"page", &Outputs::page}};

Result<Done> set_emit(CompileSpec& spec, std::string_view text) {
  for (const OutputFormat& format : kOutputFormats) spec.outputs.*format.is_written = false;
  for (const std::string_view name : split(text, ',')) {
    const auto format = std::ranges::find(kOutputFormats, name, &OutputFormat::name);
    if (format == kOutputFormats.end())
      return expected("kiln, glb, usd, 3dtiles, page or several of them, such as kiln,usd", name);
    spec.outputs.*format->is_written = true;
  }
  return Done{};
}

std::string emitted_in(const CompileSpec& spec) {
  std::string names;
  for (const OutputFormat& format : kOutputFormats)
    if (spec.outputs.*format.is_written) names += (names.empty() ? "" : ",") + std::string(format.name);
  return names;
}

/// The default of a value of the sky, as text.
template <auto kValue>
std::string default_of_sky(const CompileSpec&) {
  return fmt::format("{}", sky::Sky{}.*kValue);
}

Result<Done> set_world(CompileSpec& spec, std::string_view text) {
  constexpr std::string_view kCylinder = "cylinder";
  if (text.starts_with(kCylinder)) {
    const auto radius_m =
        text.starts_with("cylinder:") ? number_in<double>(text.substr(kCylinder.size() + 1)) : std::optional<double>();
    if (!radius_m || !(*radius_m >= map::kLeastCylinder_m && *radius_m <= map::kLargestCylinder_m))
      return expected("cylinder:R with a radius from 100 to 1000000 (metres), such as cylinder:1000", text);
    spec.world = World::kCylinder, spec.cylinder = {*radius_m};
    return Done{};
  }
  if (text != "plane" && text != "ellipsoid") return expected("plane, ellipsoid or cylinder:R", text);
  spec.world = text == "plane" ? World::kPlane : World::kEllipsoid;
  return Done{};
}

Result<Done> set_geoid(CompileSpec& spec, std::string_view text) {
  if (!number_in<double>(text) && !text.ends_with(".pgm"))
    return expected("a height in metres, such as 47.3, or a geoid of GeographicLib, such as egm96-5.pgm", text);
  spec.outputs.geoid = text;
  return Done{};
}

Result<Done> set_target(CompileSpec& spec, std::string_view text) {
  const auto target = target_named(text);
  if (!target) return expected(targets_with([](const TargetValues&) { return true; }), text);
  spec.outputs.target = *target;
  return Done{};
}

// Rejects numbers that no program can render, which are mistakes.
Result<Done> set_lights(CompileSpec& spec, std::string_view text) {
  constexpr std::int64_t kMost = 100'000;
  const Result<std::int64_t> count = parse_whole(text, 0);
  if (!count) return count.error();
  if (*count > kMost) return expected("a whole number up to 100000", text);
  spec.outputs.lights = static_cast<std::size_t>(*count);
  return Done{};
}

template <typename T>
Result<Done> put_named(const std::optional<T>& value, const char* names, std::string_view text, T& place) {
  if (!value) return expected(names, text);
  place = *value;
  return Done{};
}

Result<Done> set_split(CompileSpec& spec, std::string_view text) {
  return put_named(split_named(text), "tile, layer or building", text, spec.outputs.split);
}

Result<Done> set_compression(CompileSpec& spec, std::string_view text) {
  return put_named(compression_named(text), "none, quantize, draco or meshopt", text, spec.outputs.compress);
}

Result<Done> set_layout(CompileSpec& spec, std::string_view text) {
  return put_named(layout_named(text), "embedded or shared", text, spec.outputs.layout);
}

Result<Done> set_drive_on(CompileSpec& spec, std::string_view text) {
  if (text != "left" && text != "right") return expected("left or right", text);
  spec.map.driving_side = text == "left" ? map::DrivingSide::kLeft : map::DrivingSide::kRight;
  return Done{};
}

/// Returns the names of the assumptions of --assume: "pavements, lamps or heights".
std::string assumption_names() {
  std::string names;
  // the last one, kHouses, belongs to --fill
  const auto count = static_cast<std::size_t>(Assumption::kHouses);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) names += i + 1 == count ? " or " : ", ";
    names += name_of(static_cast<Assumption>(i));
  }
  return names;
}

Result<Done> set_assume(CompileSpec& spec, std::string_view text) {
  if (text == "all" || text == "none") {
    spec.assume = text == "all" ? kUsualAssumptions : kNoAssumptions;
    return Done{};
  }
  Assumptions set = kNoAssumptions;
  for (const std::string_view name : split(text, ',')) {
    const std::optional<Assumption> assumption = assumption_named(name);
    if (!assumption || *assumption == Assumption::kHouses)
      return expected("all, none, or names among " + assumption_names(), text);
    set |= bit_of(*assumption);
  }
  spec.assume = set;
  return Done{};
}

Result<Done> set_time(CompileSpec& spec, std::string_view text) {
  // any place will do: parsing does not depend on it
  const Result<sky::Sky> sky = sky::plan({}, std::string(text));
  if (!sky) return sky.error();
  spec.time = text;
  return Done{};
}

/// Stores a number of the air within limits.
Result<Done> put_number(std::string_view text, double low, double high, std::string_view what,
                        std::optional<double>& target) {
  const auto number = number_in<double>(text);
  if (!number || !(*number >= low && *number <= high)) return expected(what, text);
  target = number;
  return Done{};
}

Result<Done> set_visibility(CompileSpec& spec, std::string_view text) {
  return put_number(text, sky::kHaziest_km, sky::kClearest_km, "a visibility from 1 to 300 (kilometres), such as 30",
                    spec.air.visibility_km);
}

Result<Done> set_turbidity(CompileSpec& spec, std::string_view text) {
  return put_number(text, sky::kLeastTurbidity, sky::kMostTurbidity, "a turbidity from 1 to 20, such as 2.6",
                    spec.air.turbidity);
}

Result<Done> set_ground_albedo(CompileSpec& spec, std::string_view text) {
  return put_number(text, 0, 1, "an albedo from 0 to 1, such as 0.2", spec.air.ground_albedo);
}

Result<Done> set_clouds(CompileSpec& spec, std::string_view text) {
  const auto layers = sky::read_clouds(std::string(text), 0, 0);
  if (!layers) return layers.error();
  spec.clouds = text;
  return Done{};
}

Result<Done> set_seed(CompileSpec& spec, std::string_view text) {
  const auto seed = number_in<std::uint64_t>(text);
  if (!seed) return expected("a whole number of at least 0, such as 7", text);
  spec.seed = *seed;
  return Done{};
}

Result<Done> set_snow_line(CompileSpec& spec, std::string_view text) {
  spec.snow_line_m = number_in<double>(text);
  return spec.snow_line_m ? Result<Done>(Done{}) : expected("a height in metres, such as 2800", text);
}

Result<Done> set_tags(CompileSpec& spec, std::string_view text) {
  if (text != "true" && text != "false") return expected("true or false", text);
  spec.map.keeps_tags = text == "true";
  return Done{};
}

Result<Done> set_surroundings(CompileSpec& spec, std::string_view text) {
  if (text != "true" && text != "false") return expected("true or false", text);
  spec.outputs.surroundings = text == "true";
  return Done{};
}

Result<Done> set_fill(CompileSpec& spec, std::string_view text) {
  if (text != "lots" && text != "none") return expected("lots or none", text);
  spec.fill_lots = text == "lots";
  return Done{};
}

Result<Done> set_cars(CompileSpec& spec, std::string_view text) {
  if (text != "true" && text != "false") return expected("true or false", text);
  spec.cars = text == "true";
  return Done{};
}

Result<Done> set_strict(CompileSpec& spec, std::string_view text) {
  spec.strict = {.is_on = text != "false", .codes = {}};
  if (text == "true" || text == "false") return Done{};
  for (const std::string_view name : split(text, ',')) {
    const std::optional<Code> code = code_named(name);
    if (!code) return expected("diagnosis codes as in report.json, such as MissingNode,RoofFallback", name);
    spec.strict.codes.push_back(*code);
  }
  return Done{};
}

constexpr Setting kSettings[] = {
    {"map", "FILE", "OpenStreetMap extract: .osm, .osm.gz, .osm.bz2 or .osm.pbf", false,
     set_text<&CompileSpec::map_path>},
    {"dem", "FILE[,key=value...]",
     "heightmaps (.hgt, GeoTIFF, ASCII grid, PNG) or folders of them, one or several, such as N43E007.hgt or "
     "a.png,bounds=7/43/8/44,scale=0.1; keys: bounds=W/S/E/N, scale=, offset=, encoding=terrarium|mapbox, tile=Z/X/Y, "
     "credit= (default: the ground is level)",
     true, set_dem},
    {"bbox", "W,S,E,N",
     "area to compile in degrees, such as 7.40,43.72,7.44,43.75 (default: the extract's bounding box)", false,
     set_bbox},
    {"origin", "LON,LAT",
     "origin of the plane in degrees, such as 7.42,43.73 (default: the area's centre, rounded to 0.01)", false,
     set_origin},
    {"tile", "M", "side of a tile in metres, a multiple of 128 (default: {})", false, set_tile,
     [](const CompileSpec& spec) { return fmt::format("{}", spec.tile_m); }},
    {"only", "X_Y[,X_Y...]", "only these tiles, such as 0_0,0_-1 (default: all)", true,
     [](CompileSpec& spec, std::string_view text) { return add_tiles(text, spec.only); }},
    {"out", "FOLDER", "folder for all outputs; it is created if missing", false,
     [](CompileSpec& spec, std::string_view text) { return put(Result(std::string(text)), spec.outputs.folder); }},
    {"emit", "kiln,glb,usd,3dtiles,page",
     "outputs to write: kiln (manifest), glb (tiles), usd (a scene of the tiles), 3dtiles (tileset.json, on the "
     "ellipsoid), page (index.html, which shows 3dtiles in a browser) or several (default: {})",
     false, set_emit, emitted_in},
    {"lods", "M,M,...", "levels of detail: largest geometric error of each in metres, finest first (default: {})",
     false, [](CompileSpec& spec, std::string_view text) { return put(parse_ladder(text), spec.outputs.tolerances_m); },
     [](const CompileSpec& spec) { return fmt::format("{}", fmt::join(spec.outputs.tolerances_m, ",")); }},
    {"world", "plane|ellipsoid|cylinder:R",
     "shape of the world: ellipsoid for --emit 3dtiles, plane for kiln and glb, or for all of them cylinder:R, the "
     "inside of a hollow cylinder with a radius of R metres around the x axis (default: that of the output)",
     false, set_world},
    {"geoid-height", "M|FILE.pgm",
     "for 3dtiles: height of the geoid (sea level) above the ellipsoid in metres, such as 47.3, or a geoid of "
     "GeographicLib, such as egm96-5.pgm (default: 0)",
     false, set_geoid},
    {"compress", "none|quantize|draco|meshopt", "compression of meshes in .glb files (default: {})", false,
     set_compression, [](const CompileSpec& spec) { return std::string(name_of(spec.outputs.compress)); }},
    {"layout", "embedded|shared",
     "shared: plants, lamps and images of all tiles are files in glb/shared (default: {} in each .glb)", false,
     set_layout, [](const CompileSpec& spec) { return std::string(name_of(spec.outputs.layout)); }},
    {"max-bytes", "N",
     "instead of levels: each .glb is as fine as this many bytes allow, such as 5000000, as target and compression are",
     false, [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 1), spec.outputs.max_bytes); }},
    {"max-triangles", "N", "instead of levels: each .glb is as fine as this many triangles allow, such as 100000",
     false,
     [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 1), spec.outputs.max_triangles); }},
    {"target", "generic|blender|godot|three|cesium|unreal|unity",
     "program that reads the .glb files; generic uses nothing that a reader may lack (default: {})", false, set_target,
     [](const CompileSpec& spec) { return std::string(values_of(spec.outputs.target).name); }},
    {"split", "tile|layer|building",
     "nodes of a tile: one, one for each layer (ground, roads, water, buildings ...), or one for each building too "
     "(default: {})",
     false, set_split, [](const CompileSpec& spec) { return std::string(name_of(spec.outputs.split)); }},
    {"surroundings", "",
     "writes the land around the map, as far as the heightmaps know it, as a tile of its own: glb/surroundings.glb, "
     "usd/surroundings.usdc, a tile of 3dtiles",
     false, set_surroundings},
    {"lights", "N",
     "the N brightest street lamps of each tile are lights of .glb (KHR_lights_punctual) and USD (UsdLux) files, at "
     "any time (default: {})",
     false, set_lights, [](const CompileSpec& spec) { return fmt::format("{}", spec.outputs.lights); }},
    {"assume", "all|none|NAME,...", "what is assumed where the map is silent, such as pavements,lamps (default: all)",
     false, set_assume},
    {"fill", "lots|none",
     "lots: puts houses on residential land without buildings, beside mapped streets (default: none)", false, set_fill},
    {"drive-on", "left|right", "side of the road on which vehicles drive (default: by country)", false, set_drive_on},
    {"time", "ISO",
     "date and time of the sky in UTC, or with an offset from it, such as 2026-06-21T20:30+02:00 (default: midsummer, "
     "15:00 solar time)",
     false, set_time},
    {"visibility", "KM",
     "how far one sees at sea level, 1 to 300 km (default: {}, or by the turbidity if that is given)", false,
     set_visibility, default_of_sky<&sky::Sky::visibility_km>},
    {"turbidity", "T", "haze of the whole sky: 2 clear, 10 hazy (default: {})", false, set_turbidity,
     default_of_sky<&sky::Sky::turbidity>},
    {"ground-albedo", "X", "share of light that the land around reflects into the air, 0 to 1 (default: {})", false,
     set_ground_albedo, default_of_sky<&sky::Sky::ground_albedo>},
    {"clouds", "clear|fair|broken|overcast|FILE.json", "clouds of the sky, by name or in layers (default: clear)",
     false, set_clouds},
    {"seed", "N", "seed of all random choices, a whole number (default: {})", false, set_seed,
     [](const CompileSpec& spec) { return fmt::format("{}", spec.seed); }},
    {"snow-line", "M",
     "land above this height in metres is covered by snow, such as 2800 (default: all land in the winter of cold "
     "climates, "
     "else none)",
     false, set_snow_line},
    {"rules", "FOLDER", "folder of rule files (.cga) that replace shipped files of the same name", false,
     set_text<&CompileSpec::rules_folder>},
    {"things", "FOLDER",
     "folder with a table of things, things.txt, and rule files (.cga), which add to the shipped ones or replace those "
     "of the same name",
     false, set_text<&CompileSpec::things_folder>},
    {"species", "FOLDER",
     "folder with plants of your own (.lsys, .honda, .family, .tree) and tables of them, species.txt and spawners.txt, "
     "which "
     "add to the shipped ones or replace those of the same name",
     false, set_text<&CompileSpec::species_folder>},
    {"cars", "", "parked cars in parking lanes, on car parks and in parking spaces, drawn by the seed", false,
     set_cars},
    {"tags", "", "keep all tags of the map's elements, in the manifest and as a property of each feature in .glb files",
     false, set_tags},
    {"threads", "N", "number of threads; 0 uses all processors (default: {})", false,
     [](CompileSpec& spec, std::string_view text) { return put(parse_whole(text, 0), spec.threads); },
     [](const CompileSpec& spec) { return fmt::format("{}", spec.threads); }},
    {"strict", "[=CODE,...]",
     "exit with code 2 if map or height data had to be corrected or left out; with codes, such as "
     "--strict=MissingNode,RoofFallback, if one of these was diagnosed",
     false, set_strict},
};

/// The value as it would be written on the command line.
std::string text_of(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const json& item : value) text += (text.empty() ? "" : ",") + text_of(item);
  return text;
}

/// Returns "spec.json:3:14" for a byte offset of the text, counted from 1.
std::string place_of(const std::string& path, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0: the first line
  return fmt::format("{}:{}:{}", path, std::count(before.begin(), before.end(), '\n') + 1,
                     before.size() - line_begin + 1);
}

Result<Done> apply_json(const Setting& setting, const json& value, CompileSpec& spec) {
  if (!setting.repeats || !value.is_array()) return apply(setting, text_of(value), spec);
  for (const json& item : value) {
    const Result<Done> done = apply(setting, text_of(item), spec);
    if (!done) return done;
  }
  return Done{};
}

Result<Done> apply_key(const std::string& key, const json& value, CompileSpec& spec) {
  for (const Setting& setting : kSettings) {
    if (setting.name != key) continue;
    const Result<Done> done = apply_json(setting, value, spec);
    return done ? done : Error{"", fmt::format("\"{}\": {}", key, to_string(done.error()))};
  }
  std::vector<std::string> known;
  for (const Setting& setting : kSettings) known.emplace_back(setting.name);
  return Error{
      "", fmt::format("unknown setting \"{}\"{} (citykiln compile --help lists all)", key, did_you_mean(key, known))};
}

}  // namespace

std::span<const Setting> settings() { return kSettings; }

std::string help_of(const Setting& setting) {
  std::string help(setting.help);
  if (setting.default_in) help.replace(help.find("{}"), 2, setting.default_in({}));
  return help;
}

Result<Done> apply(const Setting& setting, std::string_view text, CompileSpec& spec) {
  CompileSpec changed = spec;
  const Result<Done> done = setting.apply(changed, text);
  if (done) spec = std::move(changed);
  return done;
}

Result<CompileSpec> read_spec(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "the file cannot be read"};
  const std::string text{std::istreambuf_iterator<char>(file), {}};

  json document;
  try {
    document = json::parse(text);
  } catch (const json::parse_error& problem) {
    return Error{place_of(path, text, problem.byte), "invalid JSON at this place"};
  }
  if (!document.is_object())
    return Error{path, "expected a JSON object of settings, such as {\"map\": \"town.osm\", \"tile\": 512}"};

  CompileSpec spec;
  for (const auto& [key, value] : document.items()) {
    const Result<Done> done = apply_key(key, value, spec);
    if (!done) return Error{path, to_string(done.error())};
  }
  return spec;
}

Result<Done> is_complete(const CompileSpec& spec) {
  if (spec.map_path.empty())
    return Error{"", "no map is given; expected a file such as town.osm.pbf, or the setting \"map\" in spec.json"};
  if (spec.outputs.folder.empty())
    return Error{"", "no output folder is given; add -o FOLDER, or the setting \"out\" to spec.json"};
  if (const Result<Done> fits = fits_world(spec); !fits) return fits;
  return fits_target(spec.outputs);
}

namespace {

// Checks the settings that have no meaning inside of a cylinder.
Result<Done> fits_cylinder(const CompileSpec& spec) {
  const Outputs& outputs = spec.outputs;
  if (outputs.page) return Error{"--emit", "page shows worlds on the ellipsoid; leave it out inside of a cylinder"};
  if (outputs.surroundings) return Error{"--surroundings", "there is no land around a map inside of a cylinder"};
  if (!outputs.geoid.empty()) return Error{"--geoid-height", "is for the ellipsoid; leave it out inside of a cylinder"};
  if (!spec.clouds.empty() && spec.clouds != "clear")
    return Error{"--clouds", "there are no clouds inside of a cylinder; leave it out"};
  return Done{};
}

}  // namespace

Result<Done> fits_world(const CompileSpec& spec) {
  if (spec.world == World::kCylinder) return fits_cylinder(spec);
  if (spec.world == World::kPlane && spec.outputs.tiles3d)
    return Error{"--world", "3dtiles are on the ellipsoid, found plane; leave --world out"};
  if (spec.world == World::kEllipsoid && !spec.outputs.tiles3d)
    return Error{"--world", "kiln and glb are in the plane, found ellipsoid; add --emit 3dtiles"};
  if (spec.outputs.page && !spec.outputs.tiles3d)
    return Error{"--emit", "page shows the tiles of 3dtiles; give both, such as 3dtiles,page"};
  if (spec.outputs.geoid.ends_with(".pgm") && !std::ifstream(spec.outputs.geoid))
    return Error{spec.outputs.geoid, "the file cannot be read"};
  return Done{};
}

Result<Done> fits_target(const Outputs& outputs) {
  // contents of 3D Tiles are written for CesiumJS, which reads all
  if (!outputs.glb) return Done{};
  bool (*const reads)(const TargetValues&) =
      outputs.compress == Compression::kQuantize  ? [](const TargetValues& t) { return t.reads_quantised; }
      : outputs.compress == Compression::kDraco   ? [](const TargetValues& t) { return t.reads_draco; }
      : outputs.compress == Compression::kMeshopt ? [](const TargetValues& t) { return t.reads_meshopt; }
                                                  : [](const TargetValues&) { return true; };
  const TargetValues& target = values_of(outputs.target);
  if (reads(target)) return Done{};
  return Error{"--compress", fmt::format("{} cannot be read by the target {}; add --target {}",
                                         name_of(outputs.compress), target.name, targets_with(reads))};
}

Result<double> parse_tolerance(std::string_view text) {
  const auto tolerance_m = number_in<double>(text);
  if (tolerance_m && *tolerance_m > 0 && *tolerance_m <= kCoarsest_m) return *tolerance_m;
  return expected(fmt::format("a tolerance in metres, above 0 and at most {}, such as 0.1", kCoarsest_m), text);
}

Result<std::vector<double>> parse_ladder(std::string_view text) {
  std::vector<double> tolerances_m;
  for (const std::string_view part : split(text, ',')) {
    const Result<double> tolerance_m = parse_tolerance(part);
    const double last = tolerances_m.empty() ? 0 : tolerances_m.back();
    if (!tolerance_m || !(*tolerance_m > last))
      return expected(
          fmt::format("increasing tolerances in metres, above 0 and at most {}, such as 0.1,0.5,2.5", kCoarsest_m),
          text);
    tolerances_m.push_back(*tolerance_m);
  }
  return tolerances_m;
}

Result<scene::TileKey> parse_tile(std::string_view text) {
  const auto xy = numbers_in<std::int32_t>(text, '_', 2);
  if (!xy) return expected("a tile X_Y, such as 3_-2", text);
  return scene::TileKey{(*xy)[0], (*xy)[1]};
}

Result<Done> add_tiles(std::string_view text, std::vector<scene::TileKey>& tiles) {
  assert(std::ranges::is_sorted(tiles));
  for (const std::string_view part : split(text, ',')) {
    const Result<scene::TileKey> tile = parse_tile(part);
    if (!tile) return tile.error();
    const auto place = std::ranges::lower_bound(tiles, *tile);
    if (place == tiles.end() || *place != *tile) tiles.insert(place, *tile);
  }
  return Done{};
}

Result<double> parse_number(std::string_view text) {
  const auto number = number_in<double>(text);
  return number ? Result(*number) : expected("a number", text);
}

Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t count) {
  assert(count > 0);
  auto numbers = numbers_in<double>(text, ',', count);
  return numbers ? Result(std::move(*numbers)) : expected(fmt::format("{} numbers separated by commas", count), text);
}

Result<std::int64_t> parse_whole(std::string_view text, std::int64_t least) {
  const auto number = number_in<std::int64_t>(text);
  // counts of threads, pixels and paths are ints
  if (number && *number >= least && *number <= 0x7fffffff) return *number;
  return expected(fmt::format("a whole number of at least {}", least), text);
}

}  // namespace citykiln
